// rigor-grader: `rigor grade` alone, which is what `rigor export` puts into its packages. No GSL, no SUNDIALS. What it
// writes is read by students; ./practice of the kit sets RIGOR_PRACTICE.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/grade.hpp>
#include <rigor/grader/report.hpp>

int main(int argc, char** argv) {
  CLI::App app{"rigor-grader: grades a submission", "rigor-grader"};
  app.require_subcommand(1);
  int exit_status = 0;
  const bool practice = std::getenv("RIGOR_PRACTICE") != nullptr;
  rigor::cli::add_grade(app, exit_status, practice ? rigor::grader::Reader::practice : rigor::grader::Reader::platform);
  try {
    rigor::catch_interrupts();
    app.parse(argc, argv);
    return exit_status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rigor-grader: %s\n", error.what());
    return 3;
  }
}
