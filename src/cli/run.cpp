#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/refused.hpp>
#include <rigor/cli/run.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/report/wrap.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/scene/overlap.hpp>
#include <rigor/scene/trajectory.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/view/replay.hpp>

namespace rigor::cli {
namespace {

struct RunOptions {
  std::string scene;
  std::optional<std::string> method, out;
  std::vector<std::string> beside;
  std::optional<double> dt, until, every;
  std::uint64_t seed = 0;
  std::vector<std::string> no_skip;
  bool json = false, quiet = false, explain = false;
};

int refuse_run(const Fault& fault) { return refused("run", fault.text()); }

using studies::brief;
constexpr std::size_t most_shown = 10;  // of a list, on a terminal

// At most 80 columns, names of files and reasons apart.
void print(const Scene& scene, const RunSummary& run, double wall) {
  const Ledger& l = run.ledger;
  const bool located = scene.method == "located";
  const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); };
  fmt::print("{}: {}, {}, method {}", scene.name, count(scene.bodies.size(), "cuboid"), count(scene.planes.size(), "plane"), scene.method);
  if (!located) fmt::print(", dt {} s", brief(scene.dt, "%g"));
  fmt::print("\n  {:<18} {} to t = {} s in {:.3f} s\n", located ? "advances" : "steps", run.steps, brief(run.t_end, "%g"), wall);
  const auto four = [](double x) { return brief(x, "%.4g"); };
  const auto three = [](double x) { return brief(x, "%.3g"); };
  if (const Overlap overlap = overlap_at_start(scene); overlap.cuboids > 0)
    fmt::print("  starts inside      walls or each other: {}, by up to {} m;\n                     pushed out at once\n", count(overlap.cuboids, "cuboid"), three(overlap.depth));
  fmt::print("  energy             {} J -> {} J\n", brief(l.energy.start, "%.6g"), brief(l.energy.end, "%.6g"));
  fmt::print("    accounted for    work {}, restitution lost {}, friction lost {},\n", four(l.energy.work), four(l.energy.restitution_loss), four(l.energy.friction_loss));
  fmt::print("                     correction {}, switched {}, the steps' own {} J\n", four(l.energy.correction), four(l.energy.switched), four(l.energy.stepper));
  fmt::print("  steps' own, worst  energy {} J, angular momentum {} kg m^2/s\n", three(l.energy.worst_stepper), three(l.angular.worst_stepper));
  fmt::print("  unexplained, worst energy {} J, linear momentum {} N s,\n", three(l.energy.worst_drift), three(l.linear.worst_drift));
  fmt::print("                     angular momentum {} kg m^2/s\n", three(l.angular.worst_drift));
  fmt::print("  impacts            {}: planes {}, pairs {}; {} gained energy\n", l.impacts, l.plane_impacts, l.pair_impacts, l.energy_rises);
  const auto first = [&](const auto& all, const auto& line) {
    for (std::size_t k = 0; k < std::min(all.size(), most_shown); ++k) line(all[k]);
    if (all.size() > most_shown) fmt::print("    and {} more: summary.json has all (--json prints it, --out writes it)\n", all.size() - most_shown);
  };
  first(run.accumulations, [](const Accumulation& a) { fmt::print("  bounces ended      cuboid {} at t = {} s, {} s left out\n", a.body, brief(a.at, "%.9g"), brief(a.tail, "%.2g")); });
  first(run.handed_over, [](const HandOver& h) {
    fmt::print("  handed over        cuboid {}, t = {} to {} s{}:\n    {}\n", h.body, brief(h.from, "%.6g"), brief(h.to, "%.6g"), h.times > 1 ? ", " + std::to_string(h.times) + " times" : "", h.why);
  });
  first(run.may_have_missed, [](const MayHaveMissed& m) {
    fmt::print("  may have missed    cuboids {} and {} in {}, t = {} to {} s:\n    they met too often in one step; a smaller dt follows them\n", m.A, m.B, m.times == 1 ? "1 step" : std::to_string(m.times) + " steps", brief(m.from, "%.6g"), brief(m.to, "%.6g"));
  });
  for (const PlanLine& line : plan({}, l.skips))
    if (line.skipped && line.left_out > 0) fmt::print("  skipped            {:.1f} % of {} {}: {}\n", 100 * double(line.left_out) / double(line.of), line.of, line.what, line.why);
  fmt::print("  deepest overlap    {} m\n", three(l.deepest_penetration));
  fmt::print("  orthonormality     off by {} at worst\n", brief(l.worst_orthonormality, "%.2g"));
}

// Why a run did not come to its end, or "".
std::string cut_short(const RunSummary& run, bool located) {
  const std::string at = " at t = " + brief(run.t_end, "%g") + " s";
  if (!run.stopped.empty()) return "stopped" + at + ": " + run.stopped;
  if (!run.finite) return "a number stopped being finite" + at + (located ? "" : "; the step is too long for this scene and method");
  if (run.interrupted) return "interrupted" + at + "; what is shown and written ends there";
  return "";
}

// What the methods make of one scene, line under line.
void print_beside(const std::vector<std::pair<std::string, RunSummary>>& runs) {
  fmt::print("by method: energy at the end; what the steps by themselves made of energy and\nangular momentum, at worst\n  {:<20}{:>14}{:>14}{:>14}{:>10}\n", "", "J", "J", "kg m^2/s", "impacts");
  for (const auto& [method, run] : runs) {
    const Ledger& l = run.ledger;
    fmt::print("  {:<20}{:>14}{:>14}{:>14}{:>10}\n", method, brief(l.energy.end, "%.6g"), brief(l.energy.worst_stepper), brief(l.angular.worst_stepper), l.impacts);
    if (const std::string why = cut_short(run, method == "located"); !why.empty()) fmt::print("{}", report::filled(why, 80, 4));
  }
}

// summary.json of the scene's method; under "beside" the same of each method beside it.
std::string with_beside(const std::string& own, const std::vector<std::string>& others) {
  if (others.empty()) return own;
  auto json = nlohmann::ordered_json::parse(own);
  for (const std::string& other : others) json["beside"].push_back(nlohmann::ordered_json::parse(other));
  return json.dump(2) + "\n";
}

// What the scene needs, and what was left out, each with its reason.
void explain(const Scene& scene, const Skips& skips, const RunSummary& run) {
  std::printf("plan of %s\n", scene.name.c_str());
  const auto needs = [](const char* what, bool needed, const std::string& why) { std::printf("  %-8s %-9s %s\n", needed ? "needs" : "needs no", what, why.c_str()); };
  const std::size_t n = scene.bodies.size(), partners = n > 0 ? n - 1 : 0;
  const bool vacuum = std::any_of(scene.actions.begin(), scene.actions.end(), [](const SceneAction& a) { return a.what == SceneAction::Do::vacuum_on; });
  const bool torque = !scene.forces.empty() || vacuum;
  const auto count = [](std::size_t k, const char* what) { return std::to_string(k) + " " + what + (k == 1 ? "" : "s"); };
  needs("planes", n > 0 && !scene.planes.empty(), count(scene.planes.size(), "plane") + ", " + count(n, "cuboid"));
  needs("pairs", n > 1, count(n * partners / 2, "pair") + " of cuboids");
  needs("friction", !scene.surface.frictionless() && !scene.planes.empty(),
        scene.surface.frictionless() ? "both coefficients are 0" : scene.planes.empty() ? "it acts on planes only" : std::string("law ") + name(scene.friction_law));
  needs("torque", torque, torque ? "forces or the vacuum" : "no force but gravity");
  if (scene.method == "located") std::printf("  needs no steps     flights in closed form, searched impact by impact\n");
  for (const PlanLine& line : plan(skips, run.ledger.skips))
    if (line.of == 0) continue;
    else if (line.skipped) std::printf("  skips    %-9s %ld of %ld %s: %s\n%21s%s\n", line.id.c_str(), line.left_out, line.of, line.what.c_str(), line.why.c_str(), "", line.effect.c_str());
    else std::printf("  does     %-9s all %ld %s\n", line.id.c_str(), line.of, line.what.c_str());
}

std::string lead(const Scene& scene, const RunSummary& run) {
  char text[240], dt[32] = "";
  if (scene.method != "located") std::snprintf(dt, sizeof dt, ", dt %.4g s", scene.dt);
  std::snprintf(text, sizeof text, "%zu cuboid%s, method %s%s, seed %llu; %ld impacts in %.4g s; energy %.4g J at the start, %.4g J at the end",
                scene.bodies.size(), scene.bodies.size() == 1 ? "" : "s", scene.method.c_str(), dt, static_cast<unsigned long long>(scene.seed), run.ledger.impacts, run.t_end,
                run.ledger.energy.start, run.ledger.energy.end);
  return text;
}

// Runs the scene by its method; what is to be replayed goes into `recording`, where there is one.
Outcome<RunSummary> simulate_recorded(const Scene& scene, view::Recording* recording, const Observer& observe, const Skips& skips = {}) {
  const Observer both = [&](double t, const std::vector<State<double>>& states) {
    observe(t, states);
    if (recording != nullptr) recording->add(t, states);
  };
  if (scene.method == "located")
    return simulate_located(scene, both, [&](const LocatedImpact& impact) {
      if (recording != nullptr) recording->impact(impact.body, impact.before, impact.after);
    }, skips);
  return simulate(scene, both, [&](const Impact& impact) {
    if (recording != nullptr) recording->impact(impact);
  }, skips);
}

// The scene by each method of --beside, only to be compared with it.
Outcome<std::vector<Scene>> beside(const Scene& scene, const RunOptions& options) {
  std::vector<Scene> scenes;
  for (const std::string& method : options.beside) {
    scenes.push_back(scene);
    scenes.back().method = method;
    if (const auto ok = check_scene(scenes.back()); !ok) return Fault{ok.fault().kind, "--beside", ok.fault().what};
  }
  return scenes;
}

int run_command(const RunOptions& options) {
  if (options.scene.empty()) return refuse_run({Fault::Kind::missing, "SCENE", "is empty, must be a file or a built-in scene"});
  if (options.out && options.out->empty()) return refuse_run({Fault::Kind::missing, "--out", "is empty, must be a directory"});
  auto opened = open_scene(options.scene, options.seed);
  if (!opened) return refuse_run(opened.fault());
  Scene scene = *opened;
  if (options.method) scene.method = *options.method;
  if (options.dt) scene.dt = *options.dt;
  if (options.until) scene.until = *options.until;
  if (options.every) scene.every = *options.every;
  if (const auto ok = check_scene(scene); !ok) return refuse_run({ok.fault().kind, "--" + ok.fault().where, ok.fault().what});
  const auto others = beside(scene, options);
  if (!others) return refuse_run(others.fault());

  TrajectoryCsv csv;
  const bool keep = options.out.has_value();
  if (keep)
    if (const auto ok = check_rows(scene); !ok) return refuse_run({ok.fault().kind, "--" + ok.fault().where, ok.fault().what});
  Skips wanted;
  wanted.monitors = options.quiet && !options.json && !keep;
  const auto skips = without(wanted, options.no_skip);
  if (!skips) return refuse_run({skips.fault().kind, "--" + skips.fault().where, skips.fault().what});
  std::vector<view::Recording> recordings;
  const auto record = [&](const Scene& one) { return keep ? &recordings.emplace_back(one, one.method) : nullptr; };
  const auto unfit = [&](const Fault& fault) { return refuse_run({fault.kind, options.scene + ": " + fault.where, fault.what}); };  // the method knows not all of it
  Progress progress(!options.quiet, " %");
  const auto seconds_since = [](std::chrono::steady_clock::time_point start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const auto start = std::chrono::steady_clock::now();
  const auto done = simulate_recorded(scene, record(scene), [&](double t, const std::vector<State<double>>& states) {
    if (scene.until > 0) progress(long(100 * t / scene.until), 100);
    if (keep) csv.add(t, states);
  }, *skips);
  if (!done) return unfit(done.fault());
  const RunSummary run = *done;
  const double wall = seconds_since(start);
  std::vector<std::pair<std::string, RunSummary>> by_method{{scene.method, run}};
  std::vector<std::string> other_summaries;
  for (const Scene& other : *others) {
    const auto other_start = std::chrono::steady_clock::now();
    const auto ran = simulate_recorded(other, record(other), [](double, const auto&) {});
    if (!ran) return unfit(ran.fault());
    by_method.emplace_back(other.method, *ran);
    other_summaries.push_back(summary_json(other, *ran, seconds_since(other_start)));
  }
  const std::string summary = with_beside(summary_json(scene, run, wall), other_summaries);
  std::vector<std::string> written_names;
  if (keep) {
    std::vector<std::pair<std::string, std::string>> files{{"trajectory.csv", csv.text()}, {"summary.json", summary}};
    if (auto page = view::replay_page(recordings, std::filesystem::path(scene.name).filename().string(), lead(scene, run)))
      files.insert(files.begin(), {"replay.html", std::move(page).value()});
    else
      std::fprintf(stderr, "rigor run: no replay.html: %s\n", page.fault().text().c_str());
    for (const auto& [name, text] : files) {
      if (const auto written = write_file(std::filesystem::path(*options.out) / name, text); !written) return refuse_run(written.fault());
      written_names.push_back(name);
    }
  }
  if (options.json) std::fputs(summary.c_str(), stdout);
  else if (!options.quiet) print(scene, run, wall);
  if (options.explain) explain(scene, *skips, run);
  if (!options.json && !options.quiet) {
    if (by_method.size() > 1) print_beside(by_method);
    if (keep) say_wrote(*options.out, written_names);
  }
  const std::string why = cut_short(run, scene.method == "located");
  if (why.empty()) return 0;
  std::fflush(stdout);  // or this stands in the middle of a line where both go to one place
  std::fprintf(stderr, "rigor run: %s\n", why.c_str());
  return run.stopped.empty() && run.finite ? 128 + interrupted() : 1;
}

}  // namespace

void add_run(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "simulate a scene: trajectory, energy and momentum accounts");
  command->add_option("SCENE", options->scene, "a JSON file, or a built-in: assignment, drop, tumble, slide, spin-box")->required();
  command->add_option("--method", options->method, "in place of the scene's: a stepper, or \"located\": exact flight, impacts at their time");
  command->add_option("--dt", options->dt, "step")->check(in_range(1e-30, 1e30, "s"));
  command->add_option("--until", options->until, "end")->check(in_range(0.0, 1e30, "s"));
  command->add_option("--every", options->every, "output interval; 0: each step; located, which has none: 1/60 s or until/10000")->check(in_range(0.0, 1e30, "s"));
  command->add_option("--seed", options->seed, "of the scene's random numbers")->check(in_range(std::uint64_t(1), std::uint64_t(1) << 53));
  command->add_option("--out", options->out, "directory for trajectory.csv, summary.json and replay.html");
  command->add_option("--beside", options->beside, "more methods, compared with the scene's: printed, and shown in replay.html")->delimiter(',');
  command->add_option("--no-skip", options->no_skip, "do what could be left out: pairs, planes, loads, rest, monitors or all; the same bits, slower")->delimiter(',');
  CLI::Option* explained = command->add_flag("--explain", options->explain, "print what the scene needs and what was left out, why and how often");
  command->add_flag("--json", options->json, "print summary.json")->excludes(explained);
  command->add_flag("--quiet", options->quiet, "print nothing but what went wrong")->excludes(explained);
  command->footer("Methods: " + fmt::format("{}", fmt::join(scene_methods(), ", ")) + "\n\nExample:  rigor run assignment --seed 3 --out runs/three");
  command->callback([options, &exit_status] { exit_status = run_command(*options); });
}

}  // namespace rigor::cli
