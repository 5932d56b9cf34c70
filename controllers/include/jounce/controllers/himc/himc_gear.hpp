// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

/// Gear pairs of a HIWIN HIMC controller, in HMPL's words and order: EnableGear, GearIn, GearOut,
/// DisableGear. HMPL manual, chapter 6 and 18.1.2.
///
///     himc::Gears gears;
///     gears.axis[0].enabled = gears.axis[1].enabled = true;
///     himc::GearAnswer done = himc::enable_gear(gears, 0, 1);         // done.error, done.gears
///     done = himc::gear_in(done.gears, 0, 1, 2.0, 0, 0);              // both at 0
///     double slave = himc::gear_position(done.gears, 1, 100);         // 200
namespace jounce::himc {

inline constexpr int axis_count = 16;

/// The low 16 bits of the code; the high ones are 0x83aa, aa the axis.
enum class GearError : std::uint16_t {
  ok = 0,
  disabled = 0x0078,      ///< an axis of the pair is not enabled
  synchronised = 0x00a0,  ///< DisableGear while engaged: GearOut first
  is_master = 0x00aa,     ///< a gear master cannot become a slave: there are no chains
  bad_link = 0x01c2,      ///< not an axis, the axis itself, a slave as master, another's slave
  bad_slave = 0x01cc,     ///< the slave is not an axis
  bad_ratio = 0x01d6,     ///< 0 or not finite
  not_enabled = 0x0fa0,   ///< GearIn, GearOut, DisableGear without EnableGear
  in_cam = 0x0fa1,        ///< the slave follows a cam
};
const char* explain(GearError error);

struct GearAxis {
  bool enabled = false;  ///< powered
  bool in_cam = false;
  std::optional<int> master = {};  ///< master of the pair that EnableGear made
  bool engaged = false;            ///< GearIn
  double ratio = 0;                ///< mm or deg a mm or deg of the master's; kept after GearOut
  double master_origin = 0;        ///< positions at GearIn
  double slave_origin = 0;
};

/// All axes: a small value.
struct Gears {
  std::array<GearAxis, axis_count> axis{};
};

/// Result of a call; unchanged if it is rejected.
struct GearAnswer {
  Gears gears;
  GearError error = GearError::ok;
};

/// Several slaves may have one master. A slave has one master and is the master of no axis.
/// Enabling the same pair again is not an error.
GearAnswer enable_gear(const Gears& gears, int master, int slave);

/// Engages at the command positions of both axes, or changes the ratio (from those on). There is no
/// ramp: with a master in motion the slave's velocity steps.
GearAnswer gear_in(const Gears& gears, int master, int slave, double ratio, double master_position,
                   double slave_position);

/// The slave keeps its velocity. For a slave that is not engaged: no effect, no error.
GearAnswer gear_out(const Gears& gears, int slave);

/// Dissolves the pair. Refused while engaged: the slave would continue without a command.
GearAnswer disable_gear(const Gears& gears, int slave);

/// GetGearRatio; 0 without a gear. Here and below: 0 or false for a number that is not an axis.
double gear_ratio(const Gears& gears, int slave);
bool is_in_gear(const Gears& gears, int slave);
bool is_gear_master(const Gears& gears, int axis);
bool is_gear_slave(const Gears& gears, int axis);

/// Position of an engaged slave for a command position of the master: from both positions at GearIn, so
/// nothing drifts.
double gear_position(const Gears& gears, int slave, double master_position);

}  // namespace jounce::himc
