#pragma once
#include <rigor/grader/rubric.hpp>

namespace rigor::grader {

/// A submission built with the address and undefined-behaviour sanitizers and run on a few cases of every check, in a
/// place of its own (it sees the system's libraries; its answers are thrown away). One line of advice for the report:
/// the first finding, or that there was none, or why it could not be tried.
std::string sanitizer_advice(const Submission& submission, const Rubric& rubric, BuildOptions options);

/// The first finding in what a sanitized program printed: "Cuboid.cpp:41: index 3 out of bounds ..."; "" when none is in
/// one of `files`, the submission's. A finding inside a library is put at the first of its frames that lies in one.
std::string sanitizer_finding(const std::string& output, const std::vector<std::string>& files);

}  // namespace rigor::grader
