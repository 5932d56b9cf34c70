// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <limits>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

void require_unit(const char* key, const std::string& given, const std::string& wanted,
                  const std::string& who) {
  const bool same = [&] {
    try {
      return conversion(given, wanted) == 1;
    } catch (const InputError&) {
      return false;
    }
  }();
  if (!same)
    throw InputError(std::string("units.") + key, '"' + given + '"',
                     "must be " + wanted + " for the profiles of " + who + ": give " + key +
                         " = \"" + wanted + "\" in units");
}

namespace {

void require_googol_units(const MotionFields& f) {
  require_unit("position", f.units().position, "pulse", "Googol");
  require_unit("time", f.units().x, "ms", "Googol");
}

std::optional<int> optional_int(TomlReader& reader, const char* key) {
  const auto value = reader.optional_whole(key);
  if (!value) return std::nullopt;
  if (*value < std::numeric_limits<std::int32_t>::min() ||
      *value > std::numeric_limits<std::int32_t>::max())
    reader.fail(key, std::to_string(*value), "must be from -2147483648 to 2147483647");
  return static_cast<int>(*value);
}

int int_or(TomlReader& reader, const char* key, int fallback) {
  return optional_int(reader, key).value_or(fallback);
}

// ---- HIMC ------------------------------------------------------------------------------------

himc::AxisProfile read_himc_axis(MotionFields& f) {
  require_unit("time", f.units().x, "s", "HIMC");
  himc::AxisProfile a;
  f.need("velocity", 1, a.velocity);
  f.may("acceleration", 2, a.acceleration);
  f.may_in("acceleration_time", "ms", a.acceleration_time);
  f.may("deceleration", 2, a.deceleration);
  f.may_in("deceleration_time", "ms", a.deceleration_time);
  f.may_in("smoothing_time", "ms", a.smoothing_time);
  f.may_in("velocity_scale", "1", a.velocity_scale);
  return a;
}

MoveSpec read_himc(MotionFields& f) {
  HimcMoveSpec s;
  f.may("from", 0, s.from);
  f.need("to", 0, s.to);
  s.axis = read_himc_axis(f);
  return s;
}

MoveSpec read_himc_velocity(MotionFields& f) {
  return HimcVelocitySpec{f.state("from"), int_or(f.reader(), "direction", 1), read_himc_axis(f)};
}

// ---- Googol ----------------------------------------------------------------------------------

template <class Command>
void read_googol_target(MotionFields& f, Command& m) {
  require_googol_units(f);
  f.may("from", 0, m.from);
  m.pos = f.reader().whole("pos");
  f.need("vel", 1, m.vel);
  f.need("acc", 2, m.acc);
  f.may("dec", 2, m.dec);
}

MoveSpec read_googol_trap(MotionFields& f) {
  googol::Trap m;
  read_googol_target(f, m);
  f.may("vel_start", 1, m.vel_start);
  m.smooth_time = int_or(f.reader(), "smooth_time", 0);
  return m;
}

MoveSpec read_googol_move_absolute(MotionFields& f) {
  googol::MoveAbsolute m;
  read_googol_target(f, m);
  m.percent = int_or(f.reader(), "percent", 0);
  return m;
}

MoveSpec read_googol_move_absolute_ex(MotionFields& f) {
  googol::MoveAbsoluteEx m;
  read_googol_target(f, m);
  m.percent = int_or(f.reader(), "percent", 0);
  f.may("vel_start", 1, m.vel_start);
  f.may("vel_end", 1, m.vel_end);
  m.acc_start_percent = int_or(f.reader(), "acc_start_percent", 0);
  m.dec_end_percent = int_or(f.reader(), "dec_end_percent", 0);
  return m;
}

MoveSpec read_googol_move_velocity(MotionFields& f) {
  require_googol_units(f);
  GoogolVelocitySpec s;
  s.from = f.state("from");
  f.need("vel", 1, s.move.vel);
  f.need("acc", 2, s.move.acc);
  f.may("dec", 2, s.move.dec);
  f.need("jerk_begin", 3, s.move.jerk_begin);
  f.need("jerk_end", 3, s.move.jerk_end);
  const std::vector<std::string> directions{"positive", "negative", "current"};
  if (const auto direction = f.reader().optional_choice("direction", directions))
    s.move.direction = static_cast<googol::Direction>(*direction);
  return s;
}

MoveSpec read_googol_jog(MotionFields& f) {
  require_googol_units(f);
  GoogolJogSpec s;
  f.may("from", 0, s.from);
  f.need("acc", 2, s.parameters.acc);
  f.may("dec", 2, s.parameters.dec);
  f.may_in("smooth", "1", s.parameters.smooth);
  for (TomlReader& each : f.reader().tables("velocities")) {
    MotionFields fields(each, f.units());
    googol::JogVelocity v;
    v.time = each.number("time", f.units().x);
    fields.need("vel", 1, v.vel);
    each.finish();
    s.velocities.push_back(v);
  }
  return s;
}

// ---- Agito -----------------------------------------------------------------------------------

std::optional<int> read_strokes(TomlReader& move) {
  const auto strokes = optional_int(move, "strokes");
  if (strokes && *strokes > 10'000)
    move.fail("strokes", std::to_string(*strokes), "must be at most 10000");
  return strokes;
}

agito::Settings read_agito_settings(MotionFields& f) {
  require_unit("time", f.units().x, "s", "Agito");
  agito::Settings s;
  f.need("accel", 2, s.accel);
  f.may("decel", 2, s.decel);
  f.need("speed", 1, s.speed);
  s.jerk = int_or(f.reader(), "jerk", 0);
  return s;
}

MoveSpec read_agito(MotionFields& f) {
  AgitoSpec s;
  f.may("from", 0, s.from);
  TomlReader& move = f.reader();
  s.target.abs_trgt = int_or(move, "abs_trgt", 0);
  s.target.rel_trgt = int_or(move, "rel_trgt", 0);
  if (move.has("rel_trgt") && s.target.rel_trgt == 0 && !move.has("abs_trgt"))
    move.fail("rel_trgt", "0", "must not be 0: there is no move");
  s.settings = read_agito_settings(f);
  s.strokes = read_strokes(move);
  f.may_in("rpt_wait", "ms", s.rpt_wait);
  if (!s.strokes && move.has("rpt_wait"))
    move.fail("rpt_wait", number(s.rpt_wait),
              "needs strokes, the number of repetitions: add it, or leave rpt_wait out");
  return s;
}

MoveSpec read_agito_quasi_sine(MotionFields& f) {
  require_unit("time", f.units().x, "s", "Agito");
  AgitoSineSpec s;
  f.may("from", 0, s.from);
  f.need("amplitude", 0, s.amplitude);
  s.frequency = f.reader().number("frequency", "Hz");
  s.strokes = read_strokes(f.reader()).value_or(s.strokes);
  f.may_in("rpt_wait", "ms", s.rpt_wait);
  return s;
}

MoveSpec read_agito_jog(MotionFields& f) {
  return AgitoJogSpec{f.state("from"), read_agito_settings(f)};
}

// ---- PMC600 ----------------------------------------------------------------------------------

const std::vector<std::string> velocity_modes{"trapezoid", "sigmoid", "sigmoid_limit", "quadratic"};

void read_mode(MotionFields& f, pmc600::VelocityMode& mode) {
  require_unit("time", f.units().x, "s", "PMC600");
  if (const auto given = f.reader().optional_choice("mode", velocity_modes))
    mode = static_cast<pmc600::VelocityMode>(*given);
}

MoveSpec read_pmc600(MotionFields& f) {
  Pmc600Spec s;
  f.may("from", 0, s.from);
  f.need("to", 0, s.to);
  f.need("velocity", 1, s.dynamics.velocity);
  f.need("acceleration", 2, s.dynamics.acceleration);
  f.may("deceleration", 2, s.dynamics.deceleration);
  f.may("jerk", 3, s.dynamics.jerk);
  read_mode(f, s.mode);
  return s;
}

MoveSpec read_pmc600_ls(MotionFields& f) {
  require_unit("time", f.units().x, "s", "PMC600");
  pmc600::LsMove m;
  f.may("from", 0, m.from);
  f.need("to", 0, m.to);
  f.need("velocity", 1, m.velocity);
  f.need("acceleration", 2, m.acceleration);
  f.may("deceleration", 2, m.deceleration);
  f.may("start_velocity", 1, m.start_velocity);
  f.may("end_second_velocity", 1, m.end_second_velocity);
  return m;
}

MoveSpec read_pmc600_ls_velocity(MotionFields& f) {
  require_unit("time", f.units().x, "s", "PMC600");
  Pmc600LsVelocitySpec s;
  f.may("from", 0, s.from);
  f.need("velocity", 1, s.velocity);
  f.need("acceleration", 2, s.acceleration);
  f.may("start_velocity", 1, s.start_velocity);
  return s;
}

/// Reads two numbers: one for the first move, and one for the second.
void read_both(MotionFields& f, const char* key, int order, std::array<double, 2>& values) {
  const std::string unit = rate_unit(f.units().position, f.units().x, order);
  const std::array units{unit, unit};
  const std::vector<double> given = f.reader().numbers(key, units);
  if (given.size() == 2) values = {given[0], given[1]};
}

MoveSpec read_pmc600_position_to_velocity(MotionFields& f) {
  pmc600::PositionToVelocity m;
  f.may("from", 0, m.from);
  m.relative = f.reader().optional_flag("relative").value_or(false);
  if (!f.reader().has("end_pos"))
    f.reader().fail("end_pos", "", "is missing: the motion needs its target position");
  read_both(f, "end_pos", 0, m.end_pos);
  read_both(f, "velocity", 1, m.velocity);
  read_both(f, "acceleration", 2, m.acceleration);
  read_both(f, "deceleration", 2, m.deceleration);
  read_both(f, "jerk", 3, m.jerk);
  read_mode(f, m.mode);
  return m;
}

MoveSpec read_pmc600_inch(MotionFields& f) {
  Pmc600InchSpec s;
  f.may("from", 0, s.from);
  f.need("distance", 0, s.distance);
  s.dynamics = read_dynamics(f);
  s.released = f.optional_time("released");
  return s;
}

MoveSpec read_pmc600_jog(MotionFields& f) {
  Pmc600JogSpec s;
  f.may("from", 0, s.from);
  s.dynamics = read_dynamics(f);
  s.max_velocity = f.optional("max_velocity", 1);
  for (TomlReader& each : f.reader().tables("inputs")) {
    s.inputs.push_back({each.number("time", f.units().x),
                        each.optional_flag("forward").value_or(false),
                        each.optional_flag("backward").value_or(false)});
    each.finish();
  }
  return s;
}

constexpr std::array controller_readers{
    ProfileReader{"himc", read_himc},
    ProfileReader{"himc_velocity", read_himc_velocity},
    ProfileReader{"googol_trap", read_googol_trap},
    ProfileReader{"googol_move_absolute", read_googol_move_absolute},
    ProfileReader{"googol_move_absolute_ex", read_googol_move_absolute_ex},
    ProfileReader{"googol_move_velocity", read_googol_move_velocity},
    ProfileReader{"googol_jog", read_googol_jog},
    ProfileReader{"agito", read_agito},
    ProfileReader{"agito_quasi_sine", read_agito_quasi_sine},
    ProfileReader{"agito_jog", read_agito_jog},
    ProfileReader{"pmc600", read_pmc600},
    ProfileReader{"pmc600_ls", read_pmc600_ls},
    ProfileReader{"pmc600_ls_velocity", read_pmc600_ls_velocity},
    ProfileReader{"pmc600_position_to_velocity", read_pmc600_position_to_velocity},
    ProfileReader{"pmc600_inch", read_pmc600_inch},
    ProfileReader{"pmc600_jog", read_pmc600_jog}};

}  // namespace

std::span<const ProfileReader> controller_profiles() {
  return controller_readers;
}

}  // namespace jounce::spec_detail
