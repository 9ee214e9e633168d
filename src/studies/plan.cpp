#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <reference/precise.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/peer.hpp>
#include <rigor/studies/plan.hpp>
#include <set>

namespace rigor::studies {
namespace {

using Kind = Fault::Kind;
using Names = std::vector<std::string>;

Names chosen(const Names& asked, const Names& standard) { return asked.empty() ? standard : asked; }
std::optional<Fault> unknown(const Names& asked, const Names& known, const std::string& option, const std::string& what) {
  for (const std::string& name : asked)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return Fault{Kind::unknown_key, option, fmt::format("there is no {} '{}'{}; known: {}", what, name, did_you_mean(name, known), fmt::join(known, ", "))};
  return std::nullopt;
}

// What is asked for twice would be two groups of cells in one.
std::optional<Fault> repeated(const Names& asked, const std::string& option) {
  std::set<std::string> seen;
  for (const std::string& name : asked)
    if (!seen.insert(name).second) return Fault{Kind::out_of_range, option, "has " + name + " twice, must have it once"};
  return std::nullopt;
}

// An option that the study would not look at.
std::optional<Fault> without_effect(const StudyRequest& r) {
  const Names flight{"convergence", "work-precision"}, by_step{"convergence", "work-precision", "contact"}, drift{"drift"};
  const struct {
    const char* name;
    bool given;
    const Names& studies;
  } options[] = {{"--until", r.until.has_value(), flight},          {"--h", !r.h.empty(), flight},
                 {"--tolerance", !r.tolerances.empty(), flight},    {"--peer", !r.peers.empty(), flight},
                 {"--submission", !r.submission.empty(), by_step},  {"--coarsest", r.coarsest.has_value(), by_step},
                 {"--rungs", r.rungs.has_value(), by_step},         {"--steps", r.steps.has_value(), drift},
                 {"--step", r.step.has_value(), drift},             {"--sums", !r.sums.empty(), drift}};
  for (const auto& option : options)
    if (option.given && std::find(option.studies.begin(), option.studies.end(), r.kind) == option.studies.end())
      return Fault{Kind::unsupported, option.name, fmt::format("is for {}, not for {}", fmt::join(option.studies, ", "), r.kind)};
  if (!r.h.empty() && (r.coarsest || r.rungs)) return Fault{Kind::unsupported, r.coarsest ? "--coarsest" : "--rungs", "is of a ladder, --h names the steps: only one of the two"};
  return std::nullopt;
}
std::optional<Fault> without_effect(const StudyRequest& r, const std::vector<Cell>& cells) {
  const bool by_step = std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.steps > 0; }), by_tolerance = std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.tolerance > 0; });
  for (const auto& [option, given] : {std::pair{"--h", !r.h.empty()}, {"--coarsest", r.coarsest.has_value()}, {"--rungs", r.rungs.has_value()}})
    if (given && !by_step) return Fault{Kind::unsupported, option, "is for ways that take steps: none of those asked for does"};
  if (!r.tolerances.empty() && !by_tolerance) return Fault{Kind::unsupported, "--tolerance", "is for adaptive ways and peers: none of those asked for is one"};
  return std::nullopt;
}

// A problem of the catalogue or a scene file. Of `free` flights alone, a name that is none of either is answered with those.
Outcome<const Problem*> opened(const std::string& name, double until, bool free, const Names& more = {}) {
  const Names all = problem_names();
  if (free && !name.ends_with(".json") && std::find(all.begin(), all.end(), name) == all.end()) {
    Names known = free_flight_names();
    known.insert(known.end(), more.begin(), more.end());
    Fault fault = *unknown({name}, known, "--problem", more.empty() ? "problem" : "map or problem");
    fault.what += ", or a scene file";
    return fault;
  }
  const auto problem = open_problem(name, until);
  if (problem) return problem;
  const Fault& fault = problem.fault();
  return Fault{fault.kind, fault.where == "until" ? "--until" : fault.where == "problem" ? "--problem" : fault.where, fault.what};
}
// Why a problem with a load cannot be asked of somebody who knows gravity alone.
Fault loaded(const std::string& problem, const std::string& who) {
  return {Kind::unsupported, "--problem", fmt::format("is {}, which has a load that is not gravity alone: {}; without: {}, a scene file", problem, who, fmt::join(free_flight_names(), ", "))};
}

// ---- flights

/// Numbers of steps, coarse to fine. Without a wish: by the order of the method, so that both ends of its range are seen.
std::vector<long> ladder(const StudyRequest& r, bool timed, int order) {
  std::vector<long> steps;
  const bool own = timed && !r.coarsest && !r.rungs;
  double n = own ? (order >= 6 ? 6 : order >= 4 ? 25 : 50) : double(r.coarsest.value_or(50));
  const double factor = own && order >= 6 ? 1.5 : 2;
  const int rungs = own ? (order >= 6 ? 15 : order >= 4 ? 12 : 14) : r.rungs.value_or(8);
  for (int k = 0; k < rungs; ++k, n *= factor) steps.push_back(std::lround(n));
  return steps;
}
Outcome<std::vector<long>> steps_of(const StudyRequest& r, const Problem& problem, bool timed, int order) {
  if (r.h.empty()) return ladder(r, timed, order);
  std::vector<long> steps;
  for (const double h : r.h) {
    if (!(h > 0) || std::isinf(h)) return Fault{Kind::out_of_range, "--h", "is " + digits(h) + ", must be > 0 s"};
    const double n = problem.until / h;
    if (!(n >= 0.5 && n < 1e10) || std::fabs(n - std::round(n)) > 1e-9 * n)
      return Fault{Kind::out_of_range, "--h", "is " + digits(h) + " s, which does not divide T = " + digits(problem.until) + " s of " + problem.name + " into whole steps; " +
                                                  digits(problem.until) + "/" + digits(std::fmax(1, std::floor(std::fmin(n, 1e10)))) + " does"};
    steps.push_back(std::lround(n));
  }
  std::sort(steps.begin(), steps.end());
  if (const auto twice = std::adjacent_find(steps.begin(), steps.end()); twice != steps.end())
    return Fault{Kind::out_of_range, "--h", "has " + digits(problem.until / double(*twice)) + " s twice, must have it once"};
  return steps;
}
std::vector<double> tolerances_of(const StudyRequest& r) {
  if (!r.tolerances.empty()) return r.tolerances;
  std::vector<double> all;
  for (int k = 2; k <= 14; ++k) all.push_back(std::pow(10, -k));
  return all;
}

Outcome<std::vector<Cell>> flights(const StudyRequest& r) {
  const bool timed = r.kind == "work-precision";
  if (const auto fault = unknown(r.methods, flying_methods(), "--method", "method")) return *fault;
  Names standard = method_names();
  if (timed) standard.insert(standard.end(), {"exact", "exact-plain", "dormand-prince-adaptive", "cvode-adams", "arkode-fehlberg8"});
  std::vector<PeerVariant> variants;
  for (const std::string& peer : r.peers) {
    const auto found = peer_variants(peer);
    if (!found) return found.fault();
    variants.insert(variants.end(), found->begin(), found->end());
  }
  Names problems = timed ? Names{"case-A", "case-B", "case-C"} : Names{"short-A", "case-A", "thrown"};
  if (!timed && r.submission.empty() && variants.empty()) problems.push_back("forced");
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, problems)) {
    const auto found = opened(name, r.until.value_or(0), !r.submission.empty() || !variants.empty());
    if (!found) return found.fault();
    const Problem& problem = **found;
    if (!problem.falls && !r.submission.empty()) return loaded(name, "a submission is not asked for it");
    if (!problem.falls && !variants.empty()) return loaded(name, "peers are not asked for it");
    const auto put = [&](const std::string& method, long steps, double tolerance) { cells.push_back({r.kind, name, method, steps, tolerance, r.until.value_or(0), 0, 0, false, problem.content}); };
    const auto add = [&](const std::string& method, const std::vector<long>& steps) {
      for (const long n : steps) put(method, n, 0);
    };
    const auto add_tolerances = [&](const std::string& method, double least) {
      for (const double tolerance : tolerances_of(r))
        if (tolerance >= least || !r.tolerances.empty()) put(method, 0, tolerance);
    };
    Names used = chosen(r.methods, standard);
    if (r.methods.empty() && !problem.falls)  // on free flight they have no error to study
      for (const Method& m : flow_methods())
        if (std::find(used.begin(), used.end(), m.name) == used.end()) used.emplace_back(m.name);
    if (!problem.falls)
      for (const char* free : {"exact-plain", "cvode-adams", "cvode-bdf", "arkode-fehlberg8"}) {
        const auto it = std::find(used.begin(), used.end(), free);
        if (it == used.end()) continue;
        if (!r.methods.empty()) return loaded(name, std::string(free) + " knows no other");
        used.erase(it);
      }
    for (const std::string& method : used) {
      const OtherWay* way = find_other_way(method);
      const Method* stepper = find_stepper(method);
      if (way == nullptr || (!problem.falls && stepper != nullptr)) {
        const auto steps = steps_of(r, problem, timed, problem.falls ? stepper->order : stepper->forced_order);
        if (!steps) return steps.fault();
        add(method, *steps);
      } else if (way->adaptive) {
        add_tolerances(method, 1e-14);
      } else {
        put(method, 0, 0);
      }
    }
    if (!r.submission.empty()) {
      const auto steps = steps_of(r, problem, false, 1);
      if (!steps) return steps.fault();
      add(r.submission, *steps);
    }
    for (const PeerVariant& v : variants) {
      if (v.adaptive) {
        add_tolerances(v.name, 1e-13);
        continue;
      }
      std::vector<long> steps;
      if (!r.h.empty() || !timed) {
        const auto asked = steps_of(r, problem, timed, 1);
        if (!asked) return asked.fault();
        steps = *asked;
      } else {
        for (long n = 50; double(n) * v.ns < 4e8; n *= 4) steps.push_back(n);
      }
      add(v.name, steps);
    }
  }
  return cells;
}

// ---- the others

// The free flight of a problem, for studies that leave its centre out: it must turn.
Outcome<const Problem*> spinning(const std::string& name, const std::string& study, const Names& maps = {}) {
  const auto problem = opened(name, 0, true, maps);
  if (!problem) return problem;
  if (!(*problem)->falls) return loaded(name, study + " would leave it out");
  if ((*problem)->start.w_WB.isZero(0)) return Fault{Kind::out_of_range, "--problem", "is " + name + ", whose spin is 0: " + study + " is relative to its energy"};
  return problem;
}
Outcome<std::vector<Cell>> drifts(const StudyRequest& r) {
  if (const auto fault = unknown(r.methods, method_names(), "--method", "method")) return *fault;
  const Names sums{"plain", "carried"};
  if (const auto fault = unknown(r.sums, sums, "--sums", "sum")) return *fault;
  const double step = r.step.value_or(0.01);
  if (!(step > 0) || std::isinf(step)) return Fault{Kind::out_of_range, "--step", "is " + digits(step) + ", must be > 0 s"};
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, {"case-A"})) {
    const auto problem = spinning(name, "drift");
    if (!problem) return problem.fault();
    for (const std::string& method : chosen(r.methods, method_names()))
      for (const std::string& sum : chosen(r.sums, sums)) cells.push_back({"drift", name, method, r.steps.value_or(1000000), 0, 0, step, 0, sum == "carried", (*problem)->content});
  }
  return cells;
}
Outcome<std::vector<Cell>> stabilities(const StudyRequest& r) {
  if (const auto fault = unknown(r.methods, method_names(), "--method", "method")) return *fault;
  Names known_maps;
  for (const Map& map : maps()) known_maps.push_back(map.name);
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, {"case-A", "spin", "aspect", "mass"})) {
    const Map* map = find_map(name);
    std::string content;
    if (map == nullptr) {
      const auto problem = spinning(name, "stability", known_maps);
      if (!problem) return problem.fault();
      content = (*problem)->content;
    }
    for (const std::string& method : chosen(r.methods, method_names())) {
      if (map == nullptr) cells.push_back({"stability", name, method, 0, 0, 0, 0, 0, false, content});
      else
        for (const double x : map->xs)
          for (const double y : map->ys) cells.push_back({"stability", name, method, 10000, 0, 0, x, y});
    }
  }
  return cells;
}
Outcome<std::vector<Cell>> contacts(const StudyRequest& r) {
  Names known, ways = method_names();
  for (const ContactProblem& p : contact_problems()) known.push_back(p.name);
  ways.push_back("located");
  if (const auto fault = unknown(r.problems, known, "--problem", "problem of contact")) return *fault;
  if (const auto fault = unknown(r.methods, ways, "--method", "method")) return *fault;
  Names used = chosen(r.methods, {"sheet", "split2", "located"});
  if (!r.submission.empty()) used.push_back(r.submission);
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, known))
    for (const ContactProblem& p : contact_problems())
      if (p.name == name)
        for (const std::string& method : used) {
          std::vector<long> steps{0};
          if (method != "located") {
            steps.clear();
            const int rungs = r.rungs.value_or(method == r.submission ? 4 : 7);  // its steps are calls to another process
            for (int k = 0; k < rungs; ++k) steps.push_back(r.coarsest.value_or(120) << k);
          }
          for (const long n : steps)
            for (const double x : p.sweep) cells.push_back({"contact", name, method, n, 0, 0, x});
        }
  return cells;
}

}  // namespace

const std::vector<std::string>& study_kinds() {
  static const Names kinds{"convergence", "work-precision", "drift", "stability", "contact"};
  return kinds;
}

std::vector<std::string> flying_methods() {
  Names all = method_names();
  for (const OtherWay& way : other_ways()) all.push_back(way.name);
  for (const Method& m : flow_methods())
    if (find_other_way(std::string(m.name)) == nullptr) all.emplace_back(m.name);
  return all;
}

Outcome<std::vector<Cell>> plan(const StudyRequest& r) {
  const reference::FreesPreciseCaches at_the_end;
  if (const auto fault = unknown({r.kind}, study_kinds(), "", "study")) return *fault;
  if (const auto fault = without_effect(r)) return *fault;
  Names tolerances;
  for (const double t : r.tolerances) tolerances.push_back(digits(t));
  for (const auto& [option, names] : {std::pair{"--problem", r.problems}, {"--method", r.methods}, {"--peer", r.peers}, {"--sums", r.sums}, {"--tolerance", tolerances}})
    if (const auto fault = repeated(names, option)) return *fault;
  if (r.until && !(*r.until > 0 && *r.until <= 1e4)) return Fault{Kind::out_of_range, "--until", "is " + digits(*r.until) + ", must be > 0 and at most 10000 s"};
  for (const double t : r.tolerances)
    if (!(t >= 1e-14 && t <= 0.1)) return Fault{Kind::out_of_range, "--tolerance", "is " + digits(t) + (t < 1e-14 ? ", where the estimate of an error is rounding" : "") + "; must be in [1e-14, 0.1]"};
  const auto cells = r.kind == "drift" ? drifts(r) : r.kind == "stability" ? stabilities(r) : r.kind == "contact" ? contacts(r) : flights(r);
  if (!cells) return cells;
  if (const auto fault = without_effect(r, *cells)) return *fault;
  return cells;
}

}  // namespace rigor::studies
