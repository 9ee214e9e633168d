#pragma once
#include <rigor/studies/cell.hpp>
#include <rigor/studies/student.hpp>

namespace rigor::studies {

/// A problem of contact whose answer is known in closed form.
struct ContactProblem {
  std::string name;
  std::string says;
  std::string answer;     ///< the closed form, and what the error measures
  std::string unit;       ///< of the error
  std::string x;          ///< what Cell::x sweeps
  std::vector<double> sweep;
};
const std::vector<ContactProblem>& contact_problems();

/// A contact cell: `steps` in a second of the method's stepper, or method "located", or the student's. Values: error,
/// the energy ledger (own_J: what the steps made by themselves at worst, restitution_J, friction_J) and the number of impacts, which are NaN of a student's.
Row contact(const Cell& cell, Student* student = nullptr);

}  // namespace rigor::studies
