// SPDX-License-Identifier: Apache-2.0
#include "executor/src/record/remade_masters.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::executor_detail {
namespace {

/// Equal to the last bit; a lost master (NaN) has many bit patterns.
bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::optional<TickDifference> difference(const MasterReading& was, const MasterReading& now) {
  constexpr std::array fields{"master_position", "master_velocity", "master_acceleration",
                              "master_jerk"};
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (!same(was.at[k], now.at[k])) return TickDifference{fields[k], was.at[k], now.at[k]};
  if (!same(was.age, now.age)) return TickDifference{"master_age", was.age, now.age};
  return std::nullopt;
}

}  // namespace

void RemadeMasters::add(const RecordedMaster& master) {
  One& one = masters_.emplace_back();
  if (master.made == RecordedMaster::Made::elsewhere) return;
  require_valid(master.tracker);
  if (master.made == RecordedMaster::Made::samples)
    one.heard = std::make_unique<ExternalMaster>(master.tracker);
  else
    one.read = std::make_unique<EncoderMaster>(master.tracker);
}

void RemadeMasters::take(const RecordedSample& sample) {
  if (sample.master >= masters_.size())
    throw InputError("master", std::to_string(sample.master + 1),
                     "is missing from the start of the record");
  constexpr std::int64_t latest = std::int64_t{1} << 62U;  // their differences stay in range
  if (sample.sample.stamp_ns < 0 || sample.sample.stamp_ns > latest)
    throw InputError("stamp_ns", std::to_string(sample.sample.stamp_ns), "must be from 0 to 2^62");
  One& one = masters_[sample.master];
  if (one.read) one.read->read(sample.sample.received, sample.sample.position);
  if (one.heard && !one.heard->receive(sample.sample))
    throw InputError("sample", std::to_string(sample.master + 1),
                     "exceeds the samples that a cycle can take");
}

std::optional<TickDifference> RemadeMasters::compare(const RecordedSight& seen, double time) {
  One& one = masters_[seen.master];
  Master* const master = one.heard ? static_cast<Master*>(one.heard.get()) : one.read.get();
  if (master == nullptr) return std::nullopt;
  MasterReading now{.tick = seen.sight.tick, .at = master->at(time)};
  now.age = master->age(time);
  return difference(seen.sight, now);
}

}  // namespace jounce::executor_detail
