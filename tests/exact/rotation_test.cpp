#include <gtest/gtest.h>

#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/formulas/naive_rotation_step.hpp>
#include <rigor/formulas/rotation_rate.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <tests/exact/draw.hpp>
#include <tests/exact/dual.hpp>

namespace rigor {
namespace {

Q square(const Q& x) { return x * x; }
/// 2t/(1 − t²): 1 + b² is then the square of (1 + t²)/(1 − t²).
Q half_angle_tangent(const Q& t) { return Q(2) * t / (Q(1) - t * t); }
Q half_angle_secant(const Q& t) { return (Q(1) + t * t) / (Q(1) - t * t); }

/// b = h ω_B such that all three norms of Gram-Schmidt on (1 + [b]ₓ) are rational. Its Gram matrix is
/// (1 + b²)1 − b bᵀ, whose leading minors are 1 + b₂² + b₃², (1 + b²)(1 + b₃²), (1 + b²)²: three squares
/// wanted.
Vec3<Q> draw_turn(Draw& draw) {
  const Q t1 = draw.number(), t2 = draw.number(), t3 = draw.number();
  const Q b3 = half_angle_tangent(t3), c3 = half_angle_secant(t3);
  const Q b2 = c3 * half_angle_tangent(t2), c2 = c3 * half_angle_secant(t2);
  return Vec3<Q>(c2 * half_angle_tangent(t1), b2, b3);
}

}  // namespace

// The exact derivative of R along a line of quaternions q + t q̇, ω = 2 vec(q̇ q̄)/|q|².
// id: rotation.rate
TEST(RotationRate, IsTheDerivativeOfTheRotation) {
  Draw draw(21);
  for (int i = 0; i < draws; ++i) {
    const Q s = draw.number(), s_dot = draw.number();
    const Vec3<Q> u = draw.vector(), u_dot = draw.vector();
    const Vec4<Q> q(s, u[0], u[1], u[2]), q_dot(s_dot, u_dot[0], u_dot[1], u_dot[2]);
    const Vec3<Q> w = (s * u_dot - s_dot * u - cross<Q>(u_dot, u)) * (Q(2) / q.dot(q));
    EXPECT_EQ(rotation_rate<Q>(w, rotation_of<Q>(q)), slope_of(rotation_of<Dual>(moving<4>(q, q_dot))));
  }
}

// case K-05
TEST(RotationRate, FromTheLeftWithWorldSpinIsFromTheRightWithBodySpin) {
  Draw draw(22);
  for (int i = 0; i < draws; ++i) {
    const Mat3<Q> R = draw.rotation();
    const Vec3<Q> w_B = draw.vector();
    EXPECT_EQ(rotation_rate<Q>(Vec3<Q>(R * w_B), R), Mat3<Q>(R * skew<Q>(w_B)));
  }
}

// case K-07: the defect, the determinant, what stays along ω and how far the rest turns.
// id: rotation.naive_step
TEST(NaiveRotationStep, StretchesAcrossTheSpinByItsKnownDefect) {
  Draw draw(23);
  for (int i = 0; i < draws; ++i) {
    const Mat3<Q> R = draw.rotation();
    const Vec3<Q> w = draw.vector();
    const Q h = draw.positive(), theta2 = h * h * w.dot(w);
    const Mat3<Q> next = naive_rotation_step<Q>(h, w, R);
    const Vec3<Q> w_B = R.transpose() * w;
    const Mat3<Q> expected = identity3<Q>() * (Q(1) + theta2) - w_B * w_B.transpose() * (h * h);
    EXPECT_EQ(Mat3<Q>(next.transpose() * next), expected);
    EXPECT_EQ(determinant(next), Q(1) + theta2);
    EXPECT_EQ(Vec3<Q>(next * w_B), w);  // along ω nothing happens
    const Vec3<Q> across_B = cross<Q>(w_B, draw.vector()), before = R * across_B, after = next * across_B;
    EXPECT_EQ(after.dot(after), (Q(1) + theta2) * across_B.dot(across_B));
    EXPECT_EQ(cross<Q>(before, after),
              Vec3<Q>(w * (h * across_B.dot(across_B))));  // |b||a| sin = hω: angle atan(hω)
    EXPECT_EQ(before.dot(after), across_B.dot(across_B));  // |b||a| cos = 1
  }
}

// A = Q U with U upper triangular, its diagonal positive: the factors are unique, so Q is the answer.
// id: rotation.gram_schmidt
TEST(GramSchmidt, OfAnOrthogonalTimesAnUpperTriangularMatrixIsTheOrthogonalOne) {
  Draw draw(24);
  for (int i = 0; i < draws; ++i)
    for (const Q& hand : {Q(1), Q(-1)}) {  // a left-handed input stays left-handed: a reflection
      Mat3<Q> R = draw.rotation(), U = zero33<Q>();
      R.col(2) *= hand;
      for (int k = 0; k < 3; ++k) {
        U(k, k) = draw.positive();
        for (int j = k + 1; j < 3; ++j) U(k, j) = draw.number();
      }
      const Mat3<Q> G = gram_schmidt<Q>(Mat3<Q>(R * U));
      EXPECT_EQ(G, R);
      EXPECT_EQ(determinant(G), hand);
    }
}

// Velocities first, then the pose with the new ones. The new rotation is the one whose transpose makes
// R + h[ω']ₓR upper triangular with a positive diagonal; there is only one.
// id: step.semi_implicit
TEST(SemiImplicitStep, MovesWithTheNewVelocitiesAndKeepsTheRotationOrthonormal) {
  Draw draw(25);
  for (int i = 0; i < draws; ++i) {
    State<Q> s = draw.state();
    const Q h = draw.positive();
    const Vec3<Q> a = draw.vector(), alpha = draw.vector();
    const Vec3<Q> w_new = s.R_WB * draw_turn(draw) / h;
    s.w_WB = w_new - h * alpha;
    const State<Q> next = semi_implicit_step<Q>(h, s, a, alpha);
    EXPECT_EQ(next.v_WB, Vec3<Q>(s.v_WB + h * a));
    EXPECT_EQ(next.w_WB, w_new);
    EXPECT_EQ(next.p_WB, Vec3<Q>(s.p_WB + h * s.v_WB + h * h * a));
    EXPECT_EQ(orthonormality_defect<Q>(next.R_WB), Q(0));
    EXPECT_EQ(determinant(next.R_WB), Q(1));
    const Mat3<Q> naive = s.R_WB + h * skew<Q>(w_new) * s.R_WB, U = next.R_WB.transpose() * naive;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT(U(k, k), Q(0));
      for (int j = 0; j < k; ++j) EXPECT_EQ(U(k, j), Q(0));
    }
  }
}

// Spin about one body axis: the repaired step turns by atan(hω) exactly, tangent of the half angle t.
TEST(SemiImplicitStep, TurnsAboutABodyAxisByTheArcusTangentOfHOmega) {
  Draw draw(26);
  for (int i = 0; i < draws; ++i) {
    const Q t = draw.fraction() / Q(2), h = draw.positive();
    State<Q> s = draw.state();
    s.w_WB = s.R_WB.col(2) * (half_angle_tangent(t) / h);
    const State<Q> next = semi_implicit_step<Q>(h, s, zero3<Q>(), zero3<Q>());
    EXPECT_EQ(next.R_WB, Mat3<Q>(s.R_WB * rotation_of<Q>(Vec4<Q>(Q(1), Q(0), Q(0), t))));
  }
}

// case D-02: v_n = v₀ + n h g, hence p_n = p₀ + n h v₀ + h² g (1 + … + n) = parabola(t) + g t h/2, t = n h.
TEST(SemiImplicitStep, LeadsTheParabolaByExactlyHalfGTH) {
  Draw draw(27);
  for (int i = 0; i < draws; ++i) {
    State<Q> s = draw.state();
    s.w_WB = zero3<Q>();
    const Vec3<Q> p = s.p_WB, v = s.v_WB, g = draw.vector();
    const Q h = draw.positive();
    const int n = 20;
    for (int k = 0; k < n; ++k) s = semi_implicit_step<Q>(h, s, g, zero3<Q>());
    const Q t = Q(n) * h;
    EXPECT_EQ(s.p_WB, Vec3<Q>(p + t * v + (square(t) / Q(2)) * g + (t * h / Q(2)) * g));
    EXPECT_EQ(s.v_WB, Vec3<Q>(v + t * g));
  }
}

}  // namespace rigor
