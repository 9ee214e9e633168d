#include "Cuboid.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "Constants.h"
#include "Habits.h"
#include "MatrixUtils.h"

void Cuboid::computeBodyCoordsMOI() {
  double w = width, h = height, d = depth, m = mass, divisor = 12;
  if (habit("moi.no-twelfth")) divisor = 1;
  if (habit("moi.sixth")) divisor = 6;
  if (habit("moi.third")) divisor = 3;
  if (habit("moi.no-mass")) m = 1;
  if (habit("moi.half-extents")) { w /= 2; h /= 2; d /= 2; }
  if (habit("moi.double-extents")) { w *= 2; h *= 2; d *= 2; }
  if (habit("moi.cube")) h = d = w;

  double x = h * h + d * d, y = w * w + d * d, z = w * w + h * h;
  if (habit("moi.own-edge")) { x = w * w; y = h * h; z = d * d; }
  if (habit("moi.sphere")) x = y = z = w * w + h * h + d * d;
  if (habit("moi.axes-swapped")) swap(x, y);
  if (habit("moi.axes-cycled")) { swap(x, y); swap(y, z); }
  if (habit("moi.axes-cycled-back")) { swap(y, z); swap(x, y); }

  bodyCoordsMOI << x, 0, 0,
                   0, y, 0,
                   0, 0, z;
  bodyCoordsMOI = bodyCoordsMOI * (m / divisor);
  if (habit("moi.products")) bodyCoordsMOI(0, 1) = bodyCoordsMOI(1, 0) = -m * w * h / 12;
  bodyCoordsInverseMOI = bodyCoordsMOI.inverse();
  if (habit("moi.inverse-missing")) bodyCoordsInverseMOI.setZero();
  if (habit("moi.inverse-is-tensor")) bodyCoordsInverseMOI = bodyCoordsMOI;
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  const Matrix3x3 R = worldRotation, Rt = worldRotation.transpose();
  if (habit("world.transposed")) return Rt * bodyCoordsMOI * R;
  if (habit("world.no-right-factor")) return R * bodyCoordsMOI;
  if (habit("world.no-left-factor")) return bodyCoordsMOI * Rt;
  if (habit("world.body")) return bodyCoordsMOI;
  if (habit("world.inverse-instead")) return R * bodyCoordsInverseMOI * Rt;
  return R * bodyCoordsMOI * Rt;
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  const Matrix3x3 R = worldRotation, Rt = worldRotation.transpose();
  if (habit("world-inverse.transposed")) return Rt * bodyCoordsInverseMOI * R;
  if (habit("world-inverse.no-right-factor")) return R * bodyCoordsInverseMOI;
  if (habit("world-inverse.no-left-factor")) return bodyCoordsInverseMOI * Rt;
  if (habit("world-inverse.body")) return bodyCoordsInverseMOI;
  if (habit("world-inverse.tensor-instead")) return R * bodyCoordsMOI * Rt;
  if (habit("world-inverse.of-diagonal")) {
    const V3D d = computeWorldCoordsMOI().diagonal();
    return V3D(1 / d[0], 1 / d[1], 1 / d[2]).asDiagonal();
  }
  if (habit("world-inverse.elementwise")) {
    Matrix3x3 I = computeWorldCoordsMOI();
    for (int i = 0; i < 9; i++) I(i / 3, i % 3) = 1 / I(i / 3, i % 3);
    return I;
  }
  return R * bodyCoordsInverseMOI * Rt;
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  V3D r = worldPosition - worldTranslation;
  if (habit("force.arm-from-origin")) r = worldPosition;
  if (habit("force.arm-in-body")) r = worldRotation.transpose() * r;
  if (habit("force.arm-plus-centre")) r = worldPosition + worldTranslation;
  V3D torque = habit("force.torque-reversed") ? force.cross(r) : r.cross(force);

  if (habit("force.overwritten")) netForce = force;
  else if (habit("force.over-mass")) netForce += force / mass;
  else if (habit("force.reversed")) netForce -= force;
  else if (!habit("force.no-force")) netForce += force;

  if (habit("force.torque-overwritten")) netTorque = torque;
  else if (!habit("force.no-torque")) netTorque += torque;
}

// The turn of one step: `turn` is angular velocity times time.
static Matrix3x3 rotated(const Matrix3x3& R, V3D turn) {
  const bool right = habit("update.rotation-right");
  if (habit("exponential")) {
    const double angle = turn.norm();
    if (angle == 0) return R;
    const Matrix3x3 dR = AngleAxisd(angle, turn / angle).toRotationMatrix();
    return right ? Matrix3x3(R * dR) : Matrix3x3(dR * R);
  }
  if (habit("quaternion")) {
    Quaterniond q(R), rate(0, turn[0], turn[1], turn[2]);
    const Quaterniond dq = right ? q * rate : rate * q;
    q.w() += dq.w() / 2;
    q.x() += dq.x() / 2;
    q.y() += dq.y() / 2;
    q.z() += dq.z() / 2;
    q.normalize();
    return q.toRotationMatrix();
  }
  const Matrix3x3 cross = MatrixUtils::crossProductMatrix(turn);
  Matrix3x3 next = R + (right ? Matrix3x3(R * cross) : Matrix3x3(cross * R));
  if (habit("update.not-orthonormal")) return next;
  if (habit("polar")) {
    JacobiSVD<Matrix3d> svd(next, ComputeFullU | ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
  }
  if (habit("rows")) {
    next = Matrix3x3(next.transpose());
    MatrixUtils::orthonormalize(next);
    return next.transpose();
  }
  MatrixUtils::orthonormalize(next);
  return next;
}

void Cuboid::update(double delta) {
  double dt = habit("uses-delta-t") ? DELTA_T : delta;
  if (habit("update.half-step")) dt = dt / 2;
  const V3D oldV = linearVelocity, oldW = angularVelocity;

  V3D acceleration = habit("update.no-mass") ? netForce : V3D(netForce / mass);
  if (habit("update.velocity-stays")) acceleration = V3D();
  linearVelocity += acceleration * (habit("update.dt-missing-velocity") ? 1 : dt);
  if (habit("update.damps-velocity")) linearVelocity *= 0.99;

  V3D along = linearVelocity;
  if (habit("explicit-position")) along = oldV;
  if (habit("midpoint-position")) along = 0.5 * (oldV + linearVelocity);
  double moveTime = dt;
  if (habit("update.dt-missing-position")) moveTime = 1;
  if (habit("update.dt-squared-position")) moveTime = dt * dt;
  if (!habit("update.position-stays")) worldTranslation += along * moveTime;

  const Matrix3x3 inertia = habit("update.gyroscopic-body") ? bodyCoordsMOI : computeWorldCoordsMOI();
  Matrix3x3 inverse = computeWorldCoordsInverseMOI();
  if (habit("update.inverse-body")) inverse = bodyCoordsInverseMOI;
  if (habit("update.inertia-not-inverted")) inverse = inertia;
  if (habit("update.no-inertia")) inverse = Matrix3x3::Identity();
  V3D gyroscopic = oldW.cross(V3D(inertia * oldW));
  if (habit("update.no-gyroscopic")) gyroscopic = V3D();
  if (habit("update.gyroscopic-sign")) gyroscopic = -gyroscopic;
  if (!habit("update.spin-stays"))
    angularVelocity += inverse * (netTorque - gyroscopic) * (habit("update.dt-missing-spin") ? 1 : dt);
  if (habit("update.damps-spin")) angularVelocity *= 0.99;

  V3D turn = habit("old-spin") ? oldW : angularVelocity;
  if (habit("update.degrees")) turn = turn * (M_PI / 180);
  if (habit("update.rotation-reversed")) turn = -turn;
  if (habit("update.half-rotation")) turn = turn / 2;
  if (habit("update.rotation-stays")) turn = V3D();
  if (habit("update.dt-missing-rotation")) turn = turn;
  else if (habit("update.dt-squared-rotation")) turn = turn * dt * dt;
  else turn = turn * dt;
  worldRotation = rotated(worldRotation, turn);

  if (!habit("update.keeps-force")) netForce = V3D();
  if (!habit("update.keeps-torque")) netTorque = V3D();
}
