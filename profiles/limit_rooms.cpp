#include "jounce/profiles/limit_rooms.hpp"

#include "jounce/profiles/detail/limit_check.hpp"

namespace jounce {

template <class Over>
std::vector<LimitRoom> limit_rooms(const Curve<Over>& f, const Limits& limits) {
  require_valid(limits);
  const Range travel = detail::LimitCheck::needs_stroke(limits) ? extrema(f, 0) : Range{};
  const detail::LimitCheck check(limits, Over::names, travel.max.value - travel.min.value);
  std::vector<LimitRoom> rooms;
  for (const detail::Bound& bound : check.bounds()) {
    LimitRoom& room = rooms.emplace_back(LimitRoom{bound.rule, {}});
    for (std::size_t i = 0; i < f.segments().size(); ++i)
      room.segments.push_back(
          detail::room_of(bound, segment_range(f, i, static_cast<int>(bound.order))));
  }
  return rooms;
}

template std::vector<LimitRoom> limit_rooms(const Curve<OverTime>&, const Limits&);
template std::vector<LimitRoom> limit_rooms(const Curve<OverMaster>&, const Limits&);

}  // namespace jounce
