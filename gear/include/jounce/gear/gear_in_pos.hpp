// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// A gear that is engaged at given positions: MC_GearInPos (PLCopen; PMC600 manual 6.1).
///
///     GearInPosSpec spec{.numerator = 1, .denominator = 2, .master_sync_position = 5000,
///                        .slave_sync_position = 2000, .master_start_distance = 4000};
///     const GearInPos gear = gear_in_pos(spec);                  // example 6.2
///     if (!gear) ...                                             // explain(gear.status)
///     SyncCam cam = sync_cam(gear, 0, 10000);                    // hold, engage, gear
///     GearInPosState state;                                      // or cycle by cycle:
///     const GearInPosStep now = step(gear, state, master);       // now.slave, now.in_sync
///
/// From master S - D to S (S the sync position, D the start distance) the slave moves from its
/// present position y0 to its sync position ys. It begins at rest without acceleration, and arrives
/// with the gear's ratio k and without acceleration: nothing steps at either end. Then it is
/// geared:
///
///     (1)  slave = ys + k (master - S)
///
/// This holds permanently, even if the master comes back past S. With h = ys - y0 the curve depends
/// only on rho = k D / h: the quintic (the default) does not reverse if and only if 0 <= rho <=
/// 5/2, and is not faster than the gear if and only if rho >= 5/3 (example 6.2: rho = 1, peak slope
/// 0.756 instead of 0.5). engage_window() returns the start distances that satisfy both.
///
/// u is the slave's unit, m the master's. Nothing here is over time: the curve stands still when the
/// master does.
struct GearInPosSpec {
  std::int64_t numerator = 1;       ///< k = numerator / denominator, u/m; of either sign, not 0
  std::int64_t denominator = 1;     ///< > 0
  double master_sync_position = 0;  ///< S, m
  double slave_sync_position = 0;   ///< ys, u
  /// D, m, not 0: > 0 for a master that comes forwards, < 0 for one that comes backwards.
  double master_start_distance = 0;
  double slave_start = 0;  ///< y0, u: present position of the slave
  /// The slave must not reverse. A modulo slave moves up to five turns further instead.
  bool avoid_reversal = false;
  std::optional<double> slave_period = {};  ///< u, > 0, for a modulo slave; omitted: linear
  /// m, present position of the master, to detect a master that has passed the start; omitted: not
  /// yet there.
  std::optional<double> master_position = {};
  /// m, > 0, for a modulo master, which then takes the next turn; omitted: linear.
  std::optional<double> master_period = {};
  Law law = Law::quintic;  ///< any that takes a velocity at its end: docs/laws.md, "G or R"
};

/// Numbers of the errors of the PMC600 (manual, appendix A-1).
enum class GearInPosStatus : std::uint16_t {
  ok = 0,
  master_reversed = 775,          ///< it changed direction while connecting
  reversal_unavoidable = 776,     ///< for a modulo slave, within five more turns
  reversal_on_linear_axis = 777,  ///< AvoidReversal is set, and a linear slave would reverse
  start_passed = 1000,            ///< ours: a linear master has passed the start; the slave waits
};
const char* explain(GearInPosStatus status);

struct GearInPos {
  GearInPosStatus status = GearInPosStatus::ok;
  double ratio = 1;               ///< k, u/m
  double master_start = 0;        ///< S - D, m, in the turn that is taken
  double master_sync = 0;         ///< S, m, likewise
  double slave_start = 0;         ///< y0, u
  double slave_sync = 0;          ///< ys, u, with the turns that the slave goes further
  int turns = 0;                  ///< turns of the slave, added to avoid a reversal; of either sign
  std::optional<Cam> curve = {};  ///< the engagement alone, holding outside; none unless ok
  explicit operator bool() const { return status == GearInPosStatus::ok; }
};

/// Throws InputError for values out of range: "denominator" 0 or less (PMC600 error 675), "numerator" 0,
/// "master_start_distance" 0, a period that is not > 0, a law that does not take a velocity at its end.
GearInPos gear_in_pos(const GearInPosSpec& spec);

/// rho of the engagement, and the start distances, in the direction of the given one, for which a
/// quintic does not reverse or exceed the speed of the gear: 5/3 h/k to 5/2 h/k.
struct EngageWindow {
  double rho = 0;                  ///< k D / h; infinite if h is 0
  bool exists = false;             ///< rho > 0: with a start distance alone it can be had
  double least = 0, greatest = 0;  ///< m, magnitudes
  std::string advice;  ///< "a start distance of 6666.67 to 10000 instead of 4000 ...", or ""
};
EngageWindow engage_window(const GearInPosSpec& spec);

/// Hold, engagement and gear over the master from `from` to `to`, for checks, tables and plots of a
/// master that goes one way. Throws InputError "master_start", "master_end" unless from < to and both
/// lie outside the engagement (or at its ends).
SyncCam sync_cam(const GearInPos& gear, double from, double to);

// ---- cycle by cycle ---------------------------------------------------------------------------

struct GearInPosState {
  enum class Phase : std::uint8_t { waiting, connecting, in_sync };
  Phase phase = Phase::waiting;
  bool began = false;  ///< a first cycle has been
  double master = 0;   ///< m, of the cycle before
};

struct GearInPosStep {
  GearInPosState state;     ///< for the next cycle
  Jet slave{};              ///< the set-point: u, u/s, u/s^2, u/s^3
  bool start_sync = false;  ///< StartSync: the engagement has begun
  bool in_sync = false;     ///< InSync
  GearInPosStatus status =
      GearInPosStatus::ok;  ///< status of this cycle: master_reversed, start_passed
};

/// One cycle of a valid engagement, for a master that moves as [x, x', x'', x''']. Pure, does not
/// allocate.
///
/// The slave stands still until the master passes the start in the engaging direction. A master
/// that reverses while connecting is reported in each cycle in which it moves back (775). The slave
/// moves back along its curve, to its start, and engages when the master moves forward again:
/// without a step, and without an action of the caller in that cycle. Once in sync, (1) holds for
/// any motion of the master.
GearInPosStep step(const GearInPos& gear, const GearInPosState& state, const Jet& master);

/// The slave's exact motion behind a known master: a Signal.
///
///     const GearedInPos slave(gear, master);     // master: a Trajectory
///     Motion now = slave.at(0.5);
class GearedInPos {
 public:
  GearedInPos(const GearInPos& gear, const Trajectory& master);

  [[nodiscard]] double start() const { return connecting_.start(); }
  [[nodiscard]] double end() const { return connecting_.end(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  [[nodiscard]] Motion at(double t, Side side = Side::right) const {
    return point<OverTime>(jet(t, side));
  }
  /// s; nothing if the master never gets there.
  [[nodiscard]] std::optional<double> in_sync() const { return in_sync_; }

 private:
  Followed connecting_;
  double ratio_, master_sync_, slave_sync_;
  std::optional<double> in_sync_;
  std::vector<double> breaks_;
};

static_assert(Signal<GearedInPos>);

}  // namespace jounce
