#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/refused.hpp>
#include <rigor/cli/study.hpp>
#include <rigor/cli/unless_interrupted.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>
#include <rigor/studies/peer.hpp>
#include <rigor/studies/plan.hpp>
#include <rigor/studies/run_cells.hpp>
#include <thread>

namespace rigor::cli {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  studies::StudyRequest request;
  std::string out, submission, command;
  int jobs = 0;
  bool all_peers = false, resume = false, json = false, quiet = false;
};

int refuse_study(const std::string& text) { return refused("study", text); }

std::string study_json(const std::vector<studies::Row>& rows, const std::string& command, std::size_t cells) {
  nlohmann::ordered_json json{{"schema", "rigor.study/2"}, {"command", command}, {"machine", studies::machine()}, {"cells", cells}, {"finished", rows.size()},
                              {"interrupted", rows.size() < cells}, {"rows", nlohmann::ordered_json::array()}};
  for (const studies::Row& row : rows) json["rows"].push_back(nlohmann::ordered_json::parse(studies::row_json(row)));
  return json.dump(1) + "\n";
}

// The names written, the page first.
Outcome<std::vector<std::string>> write_all(const fs::path& dir, const std::vector<studies::Row>& rows, const studies::StudyPage& page, std::size_t cells) {
  std::vector<std::pair<std::string, std::string>> files{{"study.html", studies::page_html(page)},
                                                         {"study.csv", studies::rows_csv(rows)},
                                                         {"study.json", study_json(rows, page.command, cells)},
                                                         {"README.md", studies::page_markdown(page)}};
  int k = 0;
  for (const std::string& figure : studies::page_figures(page)) files.emplace_back("figure-" + std::to_string(++k) + ".svg", figure);
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& [name, text] : files) {
    if (const auto written = write_file(dir / name, text); !written) return written.fault();
    if (!name.starts_with("figure")) names.push_back(name);
  }
  for (int more = k + 1; fs::remove(dir / fmt::format("figure-{}.svg", more), none); ++more) {}  // of a longer study here before
  if (k > 0) names.push_back(k == 1 ? "figure-1.svg" : fmt::format("figure-1.svg to figure-{}.svg", k));
  return names;
}

// What lies in the way: a file a study would write over and did not write; "" when there is none.
std::string not_of_a_study(const fs::path& dir) {
  const std::pair<const char*, const char*> marks[] = {{"study.html", "rigor study"}, {"study.csv", "study,problem,method,"}, {"study.json", "\"rigor.study/"},
                                                       {"README.md", "\nMade by `rigor study"}, {"cells.txt", "study="}};
  const auto has = [](const fs::path& path, const char* mark) {
    const auto text = read_file(path, 1u << 30);
    return text && text->find(mark) != std::string::npos;
  };
  std::error_code none;
  for (const auto& [name, mark] : marks)
    if (fs::exists(dir / name, none) && !has(dir / name, mark)) return (dir / name).string();
  if (!fs::exists(dir / "cells.txt", none) && fs::exists(dir / "figure-1.svg", none)) return (dir / "figure-1.svg").string();
  return "";
}

// The peers whose programs are there; the others are told.
std::vector<std::string> installed_peers() {
  std::vector<std::string> there;
  for (const studies::Peer& peer : studies::peers()) {
    if (const auto variants = studies::peer_variants(peer.name)) there.push_back(peer.name);
    else std::fprintf(stderr, "rigor study: left out: %s\n", variants.fault().text().c_str());
  }
  return there;
}

int study_command(const StudyOptions& options) {
  studies::StudyRequest request = options.request;
  if (options.resume && options.out.empty()) return refuse_study("--resume: needs --out, where the finished cells lie");
  if (options.all_peers && !request.peers.empty()) return refuse_study("--peers and --peer: both choose the peers");
  if (options.all_peers) request.peers = installed_peers();
  if (options.all_peers && request.peers.empty()) return refuse_study("--peers: none of their programs is there");
  std::optional<studies::Student> student;
  if (!options.submission.empty()) {
    const auto made = studies::Student::make(options.submission);
    if (!made) return refuse_study("--submission: " + made.fault().text());
    student = *made;
    request.submission = student->name();
  }
  const auto cells = unless_interrupted([&] { return studies::plan(request); }, "rigor study: interrupted before anything was measured", "making the references of the problems in 60 digits", !options.quiet);
  if (!cells) return refuse_study(cells.fault().text());
  const auto of_student = [&](const studies::Cell& cell) { return student && cell.method == student->name(); };
  if (options.jobs > 0 && std::all_of(cells->begin(), cells->end(), [&](const studies::Cell& cell) { return cell.timed() || of_student(cell); }))
    return refuse_study("--jobs: the runs of " + request.kind + " are timed, one after another");
  if (!options.out.empty()) {  // before anything is measured: can it be written, and over nothing but a study?
    if (const auto theirs = not_of_a_study(options.out); !theirs.empty())
      return refuse_study("--out: " + theirs + " is there and no study wrote it; give another directory");
    if (const auto fault = studies::other_study(options.out, *cells)) return refuse_study("--out: " + fault->text());
    std::string list;
    for (const studies::Cell& cell : *cells) list += cell.file() + "  " + cell.text() + "\n";
    if (const auto written = write_file(fs::path(options.out) / "cells.txt", list); !written) return refuse_study("--out: " + written.fault().text());
  }

  const auto measure = [&](const studies::Cell& cell) {
    studies::Student* their = of_student(cell) ? &*student : nullptr;
    if (cell.study == "drift") return studies::drift(cell);
    if (cell.study == "stability") return studies::stability(cell);
    if (cell.study == "contact") return studies::contact(cell, their);
    return studies::fly(cell, their);
  };
  Progress progress(!options.quiet);
  const studies::RunOptions run{options.jobs > 0 ? options.jobs : std::max(1, int(std::thread::hardware_concurrency())), options.out, options.resume,
                                [&](long done, long of) { progress(done, of); }};
  const auto rows = studies::run_cells(*cells, measure, of_student, run);
  if (!rows) return refuse_study(rows.fault().text());
  if (interrupted() != 0) std::fprintf(stderr, "rigor study: interrupted with %zu of %zu cells finished%s\n", rows->size(), cells->size(), options.out.empty() ? "" : "; go on with --resume");
  const studies::StudyPage page = studies::study_page(request.kind, *rows, options.command, cells->size());
  std::vector<std::string> files;
  if (!options.out.empty()) {
    const auto written = write_all(options.out, *rows, page, cells->size());
    if (!written) return refuse_study("--out: " + written.fault().text());
    files = *written;
    if (!rows->empty()) files.push_back("cells");
  }
  if (options.json) std::fputs(study_json(*rows, page.command, cells->size()).c_str(), stdout);
  else if (!options.quiet) {
    std::fputs(studies::page_text(page).c_str(), stdout);
    if (!files.empty()) say_wrote(options.out, files);
    if (const std::size_t others = options.out.empty() ? 0 : studies::cells_not_asked_for(options.out, *cells))
      fmt::print("{} more {} in {}, not asked for and not in these pages, stay there.\n", others, others == 1 ? "cell" : "cells", (fs::path(options.out) / "cells").string());
  }
  if (interrupted() != 0) return 128 + interrupted();
  if (!std::all_of(rows->begin(), rows->end(), [](const studies::Row& row) { return !row.failed.empty(); })) return 0;
  std::fprintf(stderr, "rigor study: every run failed; the first: %s\n", rows->front().failed.c_str());
  return 1;
}

// The options given, as they would be typed again, but for where the results go.
std::string typed(const CLI::App& command) {
  std::string text = "rigor study";
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--out" || name == "--jobs" || name == "--resume" || name == "--quiet" || name == "--json") continue;
    if (!option->get_positional()) text += " " + name;
    if (option->get_items_expected_max() == 0) continue;
    std::string values;
    for (const std::string& value : option->results()) values += (values.empty() ? "" : ",") + value;
    text += " " + values;
  }
  return text;
}

}  // namespace

void add_study(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<StudyOptions>();
  studies::StudyRequest& r = options->request;
  CLI::App* command = app.add_subcommand("study", "error against step, run time against error, drift, stability, contact: our methods, other engines, a submission");
  command->add_option("KIND", r.kind, "convergence, work-precision, drift, stability or contact")->required();
  command->add_option("--problem", r.problems, "by name (docs/studies.md), or a scene file")->delimiter(',');
  command->add_option("--method", r.methods, "of those below (contact: located too; by default sheet, split2 and it alone)")->delimiter(',');
  command->add_option("--until", r.until, "end of the problems")->check(in_range(1e-30, 1e4, "s"));
  command->add_option("--coarsest", r.coarsest, "steps of the first run (contact: in a second)")->check(in_range(1L, 1000000L));
  command->add_option("--rungs", r.rungs, "halvings of the step")->check(in_range(1, 24));
  command->add_option("--h", r.h, "these steps instead of a ladder")->delimiter(',')->check(in_range(1e-30, 1e30, "s"));
  command->add_option("--tolerance", r.tolerances, "of adaptive methods and peers; below 1e-14 their estimates are rounding")->delimiter(',')->check(in_range(1e-14, 0.1));
  command->add_option("--steps", r.steps, "of drift; 1000000 by default")->check(in_range(1L, 1000000000L));
  command->add_option("--step", r.step, "of drift; 0.01 s by default")->check(in_range(1e-30, 1e30, "s"));
  command->add_option("--sums", r.sums, "of drift: plain, carried; both by default")->delimiter(',')->check(one_of({"plain", "carried"}));
  command->add_option("--submission", options->submission, "a student's update (contact: and plane response) beside ours: a directory or an archive")->check(not_empty());
  command->add_flag("--peers", options->all_peers, "other engines too: those whose programs are built");
  command->add_option("--peer", r.peers, "one of them by name: bullet, ode, mujoco, simbody, dart")->delimiter(',');
  command->add_option("--jobs", options->jobs, "cells at a time, where they are not timed; all cores by default")->check(in_range(1, 256));
  command->add_option("--out", options->out, "directory for study.csv, study.json, study.html, README.md with its figures, and a file for each cell")->check(not_empty());
  command->add_flag("--resume", options->resume, "go on: take the cells whose files are there");
  command->add_flag("--json", options->json, "print study.json");
  command->add_flag("--quiet", options->quiet, "print nothing but what went wrong");
  const auto names = [](const auto& all) {
    std::string text;
    for (const auto& one : all) text += (text.empty() ? "" : ", ") + one.name;
    return text;
  };
  command->footer(fmt::format("Methods: {}\n\nProblems of flight: {}; or a scene file with one cuboid\n\nProblems of contact: {}\n\nStability: the maps {}, or a flight\n\n"
                              "Example:  rigor study convergence --problem short-A --method rk4 --out first",
                              fmt::join(studies::flying_methods(), ", "), fmt::join(studies::problem_names(), ", "), names(studies::contact_problems()), names(studies::maps())));
  command->callback([options, command, &exit_status] {
    options->command = typed(*command);
    exit_status = study_command(*options);
  });
}

}  // namespace rigor::cli
