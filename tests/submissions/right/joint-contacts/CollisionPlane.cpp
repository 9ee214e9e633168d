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

// All corners in contact at once: impulses that push, never pull, after which each corner that came in leaves with
// e times its speed or faster (projected Gauss-Seidel).
void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  struct Contact {
    P3D p;
    V3D r, turn;
    double target, k, j;
  };
  vector<Contact> contacts;
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  Matrix3x3 Iinv = c.computeWorldCoordsInverseMOI();
  double depth = 0;
  for (P3D p : corners) {
    if (!isColliding(p)) continue;
    depth = std::max(depth, normal.dot(pointOnPlane - p));
    Contact contact;
    contact.p = p;
    contact.r = p - c.worldTranslation;
    contact.turn = Iinv * contact.r.cross(normal);
    contact.k = 1 / c.mass + contact.turn.cross(contact.r).dot(normal);
    contact.target = std::max(0.0, -COEFF_RESITUTION * c.velocityOfPoint(p).dot(normal));
    contact.j = 0;
    contacts.push_back(contact);
  }
  if (contacts.empty()) return;

  V3D v = c.linearVelocity, w = c.angularVelocity;
  for (int sweep = 0; sweep < 400; ++sweep)
    for (Contact &contact : contacts) {
      double speed = (v + w.cross(contact.r)).dot(normal);
      double before = contact.j;
      contact.j = std::max(0.0, before + (contact.target - speed) / contact.k);
      v += (contact.j - before) / c.mass * normal;
      w += (contact.j - before) * contact.turn;
    }

  // friction by the slip each corner had before
  V3D dv, dw;
  for (Contact &contact : contacts) {
    V3D t = frictionTangent(c, contact.p);
    double stop = c.mass * c.velocityOfPoint(contact.p).dot(t) / contacts.size();
    double jf = stop <= COEFF_STATIC_FRICTION * contact.j ? stop : COEFF_DYNAMIC_FRICTION * contact.j;
    dv += -jf / c.mass * t;
    dw += Iinv * contact.r.cross(-jf * t);
  }
  c.linearVelocity = v + dv;
  c.angularVelocity = w + dw;
  c.worldTranslation += depth * normal;
}
