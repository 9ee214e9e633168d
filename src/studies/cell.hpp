#pragma once
#include <optional>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// One run of a study, by description alone: the same description gives the same result (its times apart) on any machine.
struct Cell {
  std::string study;      ///< "convergence", "work-precision", "drift", "stability", "contact"
  std::string problem;    ///< of the catalogue, or a scene file (then with `content`)
  std::string method;     ///< one of ours, "exact", "cvode-adams", "mujoco/rk4", "submission NAME HASH"
  long steps = 0;         ///< fixed-step methods; contact: steps in a second
  double tolerance = 0;   ///< adaptive ones
  double until = 0;       ///< s; 0: the problem's own end
  double x = 0, y = 0;    ///< what the study sweeps: its page says what they are
  bool compensated = false;  ///< drift: positions summed with a carry
  std::string content{};  ///< of a scene file: Problem::content, by which an edited file is another cell

  bool timed() const { return study == "work-precision"; }
  /// "study=drift problem=case-A ...", every field, exact.
  std::string text() const;
  /// A file name: readable, and different for different descriptions.
  std::string file() const;
};

/// What a cell gave: named numbers in the order they were put, NaN where there is none, and why it failed.
struct Row {
  Cell cell;
  std::vector<std::pair<std::string, double>> values;
  std::string failed;   ///< "" when it did not
  std::string note;     ///< settings of a peer

  /// An infinity is no number either.
  void put(const std::string& name, double value);
  /// NaN when there is none of that name.
  double at(const std::string& name) const;
};

/// null where there is no number.
std::string row_json(const Row& row);
/// Nothing when the text is not a row, or the row of another cell.
std::optional<Row> row_from_json(const std::string& text, const Cell& cell);

/// One line a row; columns: the cell, then every value any row has. Empty: what a cell has not (a tolerance, an x), or what was not
/// measured; an empty until is the problem's own end.
std::string rows_csv(const std::vector<Row>& rows);

/// The shortest decimal that reads back as x.
std::string digits(double x);
/// x with few digits: "1.2e-05", "0", "-" for NaN.
std::string brief(double x, const char* format = "%.1e");

}  // namespace rigor::studies
