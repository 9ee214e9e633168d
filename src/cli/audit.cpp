#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/audit.hpp>
#include <rigor/grader/audit.hpp>

namespace rigor::cli {

void add_audit(CLI::App& app, int& exit_status) {
  struct Options {
    int seeds = 3, cases = 24;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("audit", "tries the checks on every known mistake and every legitimate reading");
  command->add_option("--seeds", options->seeds, "seeds 1 to N")->check(CLI::Range(1, 1000))->capture_default_str();
  command->add_option("--cases", options->cases, "random inputs for each check")->check(CLI::Range(1, 100000))->capture_default_str();
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example:  rigor audit --seeds 20");
  command->callback([options, &exit_status] {
    const grader::Audit audit = grader::audit(options->seeds, options->cases);
    std::fputs((options->json ? grader::audit_json(audit) : grader::audit_text(audit)).c_str(), stdout);
    exit_status = interrupted() != 0 ? 128 + interrupted() : audit.holds() ? 0 : 1;
  });
}

}  // namespace rigor::cli
