#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace rigor::grader {

/// What the judge made of the model student with one misconception, over several seeds.
struct AuditRow {
  std::string id;
  std::string text;
  bool failed = true;               ///< at every seed at least one check failed
  bool named_right = true;          ///< at every seed the id, and nothing else, was named
  std::string named_wrong;          ///< another name that was given, if any
  std::vector<std::string> checks;  ///< that failed, at the first seed
  double median_cases = 0;          ///< of the first case that shows it, over checks' cases and seeds
  int worst_cases = 0;
};

/// The suite tried on everything it must tell apart: every misconception must fail and be named, every legitimate
/// reading must pass.
struct Audit {
  std::vector<AuditRow> misconceptions;
  std::vector<std::pair<std::string, double>> variants;  ///< reading and its lowest score over the seeds
  int seeds = 0, cases = 0;

  int failed() const;
  int named_right() const;
  int named_wrong() const;
  int right_full_marks() const;
  bool holds() const;  ///< all fail, at least 95 % named right, none named wrong, all readings full marks
};

/// Seeds 1, 2, ..., `seeds`; stops early when interrupted (then fewer rows).
Audit audit(int seeds, int cases);

std::string audit_text(const Audit& audit);
std::string audit_json(const Audit& audit);

}  // namespace rigor::grader
