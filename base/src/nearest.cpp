// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace jounce {
namespace {

/// Levenshtein distance, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t replace = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, replace});
    }
  }
  return row.back();
}

/// Letters of another case do not count.
std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return all;
}

/// The only candidate that begins with the word, or "".
std::string begun_by(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t telling = 3;  // letters that make it likely
  if (word.size() < telling) return "";
  const auto begins = [&](const std::string& one) { return lower(one).starts_with(word); };
  const auto found = std::find_if(candidates.begin(), candidates.end(), begins);
  if (found == candidates.end() || std::count_if(found, candidates.end(), begins) > 1) return "";
  return *found;
}

}  // namespace

std::string nearest(std::string_view given, std::span<const std::string> candidates) {
  const std::string word = lower(given);
  if (const std::string begun = begun_by(word, candidates); !begun.empty()) return begun;
  std::string best;
  std::size_t least = 3;
  for (const auto& one : candidates) {
    const std::string candidate = lower(one);
    const std::size_t d = distance(word, candidate);
    // If the first letter and another one differ, the word must lack a letter: "fase" means "phase", but
    // "deceleration" does not mean "acceleration".
    const bool other =
        d > 1 && !word.empty() && word[0] != candidate[0] && candidate.size() <= word.size();
    // Two letters of a short word must be exchanged: "jrek" means "jerk", but "spec" does not mean "sync".
    constexpr std::size_t few = 4;
    const bool changed =
        d > 1 && candidate.size() <= few &&
        !std::is_permutation(word.begin(), word.end(), candidate.begin(), candidate.end());
    if (d < least && d < candidate.size() && !other && !changed) {
      least = d;
      best = one;
    }
  }
  return best;
}

}  // namespace jounce
