#pragma once
#include <array>
#include <rigor/collision/box_plane.hpp>
#include <rigor/contact/impact.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>

namespace rigor {

/// The state after a plane's response, and what each corner did.
template <Field T>
struct PlaneResponse {
  State<T> after;
  Vec3<T> shift = zero3<T>();               ///< positional correction, m
  int corners = 0;                          ///< corners behind the plane
  std::array<ImpactReport<T>, 8> reports;   ///< by corner index; `separating` where nothing was done
};

/// What the assignment's program does with one cuboid and one plane: push the body out along the normal by the
/// deepest penetration, once; then one corner after another, in index order, of those found behind the plane: if it
/// approaches, its impulse by the chosen law, with the velocities the corners before it left.
///
/// Several corners at once are not solved together; the order matters (P-11). The arms are those of the pose found,
/// which the shift does not change.
///
/// frames    world axes; the plane is side A, immovable
template <Field T>
PlaneResponse<T> respond_to_plane(const Cuboid<T>& box, const State<T>& s, const Plane<T>& plane, const Surface<T>& surface,
                                  FrictionLaw law, const Vec3<T>& f_B_W = zero3<T>()) {
  PlaneResponse<T> response{s, zero3<T>(), 0, {}};
  const BoxPlane<T> found = box_plane<T>(box, s, plane);
  if (!found.touches()) return response;
  response.corners = found.behind;
  response.shift = positional_correction<T>(found.depth(), plane.normal());
  for (int i = 0; i < 3; ++i) response.after.p_WB[i] = s.p_WB[i] + response.shift[i];

  Contact<T> contact{{}, {box.inverse_mass(), world_inverse_inertia<T>(s.R_WB, box.inverse_inertia()), {}}, plane.normal(), f_B_W};
  PairVelocity<T> u{{}, {s.v_WB, s.w_WB}};
  for (int k = 0; k < 8; ++k) {
    if (!(found.gap[k] < T(0))) continue;
    contact.B.p_BC_W = found.p_BC_W[k];
    const ImpactResult<T> result = resolve_impact<T>(contact, u, surface, law);
    u = result.after;
    response.reports[k] = result.report;
  }
  response.after.v_WB = u.B.v_WB;
  response.after.w_WB = u.B.w_WB;
  return response;
}

}  // namespace rigor
