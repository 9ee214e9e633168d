// Where no known mistake fits, a simple relation that holds on every case is said, with its value.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/relations.hpp>

namespace rigor::grader {
namespace {

// The relation seen between a right student's answers changed by `change` and the right ones.
std::string seen(const std::string& id, const std::function<void(const Request&, Reply&)>& change) {
  const Check& check = *find_check(id);
  std::vector<Record> records;
  for (int k = 0; k < 12; ++k) {
    Record record{draw_case(check, 3, k), {}};
    for (const Call& call : check.calls(record.inputs)) {
      Reply r = model_answer({}, call.constants, call.request);
      change(call.request, r);
      record.replies.push_back(r);
    }
    records.push_back(record);
  }
  return relation(check, records);
}

TEST(Relations, OfARightAnswerIsTheFactorOne) {
  EXPECT_EQ(seen("moi.body", [](const Request&, Reply&) {}), "the result is 1 times the right one, always");
}
TEST(Relations, AConstantFactorWithItsValue) {
  EXPECT_EQ(seen("moi.body", [](const Request&, Reply& r) { for (double& x : r.A.body_inertia) x *= 0.3; }), "the result is 0.3 times the right one, always");
}
TEST(Relations, AFlippedSign) {
  EXPECT_EQ(seen("moi.body", [](const Request&, Reply& r) { for (double& x : r.A.body_inertia) x = -x; }), "the result has the opposite sign, always");
}
TEST(Relations, TheUnchangedInput) {
  EXPECT_EQ(seen("pair.impulse", [](const Request& q, Reply& r) { r.A = q.A, r.B = q.B; }), "the result is the unchanged input, always");
}
TEST(Relations, Zero) {
  EXPECT_EQ(seen("moi.world", [](const Request&, Reply& r) { for (double& x : r.world_inertia) x = 0; }).substr(0, 10), "the result");
}
TEST(Relations, ATransposedMatrix) {  // of dR/dt: R' − R turned over at every step size
  EXPECT_EQ(seen("update.rotation", [](const Request& q, Reply& r) {
              double d[9];
              for (int i = 0; i < 9; ++i) d[i] = r.A.rotation[i] - q.A.rotation[i];
              for (int i = 0; i < 9; ++i) r.A.rotation[i] = q.A.rotation[i] + d[3 * (i % 3) + i / 3];
            }),
            "the result is transposed, always");
}
TEST(Relations, ExchangedComponents) {
  EXPECT_EQ(seen("force.sum", [](const Request&, Reply& r) { std::swap(r.A.net_force[0], r.A.net_force[1]); }), "in the result x and y are exchanged, always");
  EXPECT_EQ(seen("force.sum", [](const Request&, Reply& r) {
              std::swap(r.A.net_force[0], r.A.net_force[1]);
              std::swap(r.A.net_force[1], r.A.net_force[2]);
            }),
            "in the result y, z, x stand in place of x, y, z, always");
}
TEST(Relations, OffByAConstant) {
  EXPECT_EQ(seen("force.sum", [](const Request&, Reply& r) { r.A.net_force[1] -= 9.8; }), "the result is off by a constant, always: net force, y by -9.8 N");
}
TEST(Relations, OneAxisOnly) {
  EXPECT_EQ(seen("force.torque", [](const Request& q, Reply& r) { r.A.net_torque[2] += q.vector[0] * q.vector[1]; }), "only the z component is wrong, always");
}
TEST(Relations, AnotherPowerOfDt) {
  const auto move = [](int power) {
    return [power](const Request& q, Reply& r) {
      for (int i = 0; i < 3; ++i) r.A.velocity[i] = q.A.velocity[i] + std::pow(q.h, power) * q.A.net_force[i] * q.A.net_force[i];
    };
  };
  EXPECT_EQ(seen("update.linear", move(0)), "in one step the velocity changes by the same whatever dt is");
  EXPECT_EQ(seen("update.linear", move(2)), "in one step the velocity changes with dt squared: wrong by the order of dt");
}
// A step of 1/60 s whatever dt is: the factor that extrapolation makes of it, 29.87, is none of the student's.
TEST(Relations, AFixedStepIsNoFactor) {
  const auto fixed = [](const Request& q, Reply& r) {
    Request at = q;
    at.h = 1.0 / 60;
    r = model_answer({}, {0.5, 0.5, 0.5, at.h}, at);
  };
  EXPECT_EQ(seen("update.torque", fixed), "in one step the angular velocity changes by the same whatever dt is");
  EXPECT_EQ(seen("update.linear", fixed), "in one step the velocity changes by the same whatever dt is; the position changes by the same whatever dt is");
  EXPECT_EQ(seen("update.rotation", fixed), "in one step the rotation changes by the same whatever dt is");
}
// dt squared leaves a limit of zero, and yet the answer is neither zero nor the input.
TEST(Relations, DtSquaredIsNotNothing) {
  EXPECT_EQ(seen("update.torque", [](const Request& q, Reply& r) { for (int i = 0; i < 3; ++i) r.A.spin[i] *= q.h; }),
            "in one step the angular velocity changes with dt squared: wrong by the order of dt");
}
// Zero, saturated or overflowing, as where a variable is not initialised: the same at every dt, but dt is not what is missing.
TEST(Relations, NoneOfAnswersThatShowNoChange) {
  for (const double value : {0.0, 1e-310, 25.0, 1e12, 1e300, double(INFINITY)})
    for (const char* check : {"update.linear", "update.gyroscopic", "update.torque", "update.rotation"}) {
      const std::string words = seen(check, [&](const Request&, Reply& r) {
        for (double& x : r.A.velocity) x = value;
        for (double& x : r.A.spin) x = value;
        for (double& x : r.A.rotation) x = value;
      });
      // at rest without a spin a spin of zero is the unchanged input
      if (value < 1e-300 && check == std::string("update.torque")) EXPECT_EQ(words, "the result is the unchanged input, always");
      else EXPECT_EQ(words, "") << check << ' ' << value;
    }
  // of the case, and yet nothing is left in it of what was there
  EXPECT_EQ(seen("update.gyroscopic", [](const Request& q, Reply& r) { for (int i = 0; i < 3; ++i) r.A.spin[i] = 1e200 * q.A.mass; }), "");
  EXPECT_EQ(seen("force.sum", [](const Request&, Reply& r) { for (double& x : r.A.net_force) x = 1e300; }), "");
}
TEST(Relations, AnAxisWithTheOppositeSign) {
  EXPECT_EQ(seen("force.torque", [](const Request&, Reply& r) { r.A.net_torque[1] = -r.A.net_torque[1]; }), "the y component has the opposite sign, always");
}
TEST(Relations, AnAxisWithTheOppositeSignOfWhatIsAdded) {
  EXPECT_EQ(seen("force.torque", [](const Request& q, Reply& r) { r.A.net_torque[1] = 2 * q.A.net_torque[1] - r.A.net_torque[1]; }), "what is added to the y component has the opposite sign, always");
}
TEST(Relations, AFactorOfOneQuantity) {
  EXPECT_EQ(seen("update.linear", [](const Request& q, Reply& r) { for (int i = 0; i < 3; ++i) r.A.velocity[i] = (r.A.velocity[i] + q.A.velocity[i]) / 2; }),
            "dv/dt is 0.5 times the right one, always");
}
// A mistake of no such form: nothing is invented.
TEST(Relations, NoneWhereThereIsNone) {
  EXPECT_EQ(seen("force.sum", [](const Request& q, Reply& r) { for (int i = 0; i < 3; ++i) r.A.net_force[i] += q.vector[(i + 1) % 3] * q.vector[i]; }), "");
  EXPECT_EQ(seen("force.sum", [](const Request&, Reply& r) { r.A.net_force[0] = NAN; }), "");
}

}  // namespace
}  // namespace rigor::grader
