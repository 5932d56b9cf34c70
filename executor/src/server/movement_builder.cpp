// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/movement_builder.hpp"

#include <utility>

namespace jounce {

std::optional<MovementBuilder::Built> MovementBuilder::build(const ArmRequested& arm,
                                                             std::uint64_t id, std::int64_t period,
                                                             double position, bool single_step) {
  const std::size_t knots =
      arm.slave.table->size() + (arm.master ? arm.master->table->size() : std::size_t{0});
  const auto canceled = std::make_shared<std::atomic<bool>>(false);
  auto now = [arm, id, period, position, single_step, group = group_, canceled] {
    return group ? movement_of(arm, id, *group, single_step, *canceled)
                 : movement_of(arm, id, period, position);
  };
  if (knots <= most_knots_) return Built{arm, now()};
  building_.emplace(Building{arm, worker_.ask(std::move(now)), canceled});
  return std::nullopt;
}

std::optional<MovementBuilder::Done> MovementBuilder::take() {
  using namespace std::chrono_literals;
  if (!building_ || building_->made.wait_for(0s) != std::future_status::ready) return std::nullopt;
  Building ended = std::move(*building_);
  building_.reset();
  Done done{.built = Built{std::move(ended.arm), ended.made.get()},
            .next = std::exchange(next_, std::nullopt)};
  if (*ended.canceled) done.built.reset();
  return done;
}

void MovementBuilder::cancel() {
  next_.reset();
  if (building_) *building_->canceled = true;
}

}  // namespace jounce
