#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <rigor/base/file.hpp>
#include <rigor/grader/build.hpp>
#include <rigor/grader/worker.hpp>

namespace rigor::grader {

namespace fs = std::filesystem;

inline fs::path samples() { return fs::path(RIGOR_SOURCE_DIR) / "tests" / "submissions"; }

inline std::vector<std::string> samples_in(const std::string& room) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(samples() / room)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// The lines of a sample's EXPECT or WHAT.
inline std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A directory of files for one test, gone with it.
class Directory {
 public:
  Directory() {
    std::string pattern = (fs::temp_directory_path() / "rigor-test-XXXXXX").string();
    path = ::mkdtemp(pattern.data());
    fs::permissions(path, fs::perms(0755));
  }
  ~Directory() {
    std::error_code ec;
    fs::remove_all(path, ec);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  void write(const fs::path& name, const std::string& text) const {
    ASSERT_TRUE(write_file(path / name, text)) << name;
  }
  fs::path path;
};

inline BuildResult built(const fs::path& path, const BuildOptions& options = {}) {
  const auto submission = open_submission(path);
  EXPECT_TRUE(submission) << submission.fault().text();
  const auto result = build(*submission, options);
  EXPECT_TRUE(result) << result.fault().text();
  return *result;
}

/// A request on two bodies with three different edges, moving and spinning.
inline Request generic(Function function) {
  Request r{};
  r.function = std::uint32_t(function);
  r.count = 1;
  r.direct = 1;
  r.h = 1.0 / 240;
  r.plane_point[0] = 1, r.plane_point[1] = 2, r.plane_point[2] = 3;
  r.plane_normal[1] = 1;
  r.point[0] = 0.5;
  for (BodyRecord* b : {&r.A, &r.B}) {
    b->mass = 2;
    for (int i = 0; i < 3; ++i) {
      b->size[i] = 1 + i;
      b->rotation[4 * i] = 1;
      b->position[i] = 0.25 * (i + 1);
      b->velocity[i] = -1 + 0.5 * i;
      b->spin[i] = 0.5 - i;
      const double moments[] = {13.0 / 6, 10.0 / 6, 5.0 / 6};  // m/12 (h^2 + d^2) and so on for edges 1, 2, 3
      b->body_inertia[4 * i] = moments[i];
      b->body_inverse_inertia[4 * i] = 1 / moments[i];
    }
  }
  r.B.position[0] += 1;
  r.vector[0] = 1;
  return r;
}

inline std::string kind_of(const Answer& answer) {
  if (std::holds_alternative<Reply>(answer)) return "reply";
  switch (std::get<Death>(answer).kind) {
    case Death::Kind::crash: return "crash";
    case Death::Kind::timeout: return "timeout";
    case Death::Kind::memory: return "memory";
    case Death::Kind::exited: return "exited";
    case Death::Kind::flood: return "flood";
    case Death::Kind::absent: return "absent";
    case Death::Kind::unstarted: return "unstarted";
  }
  return "?";
}

inline std::string words_of(const Answer& answer) {
  const Death* death = std::get_if<Death>(&answer);
  return death ? death->words : "";
}

}  // namespace rigor::grader
