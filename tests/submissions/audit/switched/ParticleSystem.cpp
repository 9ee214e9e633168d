#include "ParticleSystem.h"

#include "Constants.h"
#include "Habits.h"

// One of the two bodies, as this student sees it.
struct Side {
  Cuboid* c;
  V3D arm;
  Matrix3x3 inverse;
  double inverseMass;
};

static Side sideOf(Cuboid& c, P3D point) {
  V3D arm = point - c.worldTranslation;
  if (habit("pair.no-arm")) arm = V3D();
  if (habit("pair.arm-in-body")) arm = c.worldRotation.transpose() * arm;
  if (habit("pair.arm-from-origin")) arm = point;
  Matrix3x3 inverse = c.computeWorldCoordsInverseMOI();
  if (habit("pair.inverse-body")) inverse = Matrix3x3(c.worldRotation.transpose() * inverse * c.worldRotation);
  if (habit("pair.inertia-not-inverted")) inverse = c.computeWorldCoordsMOI();
  return Side{&c, arm, inverse, 1 / c.mass};
}

static V3D velocityOf(const Side& s) {
  const V3D turning = s.c->angularVelocity.cross(s.arm);
  if (habit("pair.centre-velocity")) return s.c->linearVelocity;
  if (habit("pair.spin-sign")) return s.c->linearVelocity - turning;
  return s.c->linearVelocity + turning;
}

static double inertiaTerm(const Side& s, V3D n) {
  if (habit("pair.no-inertia-term")) return 0;
  return V3D(s.inverse * s.arm.cross(n)).cross(s.arm).dot(n);
}

static void push(const Side& s, V3D impulse, bool spins) {
  s.c->linearVelocity += habit("pair.not-over-mass") ? impulse : V3D(impulse * s.inverseMass);
  if (!spins || habit("pair.no-spin")) return;
  const V3D change = s.inverse * s.arm.cross(impulse);
  s.c->angularVelocity += habit("pair.spin-reversed") ? V3D(-change) : change;
}

void ParticleSystem::applyCollisionImpulse(Cuboid& c1, Cuboid& c2, P3D& collisionPoint, V3D& collisionNormal) {
  const V3D n = collisionNormal;
  Side one = sideOf(c1, collisionPoint), two = sideOf(c2, collisionPoint);
  if (habit("pair.one-arm")) two.arm = one.arm;
  if (habit("pair.masses-swapped")) swap(one.inverseMass, two.inverseMass);
  if (habit("pair.first-tensor")) two.inverse = one.inverse;
  if (habit("pair.second-tensor")) one.inverse = two.inverse;
  if (habit("pair.tensors-swapped")) swap(one.inverse, two.inverse);

  double vn = (velocityOf(two) - velocityOf(one)).dot(n);
  if (vn >= 0 && !habit("no-approach-test")) return;
  if (habit("pair.relative-reversed")) vn = (velocityOf(one) - velocityOf(two)).dot(n);

  double bounciness = 1 + COEFF_RESITUTION;
  if (habit("pair.printed-restitution")) bounciness = 1 - COEFF_RESITUTION;
  if (habit("pair.restitution-ignored")) bounciness = 1;
  if (habit("pair.restitution-one")) bounciness = 2;
  const double k = one.inverseMass + two.inverseMass + inertiaTerm(one, n) + inertiaTerm(two, n);
  V3D j = -bounciness * vn / k * n;
  if (habit("pair.signs-reversed")) j = -j;

  const V3D onFirst = habit("pair.same-direction") ? j : V3D(-j);
  if (!habit("pair.second-only")) push(one, onFirst, !habit("pair.first-no-spin"));
  if (!habit("pair.first-only")) push(two, j, !habit("pair.second-no-spin"));
}
