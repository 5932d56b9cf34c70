#include "jounce/executor/queues.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

int degree(wire::RowOrder order) {
  switch (order) {
    case wire::RowOrder::linear:
      return 1;
    case wire::RowOrder::quadratic:
      return 2;
    case wire::RowOrder::cubic:
      return 3;
    case wire::RowOrder::quintic:
      break;
  }
  return 5;
}

SegmentRow row_of(const wire::Row& row) {
  return {.x_end = row.x_end,
          .p_end = row.p_end,
          .v_start = row.v_start,
          .v_end = row.v_end,
          .a_start = row.a_start,
          .a_end = row.a_end,
          .degree = degree(row.order),
          .last = row.last};
}

FifoSpec spec_of(const wire::Queue& queue, const AxisConfig& config) {
  FifoSpec spec{.each = queue.capacity,
                .stream = queue.mode == wire::QueueMode::dynamic,
                .loops = queue.loops};
  // Over a master the rates are by its position: what they are by time is seen when they are played.
  if (queue.axis == Axis::time) spec.limits = row_limits(config);
  return spec;
}

FollowRun run_of(const wire::Queue& queue) {
  FollowRun run;
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

void Queues::open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
                  Receiver& receiver) {
  const wire::Queue& queue = opened.queue;
  Open open{.queue = queue, .movement = {}, .choose = {}};
  try {
    const FifoSpec spec = spec_of(queue, config);
    if (queue.axis == Axis::time)
      keep(std::make_shared<FifoPath>(id, spec), open.movement, open.fifos, open.choose);
    else
      keep(std::make_shared<FifoFollow>(id, spec, run_of(queue)), open.movement, open.fifos,
           open.choose);
  } catch (const InputError& error) {
    return receiver.refuse_queue(queue.queue, wire::Refusal::bad_queue, error.what());
  } catch (const std::bad_alloc&) {
    return receiver.refuse_queue(queue.queue, wire::Refusal::out_of_memory, "");
  }
  open_[queue.queue] = std::move(open);
}

void Queues::take(const RowsArrived& arrived, Receiver& receiver) {
  const auto found = open_.find(arrived.rows.queue);
  if (found == open_.end()) return;
  Open& open = found->second;
  const int bank = arrived.rows.bank;
  for (std::size_t i = 0; i < arrived.rows.rows.size(); ++i) {
    const RowRule rule = open.fifos->push(bank, row_of(arrived.rows.rows[i]));
    if (rule != RowRule::none)
      return receiver.refuse_row(open.queue.queue, arrived.rows.first_row + i,
                                 std::string(name(rule)) + ": " + explain(rule));
    ++open.pushed[static_cast<std::size_t>(bank)];
  }
}

std::shared_ptr<Movement> Queues::movement(std::uint32_t queue) const {
  const Open* const open = find(queue);
  return open == nullptr ? nullptr : open->movement;
}

void Queues::choose(std::uint32_t queue, int bank) const {
  if (const Open* const open = find(queue)) open->choose(bank);
}

void Queues::handed_back(std::uint64_t movement) const {
  for (const auto& [index, open] : open_)
    if (open.movement->id() == movement) open.fifos->leave();
}

void Queues::report(const Tick& last, Receiver& receiver) const {
  for (const auto& [index, open] : open_) {
    QueueLevel level{.played = static_cast<std::int64_t>(open.fifos->rows_played())};
    for (const int bank : {0, 1}) {
      const auto b = static_cast<std::size_t>(bank);
      level.freed[b] = open.pushed[b] - std::min(open.pushed[b], held(open, bank));
    }
    level.progress = progress(open, last);
    receiver.level(index, level);
  }
}

bool Queues::queue_switch(std::uint32_t queue) {
  const Open* const open = find(queue);
  return open != nullptr && open->fifos->queue_switch();
}

bool Queues::clear(std::uint32_t queue, int bank) {
  const Open* const open = find(queue);
  return open != nullptr && open->fifos->clear(bank);
}

std::array<std::uint32_t, 2> Queues::fill(std::uint64_t movement) const {
  for (const auto& [index, open] : open_)
    if (open.movement->id() == movement) {
      const std::size_t waiting = open.fifos->size(0) + open.fifos->size(1);
      return {static_cast<std::uint32_t>(waiting), 2 * open.queue.capacity};
    }
  return {};
}

const Queues::Open* Queues::find(std::uint32_t queue) const {
  const auto found = open_.find(queue);
  return found == open_.end() ? nullptr : &found->second;
}

/// The FIFOs know how it ended: then the axis no longer plays it.
wire::Progress Queues::progress(const Open& open, const Tick& last) {
  switch (open.fifos->state()) {
    case SegmentFifos::State::idle:
    case SegmentFifos::State::taken:
      return wire::Progress::waiting;
    case SegmentFifos::State::ended:
      return wire::Progress::done;
    case SegmentFifos::State::cut_off:
    case SegmentFifos::State::lost:
      return wire::Progress::broken;
    case SegmentFifos::State::moving:
      break;
  }
  return last.job == open.movement->id() ? on_wire(last.progress) : wire::Progress::running;
}

/// Rows of a bank that still take up room: a stream gives it back in blocks of a FIFO.
std::uint64_t Queues::held(const Open& open, int bank) {
  if (open.queue.mode == wire::QueueMode::static_) return open.fifos->size(bank);
  return bank == 0 ? wire::room(open.queue) - open.fifos->space(0) : 0;
}

}  // namespace jounce
