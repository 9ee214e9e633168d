#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <reference/sundials.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_stronge.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/verify/inputs.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {
namespace {

using In = Inputs<double>;
using V = Vec3<double>;

double relative(const V& got, const V& want, double scale) {
  return std::sqrt(dot<double>(got - want, got - want)) / scale;
}

// The volume integral of density times (y^2 + z^2, ...) by two Gauss points per axis: exact for quadratics.
double gauss_inertia(const In& in) {
  V sum = zero3<double>();
  for (int k = 0; k < 8; ++k) {
    V x;
    for (int i = 0; i < 3; ++i) x[i] = (k >> i & 1 ? 0.5 : -0.5) * in.s_B[i] / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i) sum[i] += in.m / 8 * (dot<double>(x, x) - x[i] * x[i]);
  }
  return relative(in.I_B, sum, norm<double>(sum));
}

// Eight point masses with the cuboid's mass and moments: at (+-c_i s_i / (2 sqrt 3)). A rigid body is its points; sums
// over them share no formula with the tensor calculus they are compared with.
struct Points {
  double m;
  V at[8];  // arms in world axes
};
Points points_of(const In& in) {
  Points p{in.m / 8, {}};
  for (int k = 0; k < 8; ++k) {
    V x;
    for (int i = 0; i < 3; ++i) x[i] = (k >> i & 1 ? 0.5 : -0.5) * in.s_B[i] / std::sqrt(3.0);
    p.at[k] = in.R_WB * x;
  }
  return p;
}
double scalar(double got, double want, double scale) { return std::fabs(got - want) / scale; }

double world_tensor(const In& in) {
  const Points p = points_of(in);
  Mat3<double> sum = zero33<double>();
  for (const V& r : p.at) sum += p.m * (dot<double>(r, r) * identity3<double>() - r * r.transpose());
  return (in.I_B_W - sum).norm() / sum.norm();
}
// I^-1 applied to a vector against Gaussian elimination on the summed tensor.
double world_inverse(const In& in) {
  const V back = apply<double>(in.inverse_I_B_W, apply<double>(in.I_B_W, in.w_WB));
  return relative(back, in.w_WB, norm<double>(in.w_WB));
}
double kinetic(const In& in) {
  const Points p = points_of(in);
  double sum = 0;
  for (const V& r : p.at) {
    const V v = in.v_WB + in.w_WB.cross(r);
    sum += p.m * v.dot(v) / 2;
  }
  return scalar(kinetic_energy<double>(in.m, in.I_B_W, in.v_WB, in.w_WB), sum, sum);
}
double linear(const In& in) {
  const Points p = points_of(in);
  V sum = zero3<double>();
  for (const V& r : p.at) sum += p.m * (in.v_WB + in.w_WB.cross(r));
  return relative(linear_momentum<double>(in.m, in.v_WB), sum, in.m * (norm<double>(in.v_WB) + norm<double>(in.w_WB) * norm<double>(in.s_B)));
}
double angular(const In& in) {
  const Points p = points_of(in);
  V sum = zero3<double>();
  for (const V& r : p.at) sum += V(in.p_WB + r - in.p_WO).cross(V(p.m * (in.v_WB + in.w_WB.cross(r))));
  const double scale = in.m * norm<double>(V(in.p_WB - in.p_WO)) * norm<double>(in.v_WB) + in.I_B.maxCoeff() * norm<double>(in.w_WB);
  return relative(angular_momentum<double>(in.m, in.I_B_W, in.p_WB, in.v_WB, in.w_WB, in.p_WO), sum, scale);
}
// A material point's velocity by the central difference of its path under the exponential map.
double point_path(const In& in) {
  const double h = 1e-5;
  const auto at = [&](double t) { return V(in.p_WB + t * in.v_WB + exp_so3<double>(V(t * in.w_WB)) * in.p_BC_W); };
  const V difference = (at(h) - at(-h)) / (2 * h);
  return relative(point_velocity<double>(in.v_WB, in.w_WB, in.p_BC_W), difference, norm<double>(in.v_WB) + norm<double>(in.w_WB) * norm<double>(in.p_BC_W));
}
double rotation_path(const In& in) {
  const double h = 1e-5;
  const Mat3<double> difference = (exp_so3<double>(V(h * in.w_WB)) - exp_so3<double>(V(-h * in.w_WB))) * in.R_WB / (2 * h);
  return (rotation_rate<double>(in.w_WB, in.R_WB) - difference).norm() / (1 + norm<double>(in.w_WB));
}
double naive_path(const In& in) {  // its error against the exponential map is (h w)^2/2 to leading order
  const double h = in.h / 64, theta = h * norm<double>(in.w_WB);
  const Mat3<double> exact = exp_so3<double>(V(h * in.w_WB)) * in.R_WB;
  return (naive_rotation_step<double>(h, in.w_WB, in.R_WB) - exact).norm() / (theta * theta);
}
// Polar decomposition by Newton's iteration: another orthonormalisation, equal to zeroth order: the two differ
// by at most the input's distance from a rotation, times a small factor.
double polar(const In& in) {
  Mat3<double> X = in.M;
  for (int i = 0; i < 20; ++i) {
    const V a = X.col(0), b = X.col(1), c = X.col(2);
    Mat3<double> inverse_transposed;
    const double det = a.dot(b.cross(c));
    inverse_transposed.col(0) = b.cross(c) / det, inverse_transposed.col(1) = c.cross(a) / det, inverse_transposed.col(2) = a.cross(b) / det;
    X = (X + inverse_transposed) / 2;
  }
  return (gram_schmidt<double>(in.M) - X).norm() / (in.M - in.R_WB).norm();
}
// L' = torque for the body as points: the rate of w that makes the points' angular momentum change by the torque.
double euler(const In& in) {
  const Points p = points_of(in);
  const V alpha = angular_acceleration<double>(in.I_B_W, in.inverse_I_B_W, in.w_WB, in.tau_W);
  V rate = zero3<double>();  // sum of r x m a, a = alpha x r + w x (w x r)
  for (const V& r : p.at) rate += r.cross(V(p.m * (alpha.cross(r) + in.w_WB.cross(V(in.w_WB.cross(r))))));
  return relative(rate, in.tau_W, norm<double>(in.tau_W) + in.I_B.maxCoeff() * in.w_WB.dot(in.w_WB));
}
double newton(const In& in) {
  return relative(in.m * linear_acceleration<double>(in.A.inverse_mass, in.f_W), in.f_W, norm<double>(in.f_W));
}
double torque(const In& in) {  // by the determinant rule, component by component
  V t;
  for (int i = 0; i < 3; ++i) {
    Mat3<double> D;
    D.col(0) = V::Unit(i), D.col(1) = in.p_BC_W, D.col(2) = in.f_W;
    t[i] = D.determinant();
  }
  return relative(torque_of_force<double>(in.p_BC_W, in.f_W), t, norm<double>(in.p_BC_W) * norm<double>(in.f_W));
}
double force_sum(const In& in) {
  const Wrench<double> sum = add_force<double>({in.tau_W, in.j_W}, in.p_BC_W, in.f_W);
  const V t = in.j_W + in.p_BC_W.cross(in.f_W);
  return relative(sum.tau_W, t, norm<double>(t) + norm<double>(in.p_BC_W) * norm<double>(in.f_W)) + relative(sum.f_W, V(in.tau_W + in.f_W), norm<double>(in.f_W));
}
// The impulse by solving momentum balance and the restitution law together, thirteen unknowns, by Eigen's LU.
PairVelocity<double> by_balance(const In& in) {
  Eigen::Matrix<double, 13, 13> S = Eigen::Matrix<double, 13, 13>::Zero();
  Eigen::Matrix<double, 13, 1> b = Eigen::Matrix<double, 13, 1>::Zero();
  const auto side = [&](int at, const ImpactBody<double>& body, const Velocity<double>& u, double sign) {
    S.block<6, 6>(at, at).setIdentity();
    S.block<3, 1>(at, 12) = -sign * body.inverse_mass * in.n_W;
    S.block<3, 1>(at + 3, 12) = -sign * body.inverse_I_B_W * body.p_BC_W.cross(in.n_W);
    b.segment<3>(at) = u.v_WB, b.segment<3>(at + 3) = u.w_WB;
    S.block<1, 3>(12, at) = sign * in.n_W.transpose();
    S.block<1, 3>(12, at + 3) = sign * body.p_BC_W.cross(in.n_W).transpose();
  };
  side(0, in.A, in.u.A, -1);
  side(6, in.B, in.u.B, 1);
  b[12] = -in.e * relative_velocity<double>(in.A, in.B, in.u).dot(in.n_W);
  const Eigen::Matrix<double, 13, 1> x = S.fullPivLu().solve(b);
  return {{x.segment<3>(0), x.segment<3>(3)}, {x.segment<3>(6), x.segment<3>(9)}};
}
double size_of(const PairVelocity<double>& u) { return norm<double>(u.A.v_WB) + norm<double>(u.A.w_WB) + norm<double>(u.B.v_WB) + norm<double>(u.B.w_WB); }
double distance(const PairVelocity<double>& a, const PairVelocity<double>& b) {
  return (norm<double>(V(a.A.v_WB - b.A.v_WB)) + norm<double>(V(a.A.w_WB - b.A.w_WB)) + norm<double>(V(a.B.v_WB - b.B.v_WB)) + norm<double>(V(a.B.w_WB - b.B.w_WB))) /
         (size_of(a) + size_of(b));
}
double impulse(const In& in) {
  const double v_n = relative_velocity<double>(in.A, in.B, in.u).dot(in.n_W);
  const double j = normal_impulse<double>(in.e, v_n, normal_inverse_mass<double>(in.A, in.B, in.n_W));
  return distance(apply_pair_impulse<double>(in.A, in.B, in.u, V(j * in.n_W)), by_balance(in));
}
double printed(const In& in) {  // what it leaves: the restitution law with the wrong sign, by the same balance
  In wrong = in;
  wrong.e = -in.e;
  const double v_n = relative_velocity<double>(in.A, in.B, in.u).dot(in.n_W);
  const double j = normal_impulse_printed<double>(in.e, v_n, normal_inverse_mass<double>(in.A, in.B, in.n_W));
  return distance(apply_pair_impulse<double>(in.A, in.B, in.u, V(j * in.n_W)), by_balance(wrong));
}
double effective_mass(const In& in) {  // the matrix form 1/m - [r] I^-1 [r]
  const auto term = [](const ImpactBody<double>& b) {
    const Mat3<double> r = skew<double>(b.p_BC_W);
    return Mat3<double>(b.inverse_mass * identity3<double>() - r * b.inverse_I_B_W * r);
  };
  const Mat3<double> K = term(in.A) + term(in.B);
  return (effective_inverse_mass<double>(in.A, in.B) - K).norm() / K.norm();
}
double normal_mass(const In& in) {  // the response of the normal speed to a small impulse
  const double j = 1, before = relative_velocity<double>(in.A, in.B, in.u).dot(in.n_W);
  const double after = relative_velocity<double>(in.A, in.B, apply_pair_impulse<double>(in.A, in.B, in.u, V(j * in.n_W))).dot(in.n_W);
  const double k = normal_inverse_mass<double>(in.A, in.B, in.n_W);
  return scalar(k, (after - before) / j, k + std::fabs(before));
}
double impulse_work(const In& in) {  // half the sum of the points' kinetic energies before and after, for body A alone
  const Points p = points_of(in);
  const Velocity<double> before{in.v_WB, in.w_WB}, after = apply_impulse<double>(in.A, before, in.j_W);
  const auto energy = [&](const Velocity<double>& u) {
    double sum = 0;
    for (const V& r : p.at) sum += p.m / 2 * V(u.v_WB + u.w_WB.cross(r)).squaredNorm();
    return sum;
  };
  const V v0 = point_velocity<double>(before.v_WB, before.w_WB, in.A.p_BC_W), v1 = point_velocity<double>(after.v_WB, after.w_WB, in.A.p_BC_W);
  return scalar(impulse_energy<double>(in.j_W, v0, v1), energy(after) - energy(before), energy(after) + energy(before));
}
double tangent(const In& in) {  // double cross product: n x (v x n)
  V t = in.n_W.cross(V(in.v_WB.cross(in.n_W)));
  return norm<double>(V(friction_tangent<double>(in.v_WB, in.f_W, in.n_W) - t / t.norm())) * t.norm() / in.v_WB.norm();
}
double correction(const In& in) { return std::fabs(positional_correction<double>(in.m, in.n_W).norm() - in.m) / in.m; }
double sheet(const In& in) {  // a point mass on a plane: the impulse that stops it, or the friction of a pushed block
  const double slip = norm<double>(in.v_WB), j_r = norm<double>(in.j_W);
  const double stop = in.m * slip, want = stop <= in.e * j_r ? stop : in.mu * j_r;
  return scalar(sheet_friction_impulse<double>(in.m, in.e, in.mu, j_r, slip), want, stop + j_r);
}
double literal(const In& in) { return scalar(sheet_literal_friction_impulse<double>(in.mu, in.m, 1), in.mu * in.m, in.m); }

// A contact that approaches, with its slip.
struct Meeting {
  Mat3<double> K;
  V v, n;
};
Meeting meeting(const In& in) {
  Meeting m{effective_inverse_mass<double>(in.A, in.B), relative_velocity<double>(in.A, in.B, in.u), in.n_W};
  if (m.v.dot(m.n) > 0) m.v = -m.v;
  return m;
}
// Coulomb's two laws, read off the answer: the restitution law, and either no slip at the end or the cone's edge.
double coulomb(const In& in) {
  const Meeting m = meeting(in);
  const V t = friction_tangent<double>(m.v, zero3<double>(), m.n);
  const double mu = 0.8 * in.mu;
  const auto answer = coulomb_impulse<double>(m.K, m.v, m.n, t, in.e, in.mu, mu);
  const V after = m.v + m.K * answer.j_W;
  double off = std::fabs(after.dot(m.n) + in.e * m.v.dot(m.n));
  if (in.mu > 0 && answer.outcome == FrictionOutcome::stuck) off += V(after - after.dot(m.n) * m.n).norm();
  const double scale = m.K.norm() * answer.j_W.norm() + m.v.norm();
  return off / scale / m.K.norm() * V(m.K.diagonal()).minCoeff();
}
// The planar closed form against the three-dimensional process, on a contact whose K does not couple out of the plane.
double stronge(const In& in) {
  const double k_nn = 1 + in.m, k_tt = 1 + in.m_B, k_tn = 0.9 * (in.e - 0.5) * std::sqrt(k_nn * k_tt);
  Mat3<double> K;
  K << k_tt, k_tn, 0, k_tn, k_nn, 0, 0, 0, 2;
  const V v(1 + std::fabs(in.v_WB[0]), -1 - std::fabs(in.v_WB[1]), 0);
  const auto process = stronge_impulse(K, v, V(0, 1, 0), in.e, in.mu, 0.8 * in.mu);
  const auto planar = planar_impulse<double>({k_nn, k_tt, k_tn, v[1], v[0], in.e, in.mu, 0.8 * in.mu}, Restitution::stronge);
  return std::hypot(process.j_W[0] - planar.j_t, process.j_W[1] - planar.j_n) / process.j_W.norm();
}
// One step of the assignment's method against CVODE over the same time: the local error is of order h^2.
double step(const In& in) {
  const Cuboid<double> body = *Cuboid<double>::make(in.m, in.s_B);
  const double h = in.h / 16;
  const State<double> s{in.p_WB, in.R_WB, in.v_WB, in.w_WB};
  const V alpha = angular_acceleration<double>(in.I_B_W, in.inverse_I_B_W, in.w_WB, zero3<double>());
  const State<double> next = semi_implicit_step<double>(h, s, zero3<double>(), alpha);
  const auto exact = reference::cvode_free_body({body.inertia(), apply_transposed<double>(in.R_WB, in.w_WB), in.R_WB}, h, 1e-13);
  promise(bool(exact), "CVODE solves a free body over one step");
  const double w = norm<double>(in.w_WB) + norm<double>(alpha);
  return angle_between<double>(next.R_WB, exact->R_WB) / (h * h * (w + w * w));
}

struct Row {
  const char *id, *oracle;
  double bound;
  double (*distance)(const In&);
};

constexpr double u = 0x1p-53;
// Bounds: 64 u where both sides are a few dozen roundings of sums without cancellation (the worst of the default run: 9 u); a central
// difference at h = 1e-5 has h^2 |w|^3/6 + u/h, below 1e-8; the rest says so.
const Row rows[] = {
    {"contact.correction", "its length is the depth, relative", 64 * u, correction},
    {"energy.impulse", "kinetic energy of eight point masses before and after, relative", 64 * u, impulse_work},
    {"energy.kinetic", "sum over eight point masses, relative", 64 * u, kinetic},
    {"force.sum", "library cross product, relative", 64 * u, force_sum},
    {"force.torque", "determinants, relative", 64 * u, torque},
    {"friction.coulomb", "restitution law and no slip where stuck, read off the answer, relative to kappa(K)", 1e-14, coulomb},
    {"friction.sheet", "point mass: what stops it, relative", 64 * u, sheet},
    {"friction.sheet_literal", "mu_d j_r, relative", 64 * u, literal},
    {"friction.stronge", "Routh's closed form in the plane, relative (the process has tolerance 1e-13 a step)", 1e-11, stronge},
    {"friction.stronge_planar", "the three-dimensional process, relative (tolerance 1e-13 a step)", 1e-11, stronge},
    {"friction.tangent", "n x (v x n), relative", 64 * u, tangent},
    {"impulse.apply", "kinetic energy of eight point masses before and after, relative", 64 * u, impulse_work},
    {"impulse.apply_pair", "momentum balance and restitution law solved together by LU, relative", 1e-14, impulse},
    {"impulse.effective_mass", "matrix form with [r]x, relative", 64 * u, effective_mass},
    {"impulse.normal", "momentum balance and restitution law solved together by LU, relative", 1e-14, impulse},
    {"impulse.normal_effective_mass", "response of the normal speed to a unit impulse, relative", 64 * u, normal_mass},
    {"impulse.normal_printed", "the same balance with +e in the restitution law, relative", 1e-14, printed},
    {"impulse.relative_velocity", "momentum balance and restitution law solved together by LU, relative", 1e-14, impulse},
    {"inertia.cuboid", "Gauss product rule, two points per axis, relative", gamma_bound(16), gauss_inertia},
    {"inertia.cuboid_inverse", "world inverse undoes the world tensor, relative (kappa below 100)", 1e-14, world_inverse},
    {"inertia.world", "sum over eight point masses, relative", 64 * u, world_tensor},
    {"inertia.world_inverse", "undoes the world tensor, relative (kappa below 100)", 1e-14, world_inverse},
    {"momentum.angular", "sum over eight point masses, relative", 64 * u, angular},
    {"momentum.linear", "sum over eight point masses, relative", 64 * u, linear},
    {"motion.euler", "d'Alembert over eight point masses, relative", 1e-14, euler},
    {"motion.linear", "m a = f, relative", 64 * u, newton},
    {"motion.point_velocity", "central difference of the point's path, relative", 1e-8, point_path},
    {"rotation.gram_schmidt", "polar decomposition, distance over the input's error", 2, polar},
    {"rotation.naive_step", "exponential map, distance over (h w)^2", 1, naive_path},
    {"rotation.rate", "central difference of the exponential map, relative", 1e-8, rotation_path},
    {"step.semi_implicit", "CVODE over one step, error over h^2 (w + w^2)", 2, step},
};

}  // namespace

std::vector<Agreement> agreements(const std::string& only, long cases, std::uint64_t seed) {
  std::vector<Agreement> results;
  for (const Row& row : rows) {
    if (!only.empty() && only != row.id) continue;
    Agreement result{row.id, row.oracle, 0, row.bound, 0};
    Random random(seed);
    for (long c = 0; c < cases && interrupted() == 0; ++c) {
      const double distance = row.distance(draw<double>(random));
      if (!(distance <= result.worst)) result.worst = distance;  // keeps NaN, which then is not ok
      ++result.cases;
    }
    results.push_back(result);
  }
  return results;
}

}  // namespace rigor::verify
