// Every oracle against every other, on every problem that both can do: the table of reference/README.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <reference/gsl_flight.hpp>
#include <reference/jet.hpp>
#include <reference/sundials.hpp>
#include <reference/taylor.hpp>
#include <reference/theta_flight.hpp>
#include <rigor/linalg/rotation.hpp>
#include <span>
#include <string>
#include <vector>

namespace rigor::reference {
namespace {

using P = Precise;
using Numbers = std::vector<double>;  // what the oracle says the end is

struct Answer {
  std::string oracle;
  double good_to;  // what the README states, on the problem
  Numbers end;
};
// The difference of two must be within what both are good to.
void compare(const std::string& problem, const std::vector<Answer>& answers) {
  std::printf("\n%-14s", problem.c_str());
  for (std::size_t i = 1; i < answers.size(); ++i) std::printf(" %10s", answers[i].oracle.c_str());
  for (std::size_t i = 0; i + 1 < answers.size(); ++i) {
    std::printf("\n%-14s", answers[i].oracle.c_str());
    for (std::size_t j = 1; j < answers.size(); ++j) {
      if (j <= i) {
        std::printf(" %10s", "");
        continue;
      }
      double sum = 0;
      for (std::size_t k = 0; k < answers[i].end.size(); ++k) sum += std::pow(answers[i].end[k] - answers[j].end[k], 2);
      std::printf(" %10.1e", std::sqrt(sum));
      EXPECT_LT(std::sqrt(sum), answers[i].good_to + answers[j].good_to) << problem << ": " << answers[i].oracle << " and " << answers[j].oracle;
    }
  }
  std::printf("\n");
}

// The nine numbers of R over sqrt 2: their distance is the angle.
template <class T>
Numbers numbers(const Attitude<T>& a) {
  Numbers out;
  for (int i = 0; i < 9; ++i) out.push_back(static_cast<double>(a.R_WB(i / 3, i % 3)) / std::sqrt(2.0));
  return out;
}
// Euler's equations with a quaternion, y = (w_B, q), once for numbers and once for series.
template <class T>
std::vector<T> spinning(const Vec3<double>& I, const std::vector<T>& y) {
  const T &a = y[0], &b = y[1], &c = y[2], &w = y[3], &i = y[4], &j = y[5], &k = y[6], half(P(0.5));
  const auto ratio = [](double up, double down) { return T(P(up) / P(down)); };
  return {ratio(I[1] - I[2], I[0]) * b * c, ratio(I[2] - I[0], I[1]) * c * a, ratio(I[0] - I[1], I[2]) * a * b, half * (T(P(0)) - i * a - j * b - k * c),
          half * (w * a + j * c - k * b), half * (w * b + k * a - i * c), half * (w * c + i * b - j * a)};
}
// cases FB-04, FB-05
TEST(Agreement, OfEveryPairOnFreeBodies) {
  const Mat3<double> R = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  const Vec3<double> plate(13 / 12., 10 / 12., 5 / 12.);
  const struct {
    const char* name;
    FreeBody body;
    double ill;       // what the distance from the separatrix costs a closed form in double
    double stepping;  // what it costs a stepper: an error grows at most by sqrt(16/(1 - m)), 338 on FB-05, before the flip undoes it
  } problems[] = {{"case A", {plate, {0.3, 2, 0.2}, R}, 1, 1},
                  {"case B", {plate, {5, 0.01, 0.01}, R}, 1, 1},
                  {"case C", {plate, {1e-6, 2, 1e-6}, R}, 1e4, 1},
                  {"FB-05", {{97 / 120., 82 / 120., 17 / 120.}, {0.1, 5, 0.1}, R}, 1e2, 50}};
  for (const auto& p : problems) {
    const auto adams = cvode_free_body(p.body, 10, 1e-14), bdf = cvode_free_body(p.body, 10, 1e-12, Cvode::bdf), fehlberg = arkstep_free_body(p.body, 10, 1e-13);
    const auto gsl = gsl_free_body(p.body, 10);
    ASSERT_TRUE(adams && bdf && fehlberg && gsl);
    const double rounding = 2e-15;
    compare(p.name, {{"Taylor 60", rounding, numbers(taylor_free_body<P>(p.body, P(10)))},
                     {"theta 60", rounding, numbers(ThetaFlight<P>(p.body).at(P(10)))},
                     {"theta", 5e-15 * p.ill, numbers(ThetaFlight<double>(p.body).at(10))},
                     {"GSL", p.ill == 1 ? 5e-14 : 1e-6, numbers(*gsl)},
                     {"Adams", 1e-11 * p.stepping, numbers(*adams)},
                     {"BDF", 1e-8, numbers(*bdf)},
                     {"Fehlberg 8", 5e-12 * p.stepping, numbers(*fehlberg)},
                     {"Taylor 16", 1e-13 * p.stepping, numbers(taylor_free_body<double>(p.body, 10, 16, 0.0625))}});
  }
}

// How the attitude turns with the spin at the start: central differences of the closed form and of the series, in 60 digits (what
// they leave out is of the order of 1e-40 growing as the third power, what they cancel 1e-37), beside CVODES.
template <class Flight>
Mat3<double> turn_by_spin(const FreeBody& body, const Flight& flight) {
  const P d("1e-20");
  Mat3<double> turn;
  for (int i = 0; i < 3; ++i) {
    Vec3<P> more = body.w_B.cast<P>(), less = more;
    more[i] += d, less[i] -= d;
    const Mat3<P> A = flight(more), B = flight(less), D = (A - B) * (A + B).transpose() / (4 * d);  // [turn]x to second order in d
    turn.col(i) = Vec3<double>(double(P((D(2, 1) - D(1, 2)) / 2)), double(P((D(0, 2) - D(2, 0)) / 2)), double(P((D(1, 0) - D(0, 1)) / 2)));
  }
  return turn;
}
TEST(Agreement, OfEveryPairOnTheTurnByTheSpin) {
  const Mat3<double> R = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  const Vec3<double> plate(13 / 12., 10 / 12., 5 / 12.);
  const struct {
    const char* name;
    FreeBody body;
  } problems[] = {{"turn, A", {plate, {0.3, 2, 0.2}, R}}, {"turn, B", {plate, {5, 0.01, 0.01}, R}}, {"turn, C", {plate, {1e-6, 2, 1e-6}, R}}};
  for (const auto& p : problems) {
    const Mat3<double> closed = turn_by_spin(p.body, [&](const Vec3<P>& w) { return ThetaFlight<P>(p.body.I_B.cast<P>(), w, p.body.R_WB.cast<P>()).at(P(10)).R_WB; });
    const Mat3<double> series = turn_by_spin(p.body, [&](const Vec3<P>& w) {
      const auto law = [&](const auto&, const auto& y) { return spinning(p.body.I_B, y); };
      const std::vector<P> y = taylor<P>(law, {w[0], w[1], w[2], P(1), P(0), P(0), P(0)}, P(0), P(10), 20, 80);
      return Mat3<P>(p.body.R_WB.cast<P>() * rotation_of<P>(Vec4<P>(y[3], y[4], y[5], y[6])));
    });
    const auto cvodes = cvodes_turn_by_spin(p.body, 10, 1e-14);
    ASSERT_TRUE(cvodes);
    const auto relative = [&](const Mat3<double>& turn) {
      Numbers out;
      for (int i = 0; i < 9; ++i) out.push_back(turn(i / 3, i % 3) / closed.norm());
      return out;
    };
    compare(p.name, {{"theta 60", 1e-15, relative(closed)}, {"Jet 60", 1e-15, relative(series)}, {"CVODES", 1e-11, relative(*cvodes)}});
  }
}

// With a torque: Kovalevskaya's top (case F-06), once for numbers and once for series.
template <class T>
std::vector<T> top(const std::vector<T>& y) {
  const T &a = y[0], &b = y[1], &c = y[2], &g = y[3], &k = y[4], &l = y[5];
  return {T(0.5) * b * c, T(-0.5) * c * a + T(0.75) * l, T(-1.5) * k, k * c - l * b, l * a - g * c, g * b - k * a};
}
TEST(Agreement, OfEveryPairOnATop) {
  const Rhs f = [](double, std::span<const double> y, std::span<double> d) {
    const auto rate = top<double>({y.begin(), y.end()});
    std::copy(rate.begin(), rate.end(), d.begin());
  };
  const auto series = [](const auto&, const auto& y) { return top(y); };
  const Numbers start{0.5, -1.25, 2, 0.625, -0.375, 0.6875};
  const auto adams = cvode(f, start, 0, 4, 1e-14), bdf = cvode(f, start, 0, 4, 1e-12, Cvode::bdf), fehlberg = arkstep(f, start, 0, 4, 1e-13);
  ASSERT_TRUE(adams && bdf && fehlberg);
  const std::vector<P> precise = taylor<P>(series, {start.begin(), start.end()}, P(0), P(4), 24, 80);
  Numbers rounded;
  for (const P& x : precise) rounded.push_back(double(x));
  compare("F-06", {{"Jet 60", 2e-15, rounded},
                   {"Jet double", 1e-13, taylor<double>(series, start, 0, 4, 16, 80)},
                   {"Adams", 1e-11, adams->y},
                   {"BDF", 1e-8, bdf->y},
                   {"Fehlberg 8", 5e-12, fehlberg->y}});
}

}  // namespace
}  // namespace rigor::reference
