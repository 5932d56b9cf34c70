// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/controller_errors.hpp"

#include <array>
#include <charconv>
#include <string_view>

namespace jounce {
namespace {

constexpr std::array table{
    ControllerError{"PMC600", 600, "cam without tappets", "InputError track[1].track",
                    "thrown for options of a track that has no switch; a cam without switches and "
                    "without options is accepted"},
    ControllerError{"PMC600", 601, "tappet group above the maximum", "InputError switch[1].track",
                    "tracks are 1 to 32"},
    ControllerError{"PMC600", 602, "more than 32 accesses to one cam", "none",
                    "any number of axes may use one cam"},
    ControllerError{"PMC600", 625, "no cam selected", "Refusal table_missing",
                    "in the library, a Coupling always has a cam; an executor rejects the "
                    "arming of a table that is missing"},
    ControllerError{
        "PMC600", 626, "master outside the valid range", "CouplingStatus master_outside_cam",
        "for a cam with `outside = \"refuse\"`; with `\"hold\"`, the slave waits at the end value"},
    ControllerError{"PMC600", 627, "ramp-in needs velocity and acceleration",
                    "InputError velocity_diff",
                    "also `acceleration`; for a ramp over the master: `distance`"},
    ControllerError{"PMC600", 628, "master scaling wrong", "InputError master_scaling",
                    "must be greater than 0"},
    ControllerError{"PMC600", 629, "too many tappets active in one cycle", "SwitchStep lost",
                    "counts the edges beyond 32 in one step; the outputs stay correct"},
    ControllerError{"PMC600", 675, "GearIn: denominator 0", "InputError denominator",
                    "must be greater than 0"},
    ControllerError{"PMC600", 676, "GearIn: bad acceleration", "InputError acceleration",
                    "must be greater than 0, and finite"},
    ControllerError{"PMC600", 677, "GearIn: bad deceleration", "InputError deceleration",
                    "must not be negative; 0 takes the acceleration"},
    ControllerError{"PMC600", 678, "GearIn, CamIn: master enabled or disabled while coupled",
                    "CouplingStatus not_finite",
                    "a lost master is NaN; the slave keeps its position"},
    ControllerError{"PMC600", 679, "GearIn: bad jerk", "InputError jerk",
                    "must not be negative; with 0 the acceleration steps"},
    ControllerError{"PMC600", 750, "not a cam reference", "Refusal wrong_axis",
                    "the table is over time instead of over a master. In the library, this is a "
                    "compile error, because a curve over time has another type"},
    ControllerError{
        "PMC600", 751, "table does not cover the master's range", "InputError master",
        "thrown by the class `Followed` if the master leaves the interval of a cam with "
        "`outside = \"refuse\"`; an executor reports `Cause master_outside_cam`"},
    ControllerError{"PMC600", 752, "master range empty", "InputError segment",
                    "a cam needs at least one segment"},
    ControllerError{"PMC600", 753, "master minimum and maximum wrong",
                    "InputError segment[1].end.master",
                    "must be greater than that of the previous knot"},
    ControllerError{"PMC600", 754, "slave minimum and maximum wrong", "InputError position_min",
                    "position_min must not exceed position_max"},
    ControllerError{"PMC600", 775, "GearInPos: master changed direction while connecting",
                    "GearInPosStatus master_reversed",
                    "in each such cycle; an axis of the executor: Cause master_reversed"},
    ControllerError{"PMC600", 776, "GearInPos: reversal cannot be avoided",
                    "GearInPosStatus reversal_unavoidable",
                    "avoid_reversal on a modulo slave, for which five more turns do not suffice"},
    ControllerError{"PMC600", 777, "GearInPos: AvoidReversal on a linear axis",
                    "GearInPosStatus reversal_on_linear_axis",
                    "a linear slave cannot add turns: choose another start of the slave or master"},
    ControllerError{"HMPL", 0x1388, "engage window out of range", "InputError engage_window",
                    "from 0 to half of the cam"},
    ControllerError{"HMPL", 0x1389, "engage position outside the table",
                    "InputError engage_position", "must lie within the cam"},
    ControllerError{"HMPL", 0x138a, "master scale out of range", "InputError master_scaling",
                    "must be greater than 0"},
    ControllerError{"HMPL", 0x138b, "cam scale out of range", "InputError slave_scaling",
                    "must be greater than 0; mirror the cam for the other direction"},
    ControllerError{"HMPL", 0x138c, "table id out of range", "Refusal table_missing",
                    "tables are identified by their hash"},
    ControllerError{"HMPL", 0x138d, "disengage window out of range", "InputError disengage_window",
                    "from 0 to half of the cam"},
    ControllerError{"HMPL", 0x138e, "disengage position out of range",
                    "InputError disengage_position", "must lie within the cam"},
    ControllerError{"HMPL", 0x138f, "not while engaged", "Cause in_motion",
                    "a coupling is immutable; exchange() engages another one"},
    ControllerError{"HMPL", 0x1390, "bad start mode", "InputError coupling.start",
                    "in a spec; in a message of the stream: `bad_field`"},
    ControllerError{"HMPL", 0x1391, "bad move mode", "InputError periodic",
                    "in a spec; the cam itself is periodic or runs once"},
    ControllerError{"HMPL", 0x1392, "engagement failed, window too small",
                    "CouplingStatus window_missed",
                    "the master passed the engage position between two cycles, outside the window: "
                    "widen it, or give 0"},
    ControllerError{"HMPL", 0x1393, "termination in trajectory mode unsupported", "none",
                    "cam_out() ends any coupling"},
    ControllerError{"HMPL", 0x1394, "cam not enabled", "Cause not_enabled",
                    "enable the axis first"},
    ControllerError{"HMPL", 0x1395, "axis not in cam", "Cause not_armed",
                    "the library's cam_out() accepts any state of the slave, coupled or not"},
    ControllerError{"HMPL", 0x1396, "not disengaged", "Cause in_motion", "stop first"},
    ControllerError{"HMPL", 0x1397, "axis is in gear", "Cause in_motion",
                    "an axis runs one motion at a time"},
};

}  // namespace

std::span<const ControllerError> controller_errors() {
  return table;
}

std::string code_text(const ControllerError& error) {
  const bool hexadecimal = std::string_view(error.controller) == "HMPL";
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), error.code,
                                 hexadecimal ? 16 : 10);
  return (hexadecimal ? "0x" : "") + std::string(digits.data(), end.ptr);
}

std::string row(const ControllerError& error) {
  return std::string("| ") + error.controller + " | " + code_text(error) + " | " + error.meaning +
         " | " +
         (std::string_view(error.here) == "none" ? "cannot occur"
                                                 : "`" + std::string(error.here) + "`") +
         " | " + error.how + " |";
}

}  // namespace jounce
