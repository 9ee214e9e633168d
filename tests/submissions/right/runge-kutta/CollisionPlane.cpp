#include "CollisionPlane.h"
#include "Constants.h"

static V3D inPlane(const V3D &x, const V3D &n) { return x - n * n.dot(x); }

V3D CollisionPlane::frictionTangent(Cuboid &c, P3D &p) {
  V3D tangent = inPlane(c.velocityOfPoint(p), normal);
  if (tangent.norm() <= 1e-10) tangent = inPlane(c.currentNetForce(), normal);
  if (tangent.norm() <= 1e-10) tangent.zero();
  else tangent.normalize();
  return tangent;
}

// Only the deepest corner is answered; it stops slipping by its own effective mass.
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  P3D contact;
  double depth = 0;
  for (const P3D &corner : corners) {
    double d = normal.dot(pointOnPlane - corner);
    if (d > depth) {
      depth = d;
      contact = corner;
    }
  }
  if (depth <= 0) return;

  Matrix3x3 Iinv = c.computeWorldCoordsInverseMOI();
  V3D r = contact - c.centerOfMass();
  auto inverseMassAlong = [&](const V3D &u) { return 1 / c.mass + (Iinv * r.cross(u)).cross(r).dot(u); };
  auto push = [&](const V3D &j) {
    c.applyLinearImpulse(j / c.mass);
    c.applyAngularImpulse(Iinv * r.cross(j));
  };

  double vn = c.velocityOfPoint(contact).dot(normal);
  if (vn < 0) {
    V3D t = frictionTangent(c, contact);
    double vt = c.velocityOfPoint(contact).dot(t);
    double jr = -(1 + COEFF_RESITUTION) * vn / inverseMassAlong(normal);
    double stop = vt / inverseMassAlong(t);
    double jf = stop <= COEFF_STATIC_FRICTION * jr ? stop : COEFF_DYNAMIC_FRICTION * jr;
    push(jr * normal);
    push(-jf * t);
  }
  c.worldTranslation += depth * normal;
}
