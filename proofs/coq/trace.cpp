// Runs the templates of src/formulas with a recording scalar and prints what they did as Coq definitions (Traced.v).
// proofs/check compiles and runs this at every check; its output never lies in the tree.
#include <cstdio>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/scalar/traced.hpp>
#include <sstream>
#include <tuple>

namespace rigor {
namespace {

using T = Traced;

// How a C++ type looks in Coq (the records are those of Laws.v): its name, a symbol of it that lives in a
// recording, and a value of it written out.
template <class X>
struct Coq;

template <>
struct Coq<T> {
  static constexpr const char* name = "R";
  static T symbol(Recording* in, const std::string& x) { return {in, x}; }
  static std::string write(const T& x) { return x.term(); }
};

template <>
struct Coq<Vec3<T>> {
  static constexpr const char* name = "V";
  static Vec3<T> symbol(Recording* in, const std::string& x) {
    return {{in, "(vx " + x + ")"}, {in, "(vy " + x + ")"}, {in, "(vz " + x + ")"}};
  }
  static std::string write(const Vec3<T>& v) {
    return "(V3 " + v[0].term() + " " + v[1].term() + " " + v[2].term() + ")";
  }
};

template <>
struct Coq<Mat3<T>> {
  static constexpr const char* name = "M";
  static Mat3<T> symbol(Recording* in, const std::string& x) {
    const std::string axis = "xyz";
    Mat3<T> m;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m(i, j) = T(in, std::string("(") + axis[i] + axis[j] + " " + x + ")");
    return m;
  }
  static std::string write(const Mat3<T>& m) {
    std::string text = "(M3";
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) text += " " + m(i, j).term();
    return text + ")";
  }
};

template <>
struct Coq<FrictionOutcome> {
  static std::string write(FrictionOutcome x) {
    switch (x) {
      case FrictionOutcome::stuck: return "stuck";
      case FrictionOutcome::slid: return "slid";
      case FrictionOutcome::slip_stopped_inside: return "slip_stopped_inside";
      case FrictionOutcome::jammed: return "jammed";
    }
    throw std::logic_error("FrictionOutcome");
  }
};

template <>
struct Coq<PlanarMode> {
  static std::string write(PlanarMode x) {
    switch (x) {
      case PlanarMode::sliding: return "sliding";
      case PlanarMode::sticking: return "sticking";
      case PlanarMode::reversed: return "reversed";
    }
    throw std::logic_error("PlanarMode");
  }
};

// A struct: its record's constructor and fields, in the order of the C++ members.
template <class X>
struct Fields;

template <class X>
  requires requires { Fields<X>::members; }
struct Coq<X> {
  static constexpr const char* name = Fields<X>::name;
  static X symbol(Recording* in, const std::string& x) {
    X made;
    each([&](auto member, const char* field) {
      using Member = std::remove_reference_t<decltype(made.*member)>;
      made.*member = Coq<Member>::symbol(in, std::string("(") + field + " " + x + ")");
    });
    return made;
  }
  static std::string write(const X& x) {
    std::string text = std::string("(Build_") + name;
    each([&](auto member, const char*) {
      using Member = std::remove_cvref_t<decltype(x.*member)>;
      text += " " + Coq<Member>::write(x.*member);
    });
    return text + ")";
  }

 private:
  static void each(auto visit) {
    std::apply([&](auto... m) { (visit(m.first, m.second), ...); }, Fields<X>::members);
  }
};

template <class X, class Y>
constexpr std::pair<Y X::*, const char*> field(Y X::* member, const char* name) {
  return {member, name};
}
template <>
struct Fields<ImpactBody<T>> {
  using X = ImpactBody<T>;
  static constexpr const char* name = "ImpactBody";
  static constexpr auto members = std::tuple(field(&X::inverse_mass, "inverse_mass"),
                                             field(&X::inverse_I_B_W, "inverse_inertia"), field(&X::p_BC_W, "arm"));
};
template <>
struct Fields<Velocity<T>> {
  using X = Velocity<T>;
  static constexpr const char* name = "Velocity";
  static constexpr auto members = std::tuple(field(&X::v_WB, "linear"), field(&X::w_WB, "angular"));
};
template <>
struct Fields<PairVelocity<T>> {
  using X = PairVelocity<T>;
  static constexpr const char* name = "PairVelocity";
  static constexpr auto members = std::tuple(field(&X::A, "of_A"), field(&X::B, "of_B"));
};
template <>
struct Fields<Wrench<T>> {
  using X = Wrench<T>;
  static constexpr const char* name = "Wrench";
  static constexpr auto members = std::tuple(field(&X::f_W, "force"), field(&X::tau_W, "torque"));
};
template <>
struct Fields<State<T>> {
  using X = State<T>;
  static constexpr const char* name = "State";
  static constexpr auto members = std::tuple(field(&X::p_WB, "position"), field(&X::R_WB, "orientation"),
                                             field(&X::v_WB, "velocity"), field(&X::w_WB, "spin"));
};

template <>
struct Fields<FrictionImpact<T>> {
  using X = FrictionImpact<T>;
  static constexpr const char* name = "FrictionImpact";
  static constexpr auto members = std::tuple(field(&X::j_W, "impulse"), field(&X::outcome, "outcome"));
};
template <>
struct Fields<PlanarImpact<T>> {
  using X = PlanarImpact<T>;
  static constexpr const char* name = "PlanarImpact";
  static constexpr auto members =
      std::tuple(field(&X::k_nn, "k_nn"), field(&X::k_tt, "k_tt"), field(&X::k_tn, "k_tn"), field(&X::v_n, "v_n"),
                 field(&X::v_t, "v_t"), field(&X::e, "e"), field(&X::mu_s, "mu_s"), field(&X::mu_d, "mu_d"));
};
template <>
struct Fields<PlanarImpulse<T>> {
  using X = PlanarImpulse<T>;
  static constexpr const char* name = "PlanarImpulse";
  static constexpr auto members = std::tuple(field(&X::j_n, "j_n"), field(&X::j_t, "j_t"), field(&X::mode, "mode"));
};

// The formula as a term: operations as lets, comparisons as if-then-else over both outcomes.
void write_tree(const std::vector<bool>& script, const std::string& indent, auto run) {
  Recording recording(script);
  try {
    const std::string result = run(&recording);
    std::printf("%s%s%s", recording.lets(indent).c_str(), indent.c_str(), result.c_str());
  } catch (const Recording::Undecided& at) {
    std::vector<bool> yes = script, no = script;
    yes.push_back(true);
    no.push_back(false);
    std::printf("%s%sif %s then\n", recording.lets(indent).c_str(), indent.c_str(), at.condition.c_str());
    write_tree(yes, indent + "  ", run);
    std::printf("\n%selse\n", indent.c_str());
    write_tree(no, indent + "  ", run);
  }
}

// "Definition PREFIX_NAME (a : R) (b : V) : V := ..." for a function and the names of its arguments.
template <class Result, class... Arguments>
void record(const std::string& prefix, const char* name, Result (*function)(Arguments...), const std::string& argument_names) {
  std::vector<std::string> names;
  std::istringstream words(argument_names);
  for (std::string word; words >> word;) names.push_back(word);
  if (names.size() != sizeof...(Arguments)) throw std::logic_error(std::string(name) + ": argument names");

  [&]<std::size_t... i>(std::index_sequence<i...>) {
    std::printf("Definition %s_%s", prefix.c_str(), name);
    (std::printf(" (%s : %s)", names[i].c_str(), Coq<std::remove_cvref_t<Arguments>>::name), ...);
    std::printf(" : %s :=\n", Coq<Result>::name);
    write_tree({}, "  ", [&](Recording* in) {
      return Coq<Result>::write(function(Coq<std::remove_cvref_t<Arguments>>::symbol(in, names[i])...));
    });
    std::printf(".\n\n");
  }(std::index_sequence_for<Arguments...>());
}

// Formulas of + - * / alone, whose rounding is proved as well.
void record_straight(const std::string& prefix) {
  record(prefix, "cuboid_inertia", &cuboid_inertia<T>, "m s");
  record(prefix, "cuboid_inverse_inertia", &cuboid_inverse_inertia<T>, "I");
  record(prefix, "world_inertia", &world_inertia<T>, "Rot I");
  record(prefix, "world_inverse_inertia", &world_inverse_inertia<T>, "Rot inverse_I");
  record(prefix, "torque_of_force", &torque_of_force<T>, "r f");
  record(prefix, "add_force", &add_force<T>, "sum r f");
  record(prefix, "linear_acceleration", &linear_acceleration<T>, "w f");
  record(prefix, "angular_acceleration", &angular_acceleration<T>, "I inverse_I w tau");
  record(prefix, "point_velocity", &point_velocity<T>, "v w r");
  record(prefix, "rotation_rate", &rotation_rate<T>, "w Rot");
  record(prefix, "naive_rotation_step", &naive_rotation_step<T>, "h w Rot");
  record(prefix, "effective_inverse_mass", &effective_inverse_mass<T>, "A B");
  record(prefix, "normal_inverse_mass", &normal_inverse_mass<T>, "A B n");
  record(prefix, "relative_velocity", &relative_velocity<T>, "A B u");
  record(prefix, "normal_impulse", &normal_impulse<T>, "e v_n k_nn");
  record(prefix, "normal_impulse_printed", &normal_impulse_printed<T>, "e v_n k_nn");
  record(prefix, "apply_impulse", &apply_impulse<T>, "B before j");
  record(prefix, "apply_pair_impulse", &apply_pair_impulse<T>, "A B before j");
  record(prefix, "kinetic_energy", &kinetic_energy<T>, "m I v w");
  record(prefix, "impulse_energy", &impulse_energy<T>, "j v_r_before v_r_after");
  record(prefix, "linear_momentum", &linear_momentum<T>, "m v");
  record(prefix, "angular_momentum", &angular_momentum<T>, "m I p v w o");
}

// With roots or branches.
void record_others(const std::string& prefix) {
  record(prefix, "gram_schmidt", &gram_schmidt<T>, "A");
  record(prefix, "semi_implicit_step", &semi_implicit_step<T>, "h s a alpha");
  record(prefix, "friction_tangent", &friction_tangent<T>, "v_r f n");
  record(prefix, "positional_correction", &positional_correction<T>, "depth n");
  record(prefix, "sheet_friction_impulse", &sheet_friction_impulse<T>, "m mu_s mu_d j_r slip");
  record(prefix, "sheet_literal_friction_impulse", &sheet_literal_friction_impulse<T>, "mu_d j_r slip");
  record(prefix, "coulomb_impulse", &coulomb_impulse<T>, "K v_r n t e mu_s mu_d");
  record(prefix, "planar_impulse_stronge", +[](const PlanarImpact<T>& i) { return planar_impulse<T>(i, Restitution::stronge); }, "i");
  record(prefix, "planar_impulse_poisson", +[](const PlanarImpact<T>& i) { return planar_impulse<T>(i, Restitution::poisson); }, "i");
  record(prefix, "planar_impulse_newton", +[](const PlanarImpact<T>& i) { return planar_impulse<T>(i, Restitution::newton); }, "i");
}

}  // namespace
}  // namespace rigor

// The straight recordings are printed three times, with the same text in three scopes: as real numbers (cpp_), with
// every operation rounded (fl_), and with every difference a sum (size_, the absolute sum a rounding bound is relative to).
int main() {
  std::printf("(* Made by proofs/check from src/formulas. *)\nRequire Import Vec3 Laws.\n\n"
              "Section Recorded.\nVariable eps : R.  (* the scalar's epsilon *)\n\n");
  rigor::record_straight("cpp");
  rigor::record_others("cpp");
  std::printf("End Recorded.\n\n"
              "Section Rounded.\nVariable rnd : R -> R.\nDeclare Scope rounded.\n"
              "Notation \"a + b\" := (rnd (Rplus a b)) : rounded.\nNotation \"a - b\" := (rnd (Rminus a b)) : rounded.\n"
              "Notation \"a * b\" := (rnd (Rmult a b)) : rounded.\nNotation \"a / b\" := (rnd (Rdiv a b)) : rounded.\n"
              "Local Open Scope rounded.\n\n");
  rigor::record_straight("fl");
  std::printf("End Rounded.\n\n"
              "Section Sizes.\nDeclare Scope sizes.\n"
              "Notation \"a - b\" := (Rplus a b) : sizes.\nNotation \"- a\" := a (only parsing) : sizes.\nLocal Open Scope sizes.\n\n");
  rigor::record_straight("size");
  std::printf("End Sizes.\n");
}
