// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/stretch.hpp"

namespace jounce::design_detail {

std::string impossibility(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                          const std::string& who) {
  const double k = static_cast<double>(order);
  const double needed = least_peaks[order] * std::abs(s.stroke) / std::pow(s.length, k);
  const double limit = std::abs(f.limit);
  if (!s.rests || needed <= limit) return "";
  const std::string why =
      order == 1
          ? fmt::format("its mean {} is {}", f.quantity, words.of(needed, 1))
          : fmt::format("any law reaches a {} of at least {}", f.quantity, words.of(needed, order));
  return fmt::format("{} moves {} in {}: {}, above the limit {}. ", who,
                     words.of(std::abs(s.stroke), 0), words.x(s.length), why,
                     words.of(limit, order));
}

}  // namespace jounce::design_detail
