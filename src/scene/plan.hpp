#pragma once
#include <rigor/base/outcome.hpp>
#include <rigor/scene/ledger.hpp>
#include <string>
#include <vector>

namespace rigor {

/// What a stepper may leave out. The states have the same bits with and without each.
struct Skips {
  bool pairs = true;      ///< pairs too far apart to touch in the step
  bool planes = true;     ///< planes no corner can reach
  bool loads = true;      ///< moments of the forces where there is no force but gravity
  bool monitors = false;  ///< accounts of every step, where nobody asked for them: sums over steps are NaN then, the end's and the impacts' are kept
  bool rest = true;       ///< steps of cuboids at rest without load
};

/// `skips` without the named ones; "all" for every one. Fault: unknown, with the names there are.
Outcome<Skips> without(Skips skips, const std::vector<std::string>& ids);

/// One thing left out, or not: how often, of how many.
struct PlanLine {
  std::string id, what, why, effect;
  bool skipped;
  long left_out, of;
};
std::vector<PlanLine> plan(const Skips& skips, const Ledger::Skips& counted);

}  // namespace rigor
