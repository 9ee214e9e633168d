#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor export kit|autolab|gradescope DIR`: what students or a platform get, with a grader that needs only g++.
void add_export(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
