// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "jounce/pvt/segment_row.hpp"

namespace jounce {

/// Two FIFOs of rows and their player: the common core of Googol's PT and follow modes
/// (jounce/controllers/googol/googol_pt.hpp, googol_follow.hpp) and of rolling streams
/// (jounce/axis/fifo_movement.hpp). A state machine without a clock: its constructor allocates all
/// memory, and nothing throws or waits.
///
///     SegmentFifos fifos(1024);
///     fifos.reset({.each = 32, .total = 64, .stream = true});
///     while (more && fifos.push(0, next()) == RowRule::none) ...   // the producer's thread
///     fifos.start(0, 0, 0);                                         // the player's
///     const Jet now = fifos.at(t);   // every cycle; t does not fall
///
/// **Two threads**: one *producer* fills, clears, queues switches; one *player* takes, starts,
/// plays. Neither ever waits, and no row is read while it is written: the player reads only rows
/// within a FIFO's size, and empties a FIFO only when the producer has left it (a stream has moved
/// on to the other one; a table whose switch is queued takes no more rows). Both may query the
/// state.
///
/// **Vocabulary.** A *pass* plays one FIFO from its first row to its last. Its *origin* is x and
/// position at its begin: at the start, at the end of the pass before, at the switch. So the
/// position is continuous for all rows, and the rows of every FIFO count from (0, 0), those of a
/// stream from the layout's base.
///
/// As *tables* (Googol: static) each FIFO is one: played `loops` times, kept, and played again when
/// started again. A queued switch waits for the end of the pass; then the other FIFO takes over and
/// the old one is emptied. As a *stream* (dynamic) both are one path: an exhausted FIFO is emptied
/// and the other continues at its last rate. So space comes back in blocks of a FIFO. The FIFO that
/// a call names has no effect. A stream that has ended is cleared before the next one is pushed. An
/// *open* stream ends only with its `last` row: if it runs out of rows before, it waits at the end
/// of the rows pushed so far, still moving, and continues when more rows are pushed.
///
/// **Numbers.** The producer can number its actions (stamp(), ascending); see() makes those up to a
/// number visible to the player. The motion then depends on that number alone, and not on the timing of
/// the threads. Without numbers every action is visible at once. A clear() has no number.
///
/// **Rates** are as in SegmentRow: an open rate takes the end rate of the row before; in the first
/// row of a pass, that of the pass before (0 in the first pass).
///
/// **Backwards** x is followed to the beginning of the pass (of the FIFO, in a stream), and no
/// further: there the axis stands still until x comes back.
class SegmentFifos {
 public:
  /// Allocates for FIFOs of at most `most` rows.
  explicit SegmentFifos(std::size_t most);

  struct Layout {
    std::size_t each = 0;   ///< rows a FIFO holds: at most `most`
    std::size_t total = 0;  ///< both together
    bool stream = false;
    bool open = false;      ///< open of a stream
    RowStart base = {};     ///< base of a stream: start of its first row
    RowLimits limits = {};  ///< limits of rows
  };
  /// Empties both and takes another layout. Only while no thread plays, by a single thread.
  void reset(const Layout& layout);

  enum class State : std::uint8_t {
    idle,     ///< not started since it was made or reset
    taken,    ///< a FIFO is chosen and will be played: it waits for its start
    moving,   ///< it plays
    ended,    ///< it has played its last row, which came to rest
    cut_off,  ///< the last row ended at a rate: an underrun, or a table with an open end
    left,     ///< its player has left before its end
    lost,  ///< x was not finite, or 2^53 passes off: the axis keeps its position until started again
  };
  [[nodiscard]] State state() const { return state_.load(); }
  [[nodiscard]] bool moving() const { return state() == State::moving; }
  [[nodiscard]] bool stream() const { return layout_.stream; }
  [[nodiscard]] const Layout& layout() const { return layout_; }

  [[nodiscard]] std::size_t size(int fifo) const { return fifos_[index(fifo)].size.load(); }
  /// Rows that can be pushed now: into this FIFO, or into a stream.
  [[nodiscard]] std::size_t space(int fifo) const;
  /// True if it is being played, waits to be, or is part of a stream that is.
  [[nodiscard]] bool in_use(int fifo) const;
  /// The FIFO that is played, or was last: 0 or 1.
  [[nodiscard]] int active() const { return active_.load(); }
  [[nodiscard]] bool switch_queued() const { return queued_.load(); }
  /// Completed since start or switch.
  [[nodiscard]] std::int64_t passes() const { return passes_.load(); }
  /// Rows of the stream so far that have been played to their end.
  [[nodiscard]] std::uint64_t rows_played() const { return played_.load(); }
  /// The greatest rate, second and third derivative, and step of the rate, of all rows pushed since
  /// the last reset, as far as they are known (rows after an open rate of a table are not).
  [[nodiscard]] RowPeaks peaks() const;

  /// Position within a pass.
  struct Reach {
    double lowest = 0;
    double highest = 0;
  };
  /// The range of positions of the present pass; infinite if rates are open. For tables, in the
  /// player's thread.
  [[nodiscard]] Reach reach() const;
  /// The range of positions of the pass that follows in the present state; nullopt if none follows.
  [[nodiscard]] std::optional<Reach> next_reach() const;

  // ---- producer ----------------------------------------------------------------------------------

  /// The number of the following actions.
  void stamp(std::uint64_t number) { stamp_ = number; }
  /// Takes a row, or returns its error; limits are checked exactly, by (1) to (3) of
  /// segment_row.cpp. A `last` row means nothing to a table.
  RowRule push(int fifo, const SegmentRow& row);
  /// Result that push() would return.
  [[nodiscard]] RowRule admits(int fifo, const SegmentRow& row) const;
  /// Ends an open stream with the rows pushed so far, as if its last row were marked `last`. False
  /// if the stream is not open, has no rows, or does not end at rest.
  bool complete();
  /// Empties a FIFO, or the whole stream; returns false, without an effect, if it is in use.
  bool clear(int fifo);
  /// Passes that a table is played; below 1: endless. Counts at the end of a pass.
  void set_loops(std::int64_t loops) { loops_.store(loops); }
  [[nodiscard]] std::int64_t loops() const { return loops_.load(); }
  /// At the end of the pass the other FIFO takes over. False if tables have ended, or it has no
  /// rows. Before the start it is queued for the end of the first pass.
  bool queue_switch();

  // ---- player ------------------------------------------------------------------------------------

  /// From now on, actions with a greater number are not yet visible.
  void see(std::uint64_t number) { sight_ = number; }
  /// Rows of a FIFO that are.
  [[nodiscard]] std::size_t visible(int fifo) const;
  /// The sign of the first displacement of a FIFO's first 64 rows; 0: none of them moves.
  [[nodiscard]] int direction(int fifo) const;
  /// Selects the FIFO to start: false if it is empty, in use, being cleared, or a stream that has
  /// ended. give_back() cancels the selection, or a start after which nothing was played.
  bool take(int fifo);
  void give_back();
  /// Plays the selected FIFO (a stream: from its base) from x and position on.
  void start(double x, double position);
  /// Both.
  bool start(int fifo, double x, double position);

  /// The player has left: the axis keeps its position. Tables are kept, a stream must be cleared.
  void leave();

  /// Position and derivatives by x. Plays on to x, which may lie many rows or passes further:
  /// passes of a table are processed at once, so the time of a call depends only on the rows.
  /// Without motion: the end position, at rest.
  Jet at(double x);

  /// End of the rows, and the rate there: once they are `ended` or `cut_off`.
  struct End {
    double x = 0;
    double position = 0;
    double rate = 0;
  };
  [[nodiscard]] const End& end() const { return end_; }

  /// x at the end of the available rows; infinite for endless tables.
  [[nodiscard]] double known() const;
  /// True if more rows are to come: an open stream without its last one.
  [[nodiscard]] bool growing() const {
    return layout_.open && !(complete_.load() && completed_at_.load() <= sight_);
  }

 private:
  struct Slot {
    SegmentRow row;
    double rate = 0;  // at the end of the row before, as played last
    std::uint64_t stamp = 0;
    std::array<double, 4> peaks{};  // peaks of all rows so far
    Reach reach{};                  // reach of the rows of this FIFO so far, from its beginning
  };
  struct Fifo {
    std::vector<Slot> slots;
    std::atomic<std::size_t> size{0};
  };
  struct Origin {
    double x = 0;
    double position = 0;
  };
  /// State of the producer: the end of the last row, and the rate there (NaN: not known yet).
  struct Tail {
    RowStart end;
    double rate = SegmentRow::open;
  };

  static std::size_t index(int fifo) { return fifo == 0 ? 0 : 1; }
  static RowStart end_of(const SegmentRow& row) { return {row.x_end, row.p_end}; }
  [[nodiscard]] Tail tail(int fifo) const;
  void note(const RowPeaks& peaks);
  [[nodiscard]] Reach reach_with(const Fifo& to, std::size_t slot, const RowPeaks* peaks) const;
  [[nodiscard]] Reach reach_of(int fifo, std::size_t rows, double origin) const;
  [[nodiscard]] Fifo& playing() { return fifos_[index(active())]; }
  [[nodiscard]] const Fifo& playing() const { return fifos_[index(active())]; }
  [[nodiscard]] const SegmentRow& last_row() const { return playing().slots[seen_ - 1].row; }
  [[nodiscard]] RowStart before(std::size_t slot) const;
  [[nodiscard]] PtRate rates_here() const;
  [[nodiscard]] Jet here(double u) const;
  [[nodiscard]] bool dry() const;
  [[nodiscard]] bool switch_seen() const;
  [[nodiscard]] const Slot* newest() const;
  void enter(std::size_t slot);
  bool grown();
  void next();
  void end_pass();
  void new_table();
  void take_turns(std::int64_t turns);
  void end_stream_fifo();
  void skip_passes(double x);
  void stop();
  void stand(State why);
  void lose();
  Jet in_pass(double u);

  Layout layout_;
  std::array<Fifo, 2> fifos_;
  std::atomic<State> state_{State::idle};
  std::atomic<int> active_{0};
  std::atomic<bool> queued_{false};             // set by the producer, taken back by the player
  std::atomic<bool> clearing_{false};           // the producer is at it
  std::atomic<bool> spent_{false};              // a stream has ended and was not cleared
  std::atomic<bool> complete_{false};           // the stream's last row is there
  std::atomic<std::uint64_t> queued_at_{0};     // stamps of the switch, of the last row,
  std::atomic<std::uint64_t> completed_at_{0};  // and of the one that is pushed now
  std::atomic<std::uint64_t> pushed_at_{0};
  std::atomic<std::int64_t> loops_{1};
  std::atomic<std::int64_t> passes_{0};
  std::atomic<std::uint64_t> played_{0};
  std::array<std::atomic<double>, 4> peaks_{};

  // The producer's.
  std::uint64_t stamp_ = 0;
  int filling_ = 0;            // filling of a stream
  std::array<Tail, 2> tails_;  // tails of each table; [0] of a stream

  // The player's.
  std::uint64_t sight_ = std::numeric_limits<std::uint64_t>::max();
  State before_ = State::idle;  // state before take(), restored when it is undone
  Origin table_;                // table of the first pass of its period
  std::int64_t turns_ = 0;
  Origin origin_;         // origin of this pass: table_ + turns_ times the table
  RowStart base_;         // base of a stream: the end of what was emptied
  std::size_t slot_ = 0;  // played
  std::size_t seen_ = 0;  // rows of this pass
  double rate_ = 0;       // at the end of the row before
  double position_ = 0;   // given last
  End end_;
  std::array<double, 3> pass_rates_{};  // at the ends of the last passes, and how many are known
  int known_rates_ = 0;
};

}  // namespace jounce
