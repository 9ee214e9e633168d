#pragma once
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <reference/free_body.hpp>
#include <reference/precise.hpp>

namespace rigor::reference {

/// 113 bits, the format of float128 on every compiler.
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type, boost::multiprecision::et_off>;

/// Free flight in closed form, in any precision T: Jacobi's functions and the precession through theta series summed term
/// by term, elliptic integrals by the arithmetic-geometric mean with its angle. Shares the formula with the engine's
/// (van Zon and Schofield 2007) and no line of code; the Taylor series shares neither.
///
/// errors    attitude about 10 u (1 + phase turned) on generic tumbling, u of T. The one difference that cancels is D, the
///           distance from the separatrix: there the error is u/(1 − m) times as large, in double 1e-11 rad on case C.
/// domain    moments > 0; not all spins so small or large that their squares leave T
template <class T>
class ThetaFlight {
 public:
  ThetaFlight(const Vec3<T>& I_B, const Vec3<T>& w_B, const Mat3<T>& R_WB);
  explicit ThetaFlight(const FreeBody& body) : ThetaFlight(body.I_B.cast<T>(), body.w_B.cast<T>(), body.R_WB.cast<T>()) {}

  Attitude<T> at(const T& t) const;
  /// 1 − m of the motion, a measure of how far from the separatrix it is; 1 where the rotation is about one axis.
  T complement() const { return m1_; }

 private:
  enum class Kind { one_axis, small, large };  // m up to 1/2: nome q; above: nome q' of 1 − m
  /// Jacobi's functions at u and the angle that the precession has beside its uniform part.
  struct Phase {
    T sn, cn, dn, angle;
  };
  Phase phase(const T& u) const;
  Mat3<T> frame(const Phase& p) const;

  Vec3<T> I_, w_;
  Mat3<T> R0_;
  std::array<int, 3> axis_{0, 1, 2};
  std::array<T, 3> sign_{T(1), T(1), T(1)};
  Kind kind_ = Kind::one_axis;
  T G_ = T(0), L_[3] = {T(0), T(0), T(0)}, across_ = T(1), u0_ = T(0), speed_ = T(0), m_ = T(0), m1_ = T(1);
  T K_ = T(0), K1_ = T(0), nome_ = T(0), beta_ = T(0), uniform_ = T(0);
  Mat3<T> from_;  // world from the frame that does not turn
};

extern template class ThetaFlight<double>;
extern template class ThetaFlight<long double>;
extern template class ThetaFlight<Quad>;
extern template class ThetaFlight<Precise>;

}  // namespace rigor::reference
