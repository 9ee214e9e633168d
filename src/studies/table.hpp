#pragma once
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// The frozen tables reference/tables/NAME.csv and how each is made anew: inputs exact in binary, results by Taylor series in 60 digits,
/// written with 30. The flights take a minute or two, the impacts seconds.
struct FrozenTable {
  std::string name;
  std::string (*make)();
};
const std::vector<FrozenTable>& frozen_tables();
/// The same rows as JSON: "provenance" (the comment lines), "command" and "cases", every number as the text of the CSV,
/// since a JSON reader would cut 30 digits to a double.
std::string table_json(const std::string& name, const std::string& csv);

/// Somebody's answers against the table, one line a stratum.
struct TableRow {
  std::string stratum{};
  int answered = 0, of = 0;
  double attitude = 0;   ///< worst, rad
  double spin = 0;       ///< worst, relative to |ω|
  std::string worst{};     ///< the case with the worst attitude
  bool event = false;    ///< a table of impacts: with the two below
  double time = 0;       ///< worst, relative
  double velocity = 0;   ///< of the centre, worst, relative
};
/// `theirs`: CSV with a header and the columns case, qw, qx, qy, qz, wx, wy, wz (attitude body to world, spin in body axes), for a table
/// with impacts time, vx, vy, vz too, in any order; other columns are passed by. A byte order mark is passed by. Faults name line and column: malformed (nothing, UTF-16, another separator than ',', a
/// line with fewer cells than the header), missing (a column, every case), unknown_key (a
/// case that is not in the table, or twice), wrong_type or not_finite (a cell), not_unit (a quaternion off by more than 1e-3).
Outcome<std::vector<TableRow>> check_table(const std::string& table, const std::string& theirs, const std::string& name);

std::string table_text(const std::vector<TableRow>& rows);

/// What it comes to: the largest of all these errors, and the cases without an answer.
struct TableVerdict {
  double worst = 0;
  std::string of{};             ///< "attitude, generic"
  int answered = 0, cases = 0;

  bool within(double error) const { return answered == cases && worst <= error; }
};
TableVerdict verdict_of(const std::vector<TableRow>& rows);
/// "worst 6.1e-02 (attitude, generic), 8 of 49 cases answered"
std::string verdict_text(const TableVerdict& verdict);

}  // namespace rigor::studies
