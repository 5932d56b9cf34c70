// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "jounce/design/key_figures.hpp"

namespace jounce::detail {

/// The limits of a spec as constraints of a search, in the same order for every design. A limit of a
/// curve has one for each of its bounds and segments: the smallest of their margins has kinks, in which
/// a solver that follows slopes stops short of the optimum.
class TuneRows {
 public:
  /// Each <= 0 where `check` finds its limit kept. The first design settles which there are; the last
  /// stands for rules that only later designs have.
  std::vector<double> of(const Assessment& at);

  /// The rule behind each; "" behind the last.
  [[nodiscard]] const std::vector<std::string>& rules() const { return rules_; }

 private:
  /// Neighbouring constraints of one rule: one bound's segments, or the rule as a whole.
  struct Group {
    std::string rule;
    std::size_t bound = 0;  ///< its index in the rule's rooms
    std::size_t places = 1;
    bool by_segment = false;
  };
  void settle(const Assessment& at);

  std::vector<Group> groups_;
  std::vector<std::string> rules_;
};

}  // namespace jounce::detail
