#include <atomic>
#include <mutex>
#include <set>
#include <sstream>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/studies/run_cells.hpp>
#include <thread>

namespace rigor::studies {
namespace {

// A description without the hashes of what was read from files.
std::string of_any_content(std::string text) {
  text = text.substr(0, text.find(" content="));
  const std::size_t from = text.find(" method=submission "), to = text.rfind(" steps=");
  if (from == std::string::npos || to == std::string::npos || to < from) return text;
  return text.substr(0, text.rfind(' ', to - 1)) + text.substr(to);
}

}  // namespace

std::optional<Fault> other_study(const std::filesystem::path& directory, const std::vector<Cell>& cells) {
  const auto list = read_file(directory / "cells.txt");
  if (!list || cells.empty()) return std::nullopt;
  std::set<std::string> asked;
  for (const Cell& cell : cells) asked.insert(of_any_content(cell.text()));
  std::string first;
  std::istringstream lines(*list);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("  study=");
    if (at == std::string::npos) continue;
    const std::string text = line.substr(at + 2);
    if (asked.count(of_any_content(text)) > 0) return std::nullopt;
    if (first.empty()) first = text;
  }
  if (first.empty()) return std::nullopt;
  return Fault{Fault::Kind::unsupported, directory.string(),
               "has another study, none of the cells asked for: there " + first + " and so on, asked for " + cells.front().text() + " and so on; give another directory"};
}

std::size_t cells_not_asked_for(const std::filesystem::path& directory, const std::vector<Cell>& cells) {
  std::set<std::string> asked;
  for (const Cell& cell : cells) asked.insert(cell.file());
  std::error_code none;
  std::size_t others = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "cells", none)) others += asked.count(entry.path().filename().string()) == 0;
  return others;
}

Outcome<std::vector<Row>> run_cells(const std::vector<Cell>& cells, const std::function<Row(const Cell&)>& measure, const std::function<bool(const Cell&)>& alone,
                                    const RunOptions& options) {
  std::vector<std::optional<Row>> rows(cells.size());
  std::vector<std::size_t> together, one_by_one;
  const auto file = [&](std::size_t i) { return options.directory / "cells" / cells[i].file(); };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (options.resume && !options.directory.empty())
      if (const auto text = read_file(file(i))) rows[i] = row_from_json(*text, cells[i]);
    if (!rows[i]) (cells[i].timed() || alone(cells[i]) ? one_by_one : together).push_back(i);
  }
  const long of = long(together.size() + one_by_one.size());
  long done = 0;
  std::mutex mutex;
  std::optional<Fault> fault;
  std::atomic<bool> stop = false;
  const auto run = [&](std::size_t i) {
    Row row = measure(cells[i]);
    if (interrupted() != 0) return;  // it may have stopped half way
    if (!options.directory.empty())
      if (const auto written = write_file(file(i), row_json(row)); !written) {
        const std::lock_guard lock(mutex);
        fault = written.fault();
        stop = true;
        return;
      }
    const std::lock_guard lock(mutex);
    rows[i] = std::move(row);
    options.progress(++done, of);
  };
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k; (k = next++) < together.size() && !stop && interrupted() == 0;) run(together[k]);
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < options.jobs; ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (const std::size_t i : one_by_one)
    if (!stop && interrupted() == 0) run(i);
  if (fault) return *fault;
  std::vector<Row> finished;
  for (auto& row : rows)
    if (row) finished.push_back(std::move(*row));
  return finished;
}

}  // namespace rigor::studies
