// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "jounce/pvt/segment_row.hpp"

namespace jounce {

/// Two FIFOs of rows, and their player: a state machine without a clock. Googol's PT and follow
/// modes (jounce/controllers/googol/googol_pt.hpp, googol_follow.hpp) and rolling streams
/// (jounce/axis/fifo_movement.hpp) use this class. The constructor allocates all memory. Other
/// members do not throw, allocate or wait.
///
///     SegmentFifos fifos(1024);
///     fifos.reset({.each = 32, .total = 64, .stream = true});
///     while (more && fifos.push(0, next()) == RowRule::none) ...   // producer thread
///     fifos.start(0, 0, 0);                                         // player thread
///     const Jet now = fifos.at(t);                               // each cycle
///
/// **Two threads.** One *producer* pushes rows, clears FIFOs and queues switches. One *player*
/// selects, starts and plays FIFOs. Neither thread waits for the other. No row is read while it is
/// written: the player reads only rows within the size of a FIFO, and it empties a FIFO only when
/// the producer no longer writes to it. (A stream has then continued in the other FIFO; a table
/// whose switch is queued accepts no more rows.) Both threads may query the state.
///
/// **Vocabulary.** x is the time or the position of the master. A *pass* plays one FIFO from its
/// first row to its last. The *origin* of a pass is the x and the position at its beginning: at the
/// start, at the end of the previous pass, or at the switch. So the position is always continuous.
/// The rows of a table count from (0, 0), the rows of a stream from Layout::base.
///
/// **Tables** (Googol: static). Each FIFO is one table. The player plays it `loops` times; the FIFO
/// keeps its rows, so that it can be started again. A queued switch takes place at the end of the
/// pass: the player continues with the other FIFO, and the old one is emptied.
///
/// **Stream** (Googol: dynamic). The two FIFOs together are one motion. When one FIFO is exhausted,
/// it is emptied, and the other one continues at the last rate; so space becomes free in blocks of
/// one FIFO. Functions ignore their argument `fifo`. Clear a stream that has ended before you push
/// the next one. An *open* stream ends only with its row marked `last`. If the rows run out
/// earlier, the state stays `moving`: at() returns the values at the end of the last row, and plays
/// new rows as soon as they are pushed.
///
/// **Numbers.** The producer can give ascending numbers to its actions with stamp(). The player
/// makes the actions up to a number visible with see(). The motion then depends only on this
/// number, not on the timing of the threads. Without numbers, every action is visible at once.
/// clear() has no number.
///
/// **Rates**: see SegmentRow. If both rates of a row are open (not given), the row begins at the
/// end rate of the previous row. The first row of a pass then begins at the end rate of the
/// previous pass (0 in the first pass).
///
/// **Backwards.** If x decreases, the axis moves backwards to the beginning of the pass (in a
/// stream: of the FIFO). There it stands still until x returns.
class SegmentFifos {
 public:
  /// Allocates two FIFOs of at most `most` rows.
  explicit SegmentFifos(std::size_t most);

  /// Sizes, kind and limits of both FIFOs.
  struct Layout {
    std::size_t each = 0;   ///< rows that each FIFO holds, at most `most`
    std::size_t total = 0;  ///< rows that both FIFOs hold together
    bool stream = false;    ///< true: both FIFOs are one stream; false: each is a table
    bool open = false;      ///< true: an open stream, which ends only with its row marked `last`
    RowStart base = {};     ///< start of the first row of a stream
    RowLimits limits = {};  ///< limits that push() checks
  };
  /// Empties both FIFOs and sets the layout. Call reset() only while no thread plays, and from one
  /// thread at a time.
  void reset(const Layout& layout);

  enum class State : std::uint8_t {
    idle,     ///< not started since construction or reset()
    taken,    ///< a FIFO is selected and waits for start()
    moving,   ///< the FIFO is played
    ended,    ///< the last row has been played and ended at rest
    cut_off,  ///< the last row ended at a nonzero rate: an underrun, or a table that ends in motion
    left,     ///< leave() was called before the end
    /// x was not finite, or more than 2^53 passes away. The axis keeps its position until the next
    /// start.
    lost,
  };
  [[nodiscard]] State state() const { return state_.load(); }
  [[nodiscard]] bool moving() const { return state() == State::moving; }
  [[nodiscard]] bool stream() const { return layout_.stream; }
  [[nodiscard]] const Layout& layout() const { return layout_; }

  /// Returns the number of rows in a FIFO.
  [[nodiscard]] std::size_t size(int fifo) const { return fifos_[index(fifo)].size.load(); }
  /// Returns the number of rows that can be pushed now into this FIFO, or into the stream.
  [[nodiscard]] std::size_t space(int fifo) const;
  /// True if the FIFO is played or selected, or is part of a stream that is played or selected.
  /// (The target of a queued switch is not in use yet, but clear() rejects it.)
  [[nodiscard]] bool in_use(int fifo) const;
  /// The FIFO that is played or was played last: 0 or 1.
  [[nodiscard]] int active() const { return active_.load(); }
  [[nodiscard]] bool switch_queued() const { return queued_.load(); }  ///< true if a switch waits
  /// Number of passes completed since the start or the switch.
  [[nodiscard]] std::int64_t passes() const { return passes_.load(); }
  /// Number of rows of the stream that have been played to their end.
  [[nodiscard]] std::uint64_t rows_played() const { return played_.load(); }
  /// The greatest magnitudes of rate, second and third derivative, and of a step of the rate, in
  /// all rows pushed since the last reset. In tables, rows after an open rate are not included,
  /// because their rates are not known yet.
  [[nodiscard]] RowPeaks peaks() const;

  /// Range of positions.
  struct Reach {
    double lowest = 0;   ///< u
    double highest = 0;  ///< u
  };
  /// Range of positions of the present pass; infinite if rates are open. For tables, call reach()
  /// in the player thread.
  [[nodiscard]] Reach reach() const;
  /// Range of positions of the next pass in the present state; nullopt if the motion has no next
  /// pass.
  [[nodiscard]] std::optional<Reach> next_reach() const;

  // ---- producer ---------------------------------------------------------------------------------

  /// Sets the number that the following actions have (see **Numbers**).
  void stamp(std::uint64_t number) { stamp_ = number; }
  /// Adds a row, or returns the reason for rejecting the row. The check of the limits is exact, by
  /// equations (1) to (3) of segment_row.cpp. A table ignores the mark `last`.
  RowRule push(int fifo, const SegmentRow& row);
  /// Returns what push() would return.
  [[nodiscard]] RowRule admits(int fifo, const SegmentRow& row) const;
  /// Ends an open stream with the rows pushed so far, as if the last one were marked `last`.
  /// Returns false if the stream is not open, has no rows, or does not end at rest.
  bool complete();
  /// Empties a FIFO, or the whole stream. If the FIFO is in use or the target of a queued switch,
  /// returns false and changes nothing.
  bool clear(int fifo);
  /// Sets the number of passes of a table; below 1: endless. The number applies from the end of the
  /// present pass.
  void set_loops(std::int64_t loops) { loops_.store(loops); }
  [[nodiscard]] std::int64_t loops() const { return loops_.load(); }
  /// Queues a switch to the other FIFO at the end of the pass; before the start, at the end of the
  /// first pass. Returns false in these cases: the FIFOs are a stream; the state is `ended`,
  /// `cut_off`, `left` or `lost`; the other FIFO has no rows.
  bool queue_switch();

  // ---- player -----------------------------------------------------------------------------------

  /// Makes the actions up to this number visible to the player; later actions stay invisible.
  void see(std::uint64_t number) { sight_ = number; }
  /// Returns the number of visible rows of a FIFO.
  [[nodiscard]] std::size_t visible(int fifo) const;
  /// Returns the direction in which a FIFO begins: the sign of the first displacement in its first
  /// 64 rows; 0: none.
  [[nodiscard]] int direction(int fifo) const;
  /// take() selects the FIFO to start. It returns false if a FIFO is already selected or played, if
  /// the FIFO is empty or being cleared, or if the FIFOs are a stream that has ended and was not
  /// cleared. give_back() cancels the selection, or a start after which nothing was played.
  bool take(int fifo);
  void give_back();
  /// Plays the selected FIFO. The pass begins at the given x and position; a stream begins at its
  /// base.
  void start(double x, double position);
  /// Calls take(), then start(x, position).
  bool start(int fifo, double x, double position);

  /// Returns what the first at() after start() would return, if its x is in the first pass;
  /// otherwise nullopt. Changes nothing.
  [[nodiscard]] std::optional<Jet> first(double x) const;

  /// Stops playing: the axis keeps its position. The rows of a table are kept; a stream must be
  /// cleared.
  void leave();

  /// Plays up to x, and returns the position and its derivatives with respect to x. x may be many
  /// rows or passes ahead. Passes of a table are skipped in one step, so the time of a call depends
  /// only on the number of rows. If nothing is played, returns the end position, at rest.
  Jet at(double x);

  /// An end of a pass of a table.
  struct PassEnd {
    double x = 0;             ///< s or m
    std::int64_t passes = 0;  ///< passes of the table completed by then
    bool switched = false;    ///< true: the other FIFO continues from here
  };
  /// The ends of passes of tables in the last at(), in their order: for each of the two FIFOs the
  /// last one.
  [[nodiscard]] std::span<const PassEnd> pass_ends() const { return {ends_.data(), ends_count_}; }

  /// End of the rows that were played, and the rate at this end, if the state is `ended` or
  /// `cut_off`.
  struct End {
    double x = 0;         ///< s or m
    double position = 0;  ///< u
    double rate = 0;      ///< u/s or u/m
  };
  [[nodiscard]] const End& end() const { return end_; }

  /// The x at the end of the available rows; infinite for endless tables.
  [[nodiscard]] double known() const;
  /// True if more rows will follow: an open stream without its last row.
  [[nodiscard]] bool growing() const {
    return layout_.open && !(complete_.load() && completed_at_.load() <= sight_);
  }

 private:
  /// A row in a FIFO.
  struct Slot {
    SegmentRow row = {};
    double rate = 0;  // end rate of the previous row, when it was played last
    std::uint64_t stamp = 0;
    std::array<double, 4> peaks{};  // peaks of the rows up to this one
    Reach reach{};                  // range of positions of the rows of this FIFO up to this one
  };
  struct Fifo {
    std::vector<Slot> slots = {};
    std::atomic<std::size_t> size{0};
  };
  struct Origin {
    double x = 0;
    double position = 0;
  };
  /// End of the last pushed row, and the rate there (NaN: not yet known).
  struct Tail {
    RowStart end = {};
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
  void note_end(const PassEnd& end);
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
  std::atomic<bool> queued_{false};             // set by the producer, reset by the player
  std::atomic<bool> clearing_{false};           // true while the producer clears
  std::atomic<bool> spent_{false};              // true if a stream has ended and was not cleared
  std::atomic<bool> complete_{false};           // true if the last row of the stream was pushed
  std::atomic<std::uint64_t> queued_at_{0};     // stamp of the switch
  std::atomic<std::uint64_t> completed_at_{0};  // stamp of the last row
  std::atomic<std::uint64_t> pushed_at_{0};     // stamp of the row that is being pushed
  std::atomic<std::int64_t> loops_{1};
  std::atomic<std::int64_t> passes_{0};
  std::atomic<std::uint64_t> played_{0};
  std::array<std::atomic<double>, 4> peaks_{};

  // State of the producer.
  std::uint64_t stamp_ = 0;
  int filling_ = 0;            // FIFO of a stream that is filled
  std::array<Tail, 2> tails_;  // end of each table; [0]: end of the stream

  // State of the player.
  std::uint64_t sight_ = std::numeric_limits<std::uint64_t>::max();
  State before_ = State::idle;  // state before take(), restored by give_back()
  Origin table_;                // origin of the first pass of the table
  std::int64_t turns_ = 0;
  Origin origin_;         // origin of this pass: table_ plus turns_ times the table
  RowStart base_;         // base of a stream: the end of the rows that were emptied
  std::size_t slot_ = 0;  // index of the row that is played
  std::size_t seen_ = 0;  // number of rows of this pass
  double rate_ = 0;       // end rate of the previous row
  double position_ = 0;   // position returned last
  End end_;
  std::array<PassEnd, 2> ends_{};
  std::size_t ends_count_ = 0;
  // end rates of the last passes; known_rates_ of them are known
  std::array<double, 3> pass_rates_{};
  int known_rates_ = 0;
};

}  // namespace jounce
