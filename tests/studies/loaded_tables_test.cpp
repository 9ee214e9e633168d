// The frozen tables of loaded flights and of impacts, against what shares nothing with their making: CVODE with the law written here,
// invariants of the tops, and located mode.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <reference/sundials.hpp>
#include <rigor/base/file.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/table.hpp>
#include <map>
#include <sstream>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

struct Line {
  std::map<std::string, std::string> cells;
  std::string id() const { return cells.at("case"); }
  std::string stratum() const { return cells.at("stratum"); }
  double number(const std::string& name) const { return std::stod(cells.at(name)); }
  V vector(const std::string& name) const { return V(number(name + "1"), number(name + "2"), number(name + "3")); }
  V answer(const std::string& name) const { return V(number(name + "x"), number(name + "y"), number(name + "z")); }
  Mat3<double> attitude() const { return rotation_of<double>(Vec4<double>(number("qw"), number("qx"), number("qy"), number("qz"))); }
};
std::string loaded_table(const std::string& name) { return *read_file(std::filesystem::path(RIGOR_SOURCE_DIR) / "reference/tables" / (name + ".csv")); }
std::vector<Line> lines_of(const std::string& name) {
  std::vector<Line> all;
  std::vector<std::string> header;
  std::istringstream in(loaded_table(name));
  for (std::string text; std::getline(in, text);) {
    if (text.front() == '#') continue;
    std::vector<std::string> c;
    std::istringstream cells(text);
    for (std::string cell; std::getline(cells, cell, ',');) c.push_back(cell);
    if (header.empty()) {
      header = c;
      continue;
    }
    all.push_back({});
    for (std::size_t i = 0; i < header.size(); ++i) all.back().cells[header[i]] = c.at(i);
  }
  return all;
}
struct Answer {
  Mat3<double> R;
  V w_B;
  double time = 0;
  V v = zero3<double>();
};
std::string answer_line(const std::string& id, const Answer& a) {
  const Vec4<double> q = quaternion_of<double>(a.R);
  char text[500];
  std::snprintf(text, sizeof text, "%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", id.c_str(), a.time, q[0], q[1], q[2], q[3], a.w_B[0], a.w_B[1], a.w_B[2], a.v[0], a.v[1],
                a.v[2]);
  return text;
}
constexpr const char* header = "case,time,qw,qx,qy,qz,wx,wy,wz,vx,vy,vz\n";

Answer by_cvode(const Line& c) {
  const V I = c.vector("I"), w = c.vector("w"), arm = c.vector("arm"), tau = c.vector("tau"), push = c.vector("push");
  const double rate = c.number("rate");
  const reference::Rhs free = reference::free_body_rhs(I);
  const auto end = reference::cvode(
      [&](double t, std::span<const double> y, std::span<double> d) {
        free(t, y, d);
        const Mat3<double> R = rotation_of<double>(Vec4<double>(y[3], y[4], y[5], y[6]));
        const V torque = tau - cross<double>(arm, V(R.transpose() * V(0, 0, 1))) + std::cos(rate * t) * R.transpose() * push;
        for (int i = 0; i < 3; ++i) d[std::size_t(i)] += torque[i] / I[i];
      },
      {w[0], w[1], w[2], 1, 0, 0, 0}, 0, c.number("t"), 1e-14);
  EXPECT_TRUE(end);
  const auto& y = end->y;
  return {rotation_of<double>(Vec4<double>(y[3], y[4], y[5], y[6])), V(y[0], y[1], y[2])};
}

TEST(LoadedFlightTable, AgreesWithCvode) {
  std::string csv = header;
  for (const Line& c : lines_of("loaded-flight")) csv += answer_line(c.id(), by_cvode(c));
  const auto rows = check_table(loaded_table("loaded-flight"), csv, "cvode");
  ASSERT_TRUE(rows) << rows.fault().text();
  std::fputs(table_text(*rows).c_str(), stdout);
  EXPECT_EQ(rows->size(), 8u);
  for (const TableRow& row : *rows) {
    EXPECT_EQ(row.answered, row.of);
    EXPECT_LT(row.attitude, 1e-11) << row.stratum;
    EXPECT_LT(row.spin, 1e-11) << row.stratum;
  }
}

// cases F-05 to F-07 and energy: of numbers up to a few dozen, rounded from 30 digits
TEST(LoadedFlightTable, KeepsTheInvariantsOfItsTops) {
  int tops = 0;
  for (const Line& c : lines_of("loaded-flight")) {
    if (c.stratum() != "lagrange" && c.stratum() != "kovalevskaya" && c.stratum() != "goryachev" && c.stratum() != "top") continue;
    ++tops;
    const V I = c.vector("I"), arm = c.vector("arm");
    const auto invariants = [&](const V& w, const V& up) {
      const V L = I.cwiseProduct(w);
      const std::complex<double> wc(w[0], w[1]), uc(up[0], up[1]);
      const double third = c.stratum() == "lagrange" ? w[0] : c.stratum() == "kovalevskaya" ? std::norm(wc * wc - arm[0] / I[2] * uc) : c.stratum() == "goryachev" ? w[2] * (w[0] * w[0] + w[1] * w[1]) - arm[0] / I[2] * w[0] * up[2] : 0;
      return V(w.dot(L) / 2 + arm.dot(up), L.dot(up), third);
    };
    const V before = invariants(c.vector("w"), V(0, 0, 1)), after = invariants(c.answer("w"), V(c.attitude().row(2)));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(after[i], before[i], 1e-13 * (1 + std::fabs(before[i]))) << c.id() << ", " << i;
  }
  EXPECT_EQ(tops, 16);
}

TEST(ImpactTable, AgreesWithLocatedMode) {
  std::string csv = header;
  for (const Line& c : lines_of("impacts")) {
    Scene s;
    s.method = "located";
    s.gravity = V(0, -c.number("g"), 0);
    s.surface = *Surface<double>::make(c.number("e"), 0, 0);
    s.planes = {*Plane<double>::make(V(0, 0, 0), V(0, 1, 0))};
    State<double> start;
    start.p_WB = V(0, c.number("height"), 0);
    start.v_WB = c.vector("v");
    start.w_WB = c.vector("w");
    s.bodies = {{*Cuboid<double>::make(c.number("mass"), c.vector("size")), start}};
    s.until = 1.1 * c.number("time");
    std::vector<LocatedImpact> seen;
    ASSERT_TRUE(simulate_located(s, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& i) { seen.push_back(i); }));
    ASSERT_FALSE(seen.empty()) << c.id();
    const State<double>& after = seen[0].after;
    csv += answer_line(c.id(), {after.R_WB, apply_transposed<double>(after.R_WB, after.w_WB), seen[0].t, after.v_WB});
  }
  const auto rows = check_table(loaded_table("impacts"), csv, "located");
  ASSERT_TRUE(rows) << rows.fault().text();
  std::fputs(table_text(*rows).c_str(), stdout);
  for (const TableRow& row : *rows) {
    EXPECT_EQ(row.answered, row.of);
    for (const double worst : {row.attitude, row.spin, row.time, row.velocity}) EXPECT_LT(worst, 1e-12) << row.stratum;
  }
  // a tenth of a millionth in one time is seen, and where
  std::string wrong = header;
  for (const Line& c : lines_of("impacts")) wrong += answer_line(c.id(), {c.attitude(), c.answer("w"), c.number("time") * (c.id() == "plate-2" ? 1 + 1e-7 : 1), c.answer("v")});
  const auto checked = check_table(loaded_table("impacts"), wrong, "wrong");
  ASSERT_TRUE(checked);
  for (const TableRow& row : *checked) EXPECT_NEAR(row.time, row.stratum == "plate" ? 1e-7 : 0, 1e-12);
  const auto without = check_table(loaded_table("impacts"), "case,qw,qx,qy,qz,wx,wy,wz\n", "mine.csv");
  ASSERT_FALSE(without);
  EXPECT_EQ(without.fault().text(), "mine.csv has no column 'time'; needed: case, qw, qx, qy, qz, wx, wy, wz, time, vx, vy, vz");
}

}  // namespace
}  // namespace rigor::studies
