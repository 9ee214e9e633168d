#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/run.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/scene/trajectory.hpp>
#include <rigor/view/replay.hpp>

namespace rigor::cli {
namespace {

struct Options {
  std::string scene, method, out;
  std::vector<std::string> beside;
  std::optional<double> dt, until, every;
  std::uint64_t seed = 0;
  std::vector<std::string> no_skip;
  bool json = false, quiet = false, explain = false;
};

int bad_input(const Fault& fault) {
  std::fprintf(stderr, "rigor run: %s\n", fault.text().c_str());
  return 2;
}

// At most 80 columns, names of files and reasons apart.
void print(const Scene& scene, const RunSummary& run, double wall) {
  const Ledger& l = run.ledger;
  const bool located = scene.method == "located";
  const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); };
  std::printf("%s: %s, %s, method %s", scene.name.c_str(), count(scene.bodies.size(), "cuboid").c_str(), count(scene.planes.size(), "plane").c_str(), scene.method.c_str());
  if (!located) std::printf(", dt %g s", scene.dt);
  std::printf("\n  %-18s %ld to t = %g s in %.3f s\n", located ? "advances" : "steps", run.steps, run.t_end, wall);
  std::printf("  energy             %.6g J -> %.6g J\n", l.energy.start, l.energy.end);
  std::printf("    accounted for    work %.4g, restitution lost %.4g, friction lost %.4g,\n", l.energy.work, l.energy.restitution_loss, l.energy.friction_loss);
  std::printf("                     correction %.4g, switched %.4g", l.energy.correction, l.energy.switched);
  if (located) std::printf(", stepper %.4g", l.energy.stepper);
  std::printf(" J\n");
  std::printf("  unexplained, worst energy %.3g J, linear momentum %.3g N s,\n", l.energy.worst_drift, l.linear.worst_drift);
  std::printf("                     angular momentum %.3g kg m^2/s\n", l.angular.worst_drift);
  std::printf("  impacts            %ld: planes %ld, pairs %ld; %ld gained energy\n", l.impacts, l.plane_impacts, l.pair_impacts, l.energy_rises);
  for (const Accumulation& a : run.accumulations)
    std::printf("  bounces ended      cuboid %zu at t = %.9g s, %.2g s left out\n", a.body, a.at, a.tail);
  for (const HandOver& h : run.handed_over)
    std::printf("  handed over        cuboid %zu, t = %.6g to %.6g s:\n    %s\n", h.body, h.from, h.to, h.why.c_str());
  for (const PlanLine& line : plan({}, l.skips))
    if (line.skipped && line.left_out > 0) std::printf("  skipped            %.1f %% of %ld %s: %s\n", 100 * double(line.left_out) / double(line.of), line.of, line.what.c_str(), line.why.c_str());
  std::printf("  deepest overlap    %.3g m\n", l.deepest_penetration);
  std::printf("  orthonormality     off by %.2g at worst\n", l.worst_orthonormality);
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

// The scene by each method of --beside, only to be looked at.
Outcome<std::vector<Scene>> beside(const Scene& scene, const Options& options) {
  if (!options.beside.empty() && options.out.empty()) return Fault{Fault::Kind::missing, "--beside", "is shown in replay.html, which needs --out"};
  std::vector<Scene> scenes;
  for (const std::string& method : options.beside) {
    scenes.push_back(scene);
    scenes.back().method = method;
    if (const auto ok = check_scene(scenes.back()); !ok) return Fault{ok.fault().kind, "--beside", ok.fault().what};
  }
  return scenes;
}

int run_command(const Options& options) {
  auto opened = open_scene(options.scene, options.seed);
  if (!opened) return bad_input(opened.fault());
  Scene scene = *opened;
  if (!options.method.empty()) scene.method = options.method;
  if (options.dt) scene.dt = *options.dt;
  if (options.until) scene.until = *options.until;
  if (options.every) scene.every = *options.every;
  if (const auto ok = check_scene(scene); !ok) return bad_input({ok.fault().kind, "--" + ok.fault().where, ok.fault().what});
  const auto others = beside(scene, options);
  if (!others) return bad_input(others.fault());

  TrajectoryCsv csv(scene.bodies.size());
  const bool keep = !options.out.empty();
  Skips wanted;
  wanted.monitors = options.quiet && !options.json && !keep;
  const auto skips = without(wanted, options.no_skip);
  if (!skips) return bad_input({skips.fault().kind, "--" + skips.fault().where, skips.fault().what});
  std::vector<view::Recording> recordings;
  if (keep) recordings.emplace_back(scene, scene.method);
  Progress progress(!options.quiet, " %");
  const auto start = std::chrono::steady_clock::now();
  const auto done = simulate_recorded(scene, keep ? &recordings[0] : nullptr, [&](double t, const std::vector<State<double>>& states) {
    if (scene.until > 0) progress(long(100 * t / scene.until), 100);
    if (keep) csv.add(t, states);
  }, *skips);
  if (!done) return bad_input(done.fault());
  const RunSummary run = *done;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::string summary = summary_json(scene, run, wall);
  if (keep) {
    const std::filesystem::path dir = options.out;
    if (const auto written = write_file(dir / "trajectory.csv", csv.text()); !written) return bad_input(written.fault());
    if (const auto written = write_file(dir / "summary.json", summary); !written) return bad_input(written.fault());
    for (const Scene& other : *others) {
      view::Recording& recording = recordings.emplace_back(other, other.method);
      if (const auto ran = simulate_recorded(other, &recording, [](double, const auto&) {}); !ran) return bad_input(ran.fault().inside("--beside"));
    }
    if (const auto page = view::replay_page(recordings, std::filesystem::path(scene.name).filename().string(), lead(scene, run)); !page)
      std::fprintf(stderr, "rigor run: no replay.html: %s\n", page.fault().text().c_str());
    else if (const auto written = write_file(dir / "replay.html", *page); !written)
      return bad_input(written.fault());
  }
  if (options.json) std::fputs(summary.c_str(), stdout);
  else if (!options.quiet) print(scene, run, wall);
  if (options.explain) explain(scene, *skips, run);
  if (!run.stopped.empty()) {
    std::fprintf(stderr, "rigor run: stopped at t = %g s: %s\n", run.t_end, run.stopped.c_str());
    return 1;
  }
  if (!run.finite) {
    std::fprintf(stderr, "rigor run: a number stopped being finite at t = %g s; the step is too long for this scene and method\n", run.t_end);
    return 1;
  }
  if (!run.interrupted) return 0;
  std::fprintf(stderr, "rigor run: interrupted at t = %g s; what is shown and written ends there\n", run.t_end);
  return 128 + interrupted();
}

}  // namespace

void add_run(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "simulate a scene: trajectory, energy and momentum accounts");
  command->add_option("SCENE", options->scene, "a JSON file, or a built-in: assignment, drop, tumble, slide, spin-box")->required();
  command->add_option("--method", options->method, "integrator in place of the scene's, or \"located\": exact flight, impacts at their time");
  command->add_option("--dt", options->dt, "step, s");
  command->add_option("--until", options->until, "end, s");
  command->add_option("--every", options->every, "output interval, s; 0: each step");
  command->add_option("--seed", options->seed, "of the scene's random numbers")->check(in_range(std::uint64_t(1), std::uint64_t(1) << 53));
  command->add_option("--out", options->out, "directory for trajectory.csv, summary.json and replay.html");
  command->add_option("--beside", options->beside, "more methods, shown in replay.html beside the scene's")->delimiter(',');
  command->add_option("--no-skip", options->no_skip, "do what could be left out: pairs, planes, loads, rest, monitors or all; the same bits, slower")->delimiter(',');
  CLI::Option* explained = command->add_flag("--explain", options->explain, "print what the scene needs and what was left out, why and how often");
  command->add_flag("--json", options->json, "print summary.json")->excludes(explained);
  command->add_flag("--quiet", options->quiet, "print nothing");
  command->footer("Example:  rigor run assignment --seed 3 --out runs/three");
  command->callback([options, &exit_status] { exit_status = run_command(*options); });
}

}  // namespace rigor::cli
