#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// What a rotation method advances: attitude, and angular momentum in body axes.
struct Turning {
  Mat3<double> R_WB;
  Vec3<double> L_B;
};

/// One step of torque-free rotation.
using FreeTurn = Turning (*)(const Cuboid<double>& body, const Turning& now, double h);

/// A step of a body whose rotation is a free turn between two half kicks of the torque, and whose centre moves on the
/// parabola of the held force. The state of the rotation is L in world axes: without torque it stays the same to the bit,
/// whatever the free turn does. Order 2 at most where the torque acts.
Motion kicked_step(FreeTurn turn, const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Centre of mass under a held force: the parabola, exactly.
void move_centre(const Cuboid<double>& body, const Vec3<double>& f_W, double h, State<double>& s);

}  // namespace rigor
