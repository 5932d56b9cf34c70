#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "jounce/pvt/pt.hpp"

namespace jounce {

/// Two FIFOs of PT segments and what plays them: the common core of Googol's PT and follow modes
/// (pvt/googol_pt.hpp, gear/googol_follow.hpp), stepped by whoever owns an axis. A pure state
/// machine: its memory is allocated when it is made, nothing throws, nothing waits.
///
///     SegmentFifos fifos(1024);
///     fifos.reset({.each = 32, .total = 64, .stream = true});
///     while (more && fifos.space(0) > 0) fifos.push(0, next());
///     fifos.start(0, 0, 0);
///     const Jet now = fifos.at(t);   // every cycle; t does not fall
///
/// **Vocabulary.** A *pass* plays one FIFO from its first segment to its last. Its *origin* is where
/// x and position are when it begins: at the start, at the end of the pass before, at the switch. So
/// the position is continuous whatever is pushed, and the points of every FIFO count from (0, 0).
///
/// As *tables* (Googol: static) each FIFO is one: played as often as `loops` says, kept, and played
/// again when started again. A queued switch waits for the end of the pass; then the other FIFO takes
/// over and the old one is emptied.
/// As a *stream* (dynamic) both are one table, whose points count from the stream's beginning: an
/// exhausted FIFO is emptied and the other goes on, with the rate it was left with. So space comes
/// back in blocks of a FIFO. Which FIFO is named does not matter. What is pushed after the end begins
/// a new stream.
///
/// **Rates** are as in pt(): a `normal` first segment of a pass begins at 0, a `continued` one at the
/// end rate of the pass before (0 in the first one). Within a stream no segment but the first is
/// first. Positions are those of pt() to the last bit where x and the origins add up exactly, else to rounding.
///
/// **Backwards** x is followed to the beginning of the pass (of the FIFO, in a stream), and not
/// further: there the axis stands until x comes back.
class SegmentFifos {
 public:
  /// Allocates for FIFOs of at most `most` segments.
  explicit SegmentFifos(std::size_t most);

  struct Layout {
    std::size_t each = 0;   ///< segments a FIFO holds: at most `most`
    std::size_t total = 0;  ///< both together
    bool stream = false;
  };
  /// Empties both and takes another layout. Not while moving.
  void reset(const Layout& layout);

  enum class State : std::uint8_t {
    idle,     ///< not started since it was made or reset
    moving,   ///< it plays
    ended,    ///< it has played its last segment, which came to rest
    cut_off,  ///< the last segment ended at a rate: an underrun, or a table with an open end
    lost,     ///< x was not finite, or 2^53 passes off: it stands where it was, until started again
  };
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool moving() const { return state_ == State::moving; }
  [[nodiscard]] bool stream() const { return layout_.stream; }

  [[nodiscard]] std::size_t size(int fifo) const { return fifos_[index(fifo)].size; }
  /// Segments that can be pushed now: into this FIFO, or into a stream.
  [[nodiscard]] std::size_t space(int fifo) const;
  /// Whether it is being played, or part of a stream that is.
  [[nodiscard]] bool in_use(int fifo) const;
  /// The FIFO that is played, or was last: 0 or 1.
  [[nodiscard]] int active() const { return active_; }
  [[nodiscard]] bool switch_queued() const { return queued_; }
  [[nodiscard]] std::int64_t passes() const {
    return passes_;
  }  ///< completed since start or switch

  /// Whether its numbers are finite and x goes on from the last point pushed.
  [[nodiscard]] bool follows_on(int fifo, const PtPoint& point) const;
  /// Takes a point that follows on, while there is space: both asserted.
  void push(int fifo, const PtPoint& point);
  /// Empties a FIFO, or the whole stream. Not in use.
  void clear(int fifo);

  /// Passes that a table is played; below 1: for ever. Counts at the end of a pass.
  void set_loops(std::int64_t loops) { loops_ = loops; }
  [[nodiscard]] std::int64_t loops() const { return loops_; }

  /// Plays the FIFO (a stream: from its beginning) from x and position on. Not empty, not moving.
  void start(int fifo, double x, double position);
  /// At the end of the pass the other FIFO takes over. Moving tables alone; not empty.
  void queue_switch();

  /// Position and derivatives by x. Plays on to x, which may lie many segments or passes further:
  /// passes of a table are taken at once, so that the time a call takes depends on the segments alone.
  /// Where it is not moving: the position where it ended, at rest.
  Jet at(double x);

 private:
  struct Slot {
    PtPoint point;
    double start_rate = 0;  // as played last
  };
  struct Fifo {
    std::vector<Slot> slots;
    std::size_t size = 0;
  };
  struct Origin {
    double x = 0;
    double position = 0;
  };

  static std::size_t index(int fifo) { return fifo == 0 ? 0 : 1; }
  [[nodiscard]] Fifo& playing() { return fifos_[index(active_)]; }
  [[nodiscard]] const Fifo& playing() const { return fifos_[index(active_)]; }
  [[nodiscard]] PtPoint last_pushed(int fifo) const;
  [[nodiscard]] PtPoint before(std::size_t slot) const;
  [[nodiscard]] double end_rate() const;
  [[nodiscard]] Jet here(double u) const;
  void enter(std::size_t slot, bool first);
  void next();
  void end_pass();
  void take_turns(std::int64_t turns);
  void end_stream_fifo();
  void skip_passes(double x);
  void stop();
  void lose();
  Jet in_pass(double u);

  std::array<Fifo, 2> fifos_;
  Layout layout_;
  State state_ = State::idle;
  int active_ = 0;
  int filling_ = 0;  // of a stream
  bool queued_ = false;
  std::int64_t loops_ = 1;
  std::int64_t passes_ = 0;
  Origin table_;  // of the first pass of its period
  std::int64_t turns_ = 0;
  Origin origin_;  // of this pass: table_ + turns_ times the table
  PtPoint base_;   // of a stream: the last point of what was emptied
  std::size_t slot_ = 0;
  double rate_ = 0;                     // at the end of the segment before
  double position_ = 0;                 // given last
  std::array<double, 3> pass_rates_{};  // at the ends of the last passes, and how many are known
  int known_rates_ = 0;
};

}  // namespace jounce
