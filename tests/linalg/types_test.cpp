#include <gtest/gtest.h>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/bodies/plane.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/rational.hpp>
#include <rigor/scalar/strict.hpp>
#include <rigor/scalar/constants.hpp>

namespace rigor {
using Q = Rational;
template Vec3<Strict> cuboid_inertia<Strict>(const Strict&, const Vec3<Strict>&);
template Mat3<Strict> effective_inverse_mass<Strict>(const ImpactBody<Strict>&, const ImpactBody<Strict>&);
template Mat3<Strict> rotation_of<Strict>(const Vec4<Strict>&);

TEST(Rotation, OfAnIntegerQuaternionIsOrthogonalOverTheRationals) {
  const Mat3<Q> R = rotation_of<Q>(Vec4<Q>(Q(1), Q(2), Q(-1), Q(3)));
  EXPECT_EQ(orthonormality_defect<Q>(R), Q(0));
  EXPECT_EQ(dot<Q>(cross<Q>(R.col(0), R.col(1)), R.col(2)), Q(1));
  const auto c = Cuboid<Q>::make(Q(3), Vec3<Q>(Q(1), Q(2), Q(3)));
  ASSERT_TRUE(c);
  EXPECT_EQ(c->inertia()[0], Q(13, 4));
  State<double> s;
  s.w_WB = Vec3<double>(0.1, 2, 3);
  EXPECT_LT(orthonormality_defect<double>(semi_implicit_step<double>(0.01, s, zero3<double>(), zero3<double>()).R_WB), 1e-15);
  const Mat3<Q> U = gram_schmidt<Q>(R);
  EXPECT_EQ(orthonormality_defect<Q>(U), Q(0));
  EXPECT_EQ(friction_tangent<double>({3, 0, 4}, {0, 0, 0}, {1, 0, 0})[2], 1.0);
  EXPECT_FALSE(Plane<double>::make({0, 0, 0}, {0, 2, 0}));
}
}  // namespace rigor
