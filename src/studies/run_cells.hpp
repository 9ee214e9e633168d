#pragma once
#include <filesystem>
#include <functional>
#include <rigor/studies/cell.hpp>

namespace rigor::studies {

struct RunOptions {
  int jobs = 1;
  std::filesystem::path directory{};  ///< one file a cell goes below DIRECTORY/cells; empty: nothing is written
  bool resume = false;                ///< take the cells whose file is there
  std::function<void(long done, long of)> progress = [](long, long) {};
};

/// Measures the cells and returns their rows in the cells' order. Those that may run together do so on `jobs` threads;
/// timed ones, and those `alone` names, run one after another afterwards. Each finished cell is on disk before the next
/// begins: an interrupted run has lost what it was at, and returns the rows that are finished.
/// Faults: unwritable.
Outcome<std::vector<Row>> run_cells(const std::vector<Cell>& cells, const std::function<Row(const Cell&)>& measure, const std::function<bool(const Cell&)>& alone,
                                    const RunOptions& options);

}  // namespace rigor::studies
