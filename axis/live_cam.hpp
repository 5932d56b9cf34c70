#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/cam/coupling_cycle.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// MC_CamIn on the axis's live master: a cam table behind whatever the master does.
///
///     LiveCam cam(7, table, {.start = StartMode::ramp_in, .velocity_diff = 100,
///                            .acceleration = 2000});
///     if (const Cause no = cam.begin(axis, now); no != Cause::none) ...    // would_reverse, ...
///     const Setpoint point = cam.at(now);                                  // every cycle
///
/// A table that wraps or advances is periodic; one that holds or refuses runs once. Start modes,
/// scaling, offsets, jumps of the master: cam/coupling.hpp, cam/coupling_cycle.hpp. In sync, setpoints
/// are bit for bit placed() of the table.
///
/// **Progress**: `engaging` while anything is left of a correction, then `running`; a cam that has
/// run once is `done`, in the very tick. Where it ends moving the last setpoints go on at its velocity,
/// as the PMC600 and PLCopen leave the slave: the axis keeps it until its next command.
/// `broken`: the master is lost (NaN), or jumped and no correction could take that up.
class LiveCam final : public Movement {
 public:
  /// Throws InputError for a table that is not over master, and a bad coupling.
  LiveCam(std::uint64_t id, std::shared_ptr<const Table> cam, const CouplingSpec& spec = {});

  /// no_master_input, master_outside_cam, would_reverse, master_stands, no_ramp; start_position: it
  /// starts at once (absolute, relative), and the axis does not stand on the cam.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }

  /// EndOfProfile: ends of the cam passed since it began, backwards counted down.
  [[nodiscard]] std::int64_t periods() const noexcept { return periods_; }

 private:
  Setpoint break_off(Cause cause) noexcept;

  std::shared_ptr<const Table> table_;
  Coupling coupling_;
  Engaged engaged_;
  std::optional<Released> released_;
  std::int64_t periods_ = 0;
  Progress progress_ = Progress::engaging;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

/// Why a coupling could not be engaged, in the axis's words.
Cause cause_of(CouplingStatus status);

}  // namespace jounce
