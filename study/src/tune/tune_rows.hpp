// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "jounce/design/key_figures.hpp"

namespace jounce::study_detail {

/// The limits of a spec as constraints of a search, in the same order for every design. A limit of
/// a curve becomes one constraint for each of its bounds and segments. A single one, the smallest
/// margin of all, would have kinks, at which a solver that uses slopes stops before the optimum.
class TuneRows {
 public:
  /// Returns the constraints of a design; each is <= 0 if `check` reports that the limit holds. The
  /// first design determines the list. The last constraint represents rules that only later designs
  /// have.
  std::vector<double> of(const Assessment& at);

  /// The rule of each constraint; "" for the last one.
  [[nodiscard]] const std::vector<std::string>& rules() const { return rules_; }

 private:
  /// Consecutive constraints of one rule: the segments of one bound, or the rule as a whole.
  struct Group {
    std::string rule;
    std::size_t bound = 0;  ///< index among the margins of the rule
    std::size_t places = 1;
    bool by_segment = false;
  };
  void settle(const Assessment& at);

  std::vector<Group> groups_;
  std::vector<std::string> rules_;
};

}  // namespace jounce::study_detail
