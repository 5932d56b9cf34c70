// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/segment_fifos.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

// Access to a FIFO. The producer appends: it writes a slot beyond the size, then the size
// (release). The player reads below the size that it has read (acquire).
//
// The player empties a FIFO, by storing 0, in two functions, and the producer does not use that
// FIFO then. end_stream_fifo() runs when the other FIFO has rows, and the producer moves there for
// good when the first is full. end_pass() runs with a queued switch, after which push() rejects
// rows.
//
// The producer empties a FIFO in clear(). clear() and take() exclude each other: each sets a flag
// before it reads the flag of the other (sequentially consistent: one of them sees the other's
// flag, and gives way).

namespace jounce {

SegmentFifos::SegmentFifos(std::size_t most) {
  for (Fifo& fifo : fifos_) fifo.slots.resize(most);
}

void SegmentFifos::reset(const Layout& layout) {
  assert(layout.each <= fifos_[0].slots.size());
  layout_ = layout;
  state_ = State::idle;
  queued_ = false;
  passes_ = 0;
  for (auto& peak : peaks_) peak = 0;
  for (const int fifo : {0, 1}) clear(fifo);
}

std::size_t SegmentFifos::space(int fifo) const {
  const auto left = [&](int i) { return layout_.each - size(i); };
  const std::size_t together = layout_.total - size(0) - size(1);
  if (!layout_.stream) return std::min(left(fifo), together);
  const int other = 1 - filling_;  // the other FIFO is used if it is empty
  return std::min(left(filling_) + (size(other) == 0 ? layout_.each : 0), together);
}

bool SegmentFifos::in_use(int fifo) const {
  const State now = state();
  return (now == State::moving || now == State::taken) && (layout_.stream || fifo == active());
}

RowPeaks SegmentFifos::peaks() const {
  std::array<double, 4> f{peaks_[0].load(), peaks_[1].load(), peaks_[2].load(), peaks_[3].load()};
  // Read last, because the producer writes it first: so the peaks of a row are seen before the row.
  if (pushed_at_.load() > sight_) {
    const Slot* const last = newest();
    f = last != nullptr ? last->peaks : std::array<double, 4>{};
  }
  return {f[0], f[1], f[2], f[3], 0, 0};
}

// ---- producer ------------------------------------------------------------------------------------

/// A table that a switch has emptied starts again.
SegmentFifos::Tail SegmentFifos::tail(int fifo) const {
  if (layout_.stream) return tails_[0];
  return size(fifo) > 0 ? tails_[index(fifo)] : Tail{};
}

RowRule SegmentFifos::admits(int fifo, const SegmentRow& row) const {
  if (layout_.stream ? complete_.load() : switch_queued() && fifo == active())
    return layout_.stream ? RowRule::after_last : RowRule::in_use;
  if (space(fifo) == 0) return RowRule::full;
  const auto [from, rate] = tail(fifo);
  if (const RowRule wrong = check(row, from); wrong != RowRule::none) return wrong;
  // Computed when the row is played.
  if (std::isnan(rates(row, from, rate).start)) return RowRule::none;
  RowPeaks f = jounce::peaks(row, from, rate);
  if (std::isnan(rate)) f.velocity_step = 0;
  return check(f, layout_.limits);
}

RowRule SegmentFifos::push(int fifo, const SegmentRow& row) {
  if (const RowRule wrong = admits(fifo, row); wrong != RowRule::none) return wrong;
  const auto [from, rate] = tail(fifo);
  const PtRate made = rates(row, from, rate);
  pushed_at_.store(stamp_);
  std::optional<RowPeaks> f;
  if (!std::isnan(made.start)) note(f.emplace(jounce::peaks(row, from, rate)));
  if (layout_.stream) {
    if (size(filling_) == layout_.each) filling_ = 1 - filling_;
    fifo = filling_;
  }
  Fifo& to = fifos_[index(fifo)];
  const std::size_t n = to.size.load();
  to.slots[n] = {row, 0, stamp_, {}, reach_with(to, n, f ? &*f : nullptr)};
  for (std::size_t k = 0; k < peaks_.size(); ++k) to.slots[n].peaks[k] = peaks_[k].load();
  to.size.store(n + 1);
  tails_[layout_.stream ? 0 : index(fifo)] = {end_of(row), made.end};
  if (!layout_.stream) return RowRule::none;
  if (!row.last || !layout_.open) return RowRule::none;
  completed_at_.store(stamp_);
  complete_.store(true);
  return RowRule::none;
}

bool SegmentFifos::complete() {
  if (!layout_.stream || !layout_.open) return false;
  if (complete_.load()) return true;
  const bool any = size(0) + size(1) > 0;
  if (!any || !(tails_[0].rate == 0)) return false;
  completed_at_.store(stamp_);
  complete_.store(true);
  return true;
}

void SegmentFifos::note(const RowPeaks& f) {
  const std::array now{f.velocity, f.acceleration, f.jerk,
                       std::isnan(f.velocity_step) ? 0 : f.velocity_step};
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] > peaks_[k].load()) peaks_[k].store(now[k]);
}

/// The reach of a FIFO's rows including this new one; `peaks` is null if the rates of the row are
/// not known yet.
SegmentFifos::Reach SegmentFifos::reach_with(const Fifo& to, std::size_t slot,
                                             const RowPeaks* peaks) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const Reach before = slot > 0 ? to.slots[slot - 1].reach : Reach{};
  if (peaks == nullptr) return {-unknown, unknown};
  return {std::min(before.lowest, peaks->position_min),
          std::max(before.highest, peaks->position_max)};
}

bool SegmentFifos::clear(int fifo) {
  clearing_.store(true);
  const bool may = !in_use(fifo) && !(switch_queued() && fifo != active());
  if (may && layout_.stream) {
    for (Fifo& each : fifos_) each.size.store(0);
    filling_ = 0;
    tails_[0] = {layout_.base, 0};
    complete_.store(false);
    played_.store(0);
    spent_.store(false);
  } else if (may) {
    fifos_[index(fifo)].size.store(0);
  }
  clearing_.store(false);
  return may;
}

bool SegmentFifos::queue_switch() {
  const State now = state();
  const bool plays = now == State::moving || now == State::taken || now == State::idle;
  if (!plays || layout_.stream || size(1 - active()) == 0) return false;
  queued_at_.store(stamp_);
  queued_.store(true);
  return true;
}

// ---- player --------------------------------------------------------------------------------------

/// Stamps ascend, so rows that are not visible yet are at the end.
std::size_t SegmentFifos::visible(int fifo) const {
  const Fifo& of = fifos_[index(fifo)];
  std::size_t n = of.size.load();
  while (n > 0 && of.slots[n - 1].stamp > sight_) --n;
  return n;
}

int SegmentFifos::direction(int fifo) const {
  const std::size_t rows = std::min<std::size_t>(visible(fifo), 64);
  double from = layout_.stream ? layout_.base.position : 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const double to = fifos_[index(fifo)].slots[i].row.p_end;
    if (to != from) return to > from ? 1 : -1;
    from = to;
  }
  return 0;
}

bool SegmentFifos::switch_seen() const {
  return queued_.load() && queued_at_.load() <= sight_ && visible(1 - active()) > 0;
}

/// The last row that is available: the end of a stream.
const SegmentFifos::Slot* SegmentFifos::newest() const {
  const Slot* last = nullptr;
  for (const int fifo : {0, 1}) {
    const std::size_t n = visible(fifo);
    if (n == 0) continue;
    const Slot& slot = fifos_[index(fifo)].slots[n - 1];
    const bool later = last == nullptr || slot.stamp > last->stamp ||
                       (slot.stamp == last->stamp && slot.row.x_end > last->row.x_end);
    if (later) last = &slot;
  }
  return last;
}

SegmentFifos::Reach SegmentFifos::reach_of(int fifo, std::size_t rows, double origin) const {
  if (rows == 0) return {origin, origin};
  const Reach& all = fifos_[index(fifo)].slots[rows - 1].reach;
  return {origin + all.lowest, origin + all.highest};
}

SegmentFifos::Reach SegmentFifos::reach() const {
  return reach_of(active(), visible(active()), origin_.position);
}

std::optional<SegmentFifos::Reach> SegmentFifos::next_reach() const {
  const bool again = loops() < 1 || passes_.load() + 1 < loops();
  const bool switches = switch_seen();
  if (layout_.stream || !moving() || !(switches || again)) return std::nullopt;
  const int next = switches ? 1 - active() : active();
  return reach_of(next, visible(next), origin_.position + last_row().p_end);
}

bool SegmentFifos::take(int fifo) {
  const State was = state();
  if (was == State::taken || was == State::moving || spent_.load()) return false;
  const int to = layout_.stream ? 0 : fifo;
  const int active_before = active();
  active_.store(to);
  state_.store(State::taken);
  if (!clearing_.load() && visible(to) > 0) {
    before_ = was;
    return true;
  }
  state_.store(was);
  active_.store(active_before);
  return false;
}

void SegmentFifos::give_back() {
  if (state() == State::taken || moving()) state_.store(before_);
}

void SegmentFifos::start(double x, double position) {
  assert(state() == State::taken);
  base_ = layout_.stream ? layout_.base : RowStart{};
  table_ = origin_ = {x - base_.x, position - base_.position};
  position_ = position;
  turns_ = 0;
  known_rates_ = 0;
  passes_ = 0;
  rate_ = 0;
  seen_ = visible(active());
  state_.store(State::moving);
  enter(0);
}

bool SegmentFifos::start(int fifo, double x, double position) {
  if (!take(fifo)) return false;
  start(x, position);
  return true;
}

RowStart SegmentFifos::before(std::size_t slot) const {
  return slot > 0 ? end_of(playing().slots[slot - 1].row) : base_;
}

/// Begins a row at the end rate of the previous one.
void SegmentFifos::enter(std::size_t slot) {
  slot_ = slot;
  playing().slots[slot].rate = rate_;
}

PtRate SegmentFifos::rates_here() const {
  const Slot& at = playing().slots[slot_];
  return rates(at.row, before(slot_), at.rate);
}

/// True if rows have been pushed after the last one that was seen; the function is called only at
/// the end of this row. The previous passes of a table were then shorter than the later ones.
bool SegmentFifos::grown() {
  const std::size_t now = visible(active());
  if (now == seen_) return false;
  seen_ = now;
  table_ = origin_;
  turns_ = 0;
  known_rates_ = 0;
  return true;
}

void SegmentFifos::next() {
  rate_ = rates_here().end;
  if (layout_.stream) played_.fetch_add(1);
  if (slot_ + 1 < seen_ || grown())
    enter(slot_ + 1);
  else if (layout_.stream)
    end_stream_fifo();
  else
    end_pass();
}

/// True if an open stream is at the end of all pushed rows, and more may follow.
bool SegmentFifos::dry() const {
  return growing() && slot_ + 1 == visible(active()) && visible(1 - active()) == 0;
}

void SegmentFifos::end_stream_fifo() {
  if (visible(1 - active()) == 0) return stop();
  base_ = end_of(last_row());
  playing().size.store(0);
  active_.store(1 - active());
  seen_ = visible(active());
  enter(0);
}

void SegmentFifos::take_turns(std::int64_t turns) {
  const SegmentRow& last = last_row();
  turns_ += turns;
  const auto all = static_cast<double>(turns_);
  origin_ = {table_.x + all * last.x_end, table_.position + all * last.p_end};
}

void SegmentFifos::new_table() {
  playing().size.store(0);
  active_.store(1 - active());
  queued_.store(false);
  passes_ = 0;
  table_ = origin_;
  turns_ = 0;
  known_rates_ = 0;
}

/// A later end of the same table replaces the earlier one.
void SegmentFifos::note_end(const PassEnd& end) {
  const bool same = ends_count_ > 0 && !ends_[ends_count_ - 1].switched;
  if (!same && ends_count_ < ends_.size()) ++ends_count_;
  ends_[ends_count_ - 1] = end;
}

void SegmentFifos::end_pass() {
  const std::int64_t done = passes_.load() + 1;
  passes_.store(done);
  const bool again = loops() < 1 || done < loops();
  const bool switches = switch_seen();
  note_end({origin_.x + last_row().x_end, done, switches});
  if (!switches && !again) return stop();
  take_turns(1);
  if (switches) {
    new_table();
  } else {
    pass_rates_ = {pass_rates_[1], pass_rates_[2], rate_};
    known_rates_ = std::min(known_rates_ + 1, 3);
  }
  seen_ = visible(active());
  enter(0);
}

/// Skips pairs of passes. A pass that begins at the rate r ends at s r + c; s is 0 if any row has a
/// given rate, otherwise 1 or -1. So each pair of passes changes the rate by the same amount.
void SegmentFifos::skip_passes(double x) {
  if (layout_.stream || switch_seen() || slot_ != 0 || known_rates_ < 3) return;
  // 2^53: above, the position in the pass is only rounding
  constexpr double countable = 9007199254740992;
  const double ahead = (x - origin_.x) / last_row().x_end;
  if (!(ahead >= 4)) return;
  auto passes = static_cast<std::int64_t>(std::min(ahead, countable)) - 2;
  if (loops() < 1 && ahead >= countable) return lose();
  if (loops() >= 1) passes = std::min(passes, loops() - 1 - passes_.load());
  if (passes < 2) return;
  const std::int64_t pairs = passes / 2;
  rate_ += static_cast<double>(pairs) * (rate_ - pass_rates_[0]);
  known_rates_ = 0;
  passes_.fetch_add(2 * pairs);
  take_turns(2 * pairs);
  enter(0);
}

/// Stops at the end of the last row. The rows of a stream are then used up; those of a table are
/// kept. A pending switch is canceled.
void SegmentFifos::stop() {
  queued_.store(false);
  constexpr double rounding = 1e-9;  // error of a chain of quotients at a rest
  const bool rests = std::abs(rate_) <= rounding * std::abs(rates_here().start - rate_);
  origin_.position += last_row().p_end;
  end_ = {origin_.x + last_row().x_end, origin_.position, rate_};
  spent_.store(layout_.stream);
  state_.store(rests ? State::ended : State::cut_off);
}

void SegmentFifos::stand(State why) {
  origin_.position = position_;
  queued_.store(false);
  spent_.store(layout_.stream);
  state_.store(why);
}

void SegmentFifos::lose() {
  stand(State::lost);
}

void SegmentFifos::leave() {
  if (moving()) return stand(State::left);
  give_back();
}

Jet SegmentFifos::here(double u) const {
  const Slot& at = playing().slots[slot_];
  Jet f = point(at.row, before(slot_), at.rate, u);
  f[0] += origin_.position;
  return f;
}

std::optional<Jet> SegmentFifos::first(double x) const {
  const double u = x - origin_.x;
  if (!moving() || !std::isfinite(u)) return std::nullopt;
  if (u < before(0).x) return Jet{origin_.position + before(0).position, 0, 0, 0};
  double rate = 0;
  for (std::size_t slot = 0; slot < seen_; ++slot) {
    const SegmentRow& row = playing().slots[slot].row;
    if (u < row.x_end) {
      Jet f = point(row, before(slot), rate, u);
      f[0] += origin_.position;
      return f;
    }
    rate = rates(row, before(slot), rate).end;
  }
  return std::nullopt;
}

Jet SegmentFifos::at(double x) {
  ends_count_ = 0;
  if (moving() && !std::isfinite(x)) lose();
  while (moving() && x - origin_.x >= playing().slots[slot_].row.x_end && !dry()) {
    next();
    if (moving()) skip_passes(x);
  }
  const Jet f = moving() ? in_pass(x - origin_.x) : Jet{origin_.position, 0, 0, 0};
  position_ = f[0];
  return f;
}

Jet SegmentFifos::in_pass(double u) {
  while (slot_ > 0 && u < before(slot_).x) --slot_;
  if (u < before(0).x) return {origin_.position + before(0).position, 0, 0, 0};
  return here(u);
}

double SegmentFifos::known() const {
  if (layout_.stream) {
    const Slot* const last = newest();
    return origin_.x + (last != nullptr ? last->row.x_end : layout_.base.x);
  }
  if (loops() < 1) return std::numeric_limits<double>::infinity();
  const auto left = static_cast<double>(switch_seen() ? 1 : loops() - passes_.load());
  const double end = origin_.x + left * last_row().x_end;
  if (!switch_seen()) return end;
  const Fifo& next = fifos_[index(1 - active())];
  return end + static_cast<double>(loops()) * next.slots[visible(1 - active()) - 1].row.x_end;
}

}  // namespace jounce
