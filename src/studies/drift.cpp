#include <charconv>
#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/report/html.hpp>
#include <rigor/studies/drift.hpp>

namespace rigor::studies {
namespace {

std::string digits(double x) {
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}
std::string brief(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", x);
  return x == 0 ? "0" : text;
}
std::vector<std::string> cells(const Drift& d) {
  return {std::string(d.method->name), std::to_string(d.method->order), brief(d.energy), brief(d.energy_jitter), brief(d.momentum), brief(d.orthonormality), d.finite ? "" : "left the numbers"};
}

}  // namespace

Drift drift_of(const Problem& problem, const Method& method, double h, long steps) {
  Motion m = motion_of(problem.body, problem.start);
  const Vec3<double> L0 = m.L_W;
  const double E0 = L0.dot(m.state.w_WB) / 2, size = norm<double>(L0);
  Drift d{&method, h, 0, 0, 0, 0, 0, true};
  double last = 1, sum = 0, squares = 0;
  for (; d.steps < steps && interrupted() == 0; ++d.steps) {
    m = method.step(problem.body, m, {}, h);
    const double energy = m.L_W.dot(m.state.w_WB) / 2 / E0, change = energy - last, skew = orthonormality_defect<double>(m.state.R_WB);
    d.finite = std::isfinite(energy) && std::isfinite(skew);
    if (!d.finite) break;
    last = energy;
    sum += change, squares += change * change;
    d.energy = std::fmax(d.energy, std::fabs(energy - 1));
    d.momentum = std::fmax(d.momentum, norm<double>(Vec3<double>(m.L_W - L0)) / size);
    d.orthonormality = std::fmax(d.orthonormality, skew);
  }
  const double n = double(std::max(1L, d.steps)), mean = sum / n;
  d.energy_jitter = std::sqrt(std::fmax(0, squares / n - mean * mean));
  return d;
}

double stable_angle(const Problem& problem, const Method& method) {
  const double spin = norm<double>(problem.start.w_WB);
  const auto stable = [&](int quarter) {
    const Drift d = drift_of(problem, method, std::exp2(quarter / 4.0) / spin, 10000);
    return d.finite && d.energy <= 0.1;
  };
  int low = -40, high = 24;  // quarters of a power of two
  if (!stable(low)) return 0;
  if (stable(high)) return std::exp2(high / 4.0);
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (stable(middle) ? low : high) = middle;
  }
  return std::exp2(low / 4.0);
}

std::string drift_csv(const Problem& problem, const std::vector<Drift>& rows) {
  std::string out = "problem,method,h,steps,energy,energy_jitter,momentum,orthonormality,finite\n";
  for (const Drift& d : rows)
    out += problem.name + "," + std::string(d.method->name) + "," + digits(d.h) + "," + std::to_string(d.steps) + "," + digits(d.energy) + "," + digits(d.energy_jitter) + "," +
           digits(d.momentum) + "," + digits(d.orthonormality) + "," + (d.finite ? "yes" : "no") + "\n";
  return out;
}
std::string drift_text(const Problem& problem, const std::vector<Drift>& rows) {
  std::string out = problem.name + ", torque-free: " + std::to_string(rows.front().steps) + " steps of " + digits(rows.front().h) + " s\n";
  out += "  method               order  energy    jitter    |L|       R'R - 1\n";
  for (const Drift& d : rows) {
    const auto c = cells(d);
    char line[160];
    std::snprintf(line, sizeof line, "  %-20s %5s  %-8s  %-8s  %-8s  %-8s  %s\n", c[0].c_str(), c[1].c_str(), c[2].c_str(), c[3].c_str(), c[4].c_str(), c[5].c_str(), c[6].c_str());
    out += line;
  }
  return out;
}
std::string drift_html(const Problem& problem, const std::vector<Drift>& rows, const std::string& command) {
  report::Page page;
  page.title = "Drift: " + problem.name;
  page.lead = problem.says;
  std::vector<std::vector<std::string>> lines;
  for (const Drift& d : rows) lines.push_back(cells(d));
  page.body = report::table({"method", "order", "energy, worst |E/E0 - 1|", "its jitter from step to step", "worst |L - L0|/|L0|", "worst max|R'R - 1|", ""}, lines, {1, 2, 3, 4, 5},
                            std::to_string(rows.front().steps) + " steps of " + digits(rows.front().h) + " s");
  page.footer = command;
  return report::render(page);
}

std::string stability_csv(const Problem& problem, const std::vector<Stability>& rows) {
  std::string out = "problem,method,largest_stable_angle_rad\n";
  for (const Stability& s : rows) out += problem.name + "," + std::string(s.method->name) + "," + digits(s.angle) + "\n";
  return out;
}
std::string stability_text(const Problem& problem, const std::vector<Stability>& rows) {
  std::string out = problem.name + ": largest |w| h (rad) at which 10000 steps keep the energy within a tenth\n";
  for (const Stability& s : rows) {
    char line[100];
    std::snprintf(line, sizeof line, "  %-20s %5d  %s\n", std::string(s.method->name).c_str(), s.method->order, s.angle == 0 ? "none of those tried (from 0.001)" : digits(std::round(s.angle * 1000) / 1000).c_str());
    out += line;
  }
  return out;
}
std::string stability_html(const Problem& problem, const std::vector<Stability>& rows, const std::string& command) {
  report::Page page;
  page.title = "Stability: " + problem.name;
  page.lead = problem.says;
  std::vector<std::vector<std::string>> lines;
  for (const Stability& s : rows) lines.push_back({std::string(s.method->name), std::to_string(s.method->order), s.angle == 0 ? "none" : digits(std::round(s.angle * 1000) / 1000)});
  page.body = report::table({"method", "order", "largest stable |w| h, rad"}, lines, {1, 2}, "10000 steps, energy within a tenth");
  page.footer = command;
  return report::render(page);
}

}  // namespace rigor::studies
