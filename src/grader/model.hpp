#pragma once
#include <rigor/grader/protocol.hpp>
#include <rigor/grader/worker.hpp>
#include <rigor/linalg/types.hpp>

namespace rigor::grader {

/// How a model student writes each term of the assignment. The defaults are right; a misconception sets one of them
/// (misconceptions.cpp). The judge uses the model to choose inputs that show every mistake, to name the mistake behind
/// a wrong answer, and to audit itself; expected values come from src/formulas, not from here.
struct Habits {
  // computeBodyCoordsMOI
  double inertia_factor = 1.0 / 12;
  double extent_factor = 1;                  // 0.5: half extents
  bool mass_in_inertia = true;
  enum class Moments { two_others, own_edge, cyclic_1, cyclic_2, swap_xy, sum_of_all, cube_of_width } moments = Moments::two_others;
  double product_of_inertia = 0;             // off-diagonal, as a multiple of m w h / 12
  enum class BodyInverse { inverse, unfilled, same_as_tensor, transpose } body_inverse = BodyInverse::inverse;

  // computeWorldCoordsMOI and its inverse
  enum class WorldForm { rirt, rtir, ri, irt, body, other } world = WorldForm::rirt, world_inverse = WorldForm::rirt;
  bool inverse_elementwise = false, inverse_of_diagonal = false;

  // applyForce
  double force_factor = 1, torque_factor = 1;  // torque −1: F × r
  bool force_summed = true, torque_summed = true;
  bool force_over_mass = false;
  enum class Arm { centre, origin, body, plus_centre } arm = Arm::centre;

  // update
  double step_factor = 1;                      // of delta, everywhere
  double move_factor = 1, turn_factor = 1, accelerate_factor = 1, spin_up_factor = 1;  // 0: not advanced; −1: reversed
  int dt_power_position = 1, dt_power_velocity = 1, dt_power_spin = 1, dt_power_rotation = 1;
  bool mass_in_acceleration = true;
  double gyroscopic = 1;
  bool gyroscopic_in_body_tensor = false;
  enum class Torque { inverse_world, inverse_body, world, none } torque = Torque::inverse_world;
  bool rotate_on_the_right = false;            // R [w] dt
  double spin_unit = 1;                        // π/180: degrees
  bool uses_delta_t = false;                   // the constant instead of the argument
  bool clears_force = true, clears_torque = true;
  double keep_velocity = 1, keep_spin = 1;     // damping per step
  enum class Repair { gram_schmidt, rows, polar, exponential, quaternion, none } repair = Repair::gram_schmidt;
  bool old_velocity = false, old_spin = false; // explicit Euler
  bool midpoint = false;                       // position with the mean of old and new velocity

  // frictionTangent
  bool tangent_projected = true, tangent_normalised = true, tangent_of_centre = false, force_first = false, force_fallback = true;
  double tangent_factor = 1;

  // applyCollisionResponse
  bool tests_collision = true, tests_approach = true;
  enum class Correction { deepest, mean, along_y, none, each_corner } correction = Correction::deepest;
  double correction_factor = 1;
  bool contact_before_push = false;            // the corner where it was before the push-out, the centre where it is after
  enum class Corners { in_order, reversed, deepest, mean } corners = Corners::in_order;

  // the impulse itself, plane and pair
  struct Impulse {
    enum class Restitution { derived, printed, ignored, one } restitution = Restitution::derived;
    double sign = 1;                           // of the normal impulse as applied
    bool centre_velocity = false;              // relative velocity of centres instead of contact points
    double spin_sign = 1;                      // v + w × r; −1: r × w
    enum class Arm { world, zero, body, position } arm = Arm::world;
    bool inertia_in_denominator = true;
    double denominator_inertia_factor = 1;
    enum class Tensor { world_inverse, body_inverse, world, none } tensor = Tensor::world_inverse;
    bool divides_by_mass = true;
    double angular = 1;                        // 0: no spin from the impulse; −1: wrong sign
  } plane, pair;

  // friction of the plane
  enum class Friction { sheet, literal, effective_mass, coulomb, none, unlimited } friction = Friction::sheet;
  double friction_sign = 1;
  bool friction_before = false;                // slip taken before the normal impulse
  bool mu_swapped = false, mu_times_impulse = true, friction_turns = true, friction_moves = true, friction_over_mass = true;

  // applyCollisionImpulse only
  bool first_body = true, second_body = true;  // receives its impulse
  bool first_spins = true, second_spins = true;
  bool masses_swapped = false, one_arm = false, relative_reversed = false, same_direction = false;
  enum class Tensors { own, swapped, first, second } tensors = Tensors::own;  // whose inertia: each its own, ... the first's for both

  /// What no habit above expresses: changes the answer of a student who is right otherwise (own.cpp).
  void (*besides)(const Constants&, const Request&, Reply&) = nullptr;
};

/// What a student with these habits would answer. Never fails; numbers may be nonsense, as a student's may.
Reply model_answer(const Habits& habits, const Constants& constants, const Request& request);

}  // namespace rigor::grader
