#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// Rotations about the three body axes, one after the other and back (Strang). Order 2, explicit, symplectic. The energy
/// L·I⁻¹L/2 is split into its three squares, each of which turns the body about one axis at a constant rate.
Motion step_split3(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
/// The same composed by Yoshida's three stages. Order 4.
Motion step_split3_yoshida4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Two axes: |L|²/2I₂ is taken out of the energy first (I₂ the middle moment). What it does alone is a turn about L at a
/// constant rate, exact and commuting with the rest; the rest has two squares, with smaller factors. Order 2, and
/// exact for a symmetric body whose middle moment is one of the equal ones. proofs/coq/Splitting.v.
Motion step_split2(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
/// The axis of I₂ among principal moments; of equal ones, the first that lies between the others.
int middle_axis(const Vec3<double>& I_B);
/// Composed: Yoshida, order 4; Kahan and Li's nine stages, order 6, and seventeen, order 8.
Motion step_split2_yoshida4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
Motion step_split2_kahan_li6(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
Motion step_split2_kahan_li8(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// The same between kicks of the load, the whole composed: of the same order under a load that does not look at velocities.
Motion step_split3_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_split3_yoshida4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_split2_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_split2_yoshida4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_split2_kahan_li6_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_split2_kahan_li8_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Without load, many steps at a time.
Motion fly_split3(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_split3_yoshida4(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_split2(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_split2_yoshida4(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_split2_kahan_li6(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_split2_kahan_li8(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
