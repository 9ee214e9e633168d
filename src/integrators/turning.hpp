#pragma once
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>
#include <span>

namespace rigor {

/// A rotation method without torque: how far it turns a body with this angular momentum over equal steps. A quaternion of any
/// length, from the body's axes at the end to those at the start. What does not change from step to step is made once.
using FreeTurn = Vec4<double> (*)(const Cuboid<double>& body, const Vec3<double>& L_B, double h, long steps);

/// A free body over equal steps: nothing is derived in between. L in world axes stays the same to the bit.
Motion free_flight(FreeTurn turn, const Cuboid<double>& body, const Motion& now, double h, long steps);

/// A step of a body whose rotation is a free turn between two half kicks of the torque, and whose centre moves on the
/// parabola of the held force. The state of the rotation is L in world axes: without torque it stays the same to the bit,
/// whatever the free turn does. Order 2 at most where the torque acts.
Motion kicked_step(FreeTurn turn, const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Flow and kicks under a load that changes: (half a kick, free turn and drift, half a kick), composed by `stages`, each a
/// part of h. A kick changes the velocities by the load there and then, and nothing else; the turn and the drift change
/// the place and the time, and no velocity. Of the order of the composition if `turn` is symmetric and at least of order 2,
/// and if the load depends on time, position and attitude; order 1 where it depends on velocities.
Motion composed_step(FreeTurn turn, std::span<const double> stages, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// The same for a splitting that is not made of symmetric steps.
Motion split_step(FreeTurn turn, const Splitting& parts, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Centre of mass under a held force: the parabola, exactly.
void move_centre(const Cuboid<double>& body, const Vec3<double>& f_W, double h, State<double>& s);

}  // namespace rigor
