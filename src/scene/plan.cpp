#include <rigor/scene/plan.hpp>

namespace rigor {
namespace {

// The one list of ids; what counts them is beside it.
struct Entry {
  const char *id, *what, *why, *effect;
  bool Skips::*flag;
  long Ledger::Skips::*left_out, Ledger::Skips::*of;
};
constexpr Entry entries[] = {
    {"pairs", "pairs", "far apart", "same bits", &Skips::pairs, &Ledger::Skips::pairs, &Ledger::Skips::pairs_of},
    {"planes", "cuboids at planes", "out of reach", "same bits", &Skips::planes, &Ledger::Skips::planes, &Ledger::Skips::planes_of},
    {"loads", "sums of forces", "as in the step before", "same bits", &Skips::loads, &Ledger::Skips::loads, &Ledger::Skips::loads_of},
    {"rest", "steps of a cuboid", "at rest without load", "same bits", &Skips::rest, &Ledger::Skips::rest, &Ledger::Skips::rest_of},
    {"monitors", "accounts of a step", "nobody reads them", "same states; no account of steps", &Skips::monitors, &Ledger::Skips::monitors, &Ledger::Skips::monitors_of},
};

}  // namespace

Outcome<Skips> without(Skips skips, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    bool known = id == "all";
    std::string names = "all";
    for (const Entry& e : entries) {
      names += std::string(", ") + e.id;
      if (id == "all" || id == e.id) skips.*e.flag = false, known = true;
    }
    if (!known) return Fault{Fault::Kind::out_of_range, "no-skip", "is \"" + id + "\", must be one of " + names};
  }
  return skips;
}

std::vector<PlanLine> plan(const Skips& skips, const Ledger::Skips& counted) {
  std::vector<PlanLine> lines;
  for (const Entry& e : entries) lines.push_back({e.id, e.what, e.why, e.effect, skips.*e.flag, counted.*e.left_out, counted.*e.of});
  return lines;
}

}  // namespace rigor
