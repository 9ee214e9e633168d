#pragma once
#include <rigor/studies/cell.hpp>
#include <rigor/studies/report.hpp>

namespace rigor::studies {

/// The page of a study, by its kind, from its rows, and the number of cells it was to have. The problems were opened before.
StudyPage study_page(const std::string& kind, const std::vector<Row>& rows, const std::string& command, std::size_t cells);

StudyPage convergence_page(const std::vector<Row>& rows);
StudyPage work_page(const std::vector<Row>& rows);
StudyPage drift_page(const std::vector<Row>& rows);
StudyPage stability_page(const std::vector<Row>& rows);
StudyPage contact_page(const std::vector<Row>& rows);

/// Rows of one problem, then of one method, in the order they came first.
struct Group {
  std::string name;
  std::vector<const Row*> rows;
};
std::vector<Group> by_problem(const std::vector<Row>& rows);
std::vector<Group> by_method(const std::vector<const Row*>& rows);

/// The problem statement of flights: equations, and where the end is judged, T, how the reference was made and its own error.
Section problem_section(const Cell& cell);

/// More than sixteen curves cover each other: all but `kept` and one of each family of methods are set aside.
void set_aside(report::Plot& plot, const std::vector<std::string>& kept = {});

/// Cheapest row of `rows` that reaches an attitude error, by median processor time; nullptr when none does.
const Row* cheapest(const std::vector<const Row*>& rows, double error);
bool of_a_peer(const Row& row);

}  // namespace rigor::studies
