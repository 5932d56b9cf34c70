// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/queues.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "jounce/profiles/detail/digits_beside.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/row_sender.hpp"

namespace jounce {
namespace {

FifoSpec spec_of(const wire::Queue& queue, const AxisConfig& config) {
  FifoSpec spec{.each = queue.capacity,
                .stream = queue.mode == wire::QueueMode::dynamic,
                .loops = queue.loops};
  // Over a master, the rates of rows are by its position: the axis checks those by time during the
  // motion.
  if (queue.axis == Domain::time) spec.limits = row_limits(config);
  if (!queue.relative) spec.origin = queue.origin;
  spec.range = {queue.lowest, queue.highest};
  if (spec.stream) {  // the passes of tables add up: each is checked when it begins
    spec.limits.position_min = queue.lowest;
    spec.limits.position_max = queue.highest;
  }
  return spec;
}

FollowRun run_of(const wire::Queue& queue) {
  FollowRun run{.dir = queue.direction};
  if (queue.event == wire::QueueEvent::pass)
    run.event = {.event = FollowEvent::pass,
                 .position = queue.event_position,
                 .direction = queue.event_direction};
  return run;
}

template <class Fifo>
void keep(const std::shared_ptr<Fifo>& movement, std::shared_ptr<Movement>& as,
          SegmentFifos*& fifos, std::function<void(int)>& choose) {
  as = movement;
  fifos = &movement->fifos();
  choose = [raw = movement.get()](int bank) { raw->choose(bank); };
}

}  // namespace

wire::Progress on_wire(Progress progress) {
  switch (progress) {
    case Progress::waiting:
      return wire::Progress::waiting;
    case Progress::engaging:
      return wire::Progress::engaging;
    case Progress::running:
      return wire::Progress::running;
    case Progress::starving:
      return wire::Progress::starving;
    case Progress::done:
      return wire::Progress::done;
    case Progress::broken:
      break;
  }
  return wire::Progress::broken;
}

QueueMovement::QueueMovement(const wire::Queue& queue, std::uint64_t id, const AxisConfig& config) {
  const FifoSpec spec = spec_of(queue, config);
  if (queue.axis == Domain::time)
    keep(std::make_shared<FifoPath>(id, spec), movement_, fifos_, choose_);
  else
    keep(std::make_shared<FifoFollow>(id, spec, run_of(queue)), movement_, fifos_, choose_);
}

bool QueueMovement::take(const HandedOver& what) const {
  fifos_->stamp(what.number);
  switch (what.kind) {
    case HandedOver::Kind::rows:
      return std::all_of(what.rows.begin(), what.rows.end(), [&](const SegmentRow& row) {
        return fifos_->push(what.bank, row) == RowRule::none;
      });
    case HandedOver::Kind::queue_switch:
      return fifos_->queue_switch();
    case HandedOver::Kind::clear:
      return fifos_->clear(what.bank);
    case HandedOver::Kind::end:
      return fifos_->complete();
    case HandedOver::Kind::begin:
      break;
  }
  choose_(what.bank);
  return true;
}

bool Queues::open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
                  Receiver& receiver) {
  const wire::Queue& queue = opened.queue;
  try {
    open_.insert_or_assign(queue.queue, Open{.queue = queue,
                                             .made = QueueMovement(queue, id, config),
                                             .limits = spec_of(queue, config).limits});
    return true;
  } catch (const InputError& error) {
    receiver.refuse_queue(queue.queue, wire::Refusal::bad_queue, error.what());
  } catch (const std::bad_alloc&) {
    receiver.refuse_queue(queue.queue, wire::Refusal::out_of_memory, "");
  }
  return false;
}

/// Makes the changes of the FIFOs under the next number available to the axis.
void Queues::hand_over(HandedOver what) {
  what.number = ++number_;
  if (record_) record_(what);
  last_.store(number_, std::memory_order_release);
}

std::string Queues::refusal_of(const Open& open, const SegmentRow& row, RowRule rule) {
  const std::string reason = std::string(name(rule)) + ": " + explain(rule);
  if (open.queue.axis != Domain::time || open.queue.mode != wire::QueueMode::dynamic) return reason;
  const RowPeaks f = peaks(row, open.end, open.rate);
  const RowLimits& most = open.limits;
  const auto has = [&](double value, double limit, int order) {
    const std::string& unit = open.queue.units.position;
    const std::string per = order == 0 ? "" : order == 1 ? "/s" : "/s^" + std::to_string(order);
    const auto with_unit = [&](const std::string& number) {
      return number + (unit.empty() ? "" : " " + unit + per);
    };
    const std::string most_text = six_digits(limit);
    return reason + " It has " + with_unit(digits_beside(value, most_text)) + "; the limit is " +
           with_unit(most_text) + ".";
  };
  switch (rule) {
    case RowRule::velocity:
      return has(f.velocity, most.velocity, 1);
    case RowRule::acceleration:
      return has(f.acceleration, most.acceleration, 2);
    case RowRule::jerk:
      return has(f.jerk, most.jerk, 3);
    case RowRule::velocity_step:
      return has(f.velocity_step, most.velocity_step, 1);
    case RowRule::position:
      return f.position_max > most.position_max ? has(f.position_max, most.position_max, 0)
                                                : has(f.position_min, most.position_min, 0);
    default:
      return reason;
  }
}

void Queues::take(const RowsArrived& arrived, Receiver& receiver) {
  const auto found = open_.find(arrived.rows.queue);
  if (found == open_.end()) return;
  Open& open = found->second;
  const int bank = arrived.rows.bank;
  HandedOver taken{.movement = open.made.movement()->id(), .bank = bank};
  for (std::size_t i = 0; i < arrived.rows.rows.size(); ++i) {
    const SegmentRow row = segment_row(arrived.rows.rows[i]);
    open.made.fifos().stamp(number_ + 1);
    if (const RowRule rule = open.made.fifos().push(bank, row); rule != RowRule::none) {
      receiver.refuse_row(open.queue.queue, arrived.rows.first_row + i,
                          refusal_of(open, row, rule));
      break;
    }
    open.rate = rates(row, open.end, open.rate).end;
    open.end = {row.x_end, row.p_end};
    ++open.pushed[static_cast<std::size_t>(bank)];
    taken.rows.push_back(row);
    if (taken.rows.size() < HandedOver::most_rows) continue;
    hand_over(taken);
    taken.rows.clear();
  }
  if (!taken.rows.empty()) hand_over(std::move(taken));
}

std::shared_ptr<Movement> Queues::movement(std::uint32_t queue) const {
  const Open* const open = find(queue);
  return open == nullptr ? nullptr : open->made.movement();
}

std::optional<double> Queues::origin(std::uint32_t queue) const {
  const Open* const open = find(queue);
  if (open == nullptr || open->queue.relative) return std::nullopt;
  return open->queue.origin;
}

void Queues::begin_with(std::uint32_t queue, int bank) {
  (void)act(queue, HandedOver::Kind::begin, bank);
}

void Queues::handed_back(std::uint64_t movement) const {
  for (const auto& [index, open] : open_)
    if (open.made.movement()->id() == movement) open.made.fifos().leave();
}

void Queues::report(const Tick& last, Receiver& receiver) const {
  for (const auto& [index, open] : open_) {
    QueueLevel level{.played = static_cast<std::int64_t>(open.made.fifos().rows_played())};
    for (const int bank : {0, 1}) {
      const auto b = static_cast<std::size_t>(bank);
      level.freed[b] = open.pushed[b] - std::min(open.pushed[b], held(open, bank));
    }
    level.progress = progress(open, last);
    receiver.level(index, level);
  }
}

bool Queues::act(std::uint32_t queue, HandedOver::Kind kind, int bank) {
  const Open* const open = find(queue);
  if (open == nullptr) return false;
  HandedOver what{
      .movement = open->made.movement()->id(), .number = number_ + 1, .kind = kind, .bank = bank};
  if (!open->made.take(what)) return false;
  hand_over(std::move(what));
  return true;
}

bool Queues::queue_switch(std::uint32_t queue) {
  return act(queue, HandedOver::Kind::queue_switch, 0);
}

bool Queues::clear(std::uint32_t queue, int bank) {
  return act(queue, HandedOver::Kind::clear, bank);
}

bool Queues::end(std::uint32_t queue) {
  return act(queue, HandedOver::Kind::end, 0);
}

std::array<std::uint32_t, 2> Queues::fill(std::uint64_t movement) const {
  for (const auto& [index, open] : open_)
    if (open.made.movement()->id() == movement) {
      const std::size_t waiting = open.made.fifos().size(0) + open.made.fifos().size(1);
      return {static_cast<std::uint32_t>(waiting), 2 * open.queue.capacity};
    }
  return {};
}

const Queues::Open* Queues::find(std::uint32_t queue) const {
  const auto found = open_.find(queue);
  return found == open_.end() ? nullptr : &found->second;
}

/// The state of the FIFOs shows the end: the axis then no longer plays it.
wire::Progress Queues::progress(const Open& open, const Tick& last) {
  switch (open.made.fifos().state()) {
    case SegmentFifos::State::idle:
    case SegmentFifos::State::taken:
      return wire::Progress::waiting;
    case SegmentFifos::State::ended:
      return wire::Progress::done;
    case SegmentFifos::State::cut_off:
      if (open.queue.axis == Domain::master && !open.made.fifos().stream())
        return wire::Progress::done;  // at a ratio: the axis brakes
      return wire::Progress::broken;
    case SegmentFifos::State::left:
    case SegmentFifos::State::lost:
      return wire::Progress::broken;
    case SegmentFifos::State::moving:
      break;
  }
  return last.job == open.made.movement()->id() ? on_wire(last.progress) : wire::Progress::running;
}

/// Rows of a bank that still occupy space: a stream frees it in blocks of a FIFO.
std::uint64_t Queues::held(const Open& open, int bank) {
  if (open.queue.mode == wire::QueueMode::static_) return open.made.fifos().size(bank);
  return bank == 0 ? wire::room(open.queue) - open.made.fifos().space(0) : 0;
}

}  // namespace jounce
