#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/study.hpp>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/drift.hpp>

namespace rigor::cli {
namespace {

struct Options {
  std::string kind, out;
  std::vector<std::string> problems, methods;
  int rungs = 8;
  long coarsest = 50, steps = 1000000;
  double step = 0.01;
  bool json = false, quiet = false;
};

int bad_input(const std::string& text) {
  std::fprintf(stderr, "rigor study: %s\n", text.c_str());
  return 2;
}

int written(const Options& options, const std::string& csv, const std::string& html, const std::string& text) {
  if (!options.out.empty())
    for (const auto& [name, content] : {std::pair{"study.csv", csv}, std::pair{"study.html", html}})
      if (const auto done = write_file(std::filesystem::path(options.out) / name, content); !done) return bad_input(done.fault().text());
  if (!options.quiet) std::fputs(text.c_str(), stdout);
  return interrupted() != 0 ? 128 + interrupted() : 0;
}

// One problem's free flight, far beyond its end.
int long_flights(const Options& options, const std::vector<std::string>& names) {
  if (options.json) return bad_input("--json: drift and stability write study.csv and study.html");
  if (options.problems.size() > 1) return bad_input("--problem: one at a time for drift and stability");
  const studies::Problem& problem = *studies::find_problem(options.problems.empty() ? "case-A" : options.problems[0]);
  const std::string command = "rigor study " + options.kind + " --problem " + problem.name + " (rigor " RIGOR_VERSION ")";
  Progress progress(!options.quiet);
  const auto done = [&](std::size_t methods_done) { progress(long(methods_done), long(names.size())); };
  if (options.kind == "drift") {
    std::vector<studies::Drift> rows;
    for (const std::string& name : names) rows.push_back(studies::drift_of(problem, *find_method(name), options.step, options.steps)), done(rows.size());
    return written(options, studies::drift_csv(problem, rows), studies::drift_html(problem, rows, command), studies::drift_text(problem, rows));
  }
  std::vector<studies::Stability> rows;
  for (const std::string& name : names) rows.push_back({find_method(name), studies::stable_angle(problem, *find_method(name))}), done(rows.size());
  return written(options, studies::stability_csv(problem, rows), studies::stability_html(problem, rows, command), studies::stability_text(problem, rows));
}

int study_command(const Options& options) {
  const std::vector<std::string> kinds{"convergence", "work-precision", "drift", "stability"};
  if (std::find(kinds.begin(), kinds.end(), options.kind) == kinds.end())
    return bad_input("there is no study '" + options.kind + "'" + did_you_mean(options.kind, kinds) + "; there are convergence, work-precision, drift, stability");
  const std::vector<std::string> problem_names = studies::problem_names();
  std::vector<std::string> method_names;
  for (const Method& m : methods()) method_names.push_back(std::string(m.name));
  const auto chosen = [](const std::vector<std::string>& asked, const std::vector<std::string>& standard) { return asked.empty() ? standard : asked; };
  std::vector<studies::Ladder> ladders;
  for (const std::string& name : chosen(options.problems, {"short-A", "case-A", "thrown", "forced"}))
    if (std::find(problem_names.begin(), problem_names.end(), name) == problem_names.end()) return bad_input("--problem: there is no problem '" + name + "'" + did_you_mean(name, problem_names));
  for (const std::string& name : options.methods)
    if (find_method(name) == nullptr) return bad_input("--method: there is no method '" + name + "'" + did_you_mean(name, method_names));
  if (options.kind == "drift" || options.kind == "stability") return long_flights(options, chosen(options.methods, method_names));
  const int repeats = options.kind == "work-precision" ? 5 : 1;
  const auto problems = chosen(options.problems, {"short-A", "case-A", "thrown", "forced"}), integrators = chosen(options.methods, method_names);
  Progress progress(!options.quiet);
  for (const std::string& problem : problems)
    for (const std::string& method : integrators)
      if (interrupted() == 0) {
        ladders.push_back(studies::converge(*studies::find_problem(problem), *find_method(method), options.coarsest, options.rungs, repeats));
        progress(long(ladders.size()), long(problems.size() * integrators.size()));
      }

  const std::string command = "rigor study " + options.kind + " --coarsest " + std::to_string(options.coarsest) + " --rungs " + std::to_string(options.rungs) + " (rigor " RIGOR_VERSION ")";
  if (!options.out.empty()) {
    const std::filesystem::path dir = options.out;
    for (const auto& [name, text] : {std::pair{"study.csv", studies::convergence_csv(ladders)}, std::pair{"study.json", studies::convergence_json(ladders, command)},
                                     std::pair{"study.html", studies::convergence_html(ladders, options.kind, command)}})
      if (const auto written = write_file(dir / name, text); !written) return bad_input(written.fault().text());
  }
  if (options.json) std::fputs(studies::convergence_json(ladders, command).c_str(), stdout);
  else if (!options.quiet) std::fputs(studies::convergence_text(ladders).c_str(), stdout);
  return interrupted() != 0 ? 128 + interrupted() : 0;
}

}  // namespace

void add_study(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("study", "error against step, run time against error, drift and stability, for every method");
  command->add_option("KIND", options->kind, "convergence, work-precision, drift or stability")->required();
  command->add_option("--problem", options->problems, "case-A, case-B, case-C, short-A, fb-05, thrown, forced")->delimiter(',');
  command->add_option("--method", options->methods, "integrators; all by default")->delimiter(',');
  command->add_option("--coarsest", options->coarsest, "steps of the first run")->check(CLI::Range(1L, 1000000L))->capture_default_str();
  command->add_option("--rungs", options->rungs, "halvings of the step")->check(CLI::Range(1, 24))->capture_default_str();
  command->add_option("--steps", options->steps, "of drift")->check(CLI::Range(1L, 1000000000L))->capture_default_str();
  command->add_option("--step", options->step, "of drift, s")->check(CLI::Range(1e-9, 1e3))->capture_default_str();
  command->add_option("--out", options->out, "directory for study.csv, study.json, study.html");
  command->add_flag("--json", options->json, "print study.json");
  command->add_flag("--quiet", options->quiet, "print nothing");
  command->footer("Example:  rigor study convergence --problem short-A --method sheet,rk4 --out studies/first");
  command->callback([options, &exit_status] { exit_status = study_command(*options); });
}

}  // namespace rigor::cli
