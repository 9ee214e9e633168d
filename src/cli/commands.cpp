#include <rigor/cli/audit.hpp>
#include <rigor/cli/check_table.hpp>
#include <rigor/cli/class.hpp>
#include <rigor/cli/commands.hpp>
#include <rigor/cli/demo.hpp>
#include <rigor/cli/explain.hpp>
#include <rigor/cli/export.hpp>
#include <rigor/cli/grade.hpp>
#include <rigor/cli/run.hpp>
#include <rigor/cli/shell.hpp>
#include <rigor/cli/study.hpp>
#include <rigor/cli/verify.hpp>
#include <rigor/cli/view.hpp>
#include <rigor/grader/report.hpp>

namespace rigor::cli {

void add_commands(CLI::App& app, int& exit_status) {
  add_demo(app, exit_status);
  add_grade(app, exit_status, grader::Reader::instructor);
  add_class(app, exit_status);
  add_audit(app, exit_status);
  add_export(app, exit_status);
  add_run(app, exit_status);
  add_view(app, exit_status);
  add_study(app, exit_status);
  add_check_table(app, exit_status);
  add_verify(app, exit_status);
  add_explain(app, exit_status);
  add_shell(app, exit_status);
}

}  // namespace rigor::cli
