// SPDX-License-Identifier: Apache-2.0
#include <sstream>
#include <vector>

#include "jounce/base/detail/lcm_log.hpp"
#include "jounce/executor/detail/replay.hpp"
#include "jounce/profiles/error.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {
namespace {

void read(const std::string& bytes) {
  try {
    std::istringstream in(bytes);
    std::int64_t seen = 0;
    const Replay result = replay(in, "fuzz", [&](const RecordedCycle&) { ++seen; });
    require(seen == result.cycles && result.compared <= seen, "every cycle is shown");
    require(!result.same() || result.compared == seen, "the same means all of it");
  } catch (const InputError& error) {
    require(*error.what() != '\0', "an error has words");
  }
}

/// One event of each kind: an axis that plays a table, with a queue, a gear, a master and a compare output.
const std::vector<RecordEvent>& good() {
  static const std::vector<RecordEvent> events = [] {
    AxisConfig config;
    config.limits.velocity = 1000;
    config.limits.acceleration = 1e5;
    const Units units{"s", "mm"};
    const Table table(Domain::time, Interpolation::linear, Extrapolation::hold,
                      {{0, 1}, {0, 1}, {}, {}});
    const Sha256 hash = content_hash(table, units);
    RecordedCycle arm{.command = {.what = command::Arm{}, .id = 2}, .movement = 1};
    RecordedCycle enable{.command = {.what = command::Enable{}, .id = 1}};
    HandedOver rows{.movement = 2, .number = 1};
    rows.rows.push_back({.x_end = 1, .p_end = 1, .degree = 1, .last = true});
    return std::vector<RecordEvent>{
        RecordedAxis{.name = "feeder", .units = units, .config = resolved(config)},
        RecordedTable{.hash = hash, .units = units, .knots = 2, .columns = table.columns()},
        RecordedJob{.id = 1, .time = hash},
        RecordedQueue{.id = 2, .queue = {.capacity = 8}},
        RecordedRows{.what = rows},
        RecordedGear{.id = 3, .gear = command::GearIn{1, 1}},
        enable,
        arm,
        RecordedCycle{.command = {.what = command::Start{}, .id = 3}},
        RecordedLoss{.cycles = 1},
        RecordedMaster{.name = "line",
                       .unit = "mm",
                       .followers = 1,
                       .made = RecordedMaster::Made::samples,
                       .tracker = {.velocity = 1, .acceleration = 1}},
        RecordedSample{.sample = {.stamp_ns = 1'000'000, .received = 0.001, .position = 1}},
        RecordedSight{.sight = {.tick = 1, .at = {1, 0, 0, 0}, .age = 0.001}},
        RecordedOutput{
            .part = RecordedOutput::Part::compare, .points = 1, .some = {{.position = 0.5}}},
        RecordedCheck{},
    };
  }();
  return events;
}

/// Events that pass the log's own format: with changed bytes in their fields, in any order after
/// the axis; their ticks rise.
std::string events(Source& source) {
  std::string bytes;
  std::int64_t tick = 0;
  for (int i = 0; i < 60 && !source.empty(); ++i) {
    RecordEvent event = good()[i == 0 ? source.below(2) : source.below(good().size())];
    if (auto* const cycle = std::get_if<RecordedCycle>(&event)) cycle->tick.tick = tick++;
    std::string data = encoded(event);
    constexpr std::size_t hash = 8;  // hash of the type, at its head
    for (std::size_t changes = source.below(6); changes > 0; --changes) {
      const std::size_t at = source.byte() * std::size_t{256} + source.byte();
      data[hash + at % (data.size() - hash)] = static_cast<char>(source.byte());
    }
    base_detail::append(bytes, i, 0, channel_of(event), data);
  }
  return bytes;
}

}  // namespace

void log(Input input) {
  read(text_of(input));
  Source source(input);
  read(events(source));
}

}  // namespace jounce::fuzz
