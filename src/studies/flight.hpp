#pragma once
#include <rigor/studies/cell.hpp>
#include <rigor/studies/problem.hpp>
#include <rigor/studies/student.hpp>

namespace rigor::studies {

/// Ways to fly that are not fixed-step methods of ours: "exact" (closed form, set-up and one evaluation), "exact-plain" (the
/// same with constants in double), "dormand-prince-adaptive" (ours, by tolerance), "cvode-adams", "cvode-bdf" and "arkode-fehlberg8" (SUNDIALS, by tolerance).
struct OtherWay {
  std::string name;
  std::string says;
  bool adaptive;   ///< else it has neither step nor tolerance
};
const std::vector<OtherWay>& other_ways();
/// nullptr when there is none of that name.
const OtherWay* find_other_way(const std::string& name);

/// A fixed-step method of ours by name, those whose free turn is the closed form too: "exact" under a load, "exact-kicks4".
/// nullptr when there is none of that name.
const Method* find_stepper(const std::string& name);

/// A cell of "convergence" or "work-precision": errors (attitude, momentum, energy, position), `probe` (one number of the
/// solution, for extrapolation), evaluations; where timed cpu_min, cpu_median, wall_min, wall_median. The problem was opened before. A run that goes
/// wrong has NaN errors and says why.
Row fly(const Cell& cell, Student* student = nullptr);

}  // namespace rigor::studies
