#pragma once
#include <rigor/grader/report.hpp>

namespace rigor::grader {

/// The configuration of a case as a <figure> with one SVG: cuboids, contact, plane, and the vectors that matter, with a
/// text alternative. "" for a case that is a whole scene.
std::string picture(const Counterexample& example);

}  // namespace rigor::grader
