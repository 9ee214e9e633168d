#pragma once
#include <array>
#include <functional>
#include <rigor/grader/build.hpp>
#include <rigor/grader/scenario.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// One call of a case: which process (its constants), what is asked. A case may need several.
struct Call {
  Constants constants;
  Request request;
  double seconds = 0;  ///< limit for this call where it is longer than usual
};

/// One number of an answer beside what it should be.
struct Component {
  std::string name;  ///< "velocity after, x"
  std::string unit;
  double got, want, bound;  ///< right when |got − want| ≤ bound
};

/// The judge's view of one case.
struct Judgement {
  std::vector<Component> components;
  std::string note;  ///< a named variant that was seen ("literal friction rule"), or why the case cannot be right

  void add(const std::string& name, const std::string& unit, double got, double want, double bound) {
    components.push_back({name, unit, got, want, bound});
  }
  void add(const std::string& name, const std::string& unit, const Vec3<double>& got, const Vec3<double>& want, double bound) {
    for (int i = 0; i < 3; ++i) add(name + ", " + "xyz"[i], unit, got[i], want[i], bound);
  }
  void add(const std::string& name, const std::string& unit, const Mat3<double>& got, const Mat3<double>& want, double bound) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        add(name + " (" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")", unit, got(i, j), want(i, j), bound);
  }
  /// A law that holds when nothing happens must not reward a function that does nothing.
  void add_happened(const std::string& where, bool happened) { add("something happens " + where + " (1: yes)", "1", happened ? 1 : 0, 1, 0.5); }
  /// Largest |got − want|/bound; infinite where a number is not finite. Right when ≤ 1.
  double ratio() const;
};

/// A named check: which inputs, what is asked of the student's code, what counts as right.
struct Check {
  std::string id;        ///< "plane.impulse"
  std::string group;     ///< of the default rubric: "Plane normal"
  StudentFunction function;
  std::string formula;   ///< id of the formula it is about, for `rigor explain`
  std::string says;      ///< one sentence for the student: what must hold
  double points;         ///< in the default rubric; 0 is advice or information
  std::vector<std::string> claims;  ///< misconceptions that every admitted input must show by 20 bounds

  std::function<Scenario(Random&, int)> draw;   ///< case number → inputs; may be inadmissible
  std::function<std::vector<Call>(const Scenario&)> calls;
  /// `own`: expected values from what the student's own helper functions gave (errors carried forward).
  std::function<Judgement(const Scenario&, const std::vector<Reply>&, bool own)> judge;
  bool carries = false;  ///< judge() looks at `own`
  std::function<bool(const Scenario&)> sound = [](const Scenario&) { return true; };  ///< inputs mean what they should
  /// Re-derives what follows from other numbers (the position from the corner in contact), for the shrinker.
  std::function<void(Scenario&)> renew = [](Scenario&) {};
  /// Checks of what this one takes for granted. Where one of them failed, given() is what judges a case that judge() does
  /// not pass: by the answer's own value of it (the size of its normal impulse, its push-out). A wrong law is paid for once.
  std::vector<std::string> follows = {};
  std::function<Judgement(const Scenario&, const std::vector<Reply>&, bool own)> given = nullptr;
  int cases = 0;  ///< how many, where the rubric's number would take too long; 0: as the rubric says
};

/// Every check, in the order of the report.
const std::vector<Check>& checks();
/// nullptr when there is none of that id.
const Check* find_check(const std::string& id);

/// The inputs mean what they should, and a right answer is judged right on them.
bool usable(const Check& check, const Scenario& scenario);
/// Whether an input shows every mistake the check claims: wrong by at least 20 bounds, right by less than one.
bool admitted(const Check& check, const Scenario& scenario);
/// Case `number` of a check under a seed: always the same inputs. Every admitted scenario is sound.
Scenario draw_case(const Check& check, std::uint64_t seed, int number);

/// What update.convergence sees: errors of position, velocity, spin and rotation, parts of their scales, for each step.
struct Convergence {
  std::array<double, 4> h;
  std::array<std::array<double, 4>, 4> error;
};
Convergence convergence(const Scenario& scenario, const std::vector<Reply>& replies);

// The parts, one file each.
std::vector<Check> inertia_checks();
std::vector<Check> force_checks();
std::vector<Check> update_checks();
std::vector<Check> plane_checks();
std::vector<Check> friction_checks();
std::vector<Check> pair_checks();
std::vector<Check> own_checks();  ///< an instructor's: own.cpp

}  // namespace rigor::grader
