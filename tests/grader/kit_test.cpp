#include <gtest/gtest.h>

#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

TEST(Kit, SampleIsWhatIsHandedOut) {
  for (const auto& entry : fs::directory_iterator(fs::path(RIGOR_SOURCE_DIR) / "src/kit/handout"))
    EXPECT_EQ(*read_file(entry.path()), *read_file(samples() / "kit" / entry.path().filename())) << entry.path();
}

TEST(Kit, WrongSamplesDifferFromTheRightOneInFewLines) {
  for (const std::string& name : samples_in("wrong")) {
    std::ptrdiff_t changed = 0;
    for (const char* file : {"Cuboid.cpp", "CollisionPlane.cpp", "ParticleSystem.cpp"}) {
      const auto right = lines_of(samples() / "right" / "expressions" / file);
      const auto wrong = lines_of(samples() / "wrong" / name / file);
      for (const auto& line : right) changed += std::count(wrong.begin(), wrong.end(), line) == 0;
      EXPECT_FALSE(wrong.empty()) << name;
    }
    EXPECT_LE(changed, 4) << name;
    EXPECT_GE(lines_of(samples() / "wrong" / name / "EXPECT").size(), 2u) << name;
  }
}

/// What a body of frictionTangent returns for a plane with normal (0,1,0), p = (.5,0,0), and a cuboid with edges
/// 1, 2, 3, centre (.25,.5,.75), velocity (-1,-.5,0), spin (.5,-.5,-1.5).
void expect_tangent(const std::string& body, double x, double y, double z) {
  const Directory dir;
  dir.write("CollisionPlane.cpp", "#include \"CollisionPlane.h\"\n#include \"MatrixUtils.h\"\n"
                                  "V3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {\n" + body + "\n}\n");
  const BuildResult b = built(dir.path);
  ASSERT_EQ(b.of(StudentFunction::friction_tangent).kind, FunctionStatus::Kind::compiled)
      << b.of(StudentFunction::friction_tangent).error;
  Worker worker(b.executable, {});
  const Answer answer = worker.call(generic(Function::friction_tangent));
  ASSERT_EQ(kind_of(answer), "reply") << words_of(answer);
  const Reply& reply = std::get<Reply>(answer);
  EXPECT_EQ(reply.vector[0], x);
  EXPECT_EQ(reply.vector[1], y);
  EXPECT_EQ(reply.vector[2], z);
}

TEST(Kit, VectorsAndPointsTakeEveryExpressionWithoutBeingAsked) {
  // small integers and halves: every result is exact
  expect_tangent(R"(
    double s = 2;
    V3D v(1, 2, 3);
    const V3D n(0, 1, 0);
    Matrix3x3 M = Matrix3x3::Identity();
    M(0, 1) = 1;
    V3D x = s * v;                      // 2 4 6
    V3D y = M * v;                      // 3 2 3
    P3D q = x + y;                      // 5 6 9
    P3D r = q + n;                      // 5 7 9
    V3D d = r - q;                      // 0 1 0
    V3D e = -d;                         // 0 -1 0
    e = v / 2;                          // .5 1 1.5
    e += d;
    e -= n;
    e *= 2;                             // 1 2 3
    e /= 1;
    V3D f = v.cross(n) + n.cross(v);    // 0
    V3D g = v - v.dot(n) * n;           // 1 0 3
    V3D h = M.col(1);                   // 1 1 0
    V3D i = M.row(0);                   // 1 1 0
    V3D j = M.transpose() * (M.inverse() * h);
    P3D k = P3D(1, 1, 1) / 2.0;
    V3D l = q;                          // point to vector
    P3D m = l;                          // and back
    V3D o = V3D(m - P3D(5, 6, 9));      // 0
    V3D w = Vector3d(1, 0, 0);
    V3D z = V3D::Zero();
    V3D u = c.worldToLocalCoordinates(p).cwiseProduct(V3D(4, 0, 0));  // (.5 - .25) * 4 = 1
    V3D t = AngleAxisd(0, n) * v;       // 1 2 3
    V3D cond = s > 1 ? V3D(0, 0, 0) : V3D(v / 2);
    vector<P3D> many;
    many.push_back(q + n);
    many.push_back(p);
    V3D first = many[0] - q;            // 0 1 0
    V3D unit(0, 0, 2);
    unit.normalize();                   // in place
    V3D gone(1, 1, 1);
    gone.zero();                        // in place
    V3D fresh;
    P3D freshPoint;
    double sum = f.norm() + o.norm() + z.norm() + cond.norm() + gone.norm() + fresh.norm() + freshPoint.norm();
    if (sum != 0 || w[0] != 1 || u[0] != 1 || unit[2] != 1 || k(2) != 0.5 || first[1] != 1) return V3D(-1, -1, -1);
    if (V3D(3, 0, 4).norm() != 5 || V3D(0, 2, 0).normalized() != n || j.size() != 3 || i != h) return V3D(-2, -2, -2);
    return e + t + g;                   // 1+1+1, 2+2+0, 3+3+3
  )", 3, 4, 9);
}

TEST(Kit, HelpersDoWhatTheirNamesSay) {
  // arm p - centre = (.25, -.5, -.75); w x r = (wy rz - wz ry, wz rx - wx rz, wx ry - wy rx)
  //   = (.375 - .75, -.375 + .375, -.25 + .125)
  expect_tangent("return c.velocityOfPoint(p);", -1.375, -0.5, -0.125);
  // [v]x a = v x a for v = (1,2,3), a = (0,1,0): (-3, 0, 1)
  expect_tangent("return MatrixUtils::crossProductMatrix(V3D(1, 2, 3)) * V3D(0, 1, 0);", -3, 0, 1);
  // Gram-Schmidt on diag(2, 4, -8) with a column sheared along the first: the first keeps its direction, the
  // result is diag(1, 1, -1) exactly
  expect_tangent("Matrix3x3 m; m << 2, 3, 0,  0, 4, 5,  0, 0, -8; MatrixUtils::orthonormalize(m);"
                 "return V3D(m(0, 0) + m(0, 1) + m(0, 2), m(1, 1) + m(1, 2), m(2, 2));", 1, 1, -1);
  expect_tangent("vector<P3D> all; c.getTransformedVertices(all); P3D low = all[0], high = all[7];"
                 "return V3D(all.size(), (high - low)[1], low[2]);", 8, 2, 0.75 - 1.5);
  expect_tangent("c.applyLinearImpulse(V3D(1, 1, 1)); return c.linearVelocity + c.currentNetForce();", 0, 0.5, 1);
  expect_tangent("return V3D(isColliding(P3D(0, 1.9, 0)), isColliding(P3D(0, 2, 0)), isColliding(P3D(0, 2.1, 0)));",
                 1, 0, 0);
}

TEST(Kit, PairDetectionFindsCornersInsideTheOther) {
  const auto with = [](const std::string& place, const std::string& answer) {
    return "Cuboid a(2, 2, 2, 1, P3D(0, 0, 0), Matrix3x3::Identity()), b(2, 2, 2, 1, P3D(" + place +
           "), Matrix3x3::Identity()); P3D at; V3D n; double d = -1; bool hit = a.checkCollision(b, at, n, d); return " +
           answer + ";";
  };
  // corner .5 .5 .5 of b lies .5 inside a, .51 inside a grown by .01; the normal goes to b
  expect_tangent(with("1.5, 1.5, 1.5", "V3D(hit, at[0], round(100 * d))"), 1, 0.5, 51);
  expect_tangent(with("0, 1.5, 0", "n"), 0, 1, 0);
  expect_tangent(with("2.5, 0, 0", "V3D(hit, 0, 0)"), 0, 0, 0);
}

TEST(Kit, DrawingCallsOfASubmissionCompileAndDrawNothing) {
  const Directory dir;
  dir.write("CollisionPlane.cpp", R"(
#include "stdafx.h"
#include <GL/glew.h>
#include <include/glew.h>
#include <GLFW/glfw3.h>
#include "GUILib/GLMesh.h"
#include "GUILib/GLUtils.h"
#include "GUILib/OBJReader.h"
#include "Utils/Logger.h"
#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  GLMesh mesh, *read = OBJReader::loadOBJFile("../data/bunny.obj");
  vector<P3D> top(4), bottom(4);
  mesh.addPrism(bottom, top);
  mesh.computeNormals();
  GLShaderMaterial material;
  mesh.setMaterial(material);
  mesh.material.setFloatParam("u_color", 0.5, 0.5, 0.5, 1.0);
  glPushMatrix();
  glTranslated(1, 2, 3);
  glEnable(GL_LIGHTING);
  glColor4f(1.0f, 0.5f, 0.5f, 1.0f);
  glBegin(GL_QUADS);
  glNormal3d(0, 1, 0);
  glVertex3d(pointOnPlane[0], pointOnPlane[1], pointOnPlane[2]);
  glEnd();
  glPopMatrix();
  mesh.drawMesh();
  read->drawMesh();
  drawSphere(pointOnPlane, 0.1);
  Logger::consolePrint("%d planes at %lf\n", 1, pointOnPlane[0]);
}
)");
  const BuildResult b = built(dir.path);
  EXPECT_EQ(b.of(StudentFunction::plane_response).kind, FunctionStatus::Kind::compiled)
      << b.of(StudentFunction::plane_response).error;
  Worker worker(b.executable, {});
  EXPECT_EQ(kind_of(worker.call(generic(Function::plane_response))), "reply");
  EXPECT_EQ(worker.take_output(), "");
}

}  // namespace
}  // namespace rigor::grader
