#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/check_table.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/refused.hpp>
#include <rigor/cli/texts.hpp>
#include <rigor/cli/unless_interrupted.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/studies/table.hpp>

namespace rigor::cli {
namespace {

struct TableOptions {
  std::string file, write, table;
  std::optional<double> within;
};

int refuse_table(const std::string& text) { return refused("check-table", text); }
std::string frozen_table(const std::string& name) {
  for (const auto& text : texts())
    if (text.path == "reference/tables/" + name + ".csv") return std::string(text.content);
  return "";
}

// Each CSV and its JSON twin. Nothing is written before all are there.
int write_tables(const std::filesystem::path& dir) {
  const auto probe = dir / ("probe-" + std::to_string(::getpid()));  // minutes before the first table: can it be written?
  if (const auto written = write_file(probe, ""); !written) return refuse_table("--write: " + dir.string() + " " + written.fault().what);
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  const auto tables = unless_interrupted(
      [] {
        std::vector<std::pair<std::string, std::string>> made;
        for (const auto& table : studies::frozen_tables()) made.emplace_back(table.name, table.make());
        return made;
      },
      "rigor check-table: interrupted, nothing is written", "making the tables in 60 digits");
  std::vector<std::string> names;
  for (const auto& [name, csv] : tables)
    for (const auto& [file, text] : {std::pair{name + ".csv", csv}, std::pair{name + ".json", studies::table_json(name, csv)}}) {
      if (const auto written = write_file(dir / file, text); !written) return refuse_table(written.fault().text());
      names.push_back(file);
    }
  say_wrote(dir, names);
  return 0;
}

// The table a file fits a hundred times better than one it was held to with this error; "" when there is none. Many cases have the same name in two tables.
std::string other_table(const std::string& name, const std::string& theirs, double worst) {
  for (const auto& other : studies::frozen_tables()) {
    if (other.name == name) continue;
    const auto rows = studies::check_table(frozen_table(other.name), theirs, "");
    if (rows && studies::verdict_of(*rows).worst < worst / 100) return other.name;
  }
  return "";
}

int check_table_command(const TableOptions& options) {
  if (!options.write.empty()) {
    if (!options.file.empty() || !options.table.empty() || options.within) return refuse_table("--write: makes all tables anew, and looks at no FILE, --table or --within");
    return write_tables(options.write);
  }
  if (options.within && options.file.empty()) return refuse_table("--within: needs FILE, whose errors are to be within it");
  const std::string name = options.table.empty() ? "free-flight" : options.table, table = frozen_table(name);
  if (table.empty()) {
    std::vector<std::string> known;
    for (const auto& t : studies::frozen_tables()) known.push_back(t.name);
    return refuse_table(fmt::format("--table there is no table '{}'{}; known: {}", name, did_you_mean(name, known), fmt::join(known, ", ")));
  }
  if (options.file.empty()) {
    std::fputs(table.c_str(), stdout);
    return 0;
  }
  const auto theirs = read_file(options.file);
  if (!theirs) return refuse_table(theirs.fault().text());
  const auto rows = studies::check_table(table, *theirs, options.file);
  if (!rows) {
    const std::string other = other_table(name, *theirs, std::numeric_limits<double>::infinity());
    return refuse_table(rows.fault().text() + (other.empty() ? "" : "; it fits --table " + other));
  }
  const studies::TableVerdict verdict = studies::verdict_of(*rows);
  const bool within = !options.within || verdict.within(*options.within);
  std::fputs(studies::table_text(*rows).c_str(), stdout);
  const std::string asked = options.within ? (within ? "within " : "not within ") + studies::digits(*options.within) + ": " : "";
  std::puts((asked + studies::verdict_text(verdict)).c_str());
  if (const std::string other = other_table(name, *theirs, verdict.worst); !other.empty()) std::fprintf(stderr, "rigor check-table: %s fits --table %s better\n", options.file.c_str(), other.c_str());
  return within ? 0 : 1;
}

}  // namespace

void add_check_table(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* command = app.add_subcommand("check-table", "compare an engine's flights and impacts with the frozen 30-digit tables");
  command->add_option("FILE", options->file, "CSV with columns case, qw, qx, qy, qz, wx, wy, wz; impacts: time, vx, vy, vz too; without it the table is printed")->check(not_empty());
  command->add_option("--table", options->table, "free-flight (standard), loaded-flight or impacts")->check(not_empty());
  command->add_option("--write", options->write, "make the tables anew, as CSV and JSON, into this directory (minutes)")->check(not_empty());
  command->add_option("--within", options->within, "the largest error allowed, in rad or relative: exit status 1 when one is larger or a case has no answer")->check(in_range(1e-16, 1.0));
  command->footer("Example:  rigor check-table my-engine.csv");
  command->callback([options, &exit_status] { exit_status = check_table_command(*options); });
}

}  // namespace rigor::cli
