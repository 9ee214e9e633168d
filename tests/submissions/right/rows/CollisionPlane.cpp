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

// The last corner first; each one in turn is pushed out and answered where it then is.
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (int corner = 7; corner >= 0; --corner) {
    vector<P3D> corners;
    c.getTransformedVertices(corners);
    P3D p = corners[corner];
    if (!isColliding(p)) continue;
    double depth = normal.dot(pointOnPlane - p);
    c.worldTranslation += depth * normal;
    p += depth * normal;

    V3D r = p - c.worldTranslation;
    Matrix3x3 Iinv = c.computeWorldCoordsInverseMOI();
    double vn = c.velocityOfPoint(p).dot(normal);
    if (vn >= 0) continue;
    double jr = -(1 + COEFF_RESITUTION) * vn / (1 / c.mass + r.cross(normal).dot(Iinv * r.cross(normal)));
    c.applyLinearImpulse(jr / c.mass * normal);
    c.applyAngularImpulse(jr * (Iinv * r.cross(normal)));

    V3D t = frictionTangent(c, p);
    double slip = c.velocityOfPoint(p).dot(t);
    double jf = slip * c.mass;
    if (jf > COEFF_STATIC_FRICTION * jr) jf = COEFF_DYNAMIC_FRICTION * jr;
    c.applyLinearImpulse(-jf / c.mass * t);
    c.applyAngularImpulse(-jf * (Iinv * r.cross(t)));
  }
}
