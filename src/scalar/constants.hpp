#pragma once
#include <rigor/scalar/concepts.hpp>

namespace rigor {

/// π to the last bit of T; other precisions specialise it beside their scalar.
template <class T>
T pi();
template <>
inline float pi<float>() { return 3.14159265358979323846264338327950288F; }
template <>
inline double pi<double>() { return 3.14159265358979323846264338327950288; }
template <>
inline long double pi<long double>() { return 3.14159265358979323846264338327950288L; }

}  // namespace rigor
