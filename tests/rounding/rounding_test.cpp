#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/naive_rotation_step.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/scalar/magnitude.hpp>

// The bounds of the docstrings against the worst error found, by chance and by a search that tries to break them.
// The reference is the same template in long double, on the same double inputs: its own error is below 2^-11 of the
// bound, whatever the cancellation, because both are relative to the absolute sum (Magnitude).
namespace rigor {
namespace {

using Numbers = std::vector<double>;

template <class T>
struct Reader {  // hands out the numbers of a case one after another, as scalars, vectors, matrices
  const Numbers& numbers;
  std::size_t next = 0;
  T scalar() { return T(numbers.at(next++)); }
  Vec3<T> vector() {
    const T x = scalar(), y = scalar();
    return Vec3<T>(x, y, scalar());
  }
  Mat3<T> matrix() {
    Mat3<T> m;
    for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = scalar();
    return m;
  }
  ImpactBody<T> body() {
    ImpactBody<T> b;
    b.inverse_mass = scalar(), b.inverse_I_B_W = matrix(), b.p_BC_W = vector();
    return b;
  }
  Velocity<T> velocity() {
    Velocity<T> u;
    u.v_WB = vector(), u.w_WB = vector();
    return u;
  }
};

template <class T>
void put(std::vector<T>& out, const T& x) { out.push_back(x); }
template <class T>
void put(std::vector<T>& out, const Vec3<T>& v) { out.insert(out.end(), v.data(), v.data() + 3); }
template <class T>
void put(std::vector<T>& out, const Mat3<T>& m) { out.insert(out.end(), m.data(), m.data() + 9); }
template <class T>
void put(std::vector<T>& out, const Velocity<T>& u) { put<T>(out, u.v_WB), put<T>(out, u.w_WB); }

// The largest error of a component in units of gamma(k) times its absolute sum.
template <class Formula>
double ratio(const Formula& formula, int k, const Numbers& numbers) {
  static std::vector<double> got;
  static std::vector<long double> want;
  static std::vector<Magnitude> sum;
  got.clear(), want.clear(), sum.clear();
  formula(Reader<double>{numbers}, got);
  formula(Reader<long double>{numbers}, want);
  formula(Reader<Magnitude>{numbers}, sum);
  double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = double(std::abs(static_cast<long double>(got[i]) - want[i]));
    if (error == 0) continue;
    const double r = error / (gamma_bound(k) * sum[i].size);
    if (!(r <= worst)) worst = r;
  }
  return worst;
}

// A number whose roundings are large: a significand just above 1 (a rounding error is largest relative to it there),
// or any; an exponent near 0, or far away; now and then a zero, or the negative of a neighbour, to cancel.
double awkward(std::mt19937_64& random, const Numbers& before) {
  const std::uint64_t bits = random();
  const double fraction = double(bits >> 12) * 0x1p-52;
  const double significand = 1 + (bits & 1 ? fraction : fraction * fraction * fraction * fraction);
  const int reach = bits & 2 ? 2 : 60;
  const double size = std::ldexp(significand, int((bits >> 4) % std::uint64_t(2 * reach + 1)) - reach);
  if ((bits >> 10) % 32 == 0 && !before.empty()) return -before[std::size_t(bits >> 20) % before.size()] * (1 + 0x1p-52);
  if ((bits >> 10) % 64 == 1) return 0;
  return bits & 8 ? -size : size;
}

struct Measured {
  double worst = 0;
  Numbers at;
};

// Half of the cases by chance; in the other half the worst one so far is changed a little, and kept when it is worse.
template <class Formula>
Measured search(const Formula& formula, int k, std::size_t inputs, const std::vector<std::size_t>& positive, long cases) {
  std::mt19937_64 random(20260414);
  Measured found;
  Numbers numbers;
  const auto consider = [&] {
    for (const std::size_t i : positive) numbers[i] = numbers[i] == 0 ? 1 : std::abs(numbers[i]);
    const double r = ratio(formula, k, numbers);
    if (!(r <= found.worst)) found = {r, numbers};
  };
  for (long c = 0; c < cases / 2; ++c) {
    numbers.clear();
    while (numbers.size() < inputs) numbers.push_back(awkward(random, numbers));
    consider();
  }
  for (long c = cases / 2; c < cases && !found.at.empty(); ++c) {
    numbers = found.at;
    for (int changes = 1 + int(random() % 3); changes > 0; --changes) {
      double& x = numbers[random() % inputs];
      x = random() % 4 == 0 ? awkward(random, numbers) : x * (1 + std::ldexp(double(random() >> 11) * 0x1p-53 - 0.5, -int(random() % 52)));
    }
    consider();
  }
  return found;
}

// A tenth of them by default; all with RIGOR_ALL=1.
const long cases = std::getenv("RIGOR_ALL") ? 1000000 : 100000;

// Within the bound at every input tried; and a bound that no input brings above a tenth is said to be idle.
template <class Formula>
void hold(const char* id, int k, std::size_t inputs, const Formula& formula, const std::vector<std::size_t>& positive = {}) {
  const Measured m = search(formula, k, inputs, positive, cases);
  std::printf("%-30s gamma(%2d)  worst %.3f of the bound%s\n", id, k, m.worst, m.worst < 0.1 ? "  WARNING: idle" : "");
  std::string at;
  char digits[40];
  for (const double x : m.at) std::snprintf(digits, sizeof digits, " %a", x), at += digits;
  EXPECT_LE(m.worst, 1) << id << " at" << at;
  EXPECT_GT(m.worst, 0) << id << ": nothing was rounded";
}

}  // namespace

TEST(RoundingBounds, OfInertiaHold) {
  hold("inertia.cuboid", 4, 4, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T m = in.scalar();
    put<T>(out, cuboid_inertia<T>(m, in.vector()));
  });
  hold("inertia.cuboid_inverse", 1, 3, []<class T>(Reader<T> in, std::vector<T>& out) { put<T>(out, cuboid_inverse_inertia<T>(in.vector())); },
       {0, 1, 2});
  hold("inertia.world", 5, 12, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Mat3<T> R = in.matrix();
    put<T>(out, world_inertia<T>(R, in.vector()));
  });
  hold("inertia.world_inverse", 5, 12, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Mat3<T> R = in.matrix();
    put<T>(out, world_inverse_inertia<T>(R, in.vector()));
  });
}

TEST(RoundingBounds, OfForcesAndMotionHold) {
  hold("force.torque", 2, 6, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Vec3<T> r = in.vector();
    put<T>(out, torque_of_force<T>(r, in.vector()));
  });
  hold("force.sum", 3, 12, []<class T>(Reader<T> in, std::vector<T>& out) {
    Wrench<T> sum;
    sum.f_W = in.vector(), sum.tau_W = in.vector();
    const Vec3<T> r = in.vector();
    put<T>(out, add_force<T>(sum, r, in.vector()).tau_W);
  });
  hold("motion.linear", 1, 4, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T w = in.scalar();
    put<T>(out, linear_acceleration<T>(w, in.vector()));
  });
  hold("motion.euler", 9, 24, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Mat3<T> I = in.matrix(), J = in.matrix();
    const Vec3<T> w = in.vector();
    put<T>(out, angular_acceleration<T>(I, J, w, in.vector()));
  });
  hold("motion.point_velocity", 3, 9, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Vec3<T> v = in.vector(), w = in.vector();
    put<T>(out, point_velocity<T>(v, w, in.vector()));
  });
  hold("rotation.rate", 2, 12, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Vec3<T> w = in.vector();
    put<T>(out, rotation_rate<T>(w, in.matrix()));
  });
  hold("rotation.naive_step", 4, 13, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T h = in.scalar();
    const Vec3<T> w = in.vector();
    put<T>(out, naive_rotation_step<T>(h, w, in.matrix()));
  });
}

TEST(RoundingBounds, OfImpulsesHold) {
  hold("impulse.effective_mass", 8, 26, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> A = in.body();
    put<T>(out, effective_inverse_mass<T>(A, in.body()));
  }, {0, 13});
  hold("impulse.normal_effective_mass", 12, 29, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> A = in.body(), B = in.body();
    put<T>(out, normal_inverse_mass<T>(A, B, in.vector()));
  }, {0, 13});
  hold("impulse.relative_velocity", 4, 38, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> A = in.body(), B = in.body();
    PairVelocity<T> u;
    u.A = in.velocity(), u.B = in.velocity();
    put<T>(out, relative_velocity<T>(A, B, u));
  });
  const auto impulse = []<class T>(Reader<T> in, std::vector<T>& out) {
    const T e = in.scalar(), v = in.scalar();
    put<T>(out, normal_impulse<T>(e, v, in.scalar()));
  };
  hold("impulse.normal", 3, 3, impulse, {0, 2});
  hold("impulse.normal_printed", 3, 3, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T e = in.scalar(), v = in.scalar();
    put<T>(out, normal_impulse_printed<T>(e, v, in.scalar()));
  }, {0, 2});
  hold("impulse.apply, velocity", 2, 22, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> B = in.body();
    const Velocity<T> u = in.velocity();
    put<T>(out, apply_impulse<T>(B, u, in.vector()).v_WB);
  });
  hold("impulse.apply, spin", 6, 22, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> B = in.body();
    const Velocity<T> u = in.velocity();
    put<T>(out, apply_impulse<T>(B, u, in.vector()).w_WB);
  });
  hold("impulse.apply_pair", 6, 41, []<class T>(Reader<T> in, std::vector<T>& out) {
    const ImpactBody<T> A = in.body(), B = in.body();
    PairVelocity<T> u;
    u.A = in.velocity(), u.B = in.velocity();
    const PairVelocity<T> after = apply_pair_impulse<T>(A, B, u, in.vector());
    put<T>(out, after.A), put<T>(out, after.B);
  });
}

TEST(RoundingBounds, OfEnergyMomentumAndContactHold) {
  hold("energy.kinetic", 8, 16, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T m = in.scalar();
    const Mat3<T> I = in.matrix();
    const Vec3<T> v = in.vector();
    put<T>(out, kinetic_energy<T>(m, I, v, in.vector()));
  });
  hold("energy.impulse", 5, 9, []<class T>(Reader<T> in, std::vector<T>& out) {
    const Vec3<T> j = in.vector(), v = in.vector();
    put<T>(out, impulse_energy<T>(j, v, in.vector()));
  });
  hold("momentum.linear", 1, 4, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T m = in.scalar();
    put<T>(out, linear_momentum<T>(m, in.vector()));
  });
  hold("momentum.angular", 5, 22, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T m = in.scalar();
    const Mat3<T> I = in.matrix();
    const Vec3<T> p = in.vector(), v = in.vector(), w = in.vector();
    put<T>(out, angular_momentum<T>(m, I, p, v, w, in.vector()));
  });
  hold("contact.correction", 1, 4, []<class T>(Reader<T> in, std::vector<T>& out) {
    const T depth = in.scalar();
    put<T>(out, positional_correction<T>(depth, in.vector()));
  }, {0});
  hold("friction.sheet", 1, 2, []<class T>(Reader<T> in, std::vector<T>& out) {  // sticking: the product m s
    const T m = in.scalar(), s = in.scalar();
    put<T>(out, sheet_friction_impulse<T>(m, T(1e300), T(0), T(1), s));
  }, {0, 1});
}

// The teeth: a bound that counts too few roundings is broken, and so is one that forgets a term that cancels.
TEST(RoundingBounds, AreBrokenWhenOneRoundingIsForgotten) {
  const auto impulse = []<class T>(Reader<T> in, std::vector<T>& out) {
    const T e = in.scalar(), v = in.scalar();
    put<T>(out, normal_impulse<T>(e, v, in.scalar()));
  };
  EXPECT_GT(search(impulse, 2, 3, {0, 2}, 100000).worst, 1);
  const auto torque = []<class T>(Reader<T> in, std::vector<T>& out) {
    const Vec3<T> r = in.vector();
    put<T>(out, torque_of_force<T>(r, in.vector()));
  };
  EXPECT_GT(search(torque, 1, 6, {}, 100000).worst, 1);
  const auto inaccurate = []<class T>(Reader<T> in, std::vector<T>& out) {  // (a + b) - b: another formula of the same value
    const T e = in.scalar(), v = in.scalar(), k = in.scalar();
    const T j = normal_impulse<T>(e, v, k);
    if constexpr (std::is_same_v<T, double>) put<T>(out, (j + v) - v);
    else put<T>(out, j);
  };
  EXPECT_GT(search(inaccurate, 3, 3, {0, 2}, 100000).worst, 1);
}

}  // namespace rigor
