#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/export.hpp>
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

`CMakeLists.txt` is for your editor. Hand in the files of `src`.
)file";

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

/// The rubric with the seed for practice: the graded one is the instructor's secret.
std::string for_practice(const std::string& rubric, std::uint64_t practice_seed) {
  static const std::regex seeds("(^|\n)[ \t]*(practice_)?seed[ \t]*=[^\n]*");
  return "seed = " + std::to_string(practice_seed) + "                   # for practice: the course grades with another\n" + std::regex_replace(rubric, seeds, "$1");
}

Outcome<bool> write_kit(const fs::path& to, const std::string& rubric, const grader::Rubric& read) {
  Package package{{"README.md", kit_readme}, {"CMakeLists.txt", kit_cmake}, {"practice", practice, true}};
  for (const Text& text : grader::texts()) {
    const std::string path(text.path);
    if (path.starts_with("src/kit/handout/")) package.push_back({"src/" + path.substr(16), std::string(text.content)});
    if (path.starts_with("src/kit/include/")) package.push_back({"include/" + path.substr(16), std::string(text.content)});
  }
  if (const auto added = add_grader(package, "", for_practice(rubric, read.practice_seed)); !added) return added;
  return write_tree(package, to);
}

Outcome<bool> write_gradescope(const fs::path& to, const std::string& rubric) {
  Package package{{"setup.sh", setup_sh, true}, {"run_autograder", run_autograder, true}};
  if (const auto added = add_grader(package, "", rubric); !added) return added;
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
  return write_file(to / "rigor.tar", tarred(lab));
}

struct Options {
  std::string what, directory, rubric;
};

int export_command(const Options& options) {
  const auto bad_input = [](const std::string& text) { return std::fprintf(stderr, "rigor export: %s\n", text.c_str()), 2; };
  std::string text = grader::default_rubric_text();
  if (!options.rubric.empty()) {
    const auto own = read_file(options.rubric, 1u << 20);
    if (!own) return bad_input(own.fault().text());
    text = *own;
  }
  const auto rubric = grader::parse_rubric(text, options.rubric);
  if (!rubric) return bad_input(rubric.fault().text());
  for (const std::string& warning : grader::warnings(*rubric, options.what != "kit")) std::fprintf(stderr, "rigor export: %s\n", warning.c_str());
  const auto written = options.what == "kit"      ? write_kit(options.directory, text, *rubric)
                       : options.what == "autolab" ? write_autolab(options.directory, text, *rubric)
                       : options.what == "gradescope"
                           ? write_gradescope(options.directory, text)
                           : Outcome<bool>(Fault{Fault::Kind::unknown_key, "", "'" + options.what + "' is none of kit, autolab, gradescope" +
                                                                                 did_you_mean(options.what, {"kit", "autolab", "gradescope"})});
  if (!written) return bad_input(written.fault().text());
  const char* made = options.what == "kit" ? "" : options.what == "autolab" ? "/rigor.tar" : "/autograder.zip";
  std::printf("%s%s\n", options.directory.c_str(), made);
  return 0;
}

}  // namespace

void add_export(CLI::App& app, int& exit_status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "writes the students' kit, an Autolab lab or a Gradescope autograder");
  command->add_option("WHAT", options->what, "kit, autolab or gradescope")->required();
  command->add_option("DIR", options->directory, "where it goes")->required();
  command->add_option("--rubric", options->rubric, "TOML file to grade with (docs/rubric.md); the kit gets it with another seed");
  command->footer("Example:  rigor export gradescope out/gradescope");
  command->callback([options, &exit_status] { exit_status = export_command(*options); });
}

}  // namespace rigor::cli
