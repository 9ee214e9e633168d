#pragma once
#include <filesystem>
#include <functional>
#include <optional>
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

/// Whether the cells.txt of a directory, which lists the file and the description of each cell, is of another study: it has none of these cells, but for
/// what scene files and submissions held at the time. Then the fault (unsupported) names what is there. A directory without the list is of none.
std::optional<Fault> other_study(const std::filesystem::path& directory, const std::vector<Cell>& cells);

/// How many files of DIRECTORY/cells are of other cells than these: of a longer study before, or of a file since edited.
std::size_t cells_not_asked_for(const std::filesystem::path& directory, const std::vector<Cell>& cells);

}  // namespace rigor::studies
