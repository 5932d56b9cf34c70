// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/controller_errors.hpp"

#include <array>
#include <charconv>
#include <string_view>

namespace jounce {
namespace {

constexpr std::array table{
    ControllerError{
        "PMC600", 600, "cam without tappets", "InputError track[1].track",
        "options of a track without a switch; a cam without switches and options is accepted"},
    ControllerError{"PMC600", 601, "tappet group above the maximum", "InputError switch[1].track",
                    "tracks are 1 to 32"},
    ControllerError{"PMC600", 602, "more than 32 accesses to one cam", "none",
                    "a cam is a value: any number of axes may read it"},
    ControllerError{
        "PMC600", 625, "no cam selected", "Refusal table_missing",
        "in the library a Coupling has a Cam; an executor refuses to arm without its table"},
    ControllerError{
        "PMC600", 626, "master outside the valid range", "CouplingStatus master_outside_cam",
        "for a cam that rejects a master outside its range; a cam that holds waits there"},
    ControllerError{"PMC600", 627, "ramp-in needs velocity and acceleration",
                    "InputError velocity_diff", "likewise `acceleration`; over master `distance`"},
    ControllerError{"PMC600", 628, "master scaling wrong", "InputError master_scaling",
                    "must be greater than 0"},
    ControllerError{"PMC600", 629, "too many tappets active in one cycle", "SwitchStep lost",
                    "counts the edges beyond 32 in one step; the outputs stay correct"},
    ControllerError{"PMC600", 678, "master enabled or disabled while coupled",
                    "CouplingStatus not_finite",
                    "a lost master is NaN; the slave keeps its position"},
    ControllerError{"PMC600", 750, "not a cam reference", "Refusal wrong_axis",
                    "in the library, a curve over time has another type and does not compile"},
    ControllerError{"PMC600", 751, "table does not cover the master's range", "InputError master",
                    "Followed, for a master that leaves a cam that rejects this; an executor: "
                    "Cause master_outside_cam"},
    ControllerError{"PMC600", 752, "master range empty", "InputError segment",
                    "a cam has a segment"},
    ControllerError{"PMC600", 753, "master minimum and maximum wrong",
                    "InputError segment[1].end.master", "must be greater than the knot before"},
    ControllerError{"PMC600", 754, "slave minimum and maximum wrong", "InputError position_min",
                    "limits of the position, minimum above maximum"},
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
                    "in a spec; on the wire `bad_field`"},
    ControllerError{"HMPL", 0x1391, "bad move mode", "InputError periodic",
                    "in a spec; once or periodic is a property of the cam"},
    ControllerError{"HMPL", 0x1392, "engagement failed, window too small",
                    "CouplingStatus window_missed", "with a window of 0 no position is missed"},
    ControllerError{"HMPL", 0x1393, "termination in trajectory mode unsupported", "none",
                    "cam_out() ends any coupling"},
    ControllerError{"HMPL", 0x1394, "cam not enabled", "Cause not_enabled",
                    "enable the axis first"},
    ControllerError{"HMPL", 0x1395, "axis not in cam", "Cause not_armed",
                    "in the library cam_out() takes the slave's state, coupled or not"},
    ControllerError{"HMPL", 0x1396, "not disengaged", "Cause in_motion", "stop first"},
    ControllerError{"HMPL", 0x1397, "axis is in gear", "Cause in_motion",
                    "an axis plays one job at a time"},
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
