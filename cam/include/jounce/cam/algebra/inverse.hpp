// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "jounce/cam/design/runs.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/curve/signal.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The inverse of a cam on an interval where the slave does not reverse: the master position (unit
/// m) as a function of the slave position (unit u). It is a Signal.
///
///     const Inversion all = inverted(cam);              // rise, dwell, return
///     if (!all.report.ok()) { ... }                     // dwells and reversals of the slave
///     const Inverse& rise = all.branches[0];            // the caller chooses the branch
///     double master = rise.at(25).position;             // master at slave position 25
///     double ratio = rise.at(25).geo_velocity;          // m/u: master speed over slave speed
///
/// **Vocabulary.** A *branch* is a maximal interval of the master that begins and ends with motion
/// and on which the slave does not reverse: a rise or a fall, or several of one kind with dwells
/// between them. start() and end() are slave positions, ascending even for a fall. The *breaks* are
/// the slave positions at the cam's breaks, at points of rest and at dwells.
///
/// **Derivatives** with respect to the slave: `Transfer` in m/u, m/u^2, m/u^3. If the slave is at
/// rest (at the end of a dwell, at a reversal, or at an inflection with velocity zero), the
/// master has no finite derivative. All three results are then infinite, with the signs that they
/// approach from the requested side. They are never NaN.
///
/// **A dwell** inside a branch is a jump of the master: Side::left returns the master position at
/// one end of the dwell, Side::right (the default) returns the position at the other end.
/// **Outside** [start(), end()] a query is an error of the caller: it asserts in a debug build, and
/// holds in a release build.
///
/// **Accuracy.** cam(inverse(u)) equals u within 1e-12 of the stroke or 1e-14 of the position,
/// whichever is greater (1e-14 of the position is greater beyond 100 strokes from zero). This holds
/// for a master up to 100 lengths from zero. Evaluation never allocates.
class Inverse {
 public:
  using Point = Transfer;

  /// `branch`: consecutive runs of `cam` (runs.hpp). The first and the last have the same kind
  /// (rise or fall); the runs between them have this kind or are dwells.
  Inverse(std::shared_ptr<const Cam> cam, std::span<const CamRun> branch);

  [[nodiscard]] double start() const { return breaks_.front(); }
  [[nodiscard]] double end() const { return breaks_.back(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  /// Returns the master position and its derivatives at a slave position.
  [[nodiscard]] Jet jet(double slave, Side side = Side::right) const;
  [[nodiscard]] Transfer at(double slave, Side side = Side::right) const {
    return point<OverMaster>(jet(slave, side));
  }

  [[nodiscard]] bool rises() const { return rises_; }  ///< true for a rise, false for a fall
  /// Master position at the beginning of the branch; below master_to().
  [[nodiscard]] double master_from() const { return master_from_; }
  [[nodiscard]] double master_to() const { return master_to_; }  ///< master position at its end
  [[nodiscard]] const Cam& cam() const { return *cam_; }

 private:
  /// The part of one segment, from s0 to s1, over which the slave moves without rest.
  struct Piece {
    std::size_t segment = 0;
    double s0 = 0;
    double s1 = 1;
    double slave0 = 0;   ///< slave position at s0
    double slave1 = 0;   ///< slave position at s1
    bool rest0 = false;  ///< true if the slave is at rest at s0
    bool rest1 = false;  ///< true if the slave is at rest at s1
  };
  void add(const CamRun& run);

  std::shared_ptr<const Cam> cam_;
  bool rises_ = true;
  double master_from_ = 0;
  double master_to_ = 0;
  std::vector<Piece> pieces_;  // by ascending slave position: one between adjacent breaks
  std::vector<double> breaks_;
};

/// All branches of a cam's inverse, and a report on why there is not exactly one.
struct Inversion {
  std::vector<CamRun> runs = {};  ///< rises, dwells and falls of the cam (runs.hpp)
  std::vector<Inverse> branches =
      {};  ///< in the order of the master; none if the slave never moves
  /// ok() if the cam is strictly monotone; the single branch is then its inverse. Otherwise the
  /// report has findings in the order of the master: one for each interval on which the slave is at
  /// rest (`inverse/dwell`), moves against its first direction (`inverse/reversal`), or jumps
  /// (`inverse/jump`). In these findings, `where` is the master position at the start of the
  /// interval, `limit` the slave position at its start, `value` the slave position at its end; for
  /// a dwell or a reversal, `advice` names the master positions at the start and at the end of the
  /// interval.
  Report report = {};

  /// Returns the branch that contains this master position (also in a dwell inside the branch);
  /// null if no branch contains it.
  [[nodiscard]] const Inverse* branch_at(double master) const;
  /// Returns the master positions of the branches for a message: "0 to 120, 200 to 360".
  [[nodiscard]] std::string ranges_text() const;
};

/// Inverts a cam over its interval [start, end]. A periodic cam gives the branches of one period; a
/// rise or fall across the end of the period gives two branches (avoid this with phased() in
/// algebra.hpp). Does not throw, for any motion of the slave.
Inversion inverted(const Cam& cam);

/// Returns the inverse between two slave positions as a curve (a Cam over the slave's position), so
/// that tables, checks and all functions of curves apply. The error is at most `tolerance` (unit of
/// the master) and certified; see jounce/profiles/curve/fitted.hpp. Throws InputError "from" or
/// "to" if from >= to or if [from, to] is not inside the branch, and "slave" if the slave is at
/// rest anywhere in [from, to]. Throws "tolerance" like polynomial_within().
Fitted<OverMaster> inverse_within(const Inverse& g, double from, double to, double tolerance);

static_assert(Signal<Inverse>);

}  // namespace jounce
