#include <algorithm>
#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/class_run.hpp>
#include <set>
#include <thread>

namespace rigor::grader {
namespace {

std::string tool_of(const std::string& tool, const std::string& hash) { return tool + " " + hash; }

// nullopt: no report, or one that cannot be read. An entry without a name gets the report's.
std::optional<ClassRow> row_from(const std::filesystem::path& report_json, const Entry& entry) {
  const auto text = read_file(report_json);
  if (!text) return std::nullopt;
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || json.value("schema", "") != "rigor.report/1") return std::nullopt;
  ClassRow row;
  row.entry = entry;
  try {
    if (entry.student.empty()) row.entry.student = json.at("submission").at("name");
    row.score = json.at("score");
    row.max_score = json.at("max_score");
    row.tool = tool_of(json.at("tool"), json.value("tool_hash", ""));
    row.rubric_hash = json.at("rubric_hash");
    row.submission_hash = json.at("submission").at("hash");
    std::set<std::string> named;
    for (const auto& check : json.at("checks")) {
      const std::string id = check.at("id"), verdict = check.at("verdict");
      row.points[id] = check.at("points");
      row.verdicts[id] = verdict;
      const std::string group = check.at("group");
      if (row.groups.empty() || row.groups.back().first != group) row.groups.push_back({group, 0});
      row.groups.back().second += row.points[id];
      if (verdict == "pass" || check.at("max_points") == 0) continue;
      if (verdict == "fail") row.fingerprint += id + "=" + check.at("worst_ratio").dump() + ";";
      for (const auto& d : check.at("diagnosis"))
        if (d.at("id") != "relation") named.insert(d.at("id").get<std::string>());
    }
    row.diagnoses.assign(named.begin(), named.end());
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
  return row;
}

ClassRow troubled(const Entry& entry, const std::string& why) {
  ClassRow row;
  row.entry = entry;
  row.trouble = why;
  return row;
}

ClassRow grade_entry(const Entry& entry, const Rubric& rubric, const ClassOptions& options) {
  if (!entry.trouble.empty()) return troubled(entry, entry.trouble);
  const std::filesystem::path dir = options.out / safe_name(entry.student);
  const auto submission = open_submission(entry.uploads);
  if (!submission) return troubled(entry, submission.fault().text());
  if (!options.fresh)
    if (auto old = row_from(dir / "report.json", entry);
        old && old->tool == tool_of(options.tool, tool_hash()) && old->rubric_hash == rubric.hash() && old->submission_hash == submission->hash) {
      old->reused = true;
      return *old;
    }
  auto graded = grade(*submission, rubric, {}, {});
  if (interrupted() != 0) return troubled(entry, stopped);
  if (!graded) return troubled(entry, graded.fault().text());
  Report report = *graded;
  report.tool = options.tool;
  report.submission = entry.student;
  report.submission_path = entry.uploads.front().string();
  report.asked_cases = options.asked_cases;
  for (const auto& [name, text] : {std::pair{"report.html", report_html(report)}, std::pair{"report.txt", report_text(report, false)},
                                   std::pair{"report.json", report_json(report)}})  // json last: it marks the rest as whole
    if (const auto written = write_file(dir / name, text); !written) return troubled(entry, written.fault().text());
  const auto row = row_from(dir / "report.json", entry);
  return row ? *row : troubled(entry, "its report cannot be read back");
}

}  // namespace

std::string safe_name(const std::string& student) {
  std::string out;
  for (const char c : student) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '@' || (c == '.' && !out.empty());
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", unsigned(static_cast<unsigned char>(c)));
    out += plain ? std::string(1, c) : code;
  }
  constexpr std::size_t longest = 200;  // file systems take 255 bytes
  return out.size() <= longest ? out : out.substr(0, longest - 17) + "-" + sha256(student).substr(0, 16);
}

std::vector<ClassRow> grade_class(const std::vector<Entry>& entries, const Rubric& rubric, const ClassOptions& options) {
  std::vector<ClassRow> rows(entries.size());
  std::atomic<std::size_t> next{0};
  int done = 0;
  std::mutex mutex;
  checks();  // built once, before the threads
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < options.jobs; ++k)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < entries.size(); i = next++) {
          rows[i] = interrupted() != 0 ? troubled(entries[i], stopped) : grade_entry(entries[i], rubric, options);
          const std::lock_guard lock(mutex);
          options.progress(++done, int(entries.size()));
        }
      });
  }
  return rows;
}

std::vector<std::string> remove_stale_reports(const std::filesystem::path& out, const std::vector<ClassRow>& rows) {
  namespace fs = std::filesystem;
  std::set<std::string> kept;
  for (const ClassRow& row : rows)
    if (row.trouble.empty() || row.trouble == stopped) kept.insert(safe_name(row.entry.student));
  std::error_code ec;
  std::vector<std::string> removed;
  std::vector<fs::path> stale;
  for (const auto& item : fs::directory_iterator(out, ec))
    if (item.is_directory() && !item.is_symlink() && kept.count(item.path().filename().string()) == 0) stale.push_back(item.path());
  std::sort(stale.begin(), stale.end());
  for (const fs::path& dir : stale) {
    const auto row = row_from(dir / "report.json", {});
    if (!row || safe_name(row->entry.student) != dir.filename().string()) continue;  // not ours
    for (const char* name : {"report.json", "report.html", "report.txt"}) fs::remove(dir / name, ec);
    fs::remove(dir, ec);  // where nothing else is in it
    removed.push_back(row->entry.student);
  }
  return removed;
}

Outcome<std::vector<ClassRow>> read_class(const std::filesystem::path& out) {
  namespace fs = std::filesystem;
  std::error_code ec;
  if (!fs::is_directory(out, ec)) return Fault{Fault::Kind::unreadable, out.string(), "is not a directory"};
  const auto scores = read_file(out / "scores.csv");
  if (!scores || scores->rfind("student,score,max_score,", 0) != 0)
    return Fault{Fault::Kind::malformed, out.string(), "is not the --out of an earlier 'rigor class': no scores.csv of one is in it"};
  std::vector<ClassRow> rows;
  for (const auto& item : fs::directory_iterator(out, ec))
    if (auto row = row_from(item.path() / "report.json", {})) rows.push_back(*row);
  std::sort(rows.begin(), rows.end(), [](const ClassRow& a, const ClassRow& b) { return a.entry.student < b.entry.student; });
  return rows;
}

}  // namespace rigor::grader
