#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/export.hpp>
#include <rigor/cli/wrote.hpp>
#include <rigor/grader/package.hpp>
#include <rigor/grader/rubric.hpp>
#include <rigor/grader/texts.hpp>

namespace rigor::cli {
namespace {

namespace fs = std::filesystem;
using grader::Package;

// What a loader needs to start the grader anywhere: the grader is run by the loader and the libraries it was built
// with, so that neither their versions nor the C library of the other machine matter.
constexpr const char* grade_script = R"file(#!/bin/sh
# The bundled grader: rigor/grade PATH [options of `rigor grade`]. The machine needs g++; bubblewrap if it can be had.
here=$(cd "$(dirname "$0")" && pwd)
export RIGOR_EIGEN="$here/eigen3"
export RIGOR_CACHE="${RIGOR_CACHE:-${TMPDIR:-/tmp}/rigor-cache-$(id -u)}"
exec "$here/lib/LOADER" --library-path "$here/lib" "$here/lib/rigor-grader" grade --rubric "$here/rubric.toml" "$@"
)file";

constexpr const char* run_autograder = R"file(#!/bin/sh
# Gradescope runs this as root, with the submission unpacked in /autograder/submission.
exec /autograder/source/rigor/grade /autograder/submission --format gradescope --out /autograder/results --quiet
)file";
constexpr const char* setup_sh = R"file(#!/bin/sh
# Gradescope runs this once, when it builds the image.
set -e
apt-get update
apt-get install --no-install-recommends -y g++ libc6-dev bubblewrap
)file";

// Whatever happens the status is 0 and the last two lines are the grader's: anything else loses the scores.
constexpr const char* autograde_makefile = R"file(all:
	@tar xzf autograde.tar
	@sh autograde/run
)file";
constexpr const char* autolab_run = R"file(#!/bin/sh
# Autolab runs this through the Makefile, beside handin.zip.
here=$(cd "$(dirname "$0")" && pwd)
rm -rf out out.log  # of an earlier hand-in
"$here/rigor/grade" handin.zip --format text,autolab --out out >out.log 2>&1
status=$?
if [ -f out/report.txt ]; then cat out/report.txt; else cat out.log; fi
if [ -f out/autolab.txt ]; then cat out/autolab.txt; else echo "the grader did not finish (status $status)"; fi
exit 0
)file";
constexpr const char* autolab_rb = R"file(require "AssessmentBase.rb"

module Rigor
  include AssessmentBase

  def assessmentInitialize(course)
    super("rigor", course)
    @problems = []
  end
end
)file";

constexpr const char* practice = R"file(#!/bin/sh
# Grades src/ with the seed for practice; the course uses another. Options: those of `rigor grade`, for example
#   ./practice --out report                          a page to look at
#   ./practice --check plane.impulse --case 17       one case again
here=$(cd "$(dirname "$0")" && pwd)
RIGOR_PRACTICE=1 exec "$here/rigor/grade" "$here/src" "$@"
)file";
constexpr const char* kit_cmake = R"file(cmake_minimum_required(VERSION 3.10)
project(assignment CXX)
set(CMAKE_CXX_STANDARD 14)

# Compiles what you write; ./practice (or the target "practice") compiles it too, and grades it.
file(GLOB sources src/*.cpp)
add_library(assignment OBJECT ${sources})
target_include_directories(assignment PRIVATE src include ${CMAKE_SOURCE_DIR})
target_include_directories(assignment SYSTEM PRIVATE rigor/eigen3)
target_compile_options(assignment PRIVATE -include kit.hpp)
add_custom_target(practice COMMAND ${CMAKE_SOURCE_DIR}/practice)
)file";
constexpr const char* kit_readme = R"file(# Rigid bodies: the kit

`src` holds the files you finish: `Cuboid.cpp`, `CollisionPlane.cpp`, `ParticleSystem.cpp`. `include` holds stand-ins for
the window program's headers, so that everything compiles without a window.

    ./practice                 # compiles src and grades it: points, the smallest failing case, a likely mistake
    ./practice --out report    # the same as a page, report/report.html

You need g++ (Debian, Ubuntu: `apt-get install g++`); with `bubblewrap` your code runs in a sandbox. The checks, points and
tolerances are those of the course; the random cases are others. A file that does not compile costs only the functions in
it that are broken. Every verdict comes with a command that repeats it: `./practice --check ID --case N`.

`practice` is a program for Linux on an x86-64 (Intel, AMD) processor. On Windows run it in WSL: `wsl --install`, then work in its Ubuntu.
On a Mac, or anywhere else, run it in a container, from this directory:

    docker run --rm -it --platform linux/amd64 -v "$PWD":/kit -w /kit debian:12 bash
    apt-get update && apt-get install -y g++      # in it; then ./practice

`CMakeLists.txt` is for your editor and compiles on any system. Hand in the files of `src`.
)file";

// What both platforms' instructions end with.
constexpr const char* about_package = R"file(
## Seed, points, packing again

The random cases come from `seed` in the rubric, which is packed (`rigor/rubric.toml`). Keep the package and the seed from students;
for practice they get `rigor export kit`, which has another seed. To change points, seed or limits, change your rubric and
pack again into an empty directory:

    rigor grade --print-rubric > course.toml
    rigor export WHAT NEW_DIRECTORY --rubric course.toml

then upload the new package in place of the old one, and have what was handed in graded again.

## Time

Right code takes some ten seconds, the compiler among them. Slow code is stopped by the rubric's limits (`[limits]`): what the calls of one function may take is 40 times
`call_seconds`, 20 s unless you change it.
)file";
constexpr const char* gradescope_readme = R"file(# The autograder for Gradescope

1. In Gradescope: a new programming assignment with POINTS points, those of the packed rubric.
2. "Configure Autograder": upload `autograder.zip` as it is; base image Ubuntu. `setup.sh` installs g++ and bubblewrap (it needs
   the network once, while the image is built).
3. "Test Autograder" with a submission of your own; then publish.

Students hand in their files, or a zip of them. Gradescope stops an autograder after 10 minutes unless the settings say otherwise; then the
results are "the grader did not finish".
)file";
constexpr const char* autolab_readme = R"file(# The lab for Autolab

1. In Autolab: "Install Assessment", "Import from tarball", `rigor.tar`. The directory `rigor` beside it holds the same as files.
2. "Edit assessment", autograder: set the image to one with g++ and make (`rigor.yml` names `autograding_image`).
3. Hand in a submission of your own: `handin.zip`, a zip or tar of the files.

The problems are the parts of the rubric, POINTS points in all. `autograde_timeout` in `rigor.yml` is 300 s; a job that is stopped has no scores.
)file";

std::string readme(std::string text, const char* what, const grader::Rubric& rubric) {
  char sum[32];
  std::snprintf(sum, sizeof sum, "%.10g", rubric.total_points());
  text = std::regex_replace(text, std::regex("POINTS"), sum);
  return text + std::regex_replace(std::string(about_package), std::regex("WHAT"), what);
}

/// Where this program is, and with it rigor-grader.
fs::path own_directory() {
  std::error_code ec;
  return fs::read_symlink("/proc/self/exe", ec).parent_path();
}

Outcome<bool> add_file(Package& package, const std::string& as, const fs::path& from, bool executable) {
  auto bytes = read_file(from, 256u << 20);
  if (!bytes) return bytes.fault();
  package.push_back({as, *bytes, executable});
  return true;
}

Outcome<bool> add_directory(Package& package, const std::string& as, const fs::path& from) {
  std::error_code ec;
  std::vector<fs::path> files;
  for (const auto& item : fs::recursive_directory_iterator(from, ec))
    if (item.is_regular_file()) files.push_back(item.path());
  if (files.empty()) return Fault{Fault::Kind::missing, from.string(), "holds no files; the package needs them"};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    if (const auto added = add_file(package, as + "/" + file.lexically_relative(from).string(), file, false); !added) return added;
  return true;
}

/// The grader with its libraries and loader below `below`/rigor.
Outcome<bool> add_grader(Package& package, const std::string& below, const std::string& rubric) {
  const fs::path program = own_directory() / "rigor-grader";
  if (const auto added = add_file(package, below + "rigor/lib/rigor-grader", program, true); !added) return added;
  std::FILE* pipe = popen(("ldd '" + program.string() + "' 2>&1").c_str(), "r");
  if (pipe == nullptr) return Fault{Fault::Kind::unsupported, "ldd", "cannot be run"};
  std::string loader;
  char line[1024];
  static const std::regex library(R"(\s*(\S+) => (/\S+) \(.*\)\s*)"), alone(R"(\s*(/\S*/(ld-[^/\s]+)) \(.*\)\s*)");
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    std::cmatch match;
    Outcome<bool> added = true;
    if (std::regex_match(line, match, library)) added = add_file(package, below + "rigor/lib/" + match[1].str(), match[2].str(), false);
    else if (std::regex_match(line, match, alone)) added = add_file(package, below + "rigor/lib/" + (loader = match[2]), match[1].str(), true);
    if (!added) return pclose(pipe), added;
  }
  pclose(pipe);
  if (loader.empty()) return Fault{Fault::Kind::unsupported, program.string(), "is no dynamically linked program as ldd sees it"};
  package.push_back({below + "rigor/grade", std::regex_replace(std::string(grade_script), std::regex("LOADER"), loader), true});
  package.push_back({below + "rigor/rubric.toml", rubric, false});
  for (const char* eigen : {"/usr/include/eigen3", "/usr/local/include/eigen3"})
    if (fs::exists(eigen)) return add_directory(package, below + "rigor/eigen3/Eigen", fs::path(eigen) / "Eigen");
  return Fault{Fault::Kind::missing, "/usr/include/eigen3", "is not there (package libeigen3-dev)"};
}

Outcome<bool> write_kit(const fs::path& to, const grader::Rubric& rubric) {
  Package package{{"README.md", kit_readme}, {"CMakeLists.txt", kit_cmake}, {"practice", practice, true}};
  for (const Text& text : grader::texts()) {
    const std::string path(text.path);
    if (path.starts_with("src/kit/handout/")) package.push_back({"src/" + path.substr(16), std::string(text.content)});
    if (path.starts_with("src/kit/include/")) package.push_back({"include/" + path.substr(16), std::string(text.content)});
  }
  if (const auto added = add_grader(package, "", grader::practice_rubric_text(rubric)); !added) return added;
  return write_tree(package, to);
}

Outcome<bool> write_gradescope(const fs::path& to, const std::string& rubric, const grader::Rubric& read) {
  Package package{{"setup.sh", setup_sh, true}, {"run_autograder", run_autograder, true}};
  if (const auto added = add_grader(package, "", rubric); !added) return added;
  if (const auto written = write_file(to / "README.md", readme(gradescope_readme, "gradescope", read)); !written) return written;
  return write_file(to / "autograder.zip", zipped(package));
}

std::string autolab_yml(const grader::Rubric& rubric) {
  std::string problems;
  for (const std::string& group : rubric.group_names()) {
    double sum = 0;
    for (const grader::Check& check : grader::checks()) sum += rubric.group_of(check) == group ? rubric.points_of(check) : 0;
    char line[160];
    std::snprintf(line, sizeof line, "- name: %s\n  description: ''\n  max_score: %.10g\n  optional: false\n", group.c_str(), sum);
    problems += line;
  }
  return "---\ngeneral:\n  name: rigor\n  description: ''\n  display_name: Rigid bodies\n  handin_filename: handin.zip\n"
         "  handin_directory: handin\n  max_grace_days: 0\n  handout: ''\n  writeup: ''\n  max_submissions: -1\n"
         "  disable_handins: false\n  max_size: 8\n  has_svn: false\n  category_name: Labs\nproblems:\n" + problems +
         "autograder:\n  autograde_timeout: 300\n  autograde_image: autograding_image\n  release_score: true\n";
}

Outcome<bool> write_autolab(const fs::path& to, const std::string& rubric, const grader::Rubric& read) {
  Package inner{{"autograde/run", autolab_run, true}};
  if (const auto added = add_grader(inner, "autograde/", rubric); !added) return added;
  const Package lab{{"rigor/rigor.yml", autolab_yml(read)}, {"rigor/rigor.rb", autolab_rb},
                    {"rigor/autograde-Makefile", autograde_makefile}, {"rigor/autograde.tar", tarred(inner)}};
  if (const auto written = write_tree(lab, to); !written) return written;
  if (const auto written = write_file(to / "README.md", readme(autolab_readme, "autolab", read)); !written) return written;
  return write_file(to / "rigor.tar", tarred(lab));
}

struct ExportOptions {
  std::string what, directory, rubric;
};

int export_command(const ExportOptions& options) {
  const auto bad_input = [](const std::string& text) { return std::fprintf(stderr, "rigor export: %s\n", text.c_str()), 2; };
  const std::vector<std::string> known{"kit", "autolab", "gradescope"};
  if (std::find(known.begin(), known.end(), options.what) == known.end())
    return bad_input("'" + options.what + "' is none of kit, autolab, gradescope" + did_you_mean(options.what, known));
  std::string text = grader::default_rubric_text();
  if (!options.rubric.empty()) {
    const auto own = read_file(options.rubric, 1u << 20);
    if (!own) return bad_input(own.fault().text());
    text = *own;
  }
  const auto rubric = grader::parse_rubric(text, options.rubric);
  if (!rubric) return bad_input(rubric.fault().text());
  std::error_code ec;
  if (fs::exists(options.directory, ec) && (!fs::is_directory(options.directory, ec) || !fs::is_empty(options.directory, ec)))
    return bad_input(options.directory + ": is not empty, must be a new or an empty directory: nothing in it is written over");
  for (const std::string& warning : grader::warnings(*rubric, options.what != "kit")) std::fprintf(stderr, "rigor export: %s\n", warning.c_str());
  const auto written = options.what == "kit"       ? write_kit(options.directory, *rubric)
                       : options.what == "autolab" ? write_autolab(options.directory, text, *rubric)
                                                   : write_gradescope(options.directory, text, *rubric);
  if (!written) return bad_input(written.fault().text());
  if (options.what == "kit") say_wrote(options.directory, {"README.md", "CMakeLists.txt", "practice", "src", "include", "rigor"});
  else if (options.what == "autolab") say_wrote(options.directory, {"rigor.tar", "rigor"});
  else say_wrote(options.directory, {"autograder.zip"});
  return 0;
}

}  // namespace

void add_export(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "writes the students' kit, an Autolab lab or a Gradescope autograder");
  command->add_option("WHAT", options->what, "kit, autolab or gradescope")->required();
  command->add_option("DIR", options->directory, "where it goes: a new or an empty directory")->required();
  command->add_option("--rubric", options->rubric, "TOML file to grade with (docs/rubric.md); the kit gets it with another seed");
  command->footer("Example:  rigor export gradescope out/gradescope");
  command->callback([options, &exit_status] { exit_status = export_command(*options); });
}

}  // namespace rigor::cli
