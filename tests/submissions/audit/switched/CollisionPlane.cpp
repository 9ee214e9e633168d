#include "CollisionPlane.h"

#include <algorithm>

#include "Constants.h"
#include "Habits.h"

V3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {
  V3D slip = habit("tangent.of-centre") ? c.linearVelocity : c.velocityOfPoint(p);
  V3D pull = c.currentNetForce();
  if (!habit("tangent.not-projected")) {
    slip -= slip.dot(normal) * normal;
    pull -= pull.dot(normal) * normal;
  }
  const double tiny = 1e-9;
  V3D t = slip;
  if (habit("tangent.force-first") && pull.norm() > tiny) t = pull;
  if (t.norm() < tiny) t = habit("tangent.no-fallback") ? V3D() : pull;
  if (t.norm() < tiny) return V3D();
  if (!habit("tangent.not-normalised")) t.normalize();
  return habit("tangent-against-slip") ? V3D(-t) : t;
}

// What one contact needs of the body.
struct Contact {
  Cuboid& c;
  V3D arm;
  Matrix3x3 inverse;

  V3D velocity() const {
    if (habit("plane.centre-velocity")) return c.linearVelocity;
    if (habit("plane.spin-sign")) return c.linearVelocity - c.angularVelocity.cross(arm);
    return c.linearVelocity + c.angularVelocity.cross(arm);
  }
  // The inverse of the mass that a push along `direction` feels.
  double softness(V3D direction) const {
    return 1 / c.mass + V3D(inverse * arm.cross(direction)).cross(arm).dot(direction);
  }
  void push(V3D impulse, bool overMass, bool turns, bool moves = true) {
    if (moves) c.applyLinearImpulse(overMass && !habit("plane.not-over-mass") ? V3D(impulse / c.mass) : impulse);
    if (!turns || habit("plane.no-spin")) return;
    const V3D change = inverse * arm.cross(impulse);
    c.applyAngularImpulse(habit("plane.spin-reversed") ? V3D(-change) : change);
  }
};

static Contact contactAt(Cuboid& c, P3D p) {
  V3D arm = p - c.worldTranslation;
  if (habit("plane.no-arm")) arm = V3D();
  if (habit("plane.arm-in-body")) arm = c.worldRotation.transpose() * arm;
  if (habit("plane.arm-from-origin")) arm = p;
  Matrix3x3 inverse = c.computeWorldCoordsInverseMOI();
  if (habit("plane.inverse-body")) inverse = Matrix3x3(c.worldRotation.transpose() * inverse * c.worldRotation);
  if (habit("plane.inertia-not-inverted")) inverse = c.computeWorldCoordsMOI();
  return Contact{c, arm, inverse};
}

static void bounce(CollisionPlane& plane, V3D normal, Cuboid& c, P3D p) {
  Contact contact = contactAt(c, p);
  const V3D before = contact.velocity();
  const V3D tangentBefore = plane.frictionTangent(c, p);
  if (before.dot(normal) >= 0 && !habit("no-approach-test")) return;

  double bounciness = 1 + COEFF_RESITUTION;
  if (habit("plane.printed-restitution")) bounciness = 1 - COEFF_RESITUTION;
  if (habit("plane.restitution-ignored")) bounciness = 1;
  if (habit("plane.restitution-one")) bounciness = 2;
  double approach = before.dot(normal);
  if (habit("plane.velocity-reversed")) approach = V3D(-before).dot(normal);
  const double k = habit("plane.no-inertia-term") ? 1 / c.mass : contact.softness(normal);
  double j = -bounciness * approach / k;
  if (habit("plane.normal-sign")) j = -j;
  contact.push(j * normal, true, true);

  if (habit("friction.missing")) return;
  const V3D t = habit("friction-before") ? tangentBefore : plane.frictionTangent(c, p);
  V3D along = habit("tangent-against-slip") ? V3D(-t) : t;  // the way it slips
  const double slip = (habit("friction-before") ? before : contact.velocity()).dot(along);
  double muS = COEFF_STATIC_FRICTION, muD = COEFF_DYNAMIC_FRICTION;
  if (habit("friction.mu-swapped")) swap(muS, muD);
  const double unit = habit("friction.bare-coefficients") ? 1 : j;
  const double stopping = habit("friction-effective-mass") ? slip / contact.softness(t) : slip * c.mass;
  double jf = stopping <= muS * unit ? stopping : muD * unit;
  if (habit("friction-literal")) jf = slip > 0 ? muD * unit : 0;
  if (habit("friction.unlimited")) jf = stopping;
  if (habit("friction.reversed")) jf = -jf;
  contact.push(-jf * along, !habit("friction.not-over-mass"), !habit("friction.no-turn"), !habit("friction.spin-only"));
}

void CollisionPlane::applyCollisionResponse(Cuboid& c) {
  vector<P3D> all;
  c.getTransformedVertices(all);
  vector<V3D> arms;
  vector<double> depths;
  for (P3D p : all)
    if (isColliding(p) || habit("plane.no-collision-test")) {
      arms.push_back(p - c.worldTranslation);
      depths.push_back(-(p - pointOnPlane).dot(normal));
    }
  if (arms.empty()) return;
  const size_t deepest = max_element(depths.begin(), depths.end()) - depths.begin();

  double sum = 0;
  for (double d : depths) sum += d;
  double shift = depths[deepest];
  if (habit("plane.correction-mean")) shift = sum / depths.size();
  if (habit("correction-each-corner")) shift = sum;
  if (habit("plane.correction-missing")) shift = 0;
  if (habit("plane.correction-doubled")) shift *= 2;
  if (habit("plane.correction-half")) shift /= 2;
  if (habit("plane.correction-inwards")) shift = -shift;
  const P3D centreBefore = c.worldTranslation;
  c.worldTranslation += shift * (habit("plane.correction-along-y") ? V3D(0, 1, 0) : normal);

  if (habit("deepest-corner") || habit("plane.no-collision-test")) arms = {arms[deepest]};
  if (habit("mean-contact")) {
    V3D mean;
    for (V3D arm : arms) mean += arm / arms.size();
    arms = {mean};
  }
  if (habit("corners-reversed")) reverse(arms.begin(), arms.end());
  for (V3D arm : arms) bounce(*this, normal, c, (habit("friction.contact-before-push") ? centreBefore : P3D(c.worldTranslation)) + arm);
}
