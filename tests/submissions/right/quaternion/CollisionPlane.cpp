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

// Only the corner that comes fastest; when none approaches, the body is just pushed out.
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  double depth = 0, fastest = 0;
  int hit = -1;
  for (int i = 0; i < 8; ++i) {
    double below = normal.dot(pointOnPlane - corners[i]);
    if (below <= 0) continue;
    if (below > depth) depth = below;
    double speed = -normal.dot(c.velocityOfPoint(corners[i]));
    if (speed > fastest) {
      fastest = speed;
      hit = i;
    }
  }
  c.worldTranslation += depth * normal;
  if (hit < 0) return;

  P3D p = corners[hit] + depth * normal;
  V3D r = p - c.worldTranslation;
  Matrix3x3 I = c.computeWorldCoordsMOI();
  LDLT<Matrix3x3> solve(I);
  double kn = 1 / c.mass + r.cross(normal).dot(solve.solve(r.cross(normal)));
  double jr = (1 + COEFF_RESITUTION) * fastest / kn;
  V3D t = frictionTangent(c, p);
  double kt = 1 / c.mass + r.cross(t).dot(solve.solve(r.cross(t)));
  double stick = c.velocityOfPoint(p).dot(t) / kt;
  double jf = std::min(stick, stick > COEFF_STATIC_FRICTION * jr ? COEFF_DYNAMIC_FRICTION * jr : stick);
  V3D j = jr * normal - jf * t;
  c.linearVelocity += j / c.mass;
  c.angularVelocity += solve.solve(r.cross(j));
}
