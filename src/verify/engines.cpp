#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <reference/taylor.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/engine/batch.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/verify/inputs.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {
namespace {

using In = Inputs<double>;
using V = Vec3<double>;

Cuboid<double> cuboid(const In& in) { return *Cuboid<double>::make(in.m, in.s_B); }

// The attitude after two seconds against Taylor's series, which knows no elliptic function.
double exact_flight(const In& in) {
  const V w_B = apply_transposed<double>(in.R_WB, in.w_WB);
  const double t = 2;
  const Mat3<double> series = reference::taylor_free_body<double>({in.I_B, w_B, in.R_WB}, t).R_WB;
  return angle_between<double>(ExactFlight::make(in.I_B, w_B, in.R_WB)->at(t).R_WB, series);
}

// Numbers of other bits than the plain method's after fifty steps under a load, over every method of a batch.
double batch(const In& in) {
  const Cuboid<double> body = cuboid(in);
  const Load load{in.f_W, in.tau_W};
  const Motion start = motion_of(body, {in.p_WB, in.R_WB, in.v_WB, in.w_WB});
  const long steps = 50;
  double differ = 0;
  const auto compare = [&](const auto& a, const auto& b) {
    for (int i = 0; i < a.size(); ++i) differ += std::memcmp(a.data() + i, b.data() + i, sizeof(double)) != 0;
  };
  for (const BatchMethod method : batch_methods) {
    Batch many = *Batch::make({body}, {start}, method);
    many.set_load(0, load);
    many.step(in.h, steps);
    Motion one = start;
    for (long k = 0; k < steps; ++k) one = plain(method).step(body, one, load, in.h);
    const Motion stepped = many.motion(0);
    compare(stepped.state.p_WB, one.state.p_WB), compare(stepped.state.R_WB, one.state.R_WB);
    compare(stepped.state.v_WB, one.state.v_WB), compare(stepped.state.w_WB, one.state.w_WB), compare(stepped.L_W, one.L_W);
  }
  return differ;
}

// Energy of a cuboid as eight point masses of its mass and moments, in the gravity field.
double energy_of_points(const Cuboid<double>& body, const State<double>& s, const V& gravity) {
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const V r_W = s.R_WB * V(body.corner(k) / std::sqrt(3.0));
    const V v = s.v_WB + s.w_WB.cross(r_W);
    sum += body.mass() / 8 * (v.squaredNorm() / 2 - gravity.dot(V(s.p_WB + r_W)));
  }
  return sum;
}

// Two cuboids in an elastic room without friction: what is left of their energy after a second, for each impact.
double located(const In& in) {
  Scene room;
  room.method = "located", room.until = 1, room.every = 1;
  room.surface = *Surface<double>::make(1, 0, 0);
  for (int i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) room.planes.push_back(*Plane<double>::make(V(-12 * side * V::Unit(i)), V(side * V::Unit(i))));
  State<double> a{V(-5.5, 0, 0), in.R_WB, in.u.A.v_WB, in.u.A.w_WB}, b{V(5.5, 0, 0), identity3<double>(), in.u.B.v_WB, in.u.B.w_WB};
  a.v_WB[0] += 8, b.v_WB[0] -= 8;
  room.bodies = {{cuboid(in), a}, {*Cuboid<double>::make(in.m_B, in.s_B), b}};
  double first = NAN, last = NAN, size = 0;
  const auto run = simulate_located(room, [&](double, const std::vector<State<double>>& states) {
    last = 0;
    for (std::size_t i = 0; i < states.size(); ++i) last += energy_of_points(room.bodies[i].shape, states[i], room.gravity);
    if (std::isnan(first)) {
      first = last;
      size = std::fabs(first) + (in.m + in.m_B) * room.gravity.norm() * 12;
    }
  });
  promise(bool(run), "an elastic room is a scene for located mode");
  return std::fabs(last - first) / size / double(1 + run->ledger.impacts);
}

struct Row {
  const char *id, *oracle;
  double bound;
  double (*distance)(const In&);
  long share;  // of the cases: one in so many
};

constexpr double u = 0x1p-53;
const Row rows[] = {
    // a hundred steps of the series, each a few roundings of a unit quaternion: 1e-14; measured worst in tests/verify
    {"engine.exact-flight", "Taylor series of the quaternion equations in double, angle in rad after 2 s", 5e-14, exact_flight, 5},
    {"engine.batch", "the plain methods, all that a batch has: numbers of other bits after 50 steps", 0, batch, 1},
    {"engine.located", "energy of an elastic room from point masses, relative, an impact", 64 * u, located, 5},
};

}  // namespace

std::vector<std::string> engine_ids() {
  std::vector<std::string> ids;
  for (const Row& row : rows) ids.push_back(row.id);
  return ids;
}

std::vector<Agreement> engines(const std::string& only, long cases, std::uint64_t seed) {
  std::vector<Agreement> results;
  for (const Row& row : rows) {
    if (!only.empty() && only != row.id) continue;
    Agreement result{row.id, row.oracle, 0, row.bound, 0};
    Random random(seed);
    for (long c = 0; c < std::max(1L, cases / row.share) && interrupted() == 0; ++c) {
      const double distance = row.distance(draw<double>(random));
      if (!(distance <= result.worst)) result.worst = distance;
      ++result.cases;
    }
    results.push_back(result);
  }
  return results;
}

}  // namespace rigor::verify
