#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/class.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/refused.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/class_run.hpp>
#include <rigor/grader/printable.hpp>
#include <thread>

namespace rigor::cli {
namespace {

struct ClassOptions {
  std::string directory, rubric, out = "out/class", against, fill, column;
  int jobs = int(std::max(1u, std::thread::hardware_concurrency()));
  std::uint64_t seed = 0;
  int cases = 0;
  bool fresh = false, quiet = false;
};

int refuse_class(const std::string& text) { return refused("class", text); }

/// Whether `path`, which need not exist, is `directory` or lies in it.
bool inside(const std::filesystem::path& path, const std::filesystem::path& directory) {
  std::error_code ec;
  const auto plain = [&](const std::filesystem::path& p) {
    const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(p, ec), ec);
    return whole.has_filename() ? whole : whole.parent_path();
  };
  const auto inner = plain(path), outer = plain(directory);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

int class_command(const ClassOptions& options) {
  const std::filesystem::path out = options.out;
  std::filesystem::path directory = options.directory;
  if (options.fill.empty() && !options.column.empty()) return refuse_class("--column: is '" + options.column + "' without --fill, the gradebook it is a column of");
  if (inside(out, directory)) return refuse_class("--out: " + options.out + " lies in " + options.directory + ", where the next run would take it for a submission; must be outside");
  if (!options.against.empty() && inside(out, options.against) && inside(options.against, out))
    return refuse_class("--against: is the same directory as --out (" + options.out + "), which this run writes over; give another --out");
  std::vector<grader::ClassRow> before;
  if (!options.against.empty()) {
    const auto read = grader::read_class(options.against);
    if (!read) return refuse_class("--against: " + read.fault().text());
    before = *read;
  }
  if (!options.fill.empty())  // before an hour of grading, not after it
    if (const auto possible = grader::fill_gradebook(options.fill, options.column, {}); !possible) return refuse_class("--fill: " + possible.fault().text());
  grader::Rubric rubric;
  if (!options.rubric.empty()) {
    const auto read = grader::read_rubric(options.rubric);
    if (!read) return refuse_class(read.fault().text());
    rubric = *read;
  }
  std::error_code ec;
  if (std::filesystem::is_regular_file(directory, ec) && grader::archive_name(directory)) {
    const auto unpacked = grader::unpack_class(directory, out / ".unpacked");
    if (!unpacked) return refuse_class(unpacked.fault().text());
    directory = *unpacked;
  }
  const auto entries = grader::read_roster(directory);
  if (!entries) {
    if (directory != options.directory) std::filesystem::remove_all(out / ".unpacked", ec), std::filesystem::remove(out, ec);  // where it is empty
    return refuse_class(entries.fault().text());
  }
  std::filesystem::create_directories(out, ec);
  if (ec) return refuse_class("--out: " + options.out + " cannot be written: " + ec.message());
  if (options.seed != 0) rubric.seed = options.seed;
  for (const std::string& warning : grader::warnings(rubric, true)) std::fprintf(stderr, "rigor class: %s\n", warning.c_str());
  grader::ClassOptions run;
  if (options.cases > rubric.cases) run.asked_cases = options.cases;
  if (options.cases != 0) rubric.cases = options.cases;
  run.out = options.out;
  run.jobs = options.jobs;
  run.fresh = options.fresh;
  run.tool = "rigor " RIGOR_VERSION;
  Progress progress(!options.quiet);
  run.progress = [&](int done, int all) { progress(done, all); };
  const auto rows = grader::grade_class(*entries, rubric, run);
  const auto stale = grader::remove_stale_reports(out, rows);
  const auto changed = options.against.empty() ? std::vector<grader::Change>{} : grader::changes(before, rows);
  std::vector<std::string> files{"class.html", "scores.csv", "matrix.csv", "*/report.html"};
  if (const auto written = grader::write_class(out, rows, rubric, changed); !written) return refuse_class(written.fault().text());
  if (!options.against.empty()) {
    if (const auto written = write_file(out / "changes.csv", grader::changes_csv(changed)); !written) return refuse_class(written.fault().text());
    files.push_back("changes.csv");
    if (!options.quiet) std::printf("%zu changed since %s\n", changed.size(), options.against.c_str());
  }
  if (!options.fill.empty()) {
    const auto filled = grader::fill_gradebook(options.fill, options.column, rows);
    if (!filled) return refuse_class("--fill: " + filled.fault().text());
    files.push_back("filled-" + std::filesystem::path(options.fill).filename().string());
    if (const auto written = write_file(out / files.back(), filled->csv); !written) return refuse_class(written.fault().text());
    for (const std::string& remark : filled->remarks) std::fprintf(stderr, "rigor class: --fill: %s\n", remark.c_str());
    if (!options.quiet) std::printf("%d of %d rows filled in\n", filled->filled, filled->rows);
  }
  if (!options.quiet)
    for (const std::string& student : stale) std::printf("an earlier report taken away, it no longer holds: %s\n", grader::printable(student).c_str());
  int graded = 0, reused = 0, stopped = 0;
  constexpr int shown_stopped = 3;
  for (const auto& r : rows) {
    graded += r.trouble.empty();
    reused += r.reused;
    if (r.trouble == grader::stopped && ++stopped > shown_stopped) continue;
    if (!r.trouble.empty()) std::fprintf(stderr, "rigor class: %s: %s\n", grader::printable(r.entry.student).c_str(), r.trouble.c_str());
  }
  if (stopped > shown_stopped) std::fprintf(stderr, "rigor class: and %d more: %s\n", stopped - shown_stopped, grader::stopped);
  if (!options.quiet) {
    std::printf("%d of %zu graded (%d unchanged since last time)\n", graded, rows.size(), reused);
    say_wrote(out, files);
  }
  if (interrupted() != 0) {
    std::fprintf(stderr, "rigor class: interrupted; the same command goes on with those that are not graded\n");
    return 128 + interrupted();
  }
  return graded == int(rows.size()) ? 0 : 1;
}

}  // namespace

void add_class(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<ClassOptions>();
  CLI::App* command = app.add_subcommand("class", "grade a directory of submissions: scores.csv, matrix.csv, class.html");
  command->add_option("DIR", options->directory, "a directory or archive for each student (also Autolab, Canvas, Gradescope, Moodle names), or all in one .zip")->required();
  command->add_option("--rubric", options->rubric, "TOML file with points and limits (docs/rubric.md)");
  command->add_option("--seed", options->seed, "of the random cases; the rubric's by default")->check(in_range(std::uint64_t(1), std::uint64_t(1) << 53));
  command->add_option("--cases", options->cases, "random inputs for each check")->check(in_range(1, 100000));
  command->add_option("--jobs", options->jobs, "submissions at a time; all processors by default")->check(in_range(1, 256));
  command->add_option("--out", options->out, "where reports and tables go")->capture_default_str();
  command->add_option("--against", options->against, "an earlier --out: says what changed and why, in changes.csv and on the page");
  command->add_option("--fill", options->fill, "a gradebook (Canvas, Moodle, Autolab): written to --out as filled-NAME with the points filled in");
  command->add_option("--column", options->column, "with --fill: the gradebook's column for the points; \"Grade\" by default");
  command->add_flag("--fresh", options->fresh, "grade again what has not changed");
  command->add_flag("--quiet", options->quiet, "print nothing but what went wrong");
  command->footer("Example:  rigor class submissions --out graded");
  command->callback([options, &exit_status] { exit_status = class_command(*options); });
}

}  // namespace rigor::cli
