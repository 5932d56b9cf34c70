// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "jounce/cam/design/runs.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/curve/signal.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The inverse of a cam where the slave moves in one direction: the master position (unit m) over
/// the slave position (unit u), a Signal.
///
///     const Inversion all = inverted(cam);              // rise, dwell, return
///     if (!all.report.ok()) { ... }                     // dwells and reversals of the slave
///     const Inverse& rise = all.branches[0];            // the caller chooses the branch
///     double master = rise.at(25).position;             // master at slave position 25
///     double ratio = rise.at(25).geo_velocity;          // m/u: master per slave
///
/// **Vocabulary.** A *branch* is the longest interval of the master on which the slave does not
/// reverse: a rise or a fall, or several with only dwells between them. Its interval, start() to
/// end(), is the slave's, ascending even for a fall; *breaks* are the slave positions at the cam's
/// breaks, at its points of rest and at its dwells.
///
/// **Derivatives** by the slave, from the inverse function's rule: `Transfer` in m/u, m/u^2, m/u^3.
/// If the slave is at rest (the end of a dwell, a turning point, an inflection with velocity zero),
/// the master has no finite derivative. All three results are then the infinities, with their
/// signs, approached from the requested side; never NaN.
///
/// **A dwell** inside a branch is a jump of the master: Side::left returns one end of it,
/// Side::right (the default) the other. **Outside** [start, end] a query is an error of the caller:
/// it asserts, and holds in a release build, as for a curve that rejects positions outside.
///
/// **Accuracy**: cam(inverse(u)) is u within 1e-12 of the stroke, or 1e-14 of the position if that
/// is more (beyond 100 strokes from zero), for a master up to 100 lengths from zero. No evaluation
/// allocates.
class Inverse {
 public:
  using Point = Transfer;

  /// `branch`: consecutive runs of `cam`, the first and the last of one kind, between them that
  /// kind and dwells.
  Inverse(std::shared_ptr<const Cam> cam, std::span<const CamRun> branch);

  [[nodiscard]] double start() const { return breaks_.front(); }
  [[nodiscard]] double end() const { return breaks_.back(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  [[nodiscard]] Jet jet(double slave, Side side = Side::right) const;
  [[nodiscard]] Transfer at(double slave, Side side = Side::right) const {
    return point<OverMaster>(jet(slave, side));
  }

  [[nodiscard]] bool rises() const { return rises_; }
  [[nodiscard]] double master_from() const { return master_from_; }  ///< < master_to()
  [[nodiscard]] double master_to() const { return master_to_; }
  [[nodiscard]] const Cam& cam() const { return *cam_; }

 private:
  /// The part of one segment, s0 < s1, over which the slave moves without rest.
  struct Piece {
    std::size_t segment = 0;
    double s0 = 0;
    double s1 = 1;
    double slave0 = 0;  ///< slave position at that end
    double slave1 = 0;
    bool rest0 = false;  ///< true if the slave is at rest at that end
    bool rest1 = false;
  };
  void add(const CamRun& run);

  std::shared_ptr<const Cam> cam_;
  bool rises_ = true;
  double master_from_ = 0;
  double master_to_ = 0;
  std::vector<Piece> pieces_;  // by ascending slave position: one between each two breaks
  std::vector<double> breaks_;
};

/// Every branch of a cam's inverse, and the reasons why there is not exactly one.
struct Inversion {
  std::vector<CamRun> runs;
  std::vector<Inverse> branches;  ///< in the order of the master; none if the slave never moves
  /// ok() if the cam is strictly monotone: then there is one branch, the inverse. Otherwise, in the
  /// order of the master, a finding for each interval on which the slave is at rest
  /// (`inverse/dwell`), moves against its first direction (`inverse/reversal`) or jumps
  /// (`inverse/jump`). where: the master position at its start, value: the slave position at its
  /// end, limit: the slave position at its start, advice: the master positions of both.
  Report report;

  /// Returns the branch that contains this master position, its dwells included; null if there is
  /// none.
  [[nodiscard]] const Inverse* branch_at(double master) const;
};

/// Inverts a cam over its interval [start, end] only. A periodic cam has the branches of one
/// period, and a motion across the wrap is two of them (rotate it with `phased` first). Never
/// throws for any motion of the slave.
Inversion inverted(const Cam& cam);

/// The inverse between two slave positions as a curve (a Cam over the slave), for tables, checks
/// and any function of a curve. It is within `tolerance` (unit of the master), with a certified
/// error, see jounce/profiles/curve/fitted.hpp. Throws InputError "slave" unless from < to lie
/// within the branch, or if the slave is at rest anywhere between them, ends included; "tolerance"
/// like polynomial_within.
Fitted<OverMaster> inverse_within(const Inverse& g, double from, double to, double tolerance);

static_assert(Signal<Inverse>);

}  // namespace jounce
