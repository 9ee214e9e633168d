#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <rigor/grader/judge.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// Somebody the suite is tried on, by the name of the misconception or reading.
struct Auditee {
  std::string id;
  std::array<FunctionStatus, student_functions> functions{};  ///< what the build made of them
  std::function<Student()> enter;  ///< a student of its own for each thread
};

/// One executable for all of `ids`: the submission looks at the name it is started by
/// (tests/submissions/audit/switched). Faults: those of build(), and unwritable.
Outcome<std::vector<Auditee>> switched_auditees(const Submission& submission, const std::vector<std::string>& ids, const BuildOptions& options = {});
/// A submission as it is, by its own name. Faults: those of build().
Outcome<Auditee> compiled_auditee(const Submission& submission, const BuildOptions& options = {});
/// The judge's own model student: no process, for tests of the judge.
Auditee model_auditee(const std::string& id);

struct AuditOptions {
  int seeds = 3, cases = 24, jobs = 1;
  std::function<void(int done, int all)> progress = [](int, int) {};
};

/// What the suite made of one misconception, over several seeds.
struct AuditRow {
  std::string id, text;
  std::string shown_as;              ///< the name to be given: its own, or that of its class
  bool failed = true;                ///< at every seed every check that claims it failed, and at least one check
  bool named_right = true;           ///< at every seed `shown_as`, and nothing else, was named
  std::map<std::string, int> names;  ///< what was named, at how many seeds; "" nothing
  std::vector<std::string> checks;   ///< that failed, at the first seed
  std::vector<std::string> missed;   ///< that claim it and passed, at some seed
  double median_cases = 0;           ///< of the first case that shows it, over failed checks and seeds
  int worst_cases = 0;

  bool named_wrong() const;
};

/// A right student and the lowest score over the seeds.
struct AuditReading {
  std::string id;
  double lowest = 100;
  std::string failed;  ///< the first check that failed, if any
};

/// The suite tried on everything it must tell apart: every misconception must fail and be named, every legitimate
/// reading must pass.
struct Audit {
  std::vector<AuditRow> misconceptions;
  std::vector<AuditReading> variants;
  int seeds = 0, cases = 0;
  double seconds = 0;

  int failed() const;
  int named_right() const;
  int named_wrong() const;
  int right_full_marks() const;
  bool holds() const;  ///< all fail, at least 95 % named right, none named wrong, all readings full marks
};

/// Seeds 1, 2, ..., `options.seeds`; stops early when interrupted (then fewer rows).
Audit audit(const std::vector<Auditee>& wrong, const std::vector<Auditee>& right, const AuditOptions& options);

std::string audit_text(const Audit& audit);
std::string audit_json(const Audit& audit);

}  // namespace rigor::grader
