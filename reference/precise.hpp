#pragma once
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <rigor/scalar/constants.hpp>

namespace rigor::reference {

/// 60 decimal digits: the scalar in which references are computed.
using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
                                              boost::multiprecision::et_off>;

/// At its end gives back what MPFR keeps for the thread it stands in. For a thread that is started for one computation.
struct FreesPreciseCaches {
  ~FreesPreciseCaches() { mpfr_free_cache(); }
};

}  // namespace rigor::reference

namespace rigor {
template <>
inline reference::Precise pi<reference::Precise>() {
  static const reference::Precise value = boost::math::constants::pi<reference::Precise>();
  return value;
}
}  // namespace rigor
