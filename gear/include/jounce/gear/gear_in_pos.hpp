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

/// A gear that engages at given positions of master and slave: MC_GearInPos (PLCopen; PMC600 manual
/// 6.1).
///
///     GearInPosSpec spec{.numerator = 1, .denominator = 2, .master_sync_position = 5000,
///                        .slave_sync_position = 2000, .master_start_distance = 4000};
///     const GearInPos gear = gear_in_pos(spec);                  // PMC600 example 6.2
///     if (!gear) ...                                        // explain(gear.status) has the reason
///     SyncCam cam = sync_cam(gear, 0, 10000);                    // segments hold, engage, gear
///     GearInPosState state;                                      // or cycle by cycle:
///     const GearInPosStep now = step(gear, state, master);       // now.slave, now.in_sync
///
/// Let S be the sync position of the master, D the start distance, y0 the present position and ys
/// the sync position of the slave, and k the ratio of the gear. While the master moves from S - D
/// to S, the slave moves from y0 to ys. The slave begins at rest with acceleration zero, and
/// arrives with the velocity of the gear and acceleration zero, so nothing steps. From then on it
/// is in step, even if the master moves back past S:
///
///     (1)  slave = ys + k (master - S)
///
/// With h = ys - y0, the shape of the curve depends only on rho = k D / h. The quintic (the
/// default) does not reverse if and only if 0 <= rho <= 5/2, and it does not exceed the velocity of
/// the gear if and only if rho >= 5/3. (Example 6.2 of the PMC600 manual has rho = 1, and a peak
/// slope of 0.756 instead of 0.5.) engage_window() returns the start distances that satisfy both
/// conditions.
///
/// u is the slave's unit, m the master's. The curve is a function of the master's position, so the
/// slave stands still whenever the master does.
struct GearInPosSpec {
  std::int64_t numerator = 1;       ///< k = numerator / denominator, u/m; any sign, not 0
  std::int64_t denominator = 1;     ///< > 0
  double master_sync_position = 0;  ///< S, m
  double slave_sync_position = 0;   ///< ys, u
  /// D, m, not 0. Positive: the master approaches S forwards; negative: backwards.
  double master_start_distance = 0;
  double slave_start = 0;  ///< y0, u: present position of the slave
  /// True: the slave must not reverse. A modulo slave then moves up to five turns further.
  bool avoid_reversal = false;
  /// u, > 0: period of a modulo slave; omitted: a linear slave.
  std::optional<double> slave_period = {};
  /// Present position of the master, m, to detect a master that has already passed the start.
  /// Omitted: the master is before the start.
  std::optional<double> master_position = {};
  /// Period of a modulo master, m, > 0. Such a master can engage in its next turn. Omitted: a
  /// linear master.
  std::optional<double> master_period = {};
  Law law = Law::quintic;  ///< law of the engagement: any law with G (constant velocity) among its
                           ///< ends (docs/laws.md)
};

/// Reasons why the gear does not engage. The values are error numbers of the PMC600 (manual,
/// appendix A-1).
enum class GearInPosStatus : std::uint16_t {
  ok = 0,
  master_reversed = 775,          ///< the master reversed while connecting
  reversal_unavoidable = 776,     ///< a modulo slave would reverse even with five more turns
  reversal_on_linear_axis = 777,  ///< avoid_reversal is set, and a linear slave would reverse
  /// A linear master has passed the start, so the slave waits. (Not an error number of the PMC600.)
  start_passed = 1000,
};
/// Returns one sentence that explains a status to a user.
const char* explain(GearInPosStatus status);

/// A computed engagement.
struct GearInPos {
  GearInPosStatus status = GearInPosStatus::ok;
  double ratio = 1;         ///< k, u/m
  double master_start = 0;  ///< S - D, m, in the turn in which the gear engages
  double master_sync = 0;   ///< S, m, in this turn
  double slave_start = 0;   ///< y0, u
  double slave_sync = 0;    ///< ys, u, including the added turns
  int turns = 0;  ///< signed number of turns of the slave that were added to avoid a reversal
  /// The cam of the engagement alone, with the policy outside `hold`; empty unless status is ok.
  std::optional<Cam> curve = {};
  explicit operator bool() const { return status == GearInPosStatus::ok; }
};

/// Computes the engagement. Throws InputError for a value out of range: "denominator" 0 or less
/// (PMC600 error 675), "numerator" 0, "master_start_distance" 0, a number that is not finite, a
/// period that is not positive, or a law that does not accept a velocity at its end.
GearInPos gear_in_pos(const GearInPosSpec& spec);

/// The start distances with which a quintic neither reverses nor exceeds the velocity of the gear:
/// magnitudes from 5/3 |h/k| to 5/2 |h/k|, with the sign of the given start distance.
struct EngageWindow {
  double rho = 0;                  ///< k D / h of the spec; infinite if h is 0
  bool exists = false;             ///< true if such start distances exist: rho > 0, and h is not 0
  double least = 0, greatest = 0;  ///< m, magnitudes of the start distances
  std::string advice = {};  ///< "" or a sentence: "a start distance of 6666.67 to 10000 instead of
                            ///< 4000 ..."
};
/// Returns the window for a spec, with advice on its start distance. Throws InputError like
/// gear_in_pos().
EngageWindow engage_window(const GearInPosSpec& spec);

/// Returns the slave over a master that moves from `from` to `to` (m): hold, engagement and gear.
/// Use it for checks, tables and plots. Requires status ok. The interval must contain the whole
/// engagement; otherwise throws InputError "master_start" or "master_end".
SyncCam sync_cam(const GearInPos& gear, double from, double to);

// ---- cycle by cycle ---------------------------------------------------------------------------

/// State from cycle to cycle.
struct GearInPosState {
  enum class Phase : std::uint8_t { waiting, connecting, in_sync };
  Phase phase = Phase::waiting;
  bool began = false;  ///< true after the first cycle
  double master = 0;   ///< m, position of the master in the previous cycle
};

/// Result of one cycle.
struct GearInPosStep {
  GearInPosState state = {};                     ///< for the next cycle
  Jet slave{};                                   ///< setpoint of the slave: u, u/s, u/s^2, u/s^3
  bool start_sync = false;                       ///< StartSync: true if the engagement has begun
  bool in_sync = false;                          ///< InSync: true if the slave is in step
  GearInPosStatus status = GearInPosStatus::ok;  ///< ok, master_reversed or start_passed
};

/// Computes one cycle of a valid engagement, for a master at [x, x', x'', x''']. A pure function;
/// does not allocate.
///
/// The slave stands still until the master passes the start in the engaging direction. If the
/// master moves back while connecting, the status is master_reversed (775) in each such cycle. The
/// slave then moves back along its curve, at most to its start, and engages when the master moves
/// forwards again. The caller need not act, and nothing steps. Once the slave is in step, (1) holds
/// for any motion of the master.
GearInPosStep step(const GearInPos& gear, const GearInPosState& state, const Jet& master);

/// The exact motion over time of a slave with a gear in position, for a known motion of the master.
/// It is a Signal.
///
///     const GearedInPos slave(gear, web);        // web: a Trajectory
///     Motion now = slave.at(0.5);
class GearedInPos {
 public:
  /// `gear`: a computed engagement with status ok. Throws InputError "master" if the master begins
  /// past the start of the engagement.
  GearedInPos(const GearInPos& gear, const Trajectory& master);

  [[nodiscard]] double start() const { return connecting_.start(); }
  [[nodiscard]] double end() const { return connecting_.end(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  /// Returns the position of the slave at t (s), and its derivatives with respect to time.
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  [[nodiscard]] Motion at(double t, Side side = Side::right) const {
    return point<OverTime>(jet(t, side));
  }
  /// Time (s) from which the slave is in step; nullopt if the master does not reach the sync
  /// position.
  [[nodiscard]] std::optional<double> in_sync() const { return in_sync_; }

 private:
  Followed connecting_;
  double ratio_, master_sync_, slave_sync_;
  std::optional<double> in_sync_;
  std::vector<double> breaks_;
};

static_assert(Signal<GearedInPos>);

}  // namespace jounce
