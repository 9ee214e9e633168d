#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <rigor/base/file.hpp>
#include <string>
#include <vector>

namespace rigor {

/// What the oracles said of one variant: oracle -> cases it flagged. An oracle that does not apply is absent.
using Verdict = std::map<std::string, int>;

/// A section of docs/oracles.md: one row a variant, one column an oracle; "." is 0 flagged, "-" does not apply.
inline std::string matrix(const std::string& title, const std::vector<std::string>& oracles,
                          const std::vector<std::pair<std::string, Verdict>>& rows) {
  std::string text = "## " + title + "\n\n| variant |", rule = "|---|";
  for (const std::string& oracle : oracles) text += " " + oracle + " |", rule += "---:|";
  text += " seen by this one alone |\n" + rule + "---|\n";
  for (const auto& [name, verdict] : rows) {
    text += "| " + name + " |";
    std::string alone;
    int flagging = 0;
    for (const std::string& oracle : oracles) {
      const auto found = verdict.find(oracle);
      const bool flags = found != verdict.end() && found->second > 0;
      text += found == verdict.end() ? " - |" : flags ? " " + std::to_string(found->second) + " |" : " . |";
      if (flags) alone = oracle, ++flagging;
    }
    text += " " + (flagging == 1 ? alone : "") + " |\n";
  }
  return text;
}

/// The section with this heading, up to the next one; empty if there is none.
inline std::string section_of(const std::string& page, const std::string& section) {
  const std::string heading = section.substr(0, section.find('\n') + 1);
  const std::size_t begin = page.find(heading);
  if (begin == std::string::npos) return "";
  const std::size_t next = page.find("\n## ", begin);
  return page.substr(begin, next == std::string::npos ? next : next - begin);
}

/// The page shows this section; with RIGOR_WRITE set, it is written there first.
inline void expect_in_docs(const std::string& section) {
  const std::string path = std::string(RIGOR_SOURCE_DIR) + "/docs/oracles.md";
  std::string page = *read_file(path);
  if (std::getenv("RIGOR_WRITE")) {
    const std::string old = section_of(page, section);
    if (old.empty()) page += "\n" + section;
    else page.replace(page.find(old), old.size(), section);
    EXPECT_TRUE(write_file(path, page));
  }
  EXPECT_EQ(section_of(page, section), section) << "docs/oracles.md is out of date: RIGOR_WRITE=1 test_mutants writes it";
}

inline bool killed(const Verdict& verdict) {
  for (const auto& [oracle, flagged] : verdict)
    if (flagged > 0) return true;
  return false;
}

}  // namespace rigor
