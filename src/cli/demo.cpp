#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/demo.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/grader/class_run.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>
#include <rigor/scene/overlap.hpp>
#include <rigor/scene/trajectory.hpp>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>
#include <rigor/studies/plan.hpp>
#include <rigor/view/replay.hpp>
#include <thread>

namespace rigor::cli {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

int failed(const Fault& fault) {
  std::fprintf(stderr, "rigor demo: %s\n", fault.text().c_str());
  return 2;
}

// The bundled class: what a course hands in, right and wrong.
constexpr const char* students[][2] = {
    {"right/explicit-loops", "right, with explicit loops"},
    {"right/exponential-map", "right, with the exponential map"},
    {"wrong/no-gyroscopic-term", "one term missing"},
    {"wrong/world-inertia-transposed", "frames mixed up"},
    {"wrong/printed-restitution", "believed the sheet's misprint"},
    {"wrong/pair-one-body-only", "forgot the other body"},
    {"wrong/two-mistakes", "two things at once"},
    {"kit", "handed in the kit as it was"},
};

Outcome<std::string> grade_class(const fs::path& out) {
  std::printf("1. Grading a class of %zu\n", std::size(students));
  std::vector<grader::Entry> entries;
  for (const auto& [path, says] : students) entries.push_back({fs::path(path).filename(), {fs::path(RIGOR_SOURCE_DIR) / "tests" / "submissions" / path}});
  grader::ClassOptions options;
  options.out = out / "class";
  options.jobs = int(std::max(1u, std::thread::hardware_concurrency()));
  options.tool = "rigor " RIGOR_VERSION;
  Progress progress;
  options.progress = [&](int done, int all) { progress(done, all); };
  const grader::Rubric rubric;
  const std::vector<grader::ClassRow> rows = grader::grade_class(entries, rubric, options);
  if (interrupted() != 0) return std::string();
  std::string links;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const grader::ClassRow& row = rows[k];
    const std::string &name = row.entry.student, says = students[k][1];
    if (!row.trouble.empty()) return Fault{Fault::Kind::unreadable, name, row.trouble};
    const std::string found = fmt::format("{}", fmt::join(row.diagnoses, ", ")), words = found.empty() ? says : found;
    std::printf("   %-22s %3.4g of %g%s%s\n", name.c_str(), row.score, row.max_score, words.size() > 41 ? "\n      " : "   ", words.c_str());
    links += fmt::format("<li><a href=\"class/{0}/report.html\">{0}</a>: {1:g} of {2:g} ({3}){4}</li>\n", name, row.score, row.max_score, says,
                         found.empty() ? "" : "; named: <code>" + report::escape(found) + "</code>");
  }
  if (const auto written = grader::write_class(options.out, rows, rubric); !written) return written.fault();
  return fmt::format("<h2>A class of {}, graded</h2><p>Every submission was compiled unchanged and run in a locked-down process: <a href=\"class/class.html\">the class page</a>, and each "
                     "student's report:</p><ul>{}</ul>\n", rows.size(), links);
}

Outcome<std::string> run_scene(const fs::path& out) {
  Scene scene = builtin_scene("assignment", 3);
  std::printf("2. The assignment's scene: ten cuboids, 20 s, seed %llu\n", static_cast<unsigned long long>(scene.seed));
  scene.every = 1.0 / 30;
  TrajectoryCsv csv;
  view::Recording recording(scene, scene.method);
  const double shown = 4;  // s; then all are at rest
  report::Plot plot{"Heights of the ten cuboids", "time, s", "height of the centre, m", false, false, {}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) plot.series.push_back({"cuboid " + std::to_string(i + 1), {}, {}, false});
  const Stopwatch watch;
  const RunSummary run = simulate(scene, [&](double t, const std::vector<State<double>>& states) {
    csv.add(t, states);
    recording.add(t, states);
    for (std::size_t i = 0; i < states.size() && t <= shown; ++i) plot.series[i].x.push_back(t), plot.series[i].y.push_back(states[i].p_WB[1]);
  }, [&](const Impact& impact) { recording.impact(impact); });
  const double wall = watch.seconds();
  if (const auto written = write_file(out / "scene" / "trajectory.csv", csv.text()); !written) return written.fault();
  if (const auto written = write_file(out / "scene" / "summary.json", summary_json(scene, run, wall)); !written) return written.fault();
  std::string play;
  if (const auto replay = view::replay_page({recording}, "assignment", "ten cuboids in a room, 20 s; space plays")) {
    if (const auto written = write_file(out / "scene" / "replay.html", *replay); !written) return written.fault();
    play = " <a href=\"scene/replay.html\">Play it</a>;";
  }
  const Ledger& l = run.ledger;
  const Overlap overlap = overlap_at_start(scene);
  const std::string begins = fmt::format("{} cuboids begin inside walls or each other, up to {:.3g} m; pushed out", overlap.cuboids, overlap.depth);
  std::printf("   %ld steps in %.2f s; %ld impacts; energy %.4g -> %.4g J:\n   correction %.4g J, restitution lost %.4g, friction %.4g,\n   the steps' own %.4g\n   (%s)\n", run.steps, wall, l.impacts,
              l.energy.start, l.energy.end, l.energy.correction, l.energy.restitution_loss, l.energy.friction_loss, l.energy.stepper, begins.c_str());
  const std::string text = fmt::format("Seed {}: {} steps, {} impacts, {:.2f} s of wall time for 20 s. {}; that is the assignment's draw.", scene.seed, run.steps, l.impacts, wall, begins);
  return "<h2>The assignment's scene</h2><p>" + text + play + " <a href=\"scene/trajectory.csv\">trajectory.csv</a>, <a href=\"scene/summary.json\">summary.json</a></p>" +
         report::figure(plot, "Ten cuboids fall into a room and come to rest: the first " + std::to_string(int(shown)) + " s.");
}

Outcome<std::string> study(const fs::path& out) {
  std::printf("3. Convergence of three steppers against references that share no code with them\n");
  studies::StudyRequest request{"convergence", {"short-A", "forced"}, {"sheet", "euler-exponential", "rk4"}};
  request.coarsest = 25;
  request.rungs = 7;
  std::vector<studies::Row> rows;
  const auto cells = studies::plan(request);
  for (const studies::Cell& cell : *cells)
    if (interrupted() == 0) rows.push_back(studies::fly(cell));
  if (interrupted() != 0) return std::string();
  if (const auto written = write_file(out / "study" / "study.html", studies::page_html(studies::study_page("convergence", rows, "rigor demo", rows.size()))); !written) return written.fault();
  if (const auto written = write_file(out / "study" / "study.csv", studies::rows_csv(rows)); !written) return written.fault();
  report::Plot plot{"Attitude error against step, free flight", "step h, s", "attitude error at T = 1 s, rad", true, true, {}};
  std::printf("   %-8s %-18s %-13s %-16s %s\n", "problem", "method", "fitted order", "error, coarsest", "error, finest, rad");
  for (const studies::Group& problem : studies::by_problem(rows))
    for (const studies::Group& method : studies::by_method(problem.rows)) {
      report::Series series{method.name, {}, {}};
      const double until = studies::find_problem(problem.name)->until;
      for (const studies::Row* row : method.rows) series.x.push_back(until / double(row->cell.steps)), series.y.push_back(row->at("attitude"));
      std::printf("   %-8s %-18s %-13.2f %-16.2e %.2e\n", problem.name.c_str(), method.name.c_str(), studies::fit_order(series.x, series.y).order, series.y.front(), series.y.back());
      if (problem.name == "short-A") plot.series.push_back(series);
    }
  return "<h2>Convergence</h2><p>Free flight against a Taylor series in 60 digits, forced motion against SUNDIALS' CVODE. <a href=\"study/study.html\">The whole study</a></p>" +
         report::figure(plot);
}

int demo_command(const fs::path& out) {
  std::error_code ec;
  fs::create_directories(out, ec);
  if (ec) return failed({Fault::Kind::unwritable, "--out", "is " + out.string() + ", which cannot be made: " + ec.message()});
  std::string body;
  for (auto part : {grade_class, run_scene, study}) {
    const auto html = part(out);
    if (!html) return failed(html.fault());
    if (interrupted() != 0) {
      std::fprintf(stderr, "rigor demo: interrupted; %s is not written\n", (out / "index.html").string().c_str());
      return 128 + interrupted();
    }
    body += *html;
    std::printf("\n");
  }
  report::Page page;
  page.title = "rigor: what it does, on bundled input";
  page.lead = "Grading, simulation and a convergence study, made by one command: ./rigor demo";
  page.body = body;
  page.footer = "rigor " RIGOR_VERSION;
  if (const auto written = write_file(out / "index.html", report::render(page)); !written) return failed(written.fault());
  say_wrote(out, {"index.html", "class", "scene", "study"});
  std::printf("next: rigor grade DIR, rigor run SCENE.json, rigor study convergence,\n      rigor explain impulse.normal\n");
  return 0;
}

}  // namespace

void add_demo(CLI::App& app, int& exit_status) {
  auto out = std::make_shared<std::string>("out/demo");
  CLI::App* command = app.add_subcommand("demo", "the main jobs on bundled input, with one page to look at");
  command->add_option("--out", *out, "directory for index.html and what it links to")->capture_default_str();
  command->footer("Example:  rigor demo --out /tmp/demo");
  command->callback([out, &exit_status] { exit_status = demo_command(*out); });
}

}  // namespace rigor::cli
