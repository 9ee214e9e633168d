#pragma once
#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

namespace rigor::cli {

/// An option's value must be a number of type T in [low, high]; no NaN. The message names value and range.
template <class T>
CLI::Validator in_range(T low, T high) {
  const auto written = [](T x) {
    char text[40];
    return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
  };
  const std::string range = "in [" + written(low) + ", " + written(high) + "]";
  return {[=](std::string& word) {
            T x{};
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
            const bool whole = error == std::errc{} && end == word.data() + word.size();
            return whole && x >= low && x <= high ? "" : "is " + word + ", must be " + range;
          },
          range};
}

}  // namespace rigor::cli
