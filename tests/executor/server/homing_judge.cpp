// SPDX-License-Identifier: Apache-2.0
#include "executor/server/homing_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce::test {
namespace {

constexpr std::string_view homing = "homing";

/// Methods 35 and 37 name the place where the axis stands.
bool names(const Accepted& order) {
  return order.method == 35 || order.method == 37;
}

bool stands(const Line& now, const Line& before) {
  return now.v == 0 && before.v == 0;
}

/// docs/executor/homing.md: which edge methods 17 to 30 find, and in which direction they pass it.
enum class Edge { negative, positive, lower, upper };
struct Found {
  Edge edge;
  int direction;
};
constexpr Found found[] = {
    {Edge::negative, 1}, {Edge::positive, -1}, {Edge::lower, -1}, {Edge::lower, 1},
    {Edge::upper, 1},    {Edge::upper, -1},    {Edge::lower, -1}, {Edge::lower, 1},
    {Edge::upper, -1},   {Edge::upper, 1},     {Edge::upper, 1},  {Edge::upper, -1},
    {Edge::lower, 1},    {Edge::lower, -1},
};

double edge_of(Edge edge, const MachineBounds& machine) {
  switch (edge) {
    case Edge::negative:
      return machine.negative;
    case Edge::positive:
      return machine.positive;
    case Edge::lower:
      return machine.home_low;
    case Edge::upper:
      return machine.home_high;
  }
  return NAN;
}

double index_from(double edge, int direction, const MachineBounds& machine) {
  const double turns = (edge - machine.index_offset) / machine.index_period;
  const double n = direction > 0 ? std::ceil(turns - 1e-12) : std::floor(turns + 1e-12);
  return machine.index_offset + n * machine.index_period;
}

}  // namespace

void HomingJudge::take(const Line& now, const std::optional<Line>& before, bool placed,
                       const Find& find) {
  named_ = false;
  if (!before) machine_ = bounds_.machine ? bounds_.machine->start : 0;
  if (now.state != homing && (!before || before->state != homing)) searches_.clear();
  if (now.state == homing) {
    if (searches_.empty()) since_ = now.tick;
    if (searches_.empty()) begun_ = machine_;
    searches_.insert(searches_.end(), offered_.begin(), offered_.end());
  }
  offered_.clear();
  if (before) {
    const bool searched = before->state == homing && now.state != homing;
    named_ = searched && now.homed && !before->homed;
    const bool renamed = stands(now, *before) && (placed || named_);
    // Differences of neighbours are exact; a number that the position gets is rounded.
    if (renamed)
      rounded_ += std::numeric_limits<double>::epsilon() * (std::abs(now.p) + std::abs(before->p));
    else
      machine_ += now.p - before->p;
    if (now.state == homing) search(now, *before, find);
    if (named_) end(now, find);
    if (now.homed && !before->homed && now.state != homing && !searched)
      find("homed without a homing", 1, 0);
    if (bounds_.machine) limit(now, *before, find);
    const bool moves = now.v != 0 || (!renamed && now.p != before->p);
    unranged_ = now.state == homing || (unranged_ && moves);
  }
}

void HomingJudge::search(const Line& now, const Line& before, const Find& find) {
  double fastest = 0, acceleration = 0, timeout = 0;
  for (const Accepted* order : searches_) {
    fastest = std::max(fastest, order->fastest);
    acceleration = std::max(acceleration, order->acceleration);
    timeout = std::max(timeout, order->timeout);
  }
  if (searches_.empty()) return find("a homing without an order", now.v, 0);
  const double rounding = 1e-6;
  if (std::abs(now.v) > fastest * (1 + 1e-9) + rounding)
    find("velocity of a homing", now.v, fastest);
  if (std::abs(now.a) > acceleration * (1 + 1e-9) + rounding)
    find("acceleration of a homing", now.a, acceleration);
  const auto late = static_cast<double>(now.tick - before.tick);
  const double lasts = static_cast<double>(now.tick - since_) * bounds_.period;
  if (lasts > timeout + (late + 3) * bounds_.period)
    find("a homing after its timeout", lasts, timeout);
  if (now.homed &&
      !std::any_of(searches_.begin(), searches_.end(), [](const Accepted* o) { return names(*o); }))
    find("homed during a search", 1, 0);
}

/// The home position has the number that was ordered, and is where the method finds it.
void HomingJudge::end(const Line& now, const Find& find) const {
  if (!bounds_.machine) return;
  const double rounding = rounded_ + 1e-9 * std::max({1.0, std::abs(now.p), std::abs(machine_)});
  double nearest = HUGE_VAL, at = NAN;
  for (const Accepted* order : searches_) {
    if (names(*order)) return;
    at = machine_ - (now.p - order->home);
    for (const double home : homes_of(order->method, rounding))
      if (std::abs(at - home) < std::abs(nearest)) nearest = at - home;
  }
  if (!(std::abs(nearest) <= bounds_.machine->tolerance + rounding))
    find("a home position that is not that of its method", at, at - nearest);
}

std::vector<double> HomingJudge::homes_of(int method, double rounding) const {
  const MachineBounds& machine = *bounds_.machine;
  // An axis that begins on an index, to rounding, may pass it or not.
  if (method == 33 || method == 34) {
    const int way = method == 33 ? -1 : 1;
    return {index_from(begun_ - way * rounding, way, machine),
            index_from(begun_ + way * rounding, way, machine)};
  }
  const bool with_index = method >= 1 && method <= 14;
  if (!with_index && (method < 17 || method > 30)) return {};
  const auto [edge, direction] = found[static_cast<std::size_t>(method - (with_index ? 1 : 17))];
  const double place = edge_of(edge, machine);
  if (!std::isfinite(place)) return {};
  return {with_index ? index_from(place, direction, machine) : place};
}

void HomingJudge::limit(const Line& now, const Line& before, const Find& find) {
  const MachineBounds& machine = *bounds_.machine;
  const bool beyond =
      (machine_ > machine.positive && now.v > 0) || (machine_ < machine.negative && now.v < 0);
  if (!beyond) return outward_.reset();
  double acceleration = bounds_.gentlest_brake();
  for (const Accepted* order : searches_)
    acceleration = std::min(acceleration, order->acceleration);
  double time = time_to_rest(now.v, now.a, acceleration, bounds_.jerk.value_or(HUGE_VAL));
  if (now.path || before.path) time = std::max(time, bounds_.path_stop_time);
  const std::int64_t late = now.tick - before.tick - 1;
  // The drive reports the switch in the next cycle, and until then the axis speeds up.
  constexpr std::int64_t reaction = 10;
  if (!outward_)
    outward_ =
        now.tick + static_cast<std::int64_t>(std::ceil(time / bounds_.period)) + late + reaction;
  if (now.tick <= *outward_) return;
  find("moves outwards beyond a limit switch", machine_,
       now.v > 0 ? machine.positive : machine.negative);
  outward_ = now.tick + 1'000'000;
}

}  // namespace jounce::test
