#pragma once
#include <cmath>
#include <rigor/base/outcome.hpp>
#include <rigor/linalg/types.hpp>

namespace rigor {

/// An immovable half-space: a point on its boundary and the unit normal towards the free side, world axes.
template <Field T>
class Plane {
 public:
  /// Fault names "point[i]" or "normal"; the normal must have unit length within 1e-9 (an input written with nine
  /// or more digits passes) and is kept as given, not repaired.
  static Outcome<Plane> make(const Vec3<T>& point_W, const Vec3<T>& n_W) {
    using Kind = Fault::Kind;
    if constexpr (std::floating_point<T>) {
      for (int i = 0; i < 3; ++i)
        if (!std::isfinite(point_W[i]))
          return Fault{Kind::not_finite, "point[" + std::to_string(i) + "]", "is not finite"};
      for (int i = 0; i < 3; ++i)
        if (!std::isfinite(n_W[i]))
          return Fault{Kind::not_finite, "normal[" + std::to_string(i) + "]", "is not finite"};
    }
    const T off = dot<T>(n_W, n_W) - T(1), bound = T(2) / T(1000000000);
    if (!(off <= bound && -off <= bound)) return Fault{Kind::not_unit, "normal", "must have length 1 within 1e-9"};
    return Plane(point_W, n_W);
  }

  const Vec3<T>& point() const { return point_; }
  const Vec3<T>& normal() const { return normal_; }

  /// Signed distance of a point, > 0 on the free side.
  T gap(const Vec3<T>& p_W) const {
    return dot<T>(Vec3<T>(p_W[0] - point_[0], p_W[1] - point_[1], p_W[2] - point_[2]), normal_);
  }

 private:
  Plane(const Vec3<T>& point_W, const Vec3<T>& n_W) : point_(point_W), normal_(n_W) {}
  Vec3<T> point_, normal_;
};

}  // namespace rigor
