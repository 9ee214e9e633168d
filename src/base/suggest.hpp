#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor {

/// Edits (insert, delete, replace, exchange two neighbours) from a to b, no place edited twice.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j - 1] + (a[i - 1] != b[j - 1]), above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// " (did you mean 'x'?)" for the nearest known word, or "" when none is near (more than a third of it
/// differs).
inline std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string* best = nullptr;
  std::size_t least = 0;
  for (const std::string& k : known) {
    const std::size_t d = edit_distance(word.substr(0, 100), k);
    if (best == nullptr || d < least) best = &k, least = d;
  }
  if (best == nullptr || least > std::max<std::size_t>(1, best->size() / 3)) return "";
  return " (did you mean '" + *best + "'?)";
}

}  // namespace rigor
