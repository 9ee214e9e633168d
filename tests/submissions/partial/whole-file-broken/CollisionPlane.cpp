#include "CollisionPlane.h"

#include "Constants.h"

V3D CollisionPlane::frictionTangent(Cuboid &c, P3D &p) {
  V3D v = c.velocityOfPoint(p);
  V3D tangent = v - v.dot(normal) * normal;
  if (tangent.norm() < 1e-9) {
    V3D f = c.currentNetForce();
    tangent = f - f.dot(normal) * normal;
    if (tangent.norm() < 1e-9) return V3D(0, 0, 0);
  }
  return tangent.normalized();
}

// One corner after another, each as if it were alone.
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  double deepest = 0;
  for (P3D &p : corners) deepest = std::min(deepest, (p - pointOnPlane).dot(normal));
  if (deepest >= 0) return;

  for (P3D &p : corners) {
    if (!isColliding(p)) continue;
    V3D r = p - c.centerOfMass();
    V3D v = c.velocityOfPoint(p);
    if (v.dot(normal) >= 0) continue;
    Matrix3x3 inverse = c.computeWorldCoordsInverseMOI();
    V3D tangent = frictionTangent(c, p);

    double k = 1 / c.mass + (inverse * r.cross(normal)).cross(r).dot(normal);
    double jr = -(1 + COEFF_RESITUTION) * v.dot(normal) / k;
    V3D impulse = jr * normal;
    c.applyLinearImpulse(impulse / c.mass);
    c.applyAngularImpulse(inverse * r.cross(impulse));

    double stop = c.mass * v.dot(tangent);  // what would end the slip
    double jf = stop <= COEFF_STATIC_FRICTION * jr ? stop : COEFF_DYNAMIC_FRICTION * jr;
    impulse = -jf * tangent;
    c.applyLinearImpulse(impulse / c.mass);
    c.applyAngularImpulse(inverse * r.cross(impulse));
  }
  c.worldTranslation -= deepest * normal;
}
