#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// The shift that takes the deepest point of a body out of a half-space, and does nothing else.
///
///     Δp = depth · n,   depth = max(0, deepest penetration)
///
/// shapes    scalar, (3) → (3)
/// units     m → m
/// frames    world axes; n points to the free side
/// scalars   Field: exact over ℚ
/// domain    n a unit vector; depth ≤ 0 means no contact and gives exactly 0
/// rounding  each component within u
/// id        contact.correction
/// source    assignment, Part 2 (b); derivation in proofs/contact.md. It changes the potential energy by m g·Δp,
///           which goes into the ledger (reference/errata.md, point 7)
template <Field T>
Vec3<T> positional_correction(const T& depth, const Vec3<T>& n_W) {
  if (!(depth > T(0))) return zero3<T>();
  return Vec3<T>(depth * n_W[0], depth * n_W[1], depth * n_W[2]);
}

}  // namespace rigor
