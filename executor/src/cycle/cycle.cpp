// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/cycle.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <ctime>
#include <utility>

#include "jounce/executor/recorder.hpp"

namespace jounce {
namespace {

constexpr std::int64_t second = 1'000'000'000;

void post(const AxisImage& image, Mail& mail) {
  if (!mail.ticks.push(image.tick))
    mail.lost.store(mail.lost.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (image.command.id == 0 && !image.tick.handed_back.front()) return;
  [[maybe_unused]] const bool posted =
      mail.answers.push({image.command.id, image.tick.refused, image.tick.handed_back});
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

Cycle::Cycle(Machine& machine, Pacer& pacer, Post& post, CycleOptions options)
    : machine_(machine),
      pacer_(pacer),
      post_(post),
      options_(std::move(options)),
      images_(machine.size()),
      sights_(machine.masters()),
      masters_(machine.masters()),
      start_(pacer.now()) {
  assert(post.mail.size() == machine.size() && post.masters.size() == machine.masters());
  assert(options_.masters.size() == machine.masters());
  post.vitals.start.store(start_, std::memory_order_release);
  options_.drives.resize(machine.size());
}

void Cycle::once() {
  const std::int64_t period = machine_.period();
  const std::int64_t due = start_ + next_ * period;
  pacer_.sleep_until(due);
  const std::int64_t woken = pacer_.now();
  const std::int64_t missed = std::max<std::int64_t>((woken - due) / period, 0);
  const std::int64_t tick = next_ + missed;
  read();
  look(tick);
  machine_.step(tick, images_, masters_);
  write();
  account(woken - due, missed, woken);
  next_ = tick + 1;
}

void Cycle::read() {
  const bool watchdog = silent();
  for (std::size_t i = 0; i < images_.size(); ++i) {
    AxisImage& image = images_[i];
    if (!post_.mail[i]->commands.pop(image.command)) image.command = {};
    image.inputs.watchdog = watchdog;
    image.inputs.rows = post_.mail[i]->rows.load(std::memory_order_acquire);
    if (AxisDrive* const drive = options_.drives[i]) image.inputs.feedback = drive->feedback();
  }
}

/// After the drives were read: some masters are encoders on them.
void Cycle::look(std::int64_t tick) {
  const double time = static_cast<double>(tick * machine_.period()) * 1e-9;
  for (std::size_t m = 0; m < sights_.size(); ++m) {
    Master& master = *options_.masters[m];
    masters_[m] = master.at(time);
    sights_[m] = {.tick = tick, .at = masters_[m], .age = master.age(time)};
    post_.masters[m]->write(sights_[m]);
  }
}

void Cycle::write() {
  for (std::size_t m = 0; m < sights_.size() && options_.tape != nullptr; ++m) {
    for (const MasterSample& sample : options_.masters[m]->taken()) options_.tape->add(m, sample);
    options_.tape->add(m, sights_[m]);
  }
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const AxisImage& image = images_[i];
    if (AxisDrive* const drive = options_.drives[i])
      drive->command(drive_setpoint(image.tick, image.command));
    if (options_.tape != nullptr) options_.tape->add(i, image.command, image.inputs, image.tick);
    post(image, *post_.mail[i]);
  }
}

bool Cycle::silent() {
  if (options_.patience == 0) return false;
  const std::uint64_t alive = post_.vitals.alive.load(std::memory_order_relaxed);
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
  Vitals& vitals = post_.vitals;
  vitals.late.store(counts_.late, std::memory_order_relaxed);
  vitals.lateness.add(delay);
  vitals.computing.add(computed);
  counts_.lost = 0;
  for (const auto& mail : post_.mail) counts_.lost += mail->lost.load(std::memory_order_relaxed);
}

}  // namespace jounce
