#pragma once
#include <functional>
#include <rigor/grader/check.hpp>

namespace rigor::grader {

/// A simpler input on which the check still fails: zero or whole components, round masses and sizes, no turn.
/// `fails` asks the student's code (at most `calls` times); the result is usable, and the given one at worst.
Scenario shrink(const Check& check, const Scenario& failing, const std::function<bool(const Scenario&)>& fails, int calls = 200);

}  // namespace rigor::grader
