// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/cycle.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <ctime>
#include <utility>

#include "jounce/executor/detail/recorder.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::int64_t second = 1'000'000'000;

void hand_over(const AxisImage& image, AxisExchange& axis) {
  if (!axis.ticks.push(image.tick))
    axis.lost.store(axis.lost.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (image.command.id == 0 && !image.tick.handed_back.front()) return;
  [[maybe_unused]] const bool posted =
      axis.answers.push({image.command.id, image.tick.refused, image.tick.handed_back});
  assert(posted);
}

}  // namespace

std::int64_t MonotonicPacer::now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * second + t.tv_nsec;
}

void MonotonicPacer::sleep_until(std::int64_t instant) {
  const timespec t{instant / second, instant % second};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

Cycle::Cycle(Machine& machine, Pacer& pacer, MachineExchange& exchange, CycleOptions options)
    : machine_(machine),
      pacer_(pacer),
      exchange_(exchange),
      options_(std::move(options)),
      images_(machine.size()),
      sights_(machine.masters()),
      masters_(machine.masters()),
      start_(pacer.now()) {
  require_size("exchange.axes", exchange.axes.size(), machine.size());
  require_size("exchange.masters", exchange.masters.size(), machine.masters());
  require_size("options.masters", options_.masters.size(), machine.masters());
  exchange.cycle.start.store(start_, std::memory_order_release);
  options_.drives.resize(machine.size());
}

void Cycle::once() {
  const std::int64_t period = machine_.period();
  const std::int64_t due = start_ + next_ * period;
  pacer_.sleep_until(due);
  const std::int64_t woken = pacer_.now();
  const std::int64_t missed = std::max<std::int64_t>((woken - due) / period, 0);
  const std::int64_t tick = next_ + missed;
  read(tick);
  look(tick);
  machine_.step(tick, images_, masters_);
  write();
  account(woken - due, missed, woken);
  next_ = tick + 1;
}

void Cycle::read(std::int64_t tick) {
  const bool watchdog = silent();
  for (std::size_t i = 0; i < images_.size(); ++i) {
    AxisImage& image = images_[i];
    if (!exchange_.axes[i]->commands.pop(image.command)) image.command = {};
    image.inputs.watchdog = watchdog;
    image.inputs.rows = exchange_.axes[i]->rows.load(std::memory_order_acquire);
    if (AxisDrive* const drive = options_.drives[i]) {
      drive->begin(tick);
      image.inputs.feedback = drive->feedback();
    }
  }
}

/// After the drives were read: some masters are encoders on them.
void Cycle::look(std::int64_t tick) {
  const double time = static_cast<double>(tick * machine_.period()) * 1e-9;
  for (std::size_t m = 0; m < sights_.size(); ++m) {
    Master& master = *options_.masters[m];
    masters_[m] = master.at(time);
    sights_[m] = {.tick = tick, .at = masters_[m], .age = master.age(time), .lag = master.lag()};
    exchange_.masters[m]->write(sights_[m]);
  }
}

void Cycle::write() {
  for (std::size_t m = 0; m < sights_.size() && options_.record != nullptr; ++m) {
    for (const MasterSample& sample : options_.masters[m]->taken()) options_.record->add(m, sample);
    options_.record->add(m, sights_[m]);
  }
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const AxisImage& image = images_[i];
    if (AxisDrive* const drive = options_.drives[i]) {
      DriveSetpoint next = drive_setpoint(image.tick, image.command);
      next.master = image.inputs.master[0] - image.inputs.master_offset;
      drive->command(next);
    }
    if (options_.record != nullptr)
      options_.record->add(i, image.command, image.inputs, image.tick);
    hand_over(image, *exchange_.axes[i]);
  }
}

bool Cycle::silent() {
  if (options_.patience == 0) return false;
  const std::uint64_t alive = exchange_.cycle.alive.load(std::memory_order_relaxed);
  since_alive_ = alive == alive_ ? since_alive_ + 1 : 0;
  alive_ = alive;
  return since_alive_ > options_.patience;
}

void Cycle::account(std::int64_t delay, std::int64_t missed, std::int64_t woken) {
  const std::int64_t computed = pacer_.now() - woken;
  ++counts_.ticks;
  counts_.late += missed > 0;
  counts_.skipped += missed;
  counts_.latest_ns = std::max(counts_.latest_ns, delay);
  counts_.computed_ns = std::max(counts_.computed_ns, computed);
  CycleStatus& status = exchange_.cycle;
  status.late.store(counts_.late, std::memory_order_relaxed);
  status.lateness.add(delay);
  status.computing.add(computed);
  counts_.lost = 0;
  for (const auto& axis : exchange_.axes)
    counts_.lost += axis->lost.load(std::memory_order_relaxed);
}

}  // namespace jounce
