#include "CollisionPlane.h"
#include "Constants.h"

V3D CollisionPlane::frictionTangent(Cuboid &c, P3D &p) {
  V3D vr = c.velocityOfPoint(p);
  V3D t = vr - (vr.dot(normal)) * normal;
  if (t.norm() < 1e-7) {
    V3D force = c.currentNetForce();
    t = force - (force.dot(normal)) * normal;
  }
  if (t.norm() < 1e-7) return V3D(0, 0, 0);
  t.normalize();
  return t;
}

// All corners behind the plane together, as one contact at their mean. Nobody asked whether the body is leaving
// already, so nothing here asks it either.
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  P3D mean;
  int count = 0;
  double depth = 0;
  for (size_t i = 0; i < corners.size(); i++) {
    if (isColliding(corners[i])) {
      mean += corners[i];
      count++;
      depth = max(depth, -(corners[i] - pointOnPlane).dot(normal));
    }
  }
  if (count == 0) return;
  mean = mean / count;

  V3D r2 = c.worldToLocalCoordinates(mean);
  Matrix3x3 I2inv = c.computeWorldCoordsInverseMOI();
  V3D vr = c.velocityOfPoint(mean);
  V3D t = frictionTangent(c, mean);
  double jr = -(1 + COEFF_RESITUTION) * vr.dot(normal);
  jr /= 1.0 / c.mass + ((I2inv * (r2.cross(normal))).cross(r2)).dot(normal);

  V3D jf;
  double js = COEFF_STATIC_FRICTION * jr;
  double jd = COEFF_DYNAMIC_FRICTION * jr;
  double mvt = c.mass * vr.dot(t);
  if (mvt <= js) jf = -mvt * t;
  else jf = -jd * t;

  c.applyLinearImpulse((jr / c.mass) * normal);
  c.applyAngularImpulse(jr * (I2inv * (r2.cross(normal))));
  c.applyLinearImpulse(jf / c.mass);
  c.applyAngularImpulse(I2inv * (r2.cross(jf)));

  c.worldTranslation += depth * normal;
}
