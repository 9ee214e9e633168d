#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Size of the frictionless impulse that makes the contact separate at e times its approach speed.
///
///     j = −(1 + e) v_n / k_nn,   v_n = v_r · n
///
/// shapes    scalars → scalar
/// units     1, m/s, 1/kg → N·s
/// frames    n from A to B, v_r = v_B − v_A at the contact; j ≥ 0 pushes B along +n and A along −n
/// scalars   Field: exact over ℚ
/// domain    v_n < 0 (the caller acts only on approach), k_nn > 0, 0 ≤ e ≤ 1
/// rounding  within γ₃ relative, given v_n and k_nn
/// id        impulse.normal
/// source    assignment, Part 2, with 1 + e: the sheet prints 1 − e, see reference/errata.md, erratum restitution
template <Field T>
T normal_impulse(const T& e, const T& v_n, const T& k_nn) {
  return -(T(1) + e) * v_n / k_nn;
}

/// The impulse exactly as the assignment prints it, kept to be studied and recognised, not to be used.
///
///     j = −(1 − e) v_n / k_nn,   which leaves v_n' = +e v_n: still approaching
///
/// shapes    scalars → scalar
/// units     1, m/s, 1/kg → N·s
/// frames    as normal_impulse
/// scalars   Field: exact over ℚ
/// rounding  within γ₃ relative, given v_n and k_nn
/// id        impulse.normal_printed
/// source    assignment, Part 2, verbatim; reference/errata.md, erratum restitution
template <Field T>
T normal_impulse_printed(const T& e, const T& v_n, const T& k_nn) {
  return -(T(1) - e) * v_n / k_nn;
}

}  // namespace rigor
