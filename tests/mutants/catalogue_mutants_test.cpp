#include <gtest/gtest.h>

#include <functional>
#include <rigor/contact/plane_response.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/integrators/method.hpp>
#include <tests/exact/draw.hpp>
#include <tests/mutants/matrix.hpp>

// The second block of section 5: mistakes that the conservation laws alone cannot see, each with the closed
// form that kills it. A mistake is a named variant of the product where there is one, else planted in a copy
// of the few lines concerned; the oracles do not know which ran.
namespace rigor {
namespace {

const std::vector<std::string> oracles = {"P", "L", "energy", "v' = -e v", "symmetry", "closed form"};
using Rows = std::vector<std::pair<std::string, Verdict>>;

// -- a block that strikes the ground with a slip

struct Strike {
  Body body;
  Vec3<Q> p_WC, n, t;
  Q e, mu_s, mu_d;
  Contact<Q> contact() const { return {ImpactBody<Q>{}, body.at(p_WC), n, zero3<Q>()}; }
  PairVelocity<Q> before() const { return {{}, body.velocity()}; }
  Vec3<Q> v_r() const { return relative_velocity<Q>(contact().A, contact().B, before()); }
};

/// Contact below the centre along a body axis: K has n and t as eigenvectors, so FR-09 is the closed form:
/// j = (1 + e)|v_n|/k_nn n − min(μ j_n, |v_t|/k_tt) t.
Strike straight_strike(Draw& draw, const Q& v_t) {
  Strike s{draw_body(draw), {}, {}, {}, Q(1, 2), Q(1), Q(1, 4)};
  const Mat3<Q>& R = s.body.state.R_WB;
  s.n = R.col(1), s.t = R.col(0);
  s.p_WC = s.body.state.p_WB - s.n * (s.body.shape.size()[1] / Q(2));
  s.body.state.v_WB += v_t * s.t - s.n - s.v_r();
  return s;
}

/// The oracles of a strike: momentum of the body follows the impulse; energy does not rise; Newton's law; the
/// world mirrored in the plane of n and t; the closed form.
Verdict judge(const Strike& s, const std::function<Vec3<Q>(const Strike&)>& impulse) {
  const Contact<Q> c = s.contact();
  const Vec3<Q> j = impulse(s);
  const PairVelocity<Q> after = apply_pair_impulse<Q>(c.A, c.B, s.before(), j);
  const Vec3<Q> v_before = s.v_r(), v_after = relative_velocity<Q>(c.A, c.B, after);
  const Mat3<Q> K = effective_inverse_mass<Q>(c.A, c.B);
  const Q j_n = -(Q(1) + s.e) * v_before.dot(s.n) / s.n.dot(Vec3<Q>(K * s.n));
  const Q stop = v_before.dot(s.t) / s.t.dot(Vec3<Q>(K * s.t));
  const Q friction = stop <= s.mu_s * j_n ? stop : s.mu_d * j_n;
  const Vec3<Q> dP = s.body.mass() * (after.B.v_WB - s.body.state.v_WB),
                dL = s.body.inertia() * (after.B.w_WB - s.body.state.w_WB);
  const Vec3<Q> across = cross<Q>(s.n, s.t);
  return {{"P", dP != j},
          {"L", dL != cross<Q>(c.B.p_BC_W, j)},
          {"energy", impulse_energy<Q>(j, v_before, v_after) > Q(0)},
          {"v' = -e v", v_after.dot(s.n) != -s.e * v_before.dot(s.n)},
          {"symmetry", j.dot(across) != Q(0)},
          {"closed form", j != Vec3<Q>(j_n * s.n - friction * s.t)}};  // case FR-09
}

Vec3<Q> coulomb(const Strike& s) {
  return coulomb_impulse<Q>(effective_inverse_mass<Q>(s.contact().A, s.contact().B), s.v_r(), s.n, s.t, s.e,
                            s.mu_s, s.mu_d)
      .j_W;
}

void strikes(Rows& rows) {
  Draw draw(81, 512);
  Verdict right, none, swapped, flipped;
  for (const Q& v_t : {Q(1, 8), Q(1), Q(3), Q(20)}) {  // sticks, sticks between μ_d and μ_s, slides
    const Strike s = straight_strike(draw, v_t);
    const auto add = [&s](Verdict& verdict, const std::function<Vec3<Q>(const Strike&)>& law) {
      for (const auto& [oracle, flagged] : judge(s, law)) verdict[oracle] += flagged;
    };
    add(right, coulomb);
    add(none, [](Strike x) { return x.mu_s = x.mu_d = 0, coulomb(x); });
    add(swapped,
        [](Strike x) { return std::swap(x.mu_s, x.mu_d), coulomb(x); });  // case FR-05, at one impact
    add(flipped, [](const Strike&
                        x) {  // n into the ground: the contact seems to separate, nothing is done (case P-13)
      const Surface<Q> surface = *Surface<Q>::make(x.e, x.mu_s, x.mu_d);
      Contact<Q> c = x.contact();
      c.n_AB_W = -c.n_AB_W;
      return resolve_impact<Q>(c, x.before(), surface, FrictionLaw::coulomb).report.j_W;
    });
  }
  rows.push_back({"strike: none", right});
  rows.push_back({"friction never applied", none});
  rows.push_back({"mu_s and mu_d swapped", swapped});
  rows.push_back({"normal flipped", flipped});
}

// -- flat landing on four corners

struct Landing {
  Cuboid<Q> box;
  Q e;
  std::array<Vec3<Q>, 4> arms() const {
    return {box.corner(0), box.corner(1), box.corner(5), box.corner(4)};
  }  // around the face
  ImpactBody<Q> at(const Vec3<Q>& arm) const {
    return {box.inverse_mass(), world_inverse_inertia<Q>(identity3<Q>(), box.inverse_inertia()), arm};
  }
};

using Impulses = std::array<Vec3<Q>, 4>;
const Vec3<Q> up(Q(0), Q(1), Q(0));
const Velocity<Q> falling{{Q(0), Q(-1), Q(0)}, zero3<Q>()};

Velocity<Q> after(const Landing& l, const Impulses& j) {
  Velocity<Q> u = falling;
  for (int k = 0; k < 4; ++k) u = apply_impulse<Q>(l.at(l.arms()[k]), u, j[k]);
  return u;
}

Q corner_impulse(const Landing& l, int k, const Velocity<Q>& u) {
  const ImpactBody<Q> ground, B = l.at(l.arms()[k]);
  const Q v_n = relative_velocity<Q>(ground, B, {{}, u}).dot(up);
  return v_n < Q(0) ? normal_impulse<Q>(l.e, v_n, normal_inverse_mass<Q>(ground, B, up)) : Q(0);
}

Impulses together(const Landing& l) {  // the symmetric solution of v_n' = −e v_n at all four: a quarter each
  Impulses j;
  j.fill(up * ((Q(1) + l.e) * l.box.mass() / Q(4)));
  return j;
}
Impulses one_pass(const Landing& l) {  // one corner after another, each with the velocities the others left
  Impulses j;
  j.fill(zero3<Q>());
  for (int k = 0; k < 4; ++k) j[k] = up * corner_impulse(l, k, after(l, j));
  return j;
}
Impulses full_at_each(const Landing& l) {  // the single-point impulse at all four at once
  Impulses j;
  for (int k = 0; k < 4; ++k) j[k] = up * corner_impulse(l, k, falling);
  return j;
}

Verdict judge(const Landing& l, Impulses (*solve)(const Landing&)) {
  const Impulses j = solve(l);
  const Velocity<Q> u = after(l, j);
  Vec3<Q> sum = zero3<Q>(), moment = zero3<Q>();
  bool law_broken = false;
  for (int k = 0; k < 4; ++k) {
    const Vec3<Q> arm = l.arms()[k];
    sum += j[k], moment += cross<Q>(arm, j[k]);
    law_broken = law_broken || point_velocity<Q>(u.v_WB, u.w_WB, arm).dot(up) != l.e;
  }
  const Mat3<Q> I = world_inertia<Q>(identity3<Q>(), l.box.inertia());
  const auto energy = [&](const Velocity<Q>& x) {
    return kinetic_energy<Q>(l.box.mass(), I, x.v_WB, x.w_WB);
  };
  return {{"P", l.box.mass() * (u.v_WB - falling.v_WB) != sum},
          {"L", Vec3<Q>(I * u.w_WB) != moment},
          {"energy", l.e == Q(1) ? energy(u) != energy(falling) : energy(u) > energy(falling)},
          {"v' = -e v", law_broken},
          {"symmetry", u.w_WB != zero3<Q>()},             // the landing is its own mirror image twice over
          {"closed form", u.v_WB != Vec3<Q>(up * l.e)}};  // case P-10
}

// -- a free body

/// The box of case FB-05: spin (0.1, 5, 0.1), R = 1.
struct Flight {
  Vec4<double> q{1, 0, 0, 0};
  Vec3<double> w_B{0.1, 5, 0.1};
};
const Cuboid<double> fb05 = *Cuboid<double>::make(10, {0.1, 0.4, 0.9});

/// A method in double: the rate of (q, w_B).
using Rate = Flight (*)(const Flight&);

Flight along(const Flight& x, double h, const Flight& rate) {
  return {x.q + h * rate.q, x.w_B + h * rate.w_B};
}

Vec4<double> product(const Vec4<double>& a, const Vec4<double>& b) {
  const Vec3<double> u = a.tail<3>(), v = b.tail<3>(), w = a[0] * v + b[0] * u + cross<double>(u, v);
  return {a[0] * b[0] - dot<double>(u, v), w[0], w[1], w[2]};
}

Flight euler(const Flight& x) {  // q' = q (0, w_B)/2, Euler's equation in body axes
  const Mat3<double> I = world_inertia<double>(identity3<double>(), fb05.inertia());
  const Mat3<double> inverse = world_inertia<double>(identity3<double>(), fb05.inverse_inertia());
  return {product(x.q, Vec4<double>(0, x.w_B[0], x.w_B[1], x.w_B[2])) / 2,
          angular_acceleration<double>(I, inverse, x.w_B, zero3<double>())};
}
/// Without the gyroscopic term, in world axes: ω̇ = I⁻¹τ = 0 there, and so is ω_B's rate (R turns about ω).
Flight no_gyroscopic_term(const Flight& x) { return {euler(x).q, zero3<double>()}; }
/// Passive for active: the factors of the quaternion's rate the other way round.
Flight passive(const Flight& x) {
  return {product(Vec4<double>(0, x.w_B[0], x.w_B[1], x.w_B[2]), x.q) / 2, euler(x).w_B};
}

Flight fly(Rate rate, double h) {  // RK4 to t = 10
  Flight x;
  for (int i = 0, n = int(10 / h + 0.5); i < n; ++i) {
    const Flight k1 = rate(x), k2 = rate(along(x, h / 2, k1)), k3 = rate(along(x, h / 2, k2)),
                 k4 = rate(along(x, h, k3));
    x = along(along(along(along(x, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return x;
}

Verdict judge(Rate rate) {
  const Flight end = fly(rate, 0.002), coarse = fly(rate, 0.004), start;
  // Richardson for order 4, doubled; the rounding floor of the flow near its separatrix, measured at h =
  // 0.0005: 3e-10.
  const double error = 2 * ((end.q - coarse.q).norm() + (end.w_B - coarse.w_B).norm()) / 15 + 1e-9;
  const auto L = [](const Flight& x) {
    return Vec3<double>(rotation_of<double>(x.q) * fb05.inertia().cwiseProduct(x.w_B));
  };
  const auto E = [](const Flight& x) { return x.w_B.dot(fb05.inertia().cwiseProduct(x.w_B)) / 2; };
  // Turned about the body's second axis by half a turn, the same start is the same motion: diag(−1, 1, −1).
  Flight turned = start;
  turned.w_B = {-0.1, 5, -0.1};
  const Flight step = rate(start), turned_step = rate(turned);
  const bool asymmetric =
      (turned_step.w_B - Vec3<double>(-step.w_B[0], step.w_B[1], -step.w_B[2])).norm() > 1e-12;
  const Vec3<double> w_end(2.75584040514684940571769, -3.735963519216219904337773,
                           -3.161809003467518335258115);
  const Vec4<double> q_end(0.2251645634139581639295619, -0.6199275624994524882782236,
                           -0.2770291506871945918101767, 0.6987457236403101407177716);
  return {
      {"L", (L(end) - L(start)).norm() > 10 * error},
      {"energy", std::abs(E(end) - E(start)) > 10 * error},
      {"symmetry", asymmetric},
      {"closed form", (end.w_B - w_end).norm() + std::min((end.q - q_end).norm(), (end.q + q_end).norm()) >
                          error}};  // case FB-05
}

/// Spin about a principal axis by the sheet's step, with and without its repair: ω is constant, only R can be
/// wrong.
Verdict judge_rotation(const char* method) {
  State<double> s;
  s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  s.w_WB = 2 * s.R_WB.col(2);
  const Motion start = motion_of(fb05, s);
  Motion m = start;
  for (int i = 0; i < 640; ++i) m = find_method(method)->step(fb05, m, {}, 1.0 / 64);
  const Vec3<double> L = world_inertia<double>(m.state.R_WB, fb05.inertia()) * m.state.w_WB;
  return {{"L", (L - start.L_W).norm() > 1e-10},
          {"energy", std::abs(m.state.w_WB.dot(L) - s.w_WB.dot(start.L_W)) > 1e-10},
          {"closed form", orthonormality_defect<double>(m.state.R_WB) > 1e-12}};  // case K-01
}

/// Free fall of one second: explicit and semi-implicit Euler have equal errors of opposite sign. Bounds: 3 u
/// a step on numbers below 16 (m, m/s), and 2 m g of it in the energy.
Verdict judge_fall(const char* method) {
  const double h = 1.0 / 64, g = -9.8, mass = fb05.mass();
  Motion m = motion_of(fb05, State<double>{});
  for (int i = 0; i < 64; ++i)
    m = find_method(method)->step(fb05, m, {Vec3<double>(0, mass * g, 0), zero3<double>()}, h);
  const double lead = g * h / 2, bound = 64 * 3 * 0x1p-53 * 16, y = m.state.p_WB[1], v = m.state.v_WB[1];
  return {{"P", std::abs(v - g) > bound},
          {"energy", std::abs(v * v / 2 - g * y) > std::abs(g * lead) + 20 * bound},
          {"closed form", std::abs(y - (g / 2 + lead)) > bound}};  // case D-02
}

/// A point mass dropped from height 1 on the ground, e = 3/4: handled at its time, or at the end of the step
/// in which it goes through. The oracle is the apex after the bounce, e² (case P-01), at three step sizes:
/// located impacts leave the rounding, handled late they err by order h (case P-04).
Verdict judge_bounce(bool located) {
  const double g = 9.81, e = 0.75;
  int wrong = 0, energy_rose = 0;
  for (const double h : {0.01, 0.005, 0.0025}) {
    double y = 1, v = 0, apex = 0;
    bool bounced = false;
    for (double t = 0; t < 1; t += h) {
      double left = h;
      if (located && !bounced && y + v * h - g * h * h / 2 < 0) {
        const double hit = (v + std::sqrt(v * v + 2 * g * y)) / g;
        v = -e * (v - g * hit), y = 0, left -= hit, bounced = true;
      }
      y += v * left - g * left * left / 2, v -= g * left;  // between impacts both are exact
      if (!located && y < 0 && v < 0) v = -e * v, bounced = true;
      if (bounced && v > 0) apex = std::max(apex, y + v * v / (2 * g));
      if (bounced && v < 0) break;
    }
    wrong += std::abs(apex - e * e) > 1e-12;
    energy_rose += apex > 1;
  }
  return {{"energy", energy_rose}, {"closed form", wrong}};
}

/// Quaternions read as (x, y, z, w): rotations all the same, but not the ones meant.
Verdict judge_quaternion(bool w_first) {
  const auto read = [&](const Vec4<Q>& q) {
    return rotation_of<Q>(w_first ? q : Vec4<Q>(q[3], q[0], q[1], q[2]));
  };
  int wrong = 0, no_rotation = 0;
  const Vec3<Q> x(Q(1), Q(0), Q(0)), y(Q(0), Q(1), Q(0)), z(Q(0), Q(0), Q(1));
  wrong +=
      Vec3<Q>(read({Q(1), Q(0), Q(0), Q(1)}) * x) != y;  // a quarter turn about z takes x to y: case K-04
  wrong += Vec3<Q>(read({Q(1), Q(1), Q(1), Q(1)}) * y) != z;  // a third turn about the diagonal: x → y → z
  wrong += Vec3<Q>(read({Q(1), Q(0), Q(0), Q(0)}) * y) != y;  // no turn
  no_rotation += orthonormality_defect<Q>(read({Q(1), Q(2), Q(-1), Q(3)})) != Q(0);
  return {{"symmetry", no_rotation}, {"closed form", wrong}};
}

}  // namespace

TEST(CatalogueMutants, AreEachKilledByTheirClosedForm) {
  Rows rows;
  strikes(rows);

  const Landing post{*Cuboid<Q>::make(Q(1), {Q(1), Q(3), Q(1, 2)}), Q(1)},
      cube{*Cuboid<Q>::make(Q(1), {Q(1), Q(1), Q(1)}), Q(1)};
  rows.push_back({"landing: none", judge(post, together)});
  rows.push_back({"landing: none (cube)", judge(cube, together)});
  rows.push_back({"one pass over four corners, e = 1", judge(cube, one_pass)});
  rows.push_back({"the full impulse at each of four corners", judge(post, full_at_each)});
  rows.push_back({"the full impulse at each, a cube (hidden)", judge(cube, full_at_each)});

  rows.push_back({"flight: none", judge(euler)});
  rows.push_back({"no gyroscopic term", judge(no_gyroscopic_term)});
  rows.push_back({"quaternion rate passive for active", judge(passive)});
  rows.push_back({"rotation: none", judge_rotation("sheet")});
  rows.push_back({"R + h R' without repair", judge_rotation("euler-naive")});
  rows.push_back({"fall: none", judge_fall("sheet")});
  rows.push_back({"position with the old velocity", judge_fall("explicit-euler")});
  rows.push_back({"bounce: none", judge_bounce(true)});
  rows.push_back({"impact at the end of the step", judge_bounce(false)});
  rows.push_back({"quaternion: none", judge_quaternion(true)});
  rows.push_back({"quaternion read as (x, y, z, w)", judge_quaternion(false)});

  expect_in_docs(matrix("Mistakes that conservation hides", oracles, rows));
  std::map<std::string, Verdict> by_name(rows.begin(), rows.end());
  for (const auto& [name, verdict] : rows) {
    const bool right = name.find(": none") != std::string::npos || name.find("(hidden)") != std::string::npos;
    EXPECT_EQ(killed(verdict), !right) << name;
    EXPECT_EQ(verdict.at("closed form") > 0, !right) << name;
  }
  // What the catalogue says of the others' blindness, where it says so without a reserve.
  for (const char* name : {"friction never applied", "mu_s and mu_d swapped"})
    for (const char* oracle : {"P", "L", "energy", "v' = -e v"})
      EXPECT_EQ(by_name.at(name).at(oracle), 0) << name << " by " << oracle;
  EXPECT_EQ(by_name.at("one pass over four corners, e = 1").at("energy"), 0);  // exactly: case P-11
  EXPECT_GT(by_name.at("one pass over four corners, e = 1").at("symmetry"), 0);
  EXPECT_GT(by_name.at("the full impulse at each of four corners").at("energy"), 0);
  EXPECT_EQ(by_name.at("no gyroscopic term").at("energy"), 0);  // case FB-13: energy is blind, L is not
  EXPECT_GT(by_name.at("no gyroscopic term").at("L"), 0);
  EXPECT_EQ(by_name.at("R + h R' without repair").at("L"), 0);
  EXPECT_EQ(by_name.at("position with the old velocity").at("energy"), 0);
}

// case P-11: the published numbers of one pass over a unit cube's corners.
TEST(CatalogueMutants, OnePassOverACubesCornersHasThePublishedFractions) {
  Landing cube{*Cuboid<Q>::make(Q(1), {Q(1), Q(1), Q(1)}), Q(0)};
  const Velocity<Q> soft = after(cube, one_pass(cube));
  EXPECT_EQ(soft.v_WB[1], Q(-9, 256));       // −0.03515625
  EXPECT_EQ(abs(soft.w_WB[0]), Q(69, 256));  // 0.26953125
  EXPECT_EQ(abs(soft.w_WB[2]), Q(51, 256));  // 0.19921875
  cube.e = 1;
  const Velocity<Q> hard = after(cube, one_pass(cube));
  EXPECT_EQ(hard.v_WB[1], Q(11, 16));       // 0.6875
  EXPECT_EQ(abs(hard.w_WB[0]), Q(9, 16));   // 0.5625
  EXPECT_EQ(abs(hard.w_WB[2]), Q(27, 16));  // 1.6875
}

}  // namespace rigor
