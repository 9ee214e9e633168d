#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/check_table.hpp>
#include <rigor/cli/texts.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/studies/table.hpp>

namespace rigor::cli {
namespace {

struct Options {
  std::string file, write, table = "free-flight";
};

int bad_input(const std::string& text) {
  std::fprintf(stderr, "rigor check-table: %s\n", text.c_str());
  return 2;
}
std::string frozen_table(const std::string& name) {
  for (const auto& text : texts())
    if (text.path == "reference/tables/" + name + ".csv") return std::string(text.content);
  return "";
}

// Each CSV and its JSON twin. The series run beside, so that an interrupt need not wait for the flight under way; nothing is
// written before all are there.
int write_tables(const std::filesystem::path& dir) {
  auto made = std::async(std::launch::async, [] {
    std::vector<std::pair<std::string, std::string>> tables;
    for (const auto& table : studies::frozen_tables()) tables.emplace_back(table.name, table.make());
    return tables;
  });
  while (made.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
    if (interrupted() != 0) {
      std::fputs("rigor check-table: interrupted, nothing is written\n", stderr);
      std::_Exit(128 + interrupted());
    }
  std::vector<std::string> names;
  for (const auto& [name, csv] : made.get())
    for (const auto& [file, text] : {std::pair{name + ".csv", csv}, std::pair{name + ".json", studies::table_json(name, csv)}}) {
      if (const auto written = write_file(dir / file, text); !written) return bad_input(written.fault().text());
      names.push_back(file);
    }
  say_wrote(dir, names);
  return 0;
}

int check_table_command(const Options& options) {
  if (!options.write.empty()) return write_tables(options.write);
  const std::string table = frozen_table(options.table);
  if (table.empty()) {
    std::vector<std::string> known;
    for (const auto& t : studies::frozen_tables()) known.push_back(t.name);
    return bad_input(fmt::format("--table there is no table '{}'{}; known: {}", options.table, did_you_mean(options.table, known), fmt::join(known, ", ")));
  }
  if (options.file.empty()) {
    std::fputs(table.c_str(), stdout);
    return 0;
  }
  const auto theirs = read_file(options.file);
  if (!theirs) return bad_input(theirs.fault().text());
  const auto rows = studies::check_table(table, *theirs, options.file);
  if (!rows) return bad_input(rows.fault().text());
  std::fputs(studies::table_text(*rows).c_str(), stdout);
  return 0;
}

}  // namespace

void add_check_table(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check-table", "compare an engine's flights and impacts with the frozen 30-digit tables");
  command->add_option("FILE", options->file, "CSV with columns case, qw, qx, qy, qz, wx, wy, wz; impacts: time, vx, vy, vz too; without it the table is printed");
  command->add_option("--table", options->table, "free-flight (standard), loaded-flight or impacts");
  command->add_option("--write", options->write, "make the tables anew, as CSV and JSON, into this directory (minutes)");
  command->footer("Example:  rigor check-table my-engine.csv");
  command->callback([options, &exit_status] { exit_status = check_table_command(*options); });
}

}  // namespace rigor::cli
