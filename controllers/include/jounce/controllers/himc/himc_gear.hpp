// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

/// Gear pairs of a HIWIN HIMC controller, with the functions of HMPL, the controller's language:
/// EnableGear, GearIn, GearOut, DisableGear (HMPL manual, chapter 6 and 18.1.2). Positions are in
/// the unit of their axis.
///
///     himc::Gears gears;
///     gears.axis[0].enabled = gears.axis[1].enabled = true;
///     himc::GearAnswer done = himc::enable_gear(gears, 0, 1);         // done.error, done.gears
///     done = himc::gear_in(done.gears, 0, 1, 2.0, 0, 0);              // both at 0
///     double slave = himc::gear_position(done.gears, 1, 100);         // 200
namespace jounce::himc {

inline constexpr int axis_count = 16;  ///< number of axes of a controller; axes are 0 to 15

/// Error of a gear function: the low 16 bits of the controller's error code. The high 16 bits are
/// 0x83aa, where aa is the axis.
enum class GearError : std::uint16_t {
  ok = 0,
  disabled = 0x0078,      ///< an axis of the pair is not enabled
  synchronized = 0x00a0,  ///< DisableGear while the gear is engaged: call GearOut first
  is_master = 0x00aa,     ///< the slave is the master of another gear: HIMC does not permit chains
  /// The master is not an axis, is the slave itself, or is the slave of another gear; or the slave
  /// already has another master.
  bad_link = 0x01c2,
  bad_slave = 0x01cc,    ///< the slave is not an axis
  bad_ratio = 0x01d6,    ///< the ratio is 0 or not finite
  not_enabled = 0x0fa0,  ///< GearIn, GearOut or DisableGear without EnableGear
  in_cam = 0x0fa1,       ///< the slave follows a cam
};
/// Returns one sentence that describes the error.
const char* explain(GearError error);

/// Gear state of one axis.
struct GearAxis {
  bool enabled = false;            ///< true if the axis is powered
  bool in_cam = false;             ///< true if the axis follows a cam
  std::optional<int> master = {};  ///< the master, after EnableGear; nullopt: none
  bool engaged = false;            ///< true after GearIn
  double ratio = 0;                ///< slave travel divided by master travel; kept after GearOut
  double master_origin = 0;        ///< position of the master at GearIn
  double slave_origin = 0;         ///< position of the slave at GearIn
};

/// Gear states of all axes: a value type.
struct Gears {
  std::array<GearAxis, axis_count> axis{};
};

/// Result of a function: the new states, or the unchanged states and an error.
struct GearAnswer {
  Gears gears = {};                 ///< states after the call
  GearError error = GearError::ok;  ///< ok: no error
};

/// EnableGear: makes a pair. A master may have several slaves. A slave has one master and cannot be
/// a master. To enable the same pair again is not an error.
GearAnswer enable_gear(const Gears& gears, int master, int slave);

/// GearIn: engages at the given command positions of both axes, or changes the ratio from these
/// positions on. The gear has no ramp: if the master moves, the velocity of the slave steps.
GearAnswer gear_in(const Gears& gears, int master, int slave, double ratio, double master_position,
                   double slave_position);

/// GearOut: releases the slave, which keeps its velocity. If the slave is not engaged, has no
/// effect and returns no error.
GearAnswer gear_out(const Gears& gears, int slave);

/// DisableGear: dissolves the pair. Returns an error while the gear is engaged, because the slave
/// would then continue without a command.
GearAnswer disable_gear(const Gears& gears, int slave);

/// GetGearRatio: returns the ratio; 0 without a gear. This function and the next three functions
/// return 0 or false for a number that is not an axis.
double gear_ratio(const Gears& gears, int slave);
/// True if the slave is engaged.
bool is_in_gear(const Gears& gears, int slave);
/// True if the axis is the master of a pair.
bool is_gear_master(const Gears& gears, int axis);
/// True if the axis is the slave of a pair.
bool is_gear_slave(const Gears& gears, int axis);

/// Returns the position of an engaged slave for a command position of the master. The function
/// computes it from the positions at GearIn, so the slave does not drift.
double gear_position(const Gears& gears, int slave, double master_position);

}  // namespace jounce::himc
