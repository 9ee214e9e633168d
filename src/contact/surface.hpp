#pragma once
#include <cmath>
#include <optional>
#include <rigor/base/outcome.hpp>
#include <rigor/linalg/types.hpp>
#include <string_view>

namespace rigor {

/// Which law turns an approaching contact into an impulse.
enum class FrictionLaw {
  sheet,          ///< the assignment's rule, slip taken after the normal impulse
  sheet_literal,  ///< the same read literally: every slip slides
  coulomb,        ///< normal and tangent coupled, Newton's restitution
  stronge,        ///< three-dimensional process, energetic restitution
};

inline const char* name(FrictionLaw law) {
  constexpr const char* names[] = {"sheet", "sheet_literal", "coulomb", "stronge"};
  return names[int(law)];
}
inline std::optional<FrictionLaw> friction_law_named(std::string_view word) {
  for (const FrictionLaw law : {FrictionLaw::sheet, FrictionLaw::sheet_literal, FrictionLaw::coulomb, FrictionLaw::stronge})
    if (word == name(law)) return law;
  return std::nullopt;
}

/// Restitution and friction of a contact. Cannot be out of range.
template <Field T>
class Surface {
 public:
  Surface() : e_(T(0)), mu_s_(T(0)), mu_d_(T(0)) {}

  /// Faults: not_finite, negative or out_of_range, naming "restitution", "static_friction" or "dynamic_friction".
  /// 0 ≤ e ≤ 1; μ ≥ 0. The sheet's rule allows μ_d > μ_s; coulomb and stronge do not, and their callers check.
  static Outcome<Surface> make(const T& e, const T& mu_s, const T& mu_d) {
    using Kind = Fault::Kind;
    if constexpr (std::floating_point<T>) {
      if (!std::isfinite(e)) return Fault{Kind::not_finite, "restitution", "is not finite, must be in [0, 1]"};
      if (!std::isfinite(mu_s)) return Fault{Kind::not_finite, "static_friction", "is not finite, must be >= 0"};
      if (!std::isfinite(mu_d)) return Fault{Kind::not_finite, "dynamic_friction", "is not finite, must be >= 0"};
    }
    if (!(e >= T(0) && e <= T(1))) return Fault{Kind::out_of_range, "restitution", "must be in [0, 1]"};
    if (!(mu_s >= T(0))) return Fault{Kind::negative, "static_friction", "must be >= 0"};
    if (!(mu_d >= T(0))) return Fault{Kind::negative, "dynamic_friction", "must be >= 0"};
    return Surface(e, mu_s, mu_d);
  }

  const T& restitution() const { return e_; }
  const T& static_friction() const { return mu_s_; }
  const T& dynamic_friction() const { return mu_d_; }
  bool frictionless() const { return mu_s_ == T(0) && mu_d_ == T(0); }

 private:
  Surface(const T& e, const T& mu_s, const T& mu_d) : e_(e), mu_s_(mu_s), mu_d_(mu_d) {}
  T e_, mu_s_, mu_d_;
};

}  // namespace rigor
