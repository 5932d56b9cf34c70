// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jounce/cam/coupling/coupling.hpp"

namespace jounce {

/// The slave's motion over time for a given master motion, as a Signal: a coupling engaged at the
/// master's first instant, with its correction. Followed is the same for a cam alone.
///
///     const Engagement in = engage(coupling, slave, master.jet(master.start()), master.start());
///     const Coupled motion(coupling, in.engaged, master);
///     const Jet now = motion.jet(0.5);
///
/// Exact: its breaks are those of the master, of the cam where the master passes them, and of the
/// correction. It ends with the correction over time, if that is later than the master's end; the
/// master then rests at its end. A cam that runs once holds its end value, at rest.
class Coupled {
 public:
  Coupled(const Coupling& coupling, const Engaged& engaged, const Trajectory& master);

  [[nodiscard]] double start() const { return cam_.start(); }
  [[nodiscard]] double end() const { return cam_.end(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  [[nodiscard]] Motion at(double t, Side side = Side::right) const {
    return jounce::point<OverTime>(jet(t, side));
  }

  /// s, the time from which the slave stays on its cam; nullopt if the master ends before.
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
