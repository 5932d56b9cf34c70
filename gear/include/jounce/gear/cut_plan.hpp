// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "jounce/gear/cut_numbers.hpp"
#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Everything that a plan of cuts reads: the cutter, its list, and the pieces that are possible at
/// the speed of the line. A task does not change while the plan runs.
struct CutTask {
  Cutter cutter;
  CutList list;
  std::vector<CutRange> possible;  ///< possible_lengths(); not empty

  /// Throws InputError like the functions that it calls, and for a length of the list that is not
  /// possible at the speed of the line.
  explicit CutTask(const CutJob& job);

  /// True if a piece of this length is possible.
  [[nodiscard]] bool makes(double length) const;
  /// Returns the least possible length that is not below `length`, m; infinite: none.
  [[nodiscard]] double at_least(double length) const;
};

/// Answer to a request.
struct CutAnswer {
  enum class Status : std::uint8_t {
    ok,
    length,    ///< the piece is not possible: `limit` is the nearest possible length, m
    position,  ///< the cut is too early: `limit` is the next possible position of the web, m
    pending,   ///< the waiting cut on demand would no longer be possible: `limit` is its position,
               ///< m
    far,       ///< more than most_planned cuts come before the requested cut: `limit` is the last
               ///< possible cut, m
  };
  Status status = Status::ok;
  double value =
      0;  ///< the requested number, m; for a cut on demand that is accepted: its position
  double limit = 0;

  explicit operator bool() const { return status == Status::ok; }
};

/// The cuts of a web in the order in which they come, with changes on the fly. The plan is a pure
/// function of the positions of the web and of the requests: no clock, no allocation, no exception.
///
///     CutPlan plan(task, 12'000);                  // the web is at 12000; the cutter is at home
///     const Jet y = plan.at(12'004);               // once a cycle
///     if (!plan.set_length(800)) ...               // from the next cut on
///     if (!plan.cut_at(15'300)) ...                // one more cut
///     plan.finish();                               // no cut after the committed one
///
/// **Commitment.** A cut is *planned* when the cut before it is made. It is *committed* when the
/// cutter begins to move towards it: at the end of the fixed motion after a cut (Cutter::commit()),
/// or when it leaves home. Until then, a cut on demand may come before it.
///
/// **Next possible cut**, with A = Cutter::approach(), R = Cutter::retreat(), x the position of the
/// web, and C the last cut that is made or committed:
///
///     (1)  x + A                                        the cutter waits at home
///     (2)  C + R + A                                    it is on its way home after C
///     (3)  C + the shortest possible piece              otherwise
///
/// A cut on demand ends a piece early. This piece is waste, and the plan repeats its length after
/// the cut. If planned cuts come before the demand, this piece begins at the last of them, and must
/// be possible. At most most_planned cuts may come before the demand. A new cut on demand replaces
/// the waiting one. At the position of a planned cut, a demand only cancels the waiting one. A new
/// length or piece of waste keeps the waiting cut; the request is rejected if this cut would not be
/// possible.
///
/// **Web that moves backwards.** If the web moves back, the cutter moves back along its motion,
/// over the last cut to the cut before that. It does not make a cut twice. If the web moves back
/// even further, the plan is lost.
///
/// m is the unit of the web, u that of the slave.
class CutPlan {
 public:
  enum class Phase : std::uint8_t {
    home,      ///< at rest at home
    approach,  ///< from home to the next cut
    cut,       ///< in the fixed motion after a cut: the next cut may still change
    link,      ///< to the next cut
    retreat,   ///< from a cut to home
  };

  static constexpr int most_planned = 1'000;  ///< planned cuts before a cut on demand

  /// Begins at the position `web`, m, with the cutter at home. The first cut is at web + first.
  CutPlan(std::shared_ptr<const CutTask> task, double web) noexcept;

  /// Returns the position of the slave (u) and its derivatives with respect to the web, and passes
  /// the cuts up to this position. The slave is at 0 at the first cut of a knife.
  Jet at(double web) noexcept;

  /// Sets the length of all pieces that begin at the next cut or later, m.
  CutAnswer set_length(double length) noexcept;
  /// Inserts a piece of waste of this length, m, which begins at the next cut.
  CutAnswer add_waste(double length) noexcept;
  /// Adds a cut at this position of the web, m.
  CutAnswer cut_at(double web) noexcept;
  /// Adds a cut at the next possible position, unless a planned cut comes first.
  CutAnswer cut_now() noexcept;
  /// Ends the plan: no cut comes after the committed one.
  void finish() noexcept;

  /// The next possible position of a cut, m; see (1) to (3).
  [[nodiscard]] double next_possible() const noexcept;
  [[nodiscard]] Phase phase() const noexcept { return now_.phase; }
  /// True if the cutter is in step with the web, around a cut.
  [[nodiscard]] bool in_sync() const noexcept;
  /// True if the web moved back beyond the cut before the last one.
  [[nodiscard]] bool lost() const noexcept { return lost_; }
  /// Number of cuts that were made.
  [[nodiscard]] std::int64_t cuts() const noexcept { return cuts_; }
  /// Position of the last cut, m; NaN: none.
  [[nodiscard]] double last_cut() const noexcept { return now_.from; }
  /// Position of the next planned cut, m; NaN: none.
  [[nodiscard]] double next_cut() const noexcept;
  [[nodiscard]] const CutTask& task() const noexcept { return *task_; }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  /// The motion between two cuts, or between a cut and home.
  struct Span {
    Phase phase = Phase::home;
    double from = none;  ///< position of the cut where it begins
    double to = none;    ///< position of the cut where it ends; NaN for home and retreat
  };
  /// The place in the list.
  struct Place {
    std::size_t next = 0;
    double length = 0;  ///< length of all pieces, instead of the list; 0: the list
    double waste = 0;   ///< a piece of waste that comes first; 0: none
  };
  double draw(Place& place) const noexcept;
  [[nodiscard]] Jet on(const Span& span, std::int64_t cuts, double web) const noexcept;
  bool pass(double web) noexcept;
  void make_cut() noexcept;
  void plan_next() noexcept;
  [[nodiscard]] double earliest_after(double cut) const noexcept;
  [[nodiscard]] bool may_take(double web) const noexcept;
  [[nodiscard]] CutAnswer piece_answer(double length) const noexcept;
  [[nodiscard]] CutAnswer demand_answer(double web, double cut, Place place) const noexcept;
  CutAnswer change(double Place::*piece, double length) noexcept;

  std::shared_ptr<const CutTask> task_;
  Span now_;
  Span before_;         // the motion up to now_.from
  Place place_;         // after the planned cut
  Place place_before_;  // before it was planned
  double planned_ = none;
  double demand_ = none;  // a cut on demand after the planned cut
  double web_ = 0;
  bool finished_ = false;
  bool lost_ = false;
  std::int64_t cuts_ = 0;
};

}  // namespace jounce
