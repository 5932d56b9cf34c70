// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/limits/limit_margins.hpp"

#include "jounce/profiles/detail/limit_check.hpp"

namespace jounce {

template <class Over>
std::vector<LimitMargin> limit_margins(const Curve<Over>& f, const Limits& limits) {
  require_valid(limits);
  const Range travel = profiles_detail::LimitCheck::needs_stroke(limits) ? extrema(f, 0) : Range{};
  const profiles_detail::LimitCheck check(limits, Over::names, travel.max.value - travel.min.value);
  std::vector<LimitMargin> margins;
  for (const profiles_detail::Bound& bound : check.bounds()) {
    LimitMargin& margin = margins.emplace_back(LimitMargin{bound.rule.text(), {}});
    for (std::size_t i = 0; i < f.segments().size(); ++i)
      margin.segments.push_back(
          profiles_detail::room_of(bound, segment_range(f, i, static_cast<int>(bound.order))));
  }
  return margins;
}

template std::vector<LimitMargin> limit_margins(const Curve<OverTime>&, const Limits&);
template std::vector<LimitMargin> limit_margins(const Curve<OverMaster>&, const Limits&);

}  // namespace jounce
