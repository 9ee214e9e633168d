#include <rigor/grader/check.hpp>

namespace rigor::grader {
namespace {

constexpr double tight = 1e-5;  // of the scale: a student may compute in float (docs/grading.md)

Scenario draw(Random& random, bool turned) {
  Scenario s;
  s.A = draw_box(random, turned);
  return s;
}
std::vector<Call> ask_constructor(const Scenario& s) {
  Request q = request(Function::body_inertia, s);
  q.direct = 0;  // the constructor calls computeBodyCoordsMOI
  return {{s.constants, q}};
}
std::vector<Call> ask_world(const Scenario& s, std::uint32_t which) {
  Request q = request(Function::world_inertia, s);
  q.flags = which;
  return {{s.constants, q}};
}
std::vector<Call> ask_tensor(const Scenario& s) { return ask_world(s, tensor_only); }
std::vector<Call> ask_inverse(const Scenario& s) { return ask_world(s, inverse_only); }
Mat3<double> diagonal(const Vec3<double>& d) { return d.asDiagonal(); }

Judgement judge_tensor(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("body tensor", "kg m^2", mat(r[0].A.body_inertia), diagonal(s.A.I_B()), tight * s.A.I_B().maxCoeff());
  return j;
}
Judgement judge_inverse(const Scenario& s, const std::vector<Reply>& r, bool own) {
  Mat3<double> want = diagonal(s.A.inverse_I_B());
  const Mat3<double> given = mat(r[0].A.body_inertia);
  // the identity is what a constructor leaves, not a tensor of the submission's own
  if (own && given.diagonal().cwiseAbs().minCoeff() > 0 && given != identity3<double>()) want = diagonal(given.diagonal().cwiseInverse());
  Judgement j;
  // a tensor of zero (1/12 in whole numbers) has no inverse: what is not finite was made from it
  if (own && given == Mat3<double>(Mat3<double>::Zero())) {
    const Vec3<double> diagonal = mat(r[0].A.body_inverse_inertia).diagonal();
    j.add("inverse of the submission's own zero (1: not finite)", "1", (diagonal - diagonal).array().isNaN().all() ? 1 : 0, 1, 0.5);
    return j;
  }
  j.add("inverse body tensor", "1/(kg m^2)", mat(r[0].A.body_inverse_inertia), want, tight * want.cwiseAbs().maxCoeff());
  return j;
}
Judgement judge_world(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("world tensor", "kg m^2", mat(r[0].world_inertia), s.A.world_inertia(), tight * s.A.I_B().maxCoeff());
  return j;
}
Judgement judge_world_inverse(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("inverse world tensor", "1/(kg m^2)", mat(r[0].world_inverse_inertia), s.A.world_inverse(),
        tight * s.A.inverse_I_B().maxCoeff());
  return j;
}

}  // namespace

std::vector<Check> inertia_checks() {
  const auto turned = [](Random& random, int) { return draw(random, true); };
  const auto upright = [](Random& random, int) { return draw(random, false); };
  return {
      {"moi.body", "Inertia", StudentFunction::body_inertia, "inertia.cuboid",
       "the body tensor is diag(h^2+d^2, w^2+d^2, w^2+h^2) m/12, with full edge lengths", 4,
       {"moi.no-twelfth", "moi.sixth", "moi.third", "moi.half-extents", "moi.no-mass", "moi.own-edge", "moi.axes-cycled",
        "moi.axes-cycled-back", "moi.axes-swapped", "moi.sphere", "moi.cube", "moi.products"},
       turned, ask_constructor, judge_tensor},
      {"moi.body-inverse", "Inertia", StudentFunction::body_inertia, "inertia.cuboid_inverse",
       "the second field holds the inverse of the body tensor", 2, {"moi.inverse-missing", "moi.inverse-is-tensor"}, turned,
       ask_constructor, judge_inverse, true},
      {"moi.world", "Inertia", StudentFunction::world_inertia, "inertia.world", "the world tensor is R I R^T", 3,
       {"world.transposed", "world.no-right-factor", "world.no-left-factor", "world.body", "world.inverse-instead"}, turned,
       ask_tensor, judge_world},
      {"moi.world-upright", "Inertia", StudentFunction::world_inertia, "inertia.world",
       "for R = 1 the world tensor is the body tensor", 1, {"world.inverse-instead"}, upright, ask_tensor, judge_world},
      {"moi.world-inverse", "Inertia", StudentFunction::world_inverse_inertia, "inertia.world_inverse",
       "the inverse world tensor is R I^-1 R^T", 4,
       {"world-inverse.transposed", "world-inverse.no-right-factor", "world-inverse.no-left-factor", "world-inverse.body",
        "world-inverse.tensor-instead", "world-inverse.elementwise", "world-inverse.of-diagonal"},
       turned, ask_inverse, judge_world_inverse},
      {"moi.world-inverse-upright", "Inertia", StudentFunction::world_inverse_inertia, "inertia.world_inverse",
       "for R = 1 the inverse world tensor is the inverse body tensor", 1, {"world-inverse.tensor-instead"}, upright,
       ask_inverse, judge_world_inverse},
  };
}

}  // namespace rigor::grader
