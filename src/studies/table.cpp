#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <reference/taylor.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/table.hpp>
#include <set>
#include <sstream>

namespace rigor::studies {
namespace {

using P = reference::Precise;
using V = Vec3<double>;

struct Flight {
  const char* stratum;
  V inertia, w_B;   // kg m^2, rad/s; exact in binary
  double t;         // s
};

// Every stratum is one kind of difficulty; every number a multiple of a power of two.
std::vector<Flight> flights() {
  std::vector<Flight> all;
  const V bodies[] = {{1, 1.25, 1.5}, {0.5, 1.5, 1.75}, {2, 3, 4.5}, {0.125, 1, 1.0625}};
  for (int k = 0; k < 8; ++k) all.push_back({"generic", bodies[k % 4], V(1 + 0.25 * k, -0.75 + 0.5 * (k % 3), 0.5 - 0.125 * k), 1 + 0.5 * k});
  for (int k = 0; k < 6; ++k) all.push_back({"separatrix", bodies[k % 4], V(std::ldexp(1, -10 - 4 * k), 2, std::ldexp(1, -12 - 4 * k)), 4.0 + k});
  for (int k = 0; k < 6; ++k) all.push_back({"plate", V(1, 1 + std::ldexp(1, -4 - 3 * k), 2), V(0.5, 1 + 0.25 * k, 0.25), 3});           // I1 + I2 = I3, nearly a disc
  for (int k = 0; k < 4; ++k) all.push_back({"needle", V(std::ldexp(1, -8 - 2 * k), 1, 1.0009765625), V(4, 0.5, -0.25), 3});
  for (int k = 0; k < 6; ++k) all.push_back({"symmetric", k % 2 == 0 ? V(1, 1, 1.5) : V(0.5, 1.25, 1.25), V(1, -0.5 + 0.25 * k, 2), 4});
  for (int k = 0; k < 2; ++k) all.push_back({"sphere", V(1, 1, 1), V(1, 2 - k, -2), 5});
  for (int k = 0; k < 6; ++k) all.push_back({"near-axis", bodies[k % 4], k % 2 == 0 ? V(3, std::ldexp(1, -20), std::ldexp(1, -18)) : V(std::ldexp(1, -20), std::ldexp(1, -16), 3), 5});
  for (int k = 0; k < 4; ++k) all.push_back({"fast", bodies[k], V(700 - 100 * k, 300, -500), 0.03125});
  for (int k = 0; k < 4; ++k) all.push_back({"slow", bodies[k], V(std::ldexp(3, -10), std::ldexp(5, -10), std::ldexp(-7, -10)), 256});
  for (int k = 0; k < 3; ++k) all.push_back({"long", bodies[k], V(1, 0.5, -0.75), 64});
  return all;
}
std::string thirty(const P& x) { return x.str(30, std::ios_base::scientific); }
std::string exact(double x) {
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

// Splits a CSV without quotes, which is all these tables need; spaces around cells are dropped.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out{""};
  for (const char c : line) {
    if (c == ',') out.emplace_back();
    else if (c != '\r' && c != ' ' && c != '"') out.back() += c;
  }
  return out;
}
struct Parsed {
  std::vector<std::string> header;
  std::vector<std::pair<int, std::vector<std::string>>> lines;  // line number, cells
};
Parsed parse(const std::string& text) {
  Parsed parsed;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    if (parsed.header.empty()) parsed.header = cells(line);
    else parsed.lines.push_back({number, cells(line)});
  }
  return parsed;
}
int column(const std::vector<std::string>& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == name) return int(i);
  return -1;
}
double number(const std::string& text, bool& good) {
  double x = 0;
  const auto end = std::from_chars(text.data() + (text.rfind('+', 0) == 0), text.data() + text.size(), x);
  good = end.ec == std::errc() && end.ptr == text.data() + text.size();
  return x;
}

}  // namespace

std::string free_flight_table() {
  std::string out =
      "# Torque-free rotation, 30 digits. Attitude at t = 0 is the identity; q body to world, qw >= 0; I and w in body axes, SI units.\n"
      "# Inputs exact in binary. Taylor series of order 40 in 60 digits, own error below 1e-40. Written by: rigor check-table --write DIR\n"
      "case,stratum,I1,I2,I3,w1,w2,w3,t,qw,qx,qy,qz,wx,wy,wz\n";
  std::map<std::string, int> counts;
  for (const Flight& f : flights()) {
    const double step = 0.02 / std::fmax(1, norm<double>(f.w_B));
    const auto end = reference::taylor_free_body<P>({f.inertia, f.w_B, identity3<double>()}, P(f.t), 40, step);
    Vec4<P> q = quaternion_of<P>(end.R_WB);
    if (q[0] < 0) q = -q;
    out += std::string(f.stratum) + "-" + std::to_string(++counts[f.stratum]) + "," + f.stratum;
    for (int i = 0; i < 3; ++i) out += "," + exact(f.inertia[i]);
    for (int i = 0; i < 3; ++i) out += "," + exact(f.w_B[i]);
    out += "," + exact(f.t);
    for (int i = 0; i < 4; ++i) out += "," + thirty(q[i]);
    for (int i = 0; i < 3; ++i) out += "," + thirty(end.w_B[i]);
    out += "\n";
  }
  return out;
}

std::string table_json(const std::string& csv) {
  nlohmann::ordered_json json{{"schema", "rigor.free-flight-table/1"}, {"command", "rigor check-table --write DIR"}, {"provenance", nlohmann::ordered_json::array()}, {"cases", nlohmann::ordered_json::array()}};
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);)
    if (line.rfind("# ", 0) == 0) json["provenance"].push_back(line.substr(2));
  const Parsed parsed = parse(csv);
  for (const auto& [line, c] : parsed.lines) {
    nlohmann::ordered_json row;
    for (std::size_t i = 0; i < c.size(); ++i) row[parsed.header[i]] = c[i];
    json["cases"].push_back(row);
  }
  return json.dump(1) + "\n";
}

Outcome<std::vector<TableRow>> check_table(const std::string& table, const std::string& theirs, const std::string& name) {
  using Kind = Fault::Kind;
  const Parsed reference = parse(table), answers = parse(theirs);
  if (answers.header.empty()) return Fault{Kind::malformed, name, "is empty, must be a CSV with a header"};
  const char* needed[] = {"case", "qw", "qx", "qy", "qz", "wx", "wy", "wz"};
  std::map<std::string, int> at;
  for (const char* c : needed) {
    at[c] = column(answers.header, c);
    if (at[c] < 0) return Fault{Kind::missing, name, std::string("has no column '") + c + "'; needed: case, qw, qx, qy, qz, wx, wy, wz"};
  }
  struct Want {
    std::string stratum;
    Vec4<double> q;
    V w;
  };
  std::map<std::string, Want> wanted;
  std::vector<TableRow> rows;
  bool good = true;
  for (const auto& [line, c] : reference.lines) {
    Want want{c[1], {}, {}};
    for (int i = 0; i < 4; ++i) want.q[i] = number(c[std::size_t(9 + i)], good);
    for (int i = 0; i < 3; ++i) want.w[i] = number(c[std::size_t(13 + i)], good);
    wanted[c[0]] = want;
    if (rows.empty() || rows.back().stratum != c[1]) rows.push_back({c[1], 0, 0, 0, 0, ""});
    ++rows.back().of;
  }
  std::vector<std::string> known;
  for (const auto& [id, want] : wanted) known.push_back(id);
  std::set<std::string> seen;
  for (const auto& [line, c] : answers.lines) {
    const std::string where = name + ":" + std::to_string(line);
    if (c.size() < answers.header.size()) return Fault{Kind::malformed, where, "has " + std::to_string(c.size()) + " cells, the header has " + std::to_string(answers.header.size())};
    const std::string id = c[std::size_t(at["case"])];
    const auto want = wanted.find(id);
    if (want == wanted.end()) return Fault{Kind::unknown_key, where, "there is no case '" + id + "'" + did_you_mean(id, known)};
    if (!seen.insert(id).second) return Fault{Kind::unknown_key, where, "case '" + id + "' is there twice"};
    double x[7];
    for (int i = 0; i < 7; ++i) {
      const std::string& cell = c[std::size_t(at[needed[i + 1]])];
      x[i] = number(cell, good);
      if (!good) return Fault{Kind::wrong_type, where + ", " + needed[i + 1], "is '" + cell.substr(0, 40) + "', must be a number"};
      if (!std::isfinite(x[i])) return Fault{Kind::not_finite, where + ", " + needed[i + 1], "is not finite"};
    }
    const Vec4<double> q(x[0], x[1], x[2], x[3]);
    if (std::fabs(q.norm() - 1) > 1e-3) return Fault{Kind::not_unit, where, "the quaternion has length " + exact(q.norm()) + ", must be 1 within 1e-3"};
    const double attitude = angle_between<double>(rotation_of<double>(q), rotation_of<double>(want->second.q));
    const double spin = norm<double>(V(V(x[4], x[5], x[6]) - want->second.w)) / norm<double>(want->second.w);
    for (TableRow& row : rows) {
      if (row.stratum != want->second.stratum) continue;
      ++row.answered;
      if (attitude >= row.attitude) row.attitude = attitude, row.worst = id;
      row.spin = std::fmax(row.spin, spin);
    }
  }
  if (seen.empty()) return Fault{Kind::missing, name, "answers no case of the table"};
  return rows;
}

std::string table_text(const std::vector<TableRow>& rows) {
  std::string out = "stratum       answered   worst attitude, rad   worst spin, relative   at\n";
  for (const TableRow& r : rows) {
    char line[160];
    if (r.answered == 0) std::snprintf(line, sizeof line, "%-12s  %3d of %-3d\n", r.stratum.c_str(), 0, r.of);
    else std::snprintf(line, sizeof line, "%-12s  %3d of %-3d %15.2e %22.2e    %s\n", r.stratum.c_str(), r.answered, r.of, r.attitude, r.spin, r.worst.c_str());
    out += line;
  }
  return out;
}

}  // namespace rigor::studies
