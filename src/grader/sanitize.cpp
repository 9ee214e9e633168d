#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <regex>
#include <rigor/base/promise.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/sanitize.hpp>
#include <sstream>

namespace rigor::grader {
namespace {

constexpr int cases_a_check = 4;
constexpr std::uint64_t most_cpu_s = 30;
constexpr double most_wall_s = 120;
constexpr std::uint32_t most_steps = 200;

/// The requests as a file the program reads from its descriptor 3 to the end.
int requests_file(const Rubric& rubric) {
  std::string bytes;
  for (const Check& check : checks())
    for (int k = 0; k < std::min(cases_a_check, rubric.cases); ++k)
      for (Call& call : check.calls(draw_case(check, rubric.seed, k))) {
        call.request.count = std::min(call.request.count, most_steps);
        bytes.append(reinterpret_cast<const char*>(&call.request), sizeof call.request);
      }
  const int fd = memfd_create("requests", MFD_CLOEXEC);
  promise(fd >= 0 && write(fd, bytes.data(), bytes.size()) == ssize_t(bytes.size()) && lseek(fd, 0, SEEK_SET) == 0, "requests can be written to memory");
  return fd;
}

struct Outcomes {
  std::string output;
  bool started = false, late = false;
  int status = 0;
};

Outcomes run(const std::filesystem::path& executable, const Rubric& rubric) {
  int out[2];
  promise(pipe2(out, O_CLOEXEC) == 0, "a pipe can be had");
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC), requests = requests_file(rubric);
  const Confined what{Profile::sanitizer, {executable.string()}, "/", {executable}, {}, {null, out[1], out[1], requests, null},
                      {most_cpu_s, RLIM_INFINITY, 0}};  // the address sanitizer reserves terabytes of address space
  const Outcome<Child> started = start(what);
  for (const int fd : {null, requests, out[1]}) close(fd);
  Outcomes result;
  if (started) {
    const Course course = run_to_end(*started, out[0], most_wall_s);
    result = {course.output, true, !course.by_itself, course.status};
  }
  close(out[0]);
  return result;
}

}  // namespace

std::string sanitizer_finding(const std::string& output, const std::vector<std::string>& files) {
  static const std::regex undefined(R"(runtime error: (.*))"), address(R"(ERROR: AddressSanitizer: ([A-Za-z-]+))"), place(R"(([\w.-]+\.\w+):(\d+))");
  std::istringstream lines(output);
  std::string what;
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (what.empty()) {
      if (std::regex_search(line, found, undefined)) what = found[1];
      else if (std::regex_search(line, found, address)) what = found[1];
      else continue;
    }
    for (auto at = std::sregex_iterator(line.begin(), line.end(), place); at != std::sregex_iterator(); ++at)
      if (std::find(files.begin(), files.end(), (*at)[1].str()) != files.end()) return (*at)[1].str() + ":" + (*at)[2].str() + ": " + what;
  }
  return "";
}

std::string sanitizer_advice(const Submission& submission, const Rubric& rubric, BuildOptions options) {
  const std::string head = "sanitizers (advice, no points): ";
  options.sanitize = true;
  const auto built = build(submission, options);
  if (!built) return head + "not tried: " + built.fault().text();
  if (built->executable.empty()) return head + "not tried: the submission could not be linked with them";
  const Outcomes result = run(built->executable, rubric);
  std::vector<std::string> files;
  for (const auto* list : {&submission.files, &submission.others})
    for (const SourceFile& file : *list) files.push_back(file.name);
  if (const std::string finding = sanitizer_finding(result.output, files); !finding.empty()) return head + finding;
  if (!result.started || (!result.late && result.status != 0)) return head + "not tried: the program does not run with them here" + (result.output.empty() ? "" : ": " + result.output.substr(0, 200));
  if (result.late) return head + "nothing found until the time for it was used up";
  return head + "nothing found in " + std::to_string(cases_a_check) + " cases of every check";
}

}  // namespace rigor::grader
