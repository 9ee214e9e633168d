#pragma once
#include <cmath>
#include <rigor/base/outcome.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <string>

namespace rigor {

/// A homogeneous cuboid: mass and full edge lengths, with what follows from them. A Cuboid cannot be invalid.
template <Field T>
class Cuboid {
 public:
  /// units kg, m. Fault (not_finite, not_positive, out_of_range) names "mass" or "size[i]"; out_of_range when a
  /// moment of inertia or its inverse would overflow or vanish.
  static Outcome<Cuboid> make(const T& mass, const Vec3<T>& s_B) {
    using Kind = Fault::Kind;
    const auto check = [](const T& x, const std::string& where) -> Outcome<bool> {
      if (!finite(x)) return Fault{Kind::not_finite, where, "is not finite, must be a number > 0"};
      if (!(x > T(0))) return Fault{Kind::not_positive, where, "must be > 0"};
      return true;
    };
    if (const auto ok = check(mass, "mass"); !ok) return ok.fault();
    for (int i = 0; i < 3; ++i)
      if (const auto ok = check(s_B[i], "size[" + std::to_string(i) + "]"); !ok) return ok.fault();
    const Cuboid made(mass, s_B);
    for (int i = 0; i < 3; ++i)
      if (!finite(made.inertia_[i]) || !finite(made.inverse_inertia_[i]) || !(made.inertia_[i] > T(0)) ||
          !(made.inverse_inertia_[i] > T(0)))
        return Fault{Kind::out_of_range, "size", "gives a moment of inertia outside the range of the scalar"};
    return made;
  }

  const T& mass() const { return mass_; }
  const T& inverse_mass() const { return inverse_mass_; }
  const Vec3<T>& size() const { return size_; }                          ///< s_B, full edge lengths
  const Vec3<T>& inertia() const { return inertia_; }                    ///< principal moments I_B
  const Vec3<T>& inverse_inertia() const { return inverse_inertia_; }    ///< 1/I_B

  /// Corner k in body axes: bit 0, 1, 2 of k set means +half along x, y, z, else −half.
  Vec3<T> corner(int k) const {
    return Vec3<T>((k & 1 ? size_[0] : -size_[0]) / T(2), (k & 2 ? size_[1] : -size_[1]) / T(2),
                   (k & 4 ? size_[2] : -size_[2]) / T(2));
  }

 private:
  Cuboid(const T& mass, const Vec3<T>& s_B)
      : mass_(mass),
        inverse_mass_(T(1) / mass),
        size_(s_B),
        inertia_(cuboid_inertia<T>(mass, s_B)),
        inverse_inertia_(cuboid_inverse_inertia<T>(inertia_)) {}
  static bool finite(const T& x) {
    if constexpr (std::floating_point<T>) return std::isfinite(x);
    return true;
  }

  T mass_, inverse_mass_;
  Vec3<T> size_, inertia_, inverse_inertia_;
};

}  // namespace rigor
