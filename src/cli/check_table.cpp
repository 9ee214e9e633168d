#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/check_table.hpp>
#include <rigor/cli/texts.hpp>
#include <rigor/studies/table.hpp>

namespace rigor::cli {
namespace {

struct Options {
  std::string file, write;
};

int bad_input(const std::string& text) {
  std::fprintf(stderr, "rigor check-table: %s\n", text.c_str());
  return 2;
}
std::string frozen_table() {
  for (const auto& text : texts())
    if (text.path == "reference/tables/free-flight.csv") return std::string(text.content);
  return "";
}

// The CSV and its JSON twin. The series runs beside, so that an interrupt need not wait for the flight under way; nothing is
// written before all flights are there.
int write_tables(const std::filesystem::path& dir) {
  auto table = std::async(std::launch::async, studies::free_flight_table);
  while (table.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
    if (interrupted() != 0) {
      std::fputs("rigor check-table: interrupted, nothing is written\n", stderr);
      std::_Exit(128 + interrupted());
    }
  const std::string csv = table.get();
  for (const auto& [name, text] : {std::pair{"free-flight.csv", csv}, std::pair{"free-flight.json", studies::table_json(csv)}})
    if (const auto written = write_file(dir / name, text); !written) return bad_input(written.fault().text());
  return 0;
}

int check_table_command(const Options& options) {
  if (!options.write.empty()) return write_tables(options.write);
  if (options.file.empty()) {
    std::fputs(frozen_table().c_str(), stdout);
    return 0;
  }
  const auto theirs = read_file(options.file);
  if (!theirs) return bad_input(theirs.fault().text());
  const auto rows = studies::check_table(frozen_table(), *theirs, options.file);
  if (!rows) return bad_input(rows.fault().text());
  std::fputs(studies::table_text(*rows).c_str(), stdout);
  return 0;
}

}  // namespace

void add_check_table(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check-table", "compare an engine's free flights with the frozen 30-digit table");
  command->add_option("FILE", options->file, "CSV with columns case, qw, qx, qy, qz, wx, wy, wz; without it the table is printed");
  command->add_option("--write", options->write, "make the table anew, as CSV and JSON, into this directory (minutes)");
  command->footer("Example:  rigor check-table my-engine.csv");
  command->callback([options, &exit_status] { exit_status = check_table_command(*options); });
}

}  // namespace rigor::cli
