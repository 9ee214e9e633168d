#include "CollisionPlane.h"
#include "Constants.h"

V3D CollisionPlane::frictionTangent(Cuboid &c, P3D &p) {
  Vector3f n = normal.cast<float>();
  Vector3f v = c.velocityOfPoint(p).cast<float>();
  Vector3f t = v - v.dot(n) * n;
  if (t.norm() < 1e-5f) {
    Vector3f f = c.currentNetForce().cast<float>();
    t = f - f.dot(n) * n;
    if (t.norm() < 1e-5f) return V3D();
  }
  t.normalize();
  return V3D(t[0], t[1], t[2]);
}

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  float deepest = 0;
  for (P3D p : corners) {
    double depth = (pointOnPlane - p).dot(normal);
    if (depth <= 0) continue;
    deepest = max(deepest, float(depth) * 1.000001f);  // never short of it for the rounding

    Vector3f n = normal.cast<float>();
    Vector3f r = (p - c.centerOfMass()).cast<float>();
    Vector3f v = c.velocityOfPoint(p).cast<float>();
    Vector3f t = frictionTangent(c, p).cast<float>();
    Matrix3f Iinv = c.computeWorldCoordsInverseMOI().cast<float>();
    float vn = v.dot(n);
    if (vn >= 0) continue;
    Vector3f rn = r.cross(n);
    Vector3f turn = Iinv * rn;
    float e = COEFF_RESITUTION, m = c.mass;
    float jr = -(1 + e) * vn / (1 / m + turn.cross(r).dot(n));
    float stick = m * v.dot(t);
    float jf = stick <= float(COEFF_STATIC_FRICTION) * jr ? stick : float(COEFF_DYNAMIC_FRICTION) * jr;
    Vector3f j = jr * n - jf * t;
    Vector3f dv = j / m, dw = Iinv * r.cross(j);
    c.applyLinearImpulse(dv.cast<double>());
    c.applyAngularImpulse(dw.cast<double>());
  }
  c.worldTranslation += double(deepest) * normal;
}
