#include <rigor/base/promise.hpp>
#include <rigor/grader/misconceptions.hpp>

namespace rigor::grader {

using F = StudentFunction;
using H = Habits;

// To add one: a row here; if no habit can express it, a habit in model.hpp and its place in model.cpp.
namespace {

std::vector<Misconception> known_misconceptions() {
  return {
      // computeBodyCoordsMOI
      {"moi.no-twelfth", F::body_inertia, "inertia.cuboid", "the factor 1/12 is missing", [](H& h) { h.inertia_factor = 1; }},
      {"moi.sixth", F::body_inertia, "inertia.cuboid", "the factor is 1/6 instead of 1/12", [](H& h) { h.inertia_factor = 1.0 / 6; }},
      {"moi.third", F::body_inertia, "inertia.cuboid", "the factor is 1/3 (right for half extents), with full extents, or the extents are doubled", [](H& h) { h.inertia_factor = 1.0 / 3; }},
      {"moi.double-extents", F::body_inertia, "inertia.cuboid", "the extents are doubled", [](H& h) { h.extent_factor = 2; }, "moi.third"},
      {"moi.half-extents", F::body_inertia, "inertia.cuboid", "half extents are used where the formula takes full ones", [](H& h) { h.extent_factor = 0.5; }},
      {"moi.no-mass", F::body_inertia, "inertia.cuboid", "the mass is missing", [](H& h) { h.mass_in_inertia = false; }},
      {"moi.own-edge", F::body_inertia, "inertia.cuboid", "each axis uses its own edge instead of the other two", [](H& h) { h.moments = H::Moments::own_edge; }},
      {"moi.axes-cycled", F::body_inertia, "inertia.cuboid", "the three moments sit on the wrong axes (cycled once)", [](H& h) { h.moments = H::Moments::cyclic_1; }},
      {"moi.axes-cycled-back", F::body_inertia, "inertia.cuboid", "the three moments sit on the wrong axes (cycled back)", [](H& h) { h.moments = H::Moments::cyclic_2; }},
      {"moi.axes-swapped", F::body_inertia, "inertia.cuboid", "the moments of the x and y axes are exchanged", [](H& h) { h.moments = H::Moments::swap_xy; }},
      {"moi.sphere", F::body_inertia, "inertia.cuboid", "all three moments are the same", [](H& h) { h.moments = H::Moments::sum_of_all; }},
      {"moi.cube", F::body_inertia, "inertia.cuboid", "the formula of a cube with the width for every edge", [](H& h) { h.moments = H::Moments::cube_of_width; }},
      {"moi.products", F::body_inertia, "inertia.cuboid", "there are products of inertia off the diagonal", [](H& h) { h.product_of_inertia = 1; }},
      {"moi.inverse-missing", F::body_inertia, "inertia.cuboid_inverse", "the inverse tensor is not filled", [](H& h) { h.body_inverse = H::BodyInverse::unfilled; }},
      {"moi.inverse-is-tensor", F::body_inertia, "inertia.cuboid_inverse", "the inverse field holds the tensor itself", [](H& h) { h.body_inverse = H::BodyInverse::same_as_tensor; }},
      // world inertia
      {"world.transposed", F::world_inertia, "inertia.world", "R^T I R instead of R I R^T", [](H& h) { h.world = H::WorldForm::rtir; }},
      {"world.no-right-factor", F::world_inertia, "inertia.world", "R I without R^T on the right", [](H& h) { h.world = H::WorldForm::ri; }},
      {"world.no-left-factor", F::world_inertia, "inertia.world", "I R^T without R on the left", [](H& h) { h.world = H::WorldForm::irt; }},
      {"world.body", F::world_inertia, "inertia.world", "the body tensor is returned as it is", [](H& h) { h.world = H::WorldForm::body; }},
      {"world.inverse-instead", F::world_inertia, "inertia.world", "the inverse tensor is turned instead of the tensor", [](H& h) { h.world = H::WorldForm::other; }},
      {"world-inverse.transposed", F::world_inverse_inertia, "inertia.world_inverse", "R^T I^-1 R instead of R I^-1 R^T", [](H& h) { h.world_inverse = H::WorldForm::rtir; }},
      {"world-inverse.no-right-factor", F::world_inverse_inertia, "inertia.world_inverse", "R I^-1 without R^T on the right", [](H& h) { h.world_inverse = H::WorldForm::ri; }},
      {"world-inverse.no-left-factor", F::world_inverse_inertia, "inertia.world_inverse", "I^-1 R^T without R on the left", [](H& h) { h.world_inverse = H::WorldForm::irt; }},
      {"world-inverse.body", F::world_inverse_inertia, "inertia.world_inverse", "the body inverse is returned as it is", [](H& h) { h.world_inverse = H::WorldForm::body; }},
      {"world-inverse.tensor-instead", F::world_inverse_inertia, "inertia.world_inverse", "the tensor is turned instead of its inverse", [](H& h) { h.world_inverse = H::WorldForm::other; }},
      {"world-inverse.elementwise", F::world_inverse_inertia, "inertia.world_inverse", "each entry is inverted instead of the matrix", [](H& h) { h.inverse_elementwise = true; }},
      {"world-inverse.of-diagonal", F::world_inverse_inertia, "inertia.world_inverse", "the diagonal of the world tensor is inverted and the rest left zero", [](H& h) { h.inverse_of_diagonal = true; }},
      // applyForce
      {"force.torque-reversed", F::apply_force, "force.torque", "the torque is F x r instead of r x F", [](H& h) { h.torque_factor = -1; }},
      {"force.arm-from-origin", F::apply_force, "force.torque", "the arm is the world position, not the offset from the centre of mass", [](H& h) { h.arm = H::Arm::origin; }},
      {"force.arm-in-body", F::apply_force, "force.torque", "the arm is turned into body axes while the force stays in world axes", [](H& h) { h.arm = H::Arm::body; }},
      {"force.arm-plus-centre", F::apply_force, "force.torque", "the centre is added to the point instead of subtracted", [](H& h) { h.arm = H::Arm::plus_centre; }},
      {"force.overwritten", F::apply_force, "force.sum", "the net force is overwritten instead of summed", [](H& h) { h.force_summed = false; }},
      {"force.torque-overwritten", F::apply_force, "force.sum", "the net torque is overwritten instead of summed", [](H& h) { h.torque_summed = false; }},
      {"force.no-torque", F::apply_force, "force.torque", "the force gives no torque", [](H& h) { h.torque_factor = 0; }},
      {"force.no-force", F::apply_force, "force.sum", "the force is not added", [](H& h) { h.force_factor = 0; }},
      {"force.over-mass", F::apply_force, "force.sum", "the force is divided by the mass already here", [](H& h) { h.force_over_mass = true; }},
      {"force.reversed", F::apply_force, "force.sum", "the force is subtracted", [](H& h) { h.force_factor = -1; }},
      // update
      {"update.position-stays", F::update, "step.semi_implicit", "the position is not advanced", [](H& h) { h.move_factor = 0; }},
      {"update.rotation-stays", F::update, "rotation.rate", "the rotation is not advanced", [](H& h) { h.turn_factor = 0; }},
      {"update.velocity-stays", F::update, "motion.linear", "the velocity is not advanced", [](H& h) { h.accelerate_factor = 0; }},
      {"update.spin-stays", F::update, "motion.euler", "the angular velocity is not advanced", [](H& h) { h.spin_up_factor = 0; }},
      {"update.no-mass", F::update, "motion.linear", "the force is not divided by the mass", [](H& h) { h.mass_in_acceleration = false; }},
      {"update.dt-missing-position", F::update, "step.semi_implicit", "dt is missing in the position", [](H& h) { h.dt_power_position = 0; }},
      {"update.dt-missing-velocity", F::update, "motion.linear", "dt is missing in the velocity", [](H& h) { h.dt_power_velocity = 0; }},
      {"update.dt-missing-spin", F::update, "motion.euler", "dt is missing in the angular velocity", [](H& h) { h.dt_power_spin = 0; }},
      {"update.dt-missing-rotation", F::update, "rotation.rate", "dt is missing in the rotation", [](H& h) { h.dt_power_rotation = 0; }},
      {"update.dt-squared-position", F::update, "step.semi_implicit", "dt is squared in the position", [](H& h) { h.dt_power_position = 2; }},
      {"update.dt-squared-rotation", F::update, "rotation.rate", "dt is squared in the rotation", [](H& h) { h.dt_power_rotation = 2; }},
      {"update.no-gyroscopic", F::update, "motion.euler", "the term w x (I w) is missing", [](H& h) { h.gyroscopic = 0; }},
      {"update.gyroscopic-sign", F::update, "motion.euler", "the term w x (I w) has the wrong sign", [](H& h) { h.gyroscopic = -1; }},
      {"update.gyroscopic-body", F::update, "motion.euler", "w x (I w) uses the body tensor with world components", [](H& h) { h.gyroscopic_in_body_tensor = true; }},
      {"update.inverse-body", F::update, "motion.euler", "the body inverse is used with world components", [](H& h) { h.torque = H::Torque::inverse_body; }},
      {"update.inertia-not-inverted", F::update, "motion.euler", "the inertia multiplies the torque instead of its inverse", [](H& h) { h.torque = H::Torque::world; }},
      {"update.no-inertia", F::update, "motion.euler", "the torque is not divided by any inertia", [](H& h) { h.torque = H::Torque::none; }},
      {"update.rotation-right", F::update, "rotation.rate", "the rotation is multiplied on the wrong side: R [w] instead of [w] R", [](H& h) { h.rotate_on_the_right = true; }},
      {"update.rotation-reversed", F::update, "rotation.rate", "the rotation turns backwards", [](H& h) { h.turn_factor = -1; }},
      {"update.half-rotation", F::update, "rotation.rate", "the rotation turns at half the rate", [](H& h) { h.turn_factor = 0.5; }},
      {"update.half-step", F::update, "step.semi_implicit", "everything is advanced by half of delta", [](H& h) { h.step_factor = 0.5; }},
      {"update.degrees", F::update, "rotation.rate", "the angular velocity is taken as degrees per second", [](H& h) { h.spin_unit = 3.14159265358979323846 / 180; }},
      {"update.keeps-force", F::update, "step.semi_implicit", "the net force is not cleared afterwards", [](H& h) { h.clears_force = false; }},
      {"update.keeps-torque", F::update, "step.semi_implicit", "the net torque is not cleared afterwards", [](H& h) { h.clears_torque = false; }},
      {"update.not-orthonormal", F::update, "rotation.gram_schmidt", "the rotation matrix is not orthonormalised", [](H& h) { h.repair = H::Repair::none; }},
      {"update.damps-velocity", F::update, "motion.linear", "the velocity is damped by a constant factor each step", [](H& h) { h.keep_velocity = 0.99; }},
      {"update.damps-spin", F::update, "motion.euler", "the angular velocity is damped by a constant factor each step", [](H& h) { h.keep_spin = 0.99; }},
      // frictionTangent
      {"tangent.not-normalised", F::friction_tangent, "friction.tangent", "the tangent is not normalised", [](H& h) { h.tangent_normalised = false; }},
      {"tangent.not-projected", F::friction_tangent, "friction.tangent", "the normal component is not removed", [](H& h) { h.tangent_projected = false; }},
      {"tangent.of-centre", F::friction_tangent, "friction.tangent", "the velocity of the centre is used instead of the contact point's", [](H& h) { h.tangent_of_centre = true; }},
      {"tangent.force-first", F::friction_tangent, "friction.tangent", "the net force is used although there is slip", [](H& h) { h.force_first = true; }},
      {"tangent.no-fallback", F::friction_tangent, "friction.tangent", "without slip the net force is not looked at", [](H& h) { h.force_fallback = false; }},
      // applyCollisionResponse, normal
      {"plane.no-collision-test", F::plane_response, "impulse.normal", "a cuboid clear of the plane is pushed as well", [](H& h) { h.tests_collision = false; h.corners = H::Corners::deepest; }},
      {"plane.printed-restitution", F::plane_response, "impulse.normal", "the impulse has the printed -(1 - e); derived is -(1 + e), see rigor explain impulse.normal", [](H& h) { h.plane.restitution = H::Impulse::Restitution::printed; }},
      {"plane.restitution-ignored", F::plane_response, "impulse.normal", "the coefficient of restitution is not used", [](H& h) { h.plane.restitution = H::Impulse::Restitution::ignored; }},
      {"plane.restitution-one", F::plane_response, "impulse.normal", "the bounce is always fully elastic", [](H& h) { h.plane.restitution = H::Impulse::Restitution::one; }},
      {"plane.normal-sign", F::plane_response, "impulse.apply", "the normal impulse pushes into the plane (or the contact velocity is reversed)", [](H& h) { h.plane.sign = -1; }},
      {"plane.velocity-reversed", F::plane_response, "impulse.normal", "the contact velocity is the plane's as seen from the body, with the other's sign in the impulse", [](H& h) { h.plane.sign = -1; }, "plane.normal-sign"},
      {"plane.centre-velocity", F::plane_response, "motion.point_velocity", "the velocity of the centre is used instead of the contact point's", [](H& h) { h.plane.centre_velocity = true; }},
      {"plane.spin-sign", F::plane_response, "motion.point_velocity", "the contact velocity is v - w x r", [](H& h) { h.plane.spin_sign = -1; }},
      {"plane.no-arm", F::plane_response, "impulse.apply", "the arm from the centre of mass is taken as zero", [](H& h) { h.plane.arm = H::Impulse::Arm::zero; }},
      {"plane.arm-in-body", F::plane_response, "impulse.apply", "the arm is turned into body axes", [](H& h) { h.plane.arm = H::Impulse::Arm::body; }},
      {"plane.arm-from-origin", F::plane_response, "impulse.apply", "the arm is the world position of the contact", [](H& h) { h.plane.arm = H::Impulse::Arm::position; }},
      {"plane.no-inertia-term", F::plane_response, "impulse.normal_effective_mass", "the denominator lacks the inertia term", [](H& h) { h.plane.inertia_in_denominator = false; }},
      {"plane.inverse-body", F::plane_response, "inertia.world_inverse", "the body inverse inertia is used with world vectors", [](H& h) { h.plane.tensor = H::Impulse::Tensor::body_inverse; }},
      {"plane.inertia-not-inverted", F::plane_response, "inertia.world_inverse", "the inertia is used where its inverse belongs", [](H& h) { h.plane.tensor = H::Impulse::Tensor::world; }},
      {"plane.not-over-mass", F::plane_response, "impulse.apply", "the impulse is added to the velocity without dividing by the mass", [](H& h) { h.plane.divides_by_mass = false; }},
      {"plane.no-spin", F::plane_response, "impulse.apply", "the impulse does not change the angular velocity", [](H& h) { h.plane.angular = 0; }},
      {"plane.spin-reversed", F::plane_response, "impulse.apply", "the change of angular velocity has the wrong sign", [](H& h) { h.plane.angular = -1; }},
      {"plane.correction-missing", F::plane_response, "contact.correction", "the body is not pushed out of the plane", [](H& h) { h.correction = H::Correction::none; }},
      {"plane.correction-along-y", F::plane_response, "contact.correction", "the body is pushed along y, whatever the plane's normal", [](H& h) { h.correction = H::Correction::along_y; }},
      {"plane.correction-doubled", F::plane_response, "contact.correction", "the body is pushed out twice as far as it should", [](H& h) { h.correction_factor = 2; }},
      {"plane.correction-half", F::plane_response, "contact.correction", "the body is pushed out half as far as it should", [](H& h) { h.correction_factor = 0.5; }},
      {"plane.correction-mean", F::plane_response, "contact.correction", "the mean penetration is corrected, which leaves the deepest corner behind", [](H& h) { h.correction = H::Correction::mean; }},
      {"plane.correction-inwards", F::plane_response, "contact.correction", "the body is pushed further in", [](H& h) { h.correction_factor = -1; }},
      // friction
      {"friction.missing", F::plane_response, "friction.sheet", "there is no friction", [](H& h) { h.friction = H::Friction::none; }},
      {"friction.reversed", F::plane_response, "friction.sheet", "friction pushes along the slip instead of against it", [](H& h) { h.friction_sign = -1; }},
      {"friction.unlimited", F::plane_response, "friction.sheet", "friction always stops the slip, whatever the normal impulse", [](H& h) { h.friction = H::Friction::unlimited; }},
      {"friction.mu-swapped", F::plane_response, "friction.sheet", "static and dynamic coefficients are exchanged", [](H& h) { h.mu_swapped = true; }},
      {"friction.no-turn", F::plane_response, "friction.sheet", "friction does not change the angular velocity", [](H& h) { h.friction_turns = false; }},
      {"friction.spin-only", F::plane_response, "friction.sheet", "friction changes the angular velocity only", [](H& h) { h.friction_moves = false; }},
      {"friction.contact-before-push", F::plane_response, "friction.sheet", "the contact point is where the corner was before the body was pushed out, its centre where it is afterwards", [](H& h) { h.contact_before_push = true; }},
      {"friction.bare-coefficients", F::plane_response, "friction.sheet", "j_s and j_d are the bare coefficients; they are mu_s j_r and mu_d j_r", [](H& h) { h.mu_times_impulse = false; }},
      {"friction.not-over-mass", F::plane_response, "friction.sheet", "the friction impulse is not divided by the mass", [](H& h) { h.friction_over_mass = false; }},
      // applyCollisionImpulse
      {"pair.printed-restitution", F::pair_response, "impulse.normal", "the impulse has the printed -(1 - e); derived is -(1 + e), see rigor explain impulse.normal", [](H& h) { h.pair.restitution = H::Impulse::Restitution::printed; }},
      {"pair.restitution-ignored", F::pair_response, "impulse.normal", "the coefficient of restitution is not used", [](H& h) { h.pair.restitution = H::Impulse::Restitution::ignored; }},
      {"pair.restitution-one", F::pair_response, "impulse.normal", "the bounce is always fully elastic", [](H& h) { h.pair.restitution = H::Impulse::Restitution::one; }},
      {"pair.signs-reversed", F::pair_response, "impulse.apply_pair", "both impulses have the wrong sign (or the relative velocity is reversed)", [](H& h) { h.pair.sign = -1; }},
      {"pair.relative-reversed", F::pair_response, "impulse.relative_velocity", "the relative velocity is that of the first body as seen from the second", [](H& h) { h.relative_reversed = true; }, "pair.signs-reversed"},
      {"pair.first-only", F::pair_response, "impulse.apply_pair", "only the first body receives its impulse", [](H& h) { h.second_body = false; }},
      {"pair.second-only", F::pair_response, "impulse.apply_pair", "only the second body receives its impulse", [](H& h) { h.first_body = false; }},
      {"pair.same-direction", F::pair_response, "impulse.apply_pair", "both bodies are pushed the same way", [](H& h) { h.same_direction = true; }},
      {"pair.masses-swapped", F::pair_response, "impulse.apply_pair", "the two masses are exchanged", [](H& h) { h.masses_swapped = true; }},
      {"pair.tensors-swapped", F::pair_response, "impulse.apply_pair", "the two inertias are exchanged", [](H& h) { h.tensors = H::Tensors::swapped; }},
      {"pair.first-tensor", F::pair_response, "impulse.apply_pair", "the first body's inertia is used for both", [](H& h) { h.tensors = H::Tensors::first; }},
      {"pair.second-tensor", F::pair_response, "impulse.apply_pair", "the second body's inertia is used for both", [](H& h) { h.tensors = H::Tensors::second; }},
      {"pair.one-arm", F::pair_response, "impulse.apply_pair", "the first body's arm is used for both", [](H& h) { h.one_arm = true; }},
      {"pair.first-no-spin", F::pair_response, "impulse.apply_pair", "the first body's angular velocity is left as it was", [](H& h) { h.first_spins = false; }},
      {"pair.second-no-spin", F::pair_response, "impulse.apply_pair", "the second body's angular velocity is left as it was", [](H& h) { h.second_spins = false; }},
      {"pair.no-spin", F::pair_response, "impulse.apply_pair", "the impulse does not change any angular velocity", [](H& h) { h.pair.angular = 0; }},
      {"pair.spin-reversed", F::pair_response, "impulse.apply_pair", "the changes of angular velocity have the wrong sign", [](H& h) { h.pair.angular = -1; }},
      {"pair.centre-velocity", F::pair_response, "impulse.relative_velocity", "the velocities of the centres are used instead of the contact point's", [](H& h) { h.pair.centre_velocity = true; }},
      {"pair.spin-sign", F::pair_response, "impulse.relative_velocity", "the contact velocity is v - w x r", [](H& h) { h.pair.spin_sign = -1; }},
      {"pair.no-arm", F::pair_response, "impulse.apply_pair", "the arms from the centres of mass are taken as zero", [](H& h) { h.pair.arm = H::Impulse::Arm::zero; }},
      {"pair.arm-in-body", F::pair_response, "impulse.apply_pair", "the arms are turned into body axes", [](H& h) { h.pair.arm = H::Impulse::Arm::body; }},
      {"pair.arm-from-origin", F::pair_response, "impulse.apply_pair", "the arm is the world position of the contact", [](H& h) { h.pair.arm = H::Impulse::Arm::position; }},
      {"pair.no-inertia-term", F::pair_response, "impulse.normal_effective_mass", "the denominator lacks the inertia terms", [](H& h) { h.pair.inertia_in_denominator = false; }},
      {"pair.inverse-body", F::pair_response, "inertia.world_inverse", "the body inverse inertia is used with world vectors", [](H& h) { h.pair.tensor = H::Impulse::Tensor::body_inverse; }},
      {"pair.inertia-not-inverted", F::pair_response, "inertia.world_inverse", "the inertia is used where its inverse belongs", [](H& h) { h.pair.tensor = H::Impulse::Tensor::world; }},
      {"pair.not-over-mass", F::pair_response, "impulse.apply_pair", "the impulse is added to the velocities without dividing by the mass", [](H& h) { h.pair.divides_by_mass = false; }},
  };
}

}  // namespace

const std::vector<Misconception>& misconceptions() {
  static const std::vector<Misconception> all = [] {
    std::vector<Misconception> list = known_misconceptions();
    for (Misconception& own : own_misconceptions()) list.push_back(std::move(own));
    return list;
  }();
  return all;
}

const std::vector<Misconception>& variants() {
  static const std::vector<Misconception> rows{
      {"explicit-position", F::update, "step.semi_implicit", "position from the old velocity (explicit Euler)", [](H& h) { h.old_velocity = true; }},
      {"midpoint-position", F::update, "step.semi_implicit", "position from the mean of old and new velocity", [](H& h) { h.midpoint = true; }},
      {"old-spin", F::update, "rotation.rate", "rotation from the old angular velocity", [](H& h) { h.old_spin = true; }},
      {"rows", F::update, "rotation.gram_schmidt", "Gram-Schmidt on rows", [](H& h) { h.repair = H::Repair::rows; }},
      {"polar", F::update, "rotation.gram_schmidt", "polar decomposition", [](H& h) { h.repair = H::Repair::polar; }},
      {"exponential", F::update, "rotation.rate", "exponential map", [](H& h) { h.repair = H::Repair::exponential; }},
      {"quaternion", F::update, "rotation.rate", "normalised quaternion", [](H& h) { h.repair = H::Repair::quaternion; }},
      {"uses-delta-t", F::update, "step.semi_implicit", "DELTA_T instead of the argument (the same value in every call here)", [](H& h) { h.uses_delta_t = true; }},
      {"tangent-against-slip", F::friction_tangent, "friction.tangent", "tangent against the slip", [](H& h) { h.tangent_factor = -1; h.friction_sign = -1; }},
      {"no-approach-test", F::plane_response, "impulse.normal", "no test whether the contact approaches", [](H& h) { h.tests_approach = false; }},
      {"corners-reversed", F::plane_response, "impulse.apply", "corners in another order", [](H& h) { h.corners = H::Corners::reversed; }},
      {"deepest-corner", F::plane_response, "impulse.apply", "only the deepest corner is resolved", [](H& h) { h.corners = H::Corners::deepest; }},
      {"mean-contact", F::plane_response, "impulse.apply", "one contact at the mean of the corners", [](H& h) { h.corners = H::Corners::mean; }},
      {"correction-each-corner", F::plane_response, "contact.correction", "pushed out by the sum of the corners' depths, further than the deepest needs", [](H& h) { h.correction = H::Correction::each_corner; }},
      {"friction-before", F::plane_response, "friction.sheet", "slip taken before the normal impulse", [](H& h) { h.friction_before = true; }},
      {"friction-effective-mass", F::plane_response, "friction.coulomb", "friction with the tangential effective mass", [](H& h) { h.friction = H::Friction::effective_mass; }},
      {"friction-literal", F::plane_response, "friction.sheet_literal", "literal friction rule: every slip slides", [](H& h) { h.friction = H::Friction::literal; }},
  };
  return rows;
}

const std::vector<std::string>& refusable_readings() {
  static const std::vector<std::string> ids{"friction-literal", "friction-effective-mass", "tangent-against-slip"};
  return ids;
}

const Misconception* find_misconception(const std::string& id) {
  for (const auto* list : {&misconceptions(), &variants()})
    for (const Misconception& row : *list)
      if (row.id == id) return &row;
  return nullptr;
}

Habits habits_with(const std::string& ids) {
  Habits habits;
  for (std::size_t start = 0; start < ids.size();) {
    const std::size_t end = std::min(ids.find('+', start), ids.size());
    const Misconception* row = find_misconception(ids.substr(start, end - start));
    promise(row != nullptr, "a claimed misconception exists");
    row->set(habits);
    start = end + 1;
  }
  return habits;
}

}  // namespace rigor::grader
