#pragma once
#include <random>
#include <rigor/grader/build_text.hpp>
#include <rigor/grader/submission.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::grader {

/// A right submission with one to three slips of the keyboard.
struct Mutation {
  Submission submission;
  std::vector<std::string> what;  ///< "Cuboid.cpp:31: '+' -> '-'"
};

/// + for -, * for /, < for >, ...; empty where a token has no opposite.
inline std::string opposite_of(std::string_view token) {
  static const std::pair<const char*, const char*> opposites[] = {{"+", "-"}, {"*", "/"}, {"<", ">"}, {"+=", "-="}, {"0", "1"}, {"true", "false"}};
  for (const auto& [one, other] : opposites) {
    if (token == one) return other;
    if (token == other) return one;
  }
  return "";
}

/// `number` of the mutations of `right`, always the same: in the sources, a token deleted, exchanged with the next, or
/// replaced by its opposite; one as likely as another.
inline Mutation mutated(const Submission& right, int number) {
  enum Slip { deleted, exchanged, turned };
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
    const Slip slip = Slip(random() % 3);
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at + 1 < tokens.size(); ++at)
      if (slip != turned || !opposite_of(tokens[at].text).empty()) places.push_back(at);
    if (places.empty()) continue;
    const std::size_t at = places[random() % places.size()];
    const Token a = tokens[at], b = tokens[at + 1];
    const std::string before = text.substr(0, a.at), between = text.substr(a.at + a.text.size(), b.at - a.at - a.text.size()), one(a.text), next(b.text);
    std::string change;
    if (slip == deleted) {
      file.text = before + text.substr(a.at + a.text.size());
      change = "'" + one + "' deleted";
    } else if (slip == exchanged) {
      file.text = before + next + between + one + text.substr(b.at + b.text.size());
      change = "'" + one + "' and '" + next + "' exchanged";
    } else {
      file.text = before + opposite_of(one) + text.substr(a.at + a.text.size());
      change = "'" + one + "' -> '" + opposite_of(one) + "'";
    }
    m.what.push_back(file.name + ":" + std::to_string(a.line) + ": " + change);
  }
  m.submission.name = "mutation-" + std::to_string(number);
  m.submission.hash = right.hash + "/" + m.submission.name;
  return m;
}

}  // namespace rigor::grader
