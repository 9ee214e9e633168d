#pragma once
#include <random>
#include <rigor/grader/build_text.hpp>
#include <rigor/grader/submission.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// A right submission with one to three slips of the keyboard.
struct Mutation {
  Submission submission;
  std::vector<std::string> what;  ///< "Cuboid.cpp:31: '+' -> '-'"
};

/// `number` of the mutations of `right`, always the same: in the sources, a token deleted, exchanged with the next, or
/// replaced by its opposite (+ -, * /, < >, += -=, 0 1, true false).
inline Mutation mutated(const Submission& right, int number) {
  static const std::pair<const char*, const char*> opposites[] = {{"+", "-"}, {"*", "/"}, {"<", ">"}, {"+=", "-="}, {"0", "1"}, {"true", "false"}};
  std::mt19937_64 random(std::uint64_t(number) + 1);
  Mutation m{right, {}};
  std::vector<SourceFile*> sources;
  for (SourceFile& file : m.submission.files)
    if (file.name.ends_with(".cpp")) sources.push_back(&file);
  const std::size_t slips = 1 + random() % 3;
  while (m.what.size() < slips) {
    SourceFile& file = *sources[random() % sources.size()];
    const std::string text = file.text;
    const std::vector<Token> tokens = tokens_of(text);
    if (tokens.size() < 2) continue;
    const std::size_t at = random() % (tokens.size() - 1);
    const Token a = tokens[at], b = tokens[at + 1];
    std::string now, change;
    switch (random() % 3) {
      case 0:
        now = text.substr(0, a.at) + text.substr(a.at + a.text.size());
        change = "'" + std::string(a.text) + "' deleted";
        break;
      case 1:
        now = text.substr(0, a.at) + std::string(b.text) + text.substr(a.at + a.text.size(), b.at - a.at - a.text.size()) + std::string(a.text) + text.substr(b.at + b.text.size());
        change = "'" + std::string(a.text) + "' and '" + std::string(b.text) + "' exchanged";
        break;
      default:
        for (const auto& [one, other] : opposites) {
          if (a.text != one && a.text != other) continue;
          const std::string put = a.text == one ? other : one;
          now = text.substr(0, a.at) + put + text.substr(a.at + a.text.size());
          change = "'" + std::string(a.text) + "' -> '" + put + "'";
        }
    }
    if (change.empty()) continue;  // a token without an opposite
    file.text = now;
    m.what.push_back(file.name + ":" + std::to_string(a.line) + ": " + change);
  }
  m.submission.name = "mutation-" + std::to_string(number);
  m.submission.hash = right.hash + "/" + m.submission.name;
  return m;
}

}  // namespace rigor::grader
