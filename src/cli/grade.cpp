#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/grade.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/formats.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/roster.hpp>

namespace rigor::cli {
namespace {

struct GradeOptions {
  grader::Reader reader = grader::Reader::instructor;
  std::vector<std::string> paths;
  std::string rubric;
  std::uint64_t seed = 0;
  int cases = 0;
  std::vector<std::string> checks;
  int single_case = -1;
  std::vector<std::string> formats;
  std::string out;
  bool json = false, quiet = false, sanitize = false, print_rubric = false, practice = false;
  int jobs = 1;
};

struct Format {
  const char *name, *file;
  std::string (*write)(const grader::Report&);
};
const Format formats[] = {
    {"text", "report.txt", [](const grader::Report& r) { return grader::report_text(r, false); }},
    {"json", "report.json", grader::report_json},
    {"html", "report.html", grader::report_html},
    {"junit", "report.xml", grader::report_junit},
    {"gradescope", "results.json", grader::report_gradescope},
    {"autolab", "autolab.txt", grader::report_autolab},
};
const Format* find_format(const std::string& name) {
  for (const Format& format : formats)
    if (name == format.name) return &format;
  return nullptr;
}

// Writes the asked formats; their names, the page first.
Outcome<std::vector<std::string>> write_formats(const grader::Report& report, const GradeOptions& options, const std::filesystem::path& dir) {
  const std::vector<std::string> asked = options.formats.empty() ? std::vector<std::string>{"html", "text", "json"} : options.formats;
  std::vector<std::string> names;
  for (const std::string& name : asked) {
    const Format& format = *find_format(name);
    if (const auto written = write_file(dir / format.file, format.write(report)); !written) return written.fault();
    names.push_back(format.file);
  }
  return names;
}

// What a platform finds when the grader could not finish, or was killed: written first, replaced at the end.
Outcome<bool> write_failures(const std::string& why, const grader::Rubric& rubric, const GradeOptions& options) {
  for (const std::string& name : options.formats) {
    if (name != "gradescope" && name != "autolab") continue;
    const std::string text = name == "autolab" ? grader::autolab_failure(why, rubric.group_names()) : grader::gradescope_failure(why);
    if (const auto written = write_file(std::filesystem::path(options.out) / find_format(name)->file, text); !written) return written;
  }
  return true;
}

// A file out of a platform's download is one of several of its student's.
Outcome<grader::Submission> submission_at(const std::filesystem::path& path) {
  std::error_code ec;
  if (std::filesystem::is_regular_file(path, ec) && !grader::archive_name(path))
    if (const auto roster = grader::read_roster(std::filesystem::absolute(path, ec).parent_path()))
      for (const grader::Entry& entry : *roster)
        for (const auto& upload : entry.uploads)
          if (std::filesystem::equivalent(upload, path, ec)) return grader::open_submission(entry.uploads);
  return grader::open_submission(path);
}

Outcome<grader::Report> grade_one(const std::string& path, const grader::Rubric& rubric, const std::vector<std::string>& chosen, int asked_cases, bool left_out, const GradeOptions& options) {
  const auto submission = submission_at(path);
  if (!submission) return submission.fault();
  grader::Selection selection{chosen, options.single_case};
  grader::BuildOptions build;
  build.jobs = options.jobs;
  build.sanitize = options.sanitize;
  auto report = grader::grade(*submission, rubric, selection, build);
  if (!report) return report.fault();
  grader::Report filled = *report;
  filled.tool = std::string("rigor ") + RIGOR_VERSION;
  filled.submission_path = path;
  filled.reader = options.reader;
  filled.asked_cases = asked_cases;
  if (left_out) filled.notes.push_back("the course also grades by checks that are not part of this practice");
  return filled;
}

int grade_command(const GradeOptions& options) {
  if (options.print_rubric) {
    std::fputs(grader::default_rubric_text().c_str(), stdout);
    return 0;
  }
  const bool practises = options.reader == grader::Reader::practice;
  const char* const program = practises ? "./practice" : "rigor grade";
  const auto bad_input = [&](const std::string& text) { return std::fprintf(stderr, "%s: %s\n", program, text.c_str()), 2; };
  if (practises && (options.seed != 0 || options.practice)) return bad_input("--seed: ./practice has one seed, the rubric's for practice; the course grades with another");
  if (options.practice && options.seed != 0) return bad_input("--practice and --seed: both choose the cases, give one");
  if (options.json && options.quiet) return bad_input("--json and --quiet: both say what is printed, give one");
  if (options.out.empty() && options.formats.size() > 1)
    return bad_input("--format: " + std::to_string(options.formats.size()) + " formats need a directory, --out DIR; without it give one, which is printed");
  if (options.out.empty() && options.formats.size() == 1 && options.paths.size() > 1)
    return bad_input("--format: of several submissions needs a directory, --out DIR; --json prints them as a list");
  if (options.paths.empty()) return bad_input("a submission directory is missing; example: rigor grade submissions/ada");
  grader::Rubric rubric;
  if (!options.rubric.empty()) {
    const auto read = grader::read_rubric(options.rubric);
    if (!read) return bad_input(read.fault().text());
    rubric = *read;
  }
  // a rubric is an instructor's, who gives marks by it; without one, or with a seed given, somebody tries or replays
  const bool gives_marks = options.reader == grader::Reader::instructor && !options.rubric.empty() && !options.practice && options.seed == 0;
  for (const std::string& warning : grader::warnings(rubric, gives_marks))
    if (!practises) std::fprintf(stderr, "rigor grade: %s\n", warning.c_str());
  if (options.practice) rubric.seed = rubric.practice_seed;
  if (options.seed != 0) rubric.seed = options.seed;
  const int asked_cases = options.cases > rubric.cases ? options.cases : 0;  // a replay needs no more than the rubric's
  if (options.cases != 0) rubric.cases = options.cases;
  std::vector<std::string> ids;
  for (const grader::Check& check : grader::checks()) ids.push_back(check.id);
  for (const std::string& id : options.checks)
    if (grader::find_check(id) == nullptr) return bad_input("--check: there is no check '" + id + "'" + did_you_mean(id, ids) + "; " + (practises ? "rigor/rubric.toml" : "'rigor grade --print-rubric'") + " lists them");
  int most_cases = 0;
  bool left_out = false;
  std::vector<std::string> chosen = options.checks;
  for (const grader::Check& check : grader::checks()) {
    const bool asked = std::find(options.checks.begin(), options.checks.end(), check.id) != options.checks.end();
    if (!asked && !options.checks.empty()) continue;
    most_cases = std::max(most_cases, rubric.cases_of(check));
    if (!practises) continue;  // the kit leaves out what students are not to see
    const bool visible = rubric.practises(check);
    left_out = left_out || !visible;
    if (asked && !visible) return bad_input("--check: '" + check.id + "' is not part of the practice");
    if (!asked && visible) chosen.push_back(check.id);
  }
  if (chosen.empty() && practises) return bad_input("no check of this rubric is visible to students");
  if (options.single_case >= most_cases)
    return bad_input("--case is " + std::to_string(options.single_case) + ", must be in [0, " + std::to_string(most_cases - 1) + "]; --cases N asks for more");
  for (const std::string& format : options.formats)
    if (find_format(format) == nullptr) return bad_input("--format: '" + format + "' is none of text, json, html, junit, gradescope, autolab");
  const Format* printed = options.out.empty() && options.formats.size() == 1 ? find_format(options.formats.front()) : nullptr;
  const bool autolab = printed != nullptr && std::string(printed->name) == "autolab";

  if (!options.out.empty() && options.paths.size() > 1) {  // each writes below --out by its own name
    std::map<std::string, std::string> taken;
    for (const std::string& path : options.paths) {
      const std::string name = grader::submission_name(path);
      if (const auto [at, first] = taken.emplace(name, path); !first)
        return bad_input("--out: " + at->second + " and " + path + " would both write to " + (std::filesystem::path(options.out) / name).string() + "; give each an --out of its own");
    }
  }
  int graded = 0;
  const bool list = options.json && printed == nullptr && options.paths.size() > 1;
  const char* plain = std::getenv("NO_COLOR");  // any value but none: no colour (no-color.org)
  const bool colour = isatty(STDOUT_FILENO) != 0 && (plain == nullptr || *plain == '\0');
  for (const std::string& path : options.paths) {
    const bool for_a_platform = !options.out.empty() && options.paths.size() == 1;
    if (for_a_platform)
      if (const auto written = write_failures("the grader did not finish", rubric, options); !written) return bad_input(written.fault().text());
    const auto report = grade_one(path, rubric, chosen, asked_cases, left_out, options);
    if (!report || interrupted() != 0) {
      const std::string why = interrupted() != 0 ? path + ": interrupted, not graded" : report.fault().text();
      std::fprintf(stderr, "%s: %s\n", program, why.c_str());
      if (for_a_platform)
        if (const auto written = write_failures(why, rubric, options); !written) return bad_input(written.fault().text());
      if (autolab) std::fputs(grader::autolab_failure(why, rubric.group_names()).c_str(), stdout);
      if (interrupted() != 0) return 128 + interrupted();
      continue;
    }
    ++graded;
    const std::filesystem::path dir = options.paths.size() > 1 ? std::filesystem::path(options.out) / report->submission : std::filesystem::path(options.out);
    std::vector<std::string> files;
    if (!options.out.empty()) {
      const auto written = write_formats(*report, options, dir);
      if (!written) return bad_input(written.fault().text());
      files = *written;
    }
    if (printed != nullptr) std::fputs(printed->write(*report).c_str(), stdout);
    else if (options.json) std::fputs(((list ? graded == 1 ? "[\n" : ",\n" : "") + grader::report_json(*report)).c_str(), stdout);
    else if (options.quiet) std::printf("%s %g of %g\n", report->submission.c_str(), report->score, report->max_score);
    else {
      std::fputs(grader::report_text(*report, colour).c_str(), stdout);
      if (!files.empty()) say_wrote(dir, files);
    }
  }
  if (list) std::fputs(graded == 0 ? "[]\n" : "]\n", stdout);
  return autolab || graded == int(options.paths.size()) ? 0 : 2;  // Autolab takes any other status for a broken grader
}

}  // namespace

void add_grade(CLI::App& app, int& exit_status, grader::Reader reader) {
  auto options = std::make_shared<GradeOptions>();
  options->reader = reader;
  CLI::App* command = app.add_subcommand("grade", "grade submissions: points, the smallest failing case, the likely mistake");
  command->add_option("PATH", options->paths, "directory, .zip or .tar of a submission");
  command->add_option("--rubric", options->rubric, "TOML file with points and limits (docs/rubric.md)");
  command->add_option("--seed", options->seed, "of the random cases; the rubric's by default")->check(in_range(std::uint64_t(1), std::uint64_t(1) << 53));
  command->add_flag("--practice", options->practice, "the rubric's cases for practice instead of the graded ones");
  command->add_option("--cases", options->cases, "random inputs for each check")->check(in_range(1, 100000));
  command->add_option("--check", options->checks, "only this check; may be given several times");
  command->add_option("--case", options->single_case, "only this case, of every check that runs: replays a counterexample")->check(in_range(0, 100000));
  command->add_option("--format", options->formats, "text, json, html, junit, gradescope, autolab; one of them without --out is printed")->delimiter(',');
  command->add_option("--out", options->out, "directory for the reports: text, json and html unless --format says otherwise");
  command->add_option("--jobs", options->jobs, "compilers at a time")->check(in_range(1, 256));
  command->add_flag("--sanitize", options->sanitize, "build with sanitizers; their first finding is shown as advice");
  command->add_flag("--json", options->json, "print report.json; a list of them for several submissions");
  command->add_flag("--quiet", options->quiet, "print one line a submission, and what went wrong");
  command->add_flag("--print-rubric", options->print_rubric, "print the default rubric and stop");
  command->footer("Example:  rigor grade submissions/ada --out reports/ada");
  command->callback([options, &exit_status] { exit_status = grade_command(*options); });
}

}  // namespace rigor::cli
