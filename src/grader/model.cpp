#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/grader/model.hpp>
#include <rigor/grader/records.hpp>
#include <rigor/linalg/rotation.hpp>
#include <vector>

namespace rigor::grader {
namespace {

using V = Vec3<double>;
using M = Mat3<double>;

void body_inertia(const Habits& h, BodyRecord& b) {
  V s = h.extent_factor * vec(b.size);
  const double m = h.mass_in_inertia ? b.mass : 1, k = h.inertia_factor * m;
  const V square = s.cwiseProduct(s), others(square[1] + square[2], square[0] + square[2], square[0] + square[1]);
  V I = others;
  switch (h.moments) {
    case Habits::Moments::two_others: break;
    case Habits::Moments::own_edge: I = square; break;
    case Habits::Moments::cyclic_1: I = V(others[1], others[2], others[0]); break;
    case Habits::Moments::cyclic_2: I = V(others[2], others[0], others[1]); break;
    case Habits::Moments::swap_xy: I = V(others[1], others[0], others[2]); break;
    case Habits::Moments::sum_of_all: I = V::Constant(square.sum()); break;
    case Habits::Moments::cube_of_width: I = V::Constant(2 * square[0]); break;
  }
  M tensor = (k * I).asDiagonal();
  const double product = h.product_of_inertia * m * s[0] * s[1] / 12;
  tensor(0, 1) = tensor(1, 0) = -product;
  put(b.body_inertia, tensor);
  switch (h.body_inverse) {
    case Habits::BodyInverse::inverse: put(b.body_inverse_inertia, M(tensor.inverse())); break;
    case Habits::BodyInverse::unfilled: put(b.body_inverse_inertia, M(M::Zero())); break;
    case Habits::BodyInverse::same_as_tensor: put(b.body_inverse_inertia, tensor); break;
    case Habits::BodyInverse::transpose: put(b.body_inverse_inertia, M(tensor.transpose())); break;
  }
}

M world_form(Habits::WorldForm form, const M& R, const M& tensor, const M& other) {
  switch (form) {
    case Habits::WorldForm::rirt: return R * tensor * R.transpose();
    case Habits::WorldForm::rtir: return R.transpose() * tensor * R;
    case Habits::WorldForm::ri: return R * tensor;
    case Habits::WorldForm::irt: return tensor * R.transpose();
    case Habits::WorldForm::body: return tensor;
    case Habits::WorldForm::other: return R * other * R.transpose();
  }
  return tensor;
}
M world(const Habits& h, const BodyRecord& b) {
  return world_form(h.world, mat(b.rotation), mat(b.body_inertia), mat(b.body_inverse_inertia));
}
M world_inverse(const Habits& h, const BodyRecord& b) {
  if (h.inverse_of_diagonal) return world(h, b).diagonal().cwiseInverse().asDiagonal();
  if (h.inverse_elementwise) return world(h, b).cwiseInverse();
  return world_form(h.world_inverse, mat(b.rotation), mat(b.body_inverse_inertia), mat(b.body_inertia));
}

void apply_force(const Habits& h, BodyRecord& b, const V& point, const V& f) {
  const V centre = vec(b.position);
  const M R = mat(b.rotation);
  V arm = point - centre;
  if (h.arm == Habits::Arm::origin) arm = point;
  if (h.arm == Habits::Arm::body) arm = R.transpose() * arm;
  if (h.arm == Habits::Arm::plus_centre) arm = point + centre;
  const V force = h.force_factor * (h.force_over_mass ? V(f / b.mass) : f), torque = h.torque_factor * arm.cross(f);
  put(b.net_force, V((h.force_summed ? vec(b.net_force) : zero3<double>()) + force));
  put(b.net_torque, V((h.torque_summed ? vec(b.net_torque) : zero3<double>()) + torque));
}

M turned(const Habits& h, const M& R, const V& w, double dt) {
  const V theta = h.turn_factor * h.spin_unit * std::pow(dt, h.dt_power_rotation) * w;
  if (h.repair == Habits::Repair::exponential || h.repair == Habits::Repair::quaternion) {
    if (h.repair == Habits::Repair::exponential)
      return h.rotate_on_the_right ? M(R * exp_so3<double>(theta)) : M(exp_so3<double>(theta) * R);
    Eigen::Quaterniond q(R), rate(0, theta[0], theta[1], theta[2]);
    const Eigen::Quaterniond d = h.rotate_on_the_right ? q * rate : rate * q;
    q.coeffs() += 0.5 * d.coeffs();
    return q.normalized().toRotationMatrix();
  }
  const M naive = h.rotate_on_the_right ? M(R + R * skew<double>(theta)) : M(R + skew<double>(theta) * R);
  switch (h.repair) {
    case Habits::Repair::gram_schmidt: return gram_schmidt<double>(naive);
    case Habits::Repair::rows: return gram_schmidt<double>(M(naive.transpose())).transpose();
    case Habits::Repair::polar: {
      const Eigen::JacobiSVD<M> svd(naive, Eigen::ComputeFullU | Eigen::ComputeFullV);
      return svd.matrixU() * svd.matrixV().transpose();
    }
    default: return naive;
  }
}

void update(const Habits& h, const Constants& constants, BodyRecord& b, double delta) {
  const double dt = h.step_factor * (h.uses_delta_t ? constants.delta_t : delta);
  const auto step = [&](int power) { return std::pow(dt, power); };
  const V v = vec(b.velocity), w = vec(b.spin), tau = vec(b.net_torque);
  const M R = mat(b.rotation);
  const M inertia = h.gyroscopic_in_body_tensor ? mat(b.body_inertia) : world(h, b);
  M inverse = world_inverse(h, b);
  if (h.torque == Habits::Torque::inverse_body) inverse = mat(b.body_inverse_inertia);
  if (h.torque == Habits::Torque::world) inverse = inertia;
  if (h.torque == Habits::Torque::none) inverse = M::Identity();
  const V a = vec(b.net_force) / (h.mass_in_acceleration ? b.mass : 1);
  const V alpha = inverse * (tau - h.gyroscopic * w.cross(inertia * w));
  const V v_new = h.keep_velocity * (v + h.accelerate_factor * step(h.dt_power_velocity) * a);
  const V w_new = h.keep_spin * (w + h.spin_up_factor * step(h.dt_power_spin) * alpha);
  const V carry = h.midpoint ? V((v + v_new) / 2) : h.old_velocity ? v : v_new;
  put(b.position, V(vec(b.position) + h.move_factor * step(h.dt_power_position) * carry));
  put(b.rotation, turned(h, R, h.old_spin ? w : w_new, dt));
  put(b.velocity, v_new);
  put(b.spin, w_new);
  if (h.clears_force) put(b.net_force, zero3<double>());
  if (h.clears_torque) put(b.net_torque, zero3<double>());
}

V tangent(const Habits& h, const BodyRecord& b, const V& n, const V& point) {
  const V spin_part = vec(b.spin).cross(point - vec(b.position));
  const V slip = vec(b.velocity) + (h.tangent_of_centre ? zero3<double>() : spin_part);
  const auto project = [&](const V& a) { return h.tangent_projected ? V(a - a.dot(n) * n) : a; };
  const V of_slip = project(slip), of_force = project(vec(b.net_force));
  V t = of_slip;
  if (h.force_first && of_force.norm() > 1e-9) t = of_force;
  if (t.norm() < 1e-9) t = h.force_fallback ? of_force : zero3<double>();
  if (t.norm() < 1e-9) return zero3<double>();
  return h.tangent_factor * (h.tangent_normalised ? V(t / t.norm()) : t);
}

// One side's arm and tensor as the student takes them.
struct Side {
  V arm;
  M inverse;
  double inverse_mass;
};
Side side_of(const Habits& h, const Habits::Impulse& law, const BodyRecord& b, const V& point) {
  const M R = mat(b.rotation);
  V arm = point - vec(b.position);
  switch (law.arm) {
    case Habits::Impulse::Arm::world: break;
    case Habits::Impulse::Arm::zero: arm = zero3<double>(); break;
    case Habits::Impulse::Arm::body: arm = R.transpose() * arm; break;
    case Habits::Impulse::Arm::position: arm = point; break;
  }
  M inverse = world_inverse(h, b);
  if (law.tensor == Habits::Impulse::Tensor::body_inverse) inverse = mat(b.body_inverse_inertia);
  if (law.tensor == Habits::Impulse::Tensor::world) inverse = world(h, b);
  if (law.tensor == Habits::Impulse::Tensor::none) inverse = M::Identity();
  return {arm, inverse, 1 / b.mass};
}
double restitution_factor(const Habits::Impulse& law, double e) {
  switch (law.restitution) {
    case Habits::Impulse::Restitution::derived: return 1 + e;
    case Habits::Impulse::Restitution::printed: return 1 - e;
    case Habits::Impulse::Restitution::ignored: return 1;
    case Habits::Impulse::Restitution::one: return 2;
  }
  return 1 + e;
}
double angular_term(const Habits::Impulse& law, const Side& s, const V& n) {
  return law.inertia_in_denominator ? law.denominator_inertia_factor * (s.inverse * s.arm.cross(n)).cross(s.arm).dot(n) : 0;
}
V contact_velocity(const Habits::Impulse& law, const BodyRecord& b, const V& arm) {
  return vec(b.velocity) + (law.centre_velocity ? zero3<double>() : V(law.spin_sign * vec(b.spin).cross(arm)));
}
void push(const Habits::Impulse& law, const Side& s, BodyRecord& b, const V& j, double spin_factor, bool moves = true) {
  if (moves) put(b.velocity, V(vec(b.velocity) + (law.divides_by_mass ? s.inverse_mass : 1) * j));
  put(b.spin, V(vec(b.spin) + spin_factor * law.angular * (s.inverse * s.arm.cross(j))));
}

// One contact of the plane: normal impulse, then friction.
void plane_contact(const Habits& h, const Constants& k, BodyRecord& b, const V& n, const V& point) {
  const Side s = side_of(h, h.plane, b, point);
  const V v_before = contact_velocity(h.plane, b, s.arm);
  const double v_n = v_before.dot(n);
  if (h.tests_approach && v_n >= 0) return;
  const V t_before = tangent(h, b, n, point);
  const double k_nn = s.inverse_mass + angular_term(h.plane, s, n);
  const double j = h.plane.sign * -restitution_factor(h.plane, k.restitution) * v_n / k_nn;
  push(h.plane, s, b, V(j * n), 1);

  if (h.friction == Habits::Friction::none) return;
  const V t = h.friction_before ? t_before : tangent(h, b, n, point);
  const double slip = (h.tangent_factor < 0 ? -1 : 1) * (h.friction_before ? v_before : contact_velocity(h.plane, b, s.arm)).dot(t);
  const double mu_s = h.mu_swapped ? k.dynamic_friction : k.static_friction;
  const double mu_d = h.mu_swapped ? k.static_friction : k.dynamic_friction;
  const double unit = h.mu_times_impulse ? j : 1;
  const double k_tt = s.inverse_mass + (s.inverse * s.arm.cross(t)).cross(s.arm).dot(t);
  double stopping = slip * b.mass;
  if (h.friction == Habits::Friction::effective_mass || h.friction == Habits::Friction::coulomb) stopping = slip / k_tt;
  double j_f = stopping <= mu_s * unit ? stopping : mu_d * unit;
  if (h.friction == Habits::Friction::literal) j_f = slip > 0 ? mu_d * unit : 0;
  if (h.friction == Habits::Friction::unlimited) j_f = stopping;
  const V direction = -h.friction_sign * t;
  Habits::Impulse law = h.plane;
  law.divides_by_mass = h.plane.divides_by_mass && h.friction_over_mass;
  push(law, s, b, V(j_f * direction), h.friction_turns ? 1 : 0, h.friction_moves);
}

void plane_response(const Habits& h, const Constants& k, BodyRecord& b, const V& p, const V& n) {
  const V half = vec(b.size) / 2;
  const M R = mat(b.rotation);
  std::vector<V> arms;
  std::vector<double> depth;
  for (int c = 0; c < 8; ++c) {
    const V arm = R * V(c & 1 ? half[0] : -half[0], c & 2 ? half[1] : -half[1], c & 4 ? half[2] : -half[2]);
    const double d = -(vec(b.position) + arm - p).dot(n);
    if (d > 0 || !h.tests_collision) arms.push_back(arm), depth.push_back(d);
  }
  if (arms.empty()) return;
  const std::size_t deepest = std::size_t(std::max_element(depth.begin(), depth.end()) - depth.begin());
  double shift = depth[deepest];
  if (h.correction == Habits::Correction::mean || h.correction == Habits::Correction::each_corner) {
    shift = 0;
    for (const double d : depth) shift += d;
    if (h.correction == Habits::Correction::mean) shift /= double(depth.size());
  }
  if (h.correction == Habits::Correction::none) shift = 0;
  const V along = h.correction == Habits::Correction::along_y ? V(0, 1, 0) : n;
  const V before = vec(b.position);
  put(b.position, V(before + h.correction_factor * shift * along));
  const V centre = h.contact_before_push ? before : vec(b.position);
  if (h.corners == Habits::Corners::deepest) return plane_contact(h, k, b, n, V(centre + arms[deepest]));
  if (h.corners == Habits::Corners::mean) {
    V mean = zero3<double>();
    for (const V& a : arms) mean += a / double(arms.size());
    return plane_contact(h, k, b, n, V(centre + mean));
  }
  if (h.corners == Habits::Corners::reversed) std::reverse(arms.begin(), arms.end());
  for (const V& a : arms) plane_contact(h, k, b, n, V(centre + a));
}

void pair_response(const Habits& h, const Constants& k, BodyRecord& a, BodyRecord& b, const V& point, const V& n) {
  Side A = side_of(h, h.pair, a, point), B = side_of(h, h.pair, b, point);
  if (h.one_arm) B.arm = A.arm;
  if (h.masses_swapped) std::swap(A.inverse_mass, B.inverse_mass);
  if (h.tensors == Habits::Tensors::swapped) std::swap(A.inverse, B.inverse);
  if (h.tensors == Habits::Tensors::first) B.inverse = A.inverse;
  if (h.tensors == Habits::Tensors::second) A.inverse = B.inverse;
  V v_r = contact_velocity(h.pair, b, B.arm) - contact_velocity(h.pair, a, A.arm);
  if (h.relative_reversed) v_r = -v_r;
  const double v_n = v_r.dot(n);
  if (h.tests_approach && (h.relative_reversed ? -v_n : v_n) >= 0) return;
  const double k_nn = A.inverse_mass + B.inverse_mass + angular_term(h.pair, A, n) + angular_term(h.pair, B, n);
  const V j = h.pair.sign * -restitution_factor(h.pair, k.restitution) * v_n / k_nn * n;
  if (h.first_body) push(h.pair, A, a, h.same_direction ? j : V(-j), h.first_spins ? 1 : 0);
  if (h.second_body) push(h.pair, B, b, j, h.second_spins ? 1 : 0);
}

}  // namespace

Reply model_answer(const Habits& h, const Constants& k, const Request& q) {
  Reply r{};
  r.magic = reply_magic;
  r.serial = q.serial;
  r.A = q.A;
  r.B = q.B;
  if ((q.flags & want_helpers) != 0) {
    for (auto [helpers, body] : {std::pair{&r.A_helpers, &q.A}, std::pair{&r.B_helpers, &q.B}}) {
      put(helpers->world_inertia, world(h, *body));
      put(helpers->world_inverse_inertia, world_inverse(h, *body));
    }
    put(r.vector, tangent(h, q.A, vec(q.plane_normal), vec(q.point)));
  }
  switch (Function(q.function)) {
    case Function::body_inertia: body_inertia(h, r.A); break;
    case Function::world_inertia:
      put(r.world_inertia, world(h, q.A));
      put(r.world_inverse_inertia, world_inverse(h, q.A));
      break;
    case Function::apply_force: apply_force(h, r.A, vec(q.point), vec(q.vector)); break;
    case Function::update:
      for (std::uint32_t i = 0; i < q.count; ++i) {
        if ((q.flags & hold_forces) != 0 && i > 0) {
          put(r.A.net_force, vec(q.A.net_force));
          put(r.A.net_torque, vec(q.A.net_torque));
        }
        update(h, k, r.A, q.h);
      }
      break;
    case Function::friction_tangent: put(r.vector, tangent(h, q.A, vec(q.plane_normal), vec(q.point))); break;
    case Function::plane_response: plane_response(h, k, r.A, vec(q.plane_point), vec(q.plane_normal)); break;
    case Function::pair_response: pair_response(h, k, r.A, r.B, vec(q.point), vec(q.vector)); break;
    case Function::scene_steps: r.scene[3] = 1; break;  // the model has no scene of its own: judged on real submissions
    case Function::constants:
      r.constants[0] = k.restitution, r.constants[1] = k.static_friction;
      r.constants[2] = k.dynamic_friction, r.constants[3] = k.delta_t;
      break;
  }
  if (h.besides != nullptr) h.besides(k, q, r);
  return r;
}

}  // namespace rigor::grader
