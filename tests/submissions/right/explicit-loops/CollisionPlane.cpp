#include "CollisionPlane.h"

#include "Constants.h"

CollisionPlane::CollisionPlane(P3D p, V3D n) : pointOnPlane(p), normal(n.normalized()) {}

bool CollisionPlane::isColliding(P3D p) { return (p - pointOnPlane).dot(normal) < 0; }

V3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {
  V3D v = c.velocityOfPoint(p);
  V3D f = c.currentNetForce();
  double vn = 0, fn = 0;
  for (int i = 0; i < 3; i++) {
    vn += v[i] * normal[i];
    fn += f[i] * normal[i];
  }
  V3D vt, ft;
  for (int i = 0; i < 3; i++) {
    vt[i] = v[i] - vn * normal[i];
    ft[i] = f[i] - fn * normal[i];
  }
  if (vt.norm() > 1e-8) {
    vt.normalize();
    return vt;
  }
  if (ft.norm() > 1e-8) {
    ft.normalize();
    return ft;
  }
  return V3D();
}

// The corners one after another, in their order; the slip is taken after the normal impulse.
void CollisionPlane::applyCollisionResponse(Cuboid& c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  double push = 0;
  for (unsigned i = 0; i < corners.size(); i++) {
    if (!isColliding(corners[i])) continue;
    double depth = -(corners[i] - pointOnPlane).dot(normal);
    if (depth > push) push = depth;
  }
  if (push == 0) return;
  // out of the plane first; then the corners that were in it
  for (int i = 0; i < 3; i++) c.worldTranslation[i] += push * normal[i];

  for (unsigned i = 0; i < corners.size(); i++) {
    if (!isColliding(corners[i])) continue;
    P3D p = corners[i] + push * normal;
    V3D v = c.velocityOfPoint(p);
    double vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    if (vn >= 0) continue;
    V3D r = p - c.centerOfMass();
    Matrix3x3 Iinv = c.computeWorldCoordsInverseMOI();
    V3D rxn = r.cross(normal);
    V3D a = Iinv * rxn;
    double denominator = 1 / c.mass + a.cross(r).dot(normal);
    double jr = -(1 + COEFF_RESITUTION) * vn / denominator;
    c.applyLinearImpulse(jr / c.mass * normal);
    c.applyAngularImpulse(jr * a);

    V3D t = frictionTangent(c, p);
    double slip = c.velocityOfPoint(p).dot(t);
    double js = COEFF_STATIC_FRICTION * jr, jd = COEFF_DYNAMIC_FRICTION * jr;
    double jf;
    if (c.mass * slip <= js)
      jf = c.mass * slip;
    else
      jf = jd;
    c.applyLinearImpulse(-jf / c.mass * t);
    c.applyAngularImpulse(-jf * (Iinv * r.cross(t)));
  }
}
