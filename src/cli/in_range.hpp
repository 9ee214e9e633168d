#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <rigor/base/suggest.hpp>
#include <string>
#include <vector>

namespace rigor::cli {

/// An option's value must be a number of type T in [low, high]; no NaN. The message names value, range and unit.
template <class T>
CLI::Validator in_range(T low, T high, const std::string& unit = "") {
  const auto written = [](T x) {
    char text[40];
    std::string word(text, std::to_chars(text, text + sizeof text, x).ptr);
    if (const std::size_t e = word.find("e+"); e != std::string::npos) word.erase(e + 1, word.find_first_not_of("+0", e + 1) - e - 1);  // 1e7, not 1e+07
    return word;
  };
  const std::string range = "in [" + written(low) + ", " + written(high) + "]" + (unit.empty() ? "" : " " + unit);
  return {[=](std::string& word) {
            T x{};
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
            const bool whole = error == std::errc{} && end == word.data() + word.size();
            return whole && x >= low && x <= high ? "" : "is " + word + ", must be " + range;
          },
          range};
}

/// An option's value, a path or a name, must not be empty: "$DIR" of a variable that is not set is a mistake.
inline CLI::Validator not_empty() {
  return {[](std::string& word) { return std::string(word.empty() ? "is empty" : ""); }, ""};
}

/// An option's value must be one of `words`.
inline CLI::Validator one_of(const std::vector<std::string>& words) {
  const std::string all = fmt::format("{}", fmt::join(words, ", "));
  return {[=](std::string& word) {
            return std::find(words.begin(), words.end(), word) != words.end() ? "" : "is " + word + ", must be one of " + all + did_you_mean(word, words);
          },
          all};
}

}  // namespace rigor::cli
