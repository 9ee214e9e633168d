#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rigor/base/suggest.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/peer.hpp>
#include <rigor/studies/plan.hpp>

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
  Names ours = method_names(), known = ours;
  for (const OtherWay& way : other_ways()) known.push_back(way.name);
  for (const Method& m : flow_methods())
    if (find_other_way(std::string(m.name)) == nullptr) known.emplace_back(m.name);
  if (const auto fault = unknown(r.methods, known, "--method", "method")) return *fault;
  Names standard = ours;
  if (timed) standard.insert(standard.end(), {"exact", "exact-plain", "dormand-prince-adaptive", "cvode-adams", "arkode-fehlberg8"});
  std::vector<PeerVariant> variants;
  for (const std::string& peer : r.peers) {
    const auto found = peer_variants(peer);
    if (!found) return found.fault();
    variants.insert(variants.end(), found->begin(), found->end());
  }
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, timed ? Names{"case-A", "case-B", "case-C"} : Names{"short-A", "case-A", "thrown", "forced"})) {
    const auto opened = open_problem(name, r.until.value_or(0));
    if (!opened) return Fault{opened.fault().kind, opened.fault().where == "until" ? "--until" : opened.fault().where == "problem" ? "--problem" : opened.fault().where, opened.fault().what};
    const Problem& problem = **opened;
    const auto add = [&](const std::string& method, const std::vector<long>& steps) {
      for (const long n : steps) cells.push_back({r.kind, name, method, n, 0, r.until.value_or(0)});
    };
    const auto add_tolerances = [&](const std::string& method, double least) {
      for (const double tolerance : tolerances_of(r))
        if (tolerance >= least || !r.tolerances.empty()) cells.push_back({r.kind, name, method, 0, tolerance, r.until.value_or(0)});
    };
    Names used = chosen(r.methods, standard);
    if (r.methods.empty() && !problem.falls)  // on free flight they have no error to study
      for (const Method& m : flow_methods())
        if (std::find(used.begin(), used.end(), m.name) == used.end()) used.emplace_back(m.name);
    if (r.methods.empty() && !problem.falls)  // these know free flight alone: every run of theirs would fail
      for (const char* free : {"exact-plain", "cvode-adams", "arkode-fehlberg8"}) used.erase(std::remove(used.begin(), used.end(), free), used.end());
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
        cells.push_back({r.kind, name, method, 0, 0, r.until.value_or(0)});
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

Outcome<std::vector<Cell>> drifts(const StudyRequest& r) {
  if (const auto fault = unknown(r.methods, method_names(), "--method", "method")) return *fault;
  if (!(r.step > 0) || std::isinf(r.step)) return Fault{Kind::out_of_range, "--step", "is " + digits(r.step) + ", must be > 0 s"};
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, {"case-A"})) {
    const auto opened = open_problem(name);
    if (!opened) return Fault{opened.fault().kind, "--problem", opened.fault().what};
    for (const std::string& method : chosen(r.methods, method_names()))
      for (const bool carried : {false, true})
        if (carried ? r.carried_sums : r.plain_sums) cells.push_back({"drift", name, method, r.steps, 0, 0, r.step, 0, carried});
  }
  return cells;
}
Outcome<std::vector<Cell>> stabilities(const StudyRequest& r) {
  if (const auto fault = unknown(r.methods, method_names(), "--method", "method")) return *fault;
  Names known = problem_names();
  for (const Map& map : maps()) known.push_back(map.name);
  if (const auto fault = unknown(r.problems, known, "--problem", "map or problem")) return *fault;
  std::vector<Cell> cells;
  for (const std::string& name : chosen(r.problems, {"case-A", "spin", "aspect", "mass"}))
    for (const std::string& method : chosen(r.methods, method_names())) {
      if (find_problem(name) != nullptr) cells.push_back({"stability", name, method});
      for (const Map& map : maps())
        if (map.name == name)
          for (const double x : map.xs)
            for (const double y : map.ys) cells.push_back({"stability", name, method, 10000, 0, 0, x, y});
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

Outcome<std::vector<Cell>> plan(const StudyRequest& r) {
  if (const auto fault = unknown({r.kind}, study_kinds(), "", "study")) return *fault;
  const bool flight = r.kind == "convergence" || r.kind == "work-precision";
  const auto refuse = [&](const char* option) { return Fault{Kind::unsupported, option, "is for convergence and work-precision, not for " + r.kind}; };
  if (!flight && r.until) return refuse("--until");
  if (!flight && !r.h.empty()) return refuse("--h");
  if (!flight && !r.tolerances.empty()) return refuse("--tolerance");
  if (!flight && !r.peers.empty()) return refuse("--peers");
  if (!flight && r.kind != "contact" && !r.submission.empty()) return Fault{Kind::unsupported, "--submission", "is for convergence, work-precision and contact, not for " + r.kind};
  if (r.until && !(*r.until > 0 && *r.until <= 1e4)) return Fault{Kind::out_of_range, "--until", "is " + digits(*r.until) + ", must be > 0 and at most 10000 s"};
  for (const double t : r.tolerances)
    if (!(t >= 1e-15 && t <= 0.1)) return Fault{Kind::out_of_range, "--tolerance", "is " + digits(t) + (t < 1e-15 ? ", below rounding" : "") + "; must be in [1e-15, 0.1]"};
  if (flight) return flights(r);
  if (r.kind == "drift") return drifts(r);
  return r.kind == "stability" ? stabilities(r) : contacts(r);
}

}  // namespace rigor::studies
