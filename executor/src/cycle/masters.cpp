// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/masters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

/// The filter of a measured master; nullptr: the position is computed.
const TrackerSpec* filter_of(const Master& master) {
  if (const auto* external = dynamic_cast<const ExternalMaster*>(&master)) return &external->spec();
  if (const auto* encoder = dynamic_cast<const EncoderMaster*>(&master)) return &encoder->spec();
  return nullptr;
}

}  // namespace

MasterServer::MasterServer(Options options, ReceiverPump& pump, MachineExchange& exchange,
                           Clock clock)
    : options_(std::move(options)), pump_(pump), exchange_(exchange), clock_(std::move(clock)) {
  for (std::size_t m = 0; m < options_.masters.size(); ++m) {
    One& one = masters_.emplace_back(One{.master = options_.masters[m]});
    for (const Follow& follow : options_.follows)
      one.said_by.push_back(follow.what == Follow::What::master && follow.index == m);
    if (std::find(one.said_by.begin(), one.said_by.end(), true) == one.said_by.end())
      one.said_by.assign(1, true);  // without a follower, the first axis publishes it
    if (auto* external = dynamic_cast<ExternalMaster*>(one.master.source.get()))
      subscribe(one, *external);
  }
}

/// Samples go directly to the cycle, with their time of arrival by its clock.
void MasterServer::subscribe(One& one, ExternalMaster& master) {
  one.intake.emplace(MasterIntakeOptions{.unit = one.master.unit, .keyed = options_.keyed});
  pump_.subscribe(one.master.name, [this, &one, &master](const wire::Master& said) {
    const Nanos now = clock_();
    const std::int64_t start = exchange_.cycle.start.load(std::memory_order_acquire);
    if (!one.intake->take(said, now)) return refused(one, said);
    one.epoch = said.clock;
    if (start == CycleStatus::not_started) return;
    // A sample without space counts as lost: 64 came within a cycle.
    master.receive({.stamp_ns = said.stamp_ns,
                    .clock = said.clock,
                    .received = static_cast<double>(now.count() - start) * 1e-9,
                    .position = said.position,
                    .valid = said.valid});
  });
}

/// A sender that counts its own epochs, after one that took them from the clock, is never accepted
/// again. Reports this, once for each received epoch.
void MasterServer::refused(One& one, const wire::Master& said) {
  const bool over = one.epoch && said.unit == one.master.unit && said.clock < *one.epoch;
  if (!over || one.told_epoch == one.epoch) return;
  one.told_epoch = one.epoch;
  if (options_.notify)
    options_.notify("master " + one.master.name + ": samples rejected: epoch " +
                    std::to_string(said.clock) + " is older than " + std::to_string(*one.epoch) +
                    ", the newest received; give the sender a greater one with --epoch");
}

void MasterServer::turn() {
  for (std::size_t m = 0; m < masters_.size(); ++m)
    if (const auto now = exchange_.masters[m]->read()) compare(masters_[m], *now);
}

/// Reports once that a master moves faster than its filter permits, and again after it has caught up.
void MasterServer::compare_lag(One& one, const MasterReading& now) {
  constexpr double notable = 0.1;  // share of the jump, beyond which a lag is reported
  const TrackerSpec* const filter = filter_of(*one.master.source);
  const double lag = std::abs(now.lag.distance);
  const bool behind = filter != nullptr && lag > notable * filter->jump;
  if (behind && !one.told_lag && options_.notify) {
    const std::string& unit = one.master.unit;
    const auto valued = [&](double number, const char* per) {
      return six_digits(number) + " " + unit + per;
    };
    options_.notify("master " + one.master.name + ": measured velocity " +
                    valued(now.lag.velocity, "/s") +
                    ", limit velocity = " + valued(filter->velocity, "/s") +
                    ", acceleration = " + valued(filter->acceleration, "/s^2") +
                    ": its followers are " + valued(lag, "") + " behind at tick " +
                    std::to_string(now.tick) + "; beyond jump = " + valued(filter->jump, "") +
                    " the master is lost: slow the master down, or raise its limits");
  }
  one.told_lag = behind;
}

void MasterServer::compare(One& one, const MasterReading& now) {
  one.last = now;
  const bool other_unit = one.intake && !one.intake->other_unit().empty();
  if (other_unit && !one.told_unit && options_.notify)
    options_.notify("master " + one.master.name + ": samples rejected, because their unit is " +
                    one.intake->other_unit() + ", not " + one.master.unit);
  one.told_unit |= other_unit;
  compare_lag(one, now);
  const bool there = now.tick >= 0 && !now.lost();
  if (there == one.was_there) return;
  one.was_there = there;
  if (options_.notify)
    options_.notify("master " + one.master.name + (there ? " is present" : " is lost") +
                    " at tick " + std::to_string(now.tick));
}

wire::MasterStatus MasterServer::status(std::size_t master) const {
  const One& one = masters_[master];
  wire::MasterStatus status{.master = one.master.name,
                            .unit = one.master.unit,
                            .tick = std::max<std::int64_t>(one.last.tick, 0),
                            .lost = one.last.lost()};
  if (!status.lost) {
    status.position = one.last.at[0];
    status.velocity = one.last.at[1];
  }
  // A sample may be slightly later than the cycle's instant.
  status.age_s = one.last.age < 0 ? 0 : one.last.age;
  if (one.intake) {
    status.taken = one.intake->taken();
    status.refused = one.intake->refused();
  }
  return status;
}

void MasterServer::publish(std::size_t axis) {
  for (std::size_t m = 0; m < masters_.size(); ++m)
    if (const auto& by = masters_[m].said_by; axis < by.size() && by[axis])
      pump_.publish_master(status(m), axis);
}

}  // namespace jounce
