#pragma once
#include <reference/free_body.hpp>
#include <rigor/base/outcome.hpp>

namespace rigor::reference {

/// Free flight in closed form through GSL's Jacobi functions and its elliptic integral of the third kind: another
/// formula and another author than the theta series of the engine.
///
/// errors    attitude about 1e-14 rad at T = 10 on generic tumbling. Near the separatrix the interface of the library
///           takes m, and one ulp of m is worth 1e-16/(1 − m) in the quarter period: 1e-7 rad on case C.
/// Faults    unsupported for the degenerate cases this form does not cover (sphere, symmetric top, spin about an
///           axis, separatrix within rounding).
Outcome<Attitude<double>> gsl_free_body(const FreeBody& body, double t);

}  // namespace rigor::reference
