// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/outputs.hpp"

#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {

Outputs::Outputs(const AxisSwitches& switches, const AxisCompare& compare)
    : has_switches_(!switches.table.switches.empty()),
      switches_of_(switches.of),
      switches_(switches.table),
      compare_of_(compare.of) {
  if (compare.plane && has_switches_)
    throw InputError("plane", "",
                     "cannot be combined with cam switches, whose outputs are the same: leave one "
                     "of the two out");
  if (compare.plane) plane_.emplace(*compare.plane);
  if (!compare.list) return;
  if (compare.of == SwitchesOf::master)
    throw InputError("of", "master",
                     "must be position or actual: an axis has no compare of the master");
  compare_.emplace(*compare.list);
}

void Outputs::place(SwitchesOf what) {
  const auto moved = [&](SwitchesOf of) {
    return of == what || (what == SwitchesOf::position && of == SwitchesOf::actual);
  };
  if (moved(switches_of_)) switches_.place();
  if (!moved(compare_of_)) return;
  last_actual_ = std::numeric_limits<double>::quiet_NaN();
  if (compare_) compare_->place();
}

void Outputs::begin() {
  if (compare_) compare_->arm();
  if (plane_) plane_->arm();
}

void Outputs::step(const OutputPlaces& places, double dt) {
  if (has_switches_) {
    const auto [position, velocity] = place_of(switches_of_, places, dt);
    switch_step_ = switches_.step(position, velocity, dt);
  }
  if (plane_) {
    const auto place = [&](std::size_t k) {
      return LivePlaneCompare::Place{places.plane[k].position, places.plane[k].velocity};
    };
    const PlaneStep& now = plane_->step(place(0), place(1), dt);
    switch_step_ = {.outputs = now.outputs, .count = now.count, .lost = now.lost};
    for (std::uint32_t i = 0; i < now.count; ++i)
      switch_step_.edge[i] = {now.edge[i].time, now.edge[i].output, now.edge[i].on};
  }
  if (compare_) {
    const auto [position, velocity] =
        std::isnan(places.way.position) ? place_of(compare_of_, places, dt) : places.way;
    compare_step_ = compare_->step(position, velocity, dt);
  }
  last_actual_ = places.actual.position;
}

OutputPlaces::Place Outputs::place_of(SwitchesOf of, const OutputPlaces& places, double dt) const {
  if (of == SwitchesOf::position) return places.commanded;
  if (of == SwitchesOf::master) return places.master;
  OutputPlaces::Place actual = places.actual;
  if (!std::isfinite(actual.velocity)) actual.velocity = (actual.position - last_actual_) / dt;
  if (!std::isfinite(actual.velocity)) actual.velocity = 0;
  return actual;
}

}  // namespace jounce
