// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jounce/cam/coupling/coupling.hpp"

namespace jounce {

/// The motion of a slave over time for a given motion of the master, as a Signal. The coupling
/// engages at the start of the master's motion and applies its correction. For a cam without
/// coupling, see Followed.
///
///     const Engagement in = engage(coupling, slave, master.jet(master.start()), master.start());
///     const Coupled motion(coupling, in.engaged, master);
///     const Jet now = motion.jet(0.5);
///
/// The motion is exact. Its breaks are the breaks of the master, the breaks of the correction, and
/// the instants at which the master passes a break of the cam. The motion ends when both the
/// master's motion and a correction over time have ended. If the correction ends later, the master
/// rests at its end position in the meantime. A cam that runs once holds its end value, at rest.
/// The constructor throws InputError like require_few_periods().
class Coupled {
 public:
  /// `engaged`: the result of engage() for this coupling and the start of `master`.
  Coupled(const Coupling& coupling, const Engaged& engaged, const Trajectory& master);

  [[nodiscard]] double start() const { return cam_.start(); }
  [[nodiscard]] double end() const { return cam_.end(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  /// Returns the position of the slave at t (s), and its derivatives with respect to time.
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  [[nodiscard]] Motion at(double t, Side side = Side::right) const {
    return jounce::point<OverTime>(jet(t, side));
  }

  /// Time (s) from which the slave stays on its cam; nullopt if the master's motion ends earlier.
  [[nodiscard]] std::optional<double> in_sync() const { return in_sync_; }

 private:
  void add_breaks(std::span<const double> breaks);

  Followed cam_;
  std::optional<Trajectory> over_time_;
  std::optional<Followed> over_master_;
  std::optional<double> in_sync_;
  std::vector<double> breaks_;
};

static_assert(Signal<Coupled>);

}  // namespace jounce
