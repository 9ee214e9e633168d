#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// The discrete Moser-Veselov map: a free body's motion on a time grid that keeps the energy and the momentum exactly;
/// one implicit equation for a quaternion a step, solved to rounding. It moves along the true orbit at a slightly wrong
/// speed, so changing the moments of inertia by powers of h, known in closed form, raises the order: 2 as it is, 4 and 8
/// preprocessed (Hairer and Vilmart 2006).
Motion step_moser_veselov(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
Motion step_moser_veselov4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
Motion step_moser_veselov8(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// The map as the free flow between kicks of the load: Strang, Yoshida, Kahan and Li. Orders 2, 4 and 8.
Motion step_moser_veselov_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_moser_veselov4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_moser_veselov8_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Without load, many steps at a time.
Motion fly_moser_veselov(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_moser_veselov4(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_moser_veselov8(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
