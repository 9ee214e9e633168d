#include <gtest/gtest.h>

#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/apply_impulse.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/effective_mass.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/naive_rotation_step.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/rotation_rate.hpp>
#include <rigor/formulas/torque_of_force.hpp>
#include <rigor/formulas/world_inertia.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/scalar/strict.hpp>

// Strict has + − × ÷ and order and takes no floating literal: what compiles here has no hidden 0.5 and no
// hidden root. The compiler is the test.
namespace rigor {

using S = Strict;
using V = Vec3<Strict>;
using M = Mat3<Strict>;

template V angular_acceleration<Strict>(const M&, const M&, const V&, const V&);
template Velocity<S> apply_impulse<Strict>(const ImpactBody<S>&, const Velocity<S>&, const V&);
template PairVelocity<S> apply_pair_impulse<Strict>(const ImpactBody<S>&, const ImpactBody<S>&,
                                                    const PairVelocity<S>&, const V&);
template V relative_velocity<Strict>(const ImpactBody<S>&, const ImpactBody<S>&, const PairVelocity<S>&);
template V cuboid_inertia<Strict>(const S&, const V&);
template V cuboid_inverse_inertia<Strict>(const V&);
template M effective_inverse_mass<Strict>(const ImpactBody<S>&, const ImpactBody<S>&);
template Wrench<S> add_force<Strict>(const Wrench<S>&, const V&, const V&);
template V impulse_cancelling<Strict>(const M&, const V&);
template FrictionImpact<S> coulomb_impulse<Strict>(const M&, const V&, const V&, const V&, const S&, const S&,
                                                   const S&);
template S sheet_friction_impulse<Strict>(const S&, const S&, const S&, const S&, const S&);
template S sheet_literal_friction_impulse<Strict>(const S&, const S&, const S&);
template S kinetic_energy<Strict>(const S&, const M&, const V&, const V&);
template S impulse_energy<Strict>(const V&, const V&, const V&);
template V linear_acceleration<Strict>(const S&, const V&);
template V linear_momentum<Strict>(const S&, const V&);
template V angular_momentum<Strict>(const S&, const M&, const V&, const V&, const V&, const V&);
template M naive_rotation_step<Strict>(const S&, const V&, const M&);
template S normal_inverse_mass<Strict>(const ImpactBody<S>&, const ImpactBody<S>&, const V&);
template S normal_impulse<Strict>(const S&, const S&, const S&);
template S normal_impulse_printed<Strict>(const S&, const S&, const S&);
template V point_velocity<Strict>(const V&, const V&, const V&);
template V positional_correction<Strict>(const S&, const V&);
template M rotation_rate<Strict>(const V&, const M&);
template V torque_of_force<Strict>(const V&, const V&);
template M world_inertia<Strict>(const M&, const V&);
template M world_inverse_inertia<Strict>(const M&, const V&);

TEST(Strict, TakesNoFloatingLiteralAndHasNoRoot) {
  EXPECT_FALSE((std::is_constructible_v<Strict, double>));
  EXPECT_TRUE(Field<Strict>);
  EXPECT_FALSE(Rooted<Strict>);
}

}  // namespace rigor
