// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

MoveSpec read_trapezoid(MotionFields& f) {
  TrapezoidSpec t;
  f.may("from", 0, t.from);
  f.need("to", 0, t.to);
  f.need_positive("velocity", 1, t.velocity);
  f.need_positive("acceleration", 2, t.acceleration);
  f.may("deceleration", 2, t.deceleration);
  return t;
}

/// Reads the jerk, or the parameter that some controllers use instead: the time in which the
/// acceleration increases from 0. In each half, jerk = acceleration / smoothing (Googol smoothTime,
/// HMPL SetSmoothTime).
void read_jerk(MotionFields& f, SCurveSpec& s) {
  TomlReader& move = f.reader();
  const auto jerk = move.optional_positive("jerk", f.unit(3));
  const auto smoothing = move.optional_positive("smoothing", f.units().x);
  const auto deceleration_jerk = move.optional_positive("deceleration_jerk", f.unit(3));
  if (jerk.has_value() == smoothing.has_value())
    move.fail("jerk", "",
              jerk ? "cannot be combined with smoothing: give one of the two"
                   : "is missing: add jerk = NUMBER, or smoothing = \"50 ms\", the "
                     "rise time of the acceleration");
  if (smoothing) {
    if (deceleration_jerk)
      move.fail("deceleration_jerk", number(*deceleration_jerk), "needs jerk instead of smoothing");
    s.jerk = s.acceleration / *smoothing;
    s.deceleration_jerk = (s.deceleration == 0 ? s.acceleration : s.deceleration) / *smoothing;
  } else {
    s.jerk = *jerk;
    s.deceleration_jerk = deceleration_jerk.value_or(0);
  }
}

MoveSpec read_s_curve(MotionFields& f) {
  const auto t = std::get<TrapezoidSpec>(read_trapezoid(f));
  SCurveSpec s{t.from, t.to, t.velocity, t.acceleration, t.deceleration, 0, 0};
  read_jerk(f, s);
  return s;
}

MoveSpec read_fourth_order(MotionFields& f) {
  FourthOrderSpec s;
  f.may("from", 0, s.from);
  f.need("to", 0, s.to);
  f.need_positive("velocity", 1, s.velocity);
  f.need_positive("acceleration", 2, s.acceleration);
  f.need_positive("jerk", 3, s.jerk);
  f.need_positive("jounce", 4, s.jounce);
  return s;
}

constexpr std::array directions{Direction::negative, Direction::shortest, Direction::positive,
                                Direction::current, Direction::fastest};
const std::vector<std::string> direction_names{"negative", "shortest", "positive", "current",
                                               "fastest"};

MoveSpec read_point_to_point(MotionFields& f) {
  PointToPointSpec s;
  TomlReader& move = f.reader();
  s.from = f.state("from");
  (void)move.number("to", f.units().position);  // required
  s.to = f.state("to");
  s.bounds = f.bounds();
  s.duration = f.optional_time("duration");
  if (s.duration && !(*s.duration > 0))
    move.fail("duration", number(*s.duration), "must be greater than 0");
  s.period = f.optional("period", 0);
  s.direction = read_direction(move, s.period.has_value());
  return s;
}

MoveSpec read_velocity(MotionFields& f) {
  VelocitySpec s;
  s.from = f.state("from");
  f.need("to_velocity", 1, s.velocity);
  f.may("to_acceleration", 2, s.acceleration);
  s.bounds = f.bounds();
  return s;
}

constexpr std::array general{
    ProfileReader{"trapezoid", read_trapezoid}, ProfileReader{"s_curve", read_s_curve},
    ProfileReader{"fourth_order", read_fourth_order},
    ProfileReader{"point_to_point", read_point_to_point}, ProfileReader{"velocity", read_velocity}};

/// Applies `period` and `direction` to a move from rest to a target, of any profile.
void read_period(MotionFields& f, MoveSpec& spec) {
  const auto period = f.optional("period", 0);
  TomlReader& move = f.reader();
  if (!period) return;
  const Direction direction = read_direction(move, true);
  std::visit(
      [&](auto& s) {
        const auto turned = [&](const char* key, double from, double to) {
          return turned_target(move, key, {.position = from}, to, direction, *period);
        };
        if constexpr (requires { s.from + s.to; }) {
          s.to = turned("to", s.from, s.to);
        } else if constexpr (requires { s.from + static_cast<double>(s.pos); }) {
          const double target = turned("pos", s.from, static_cast<double>(s.pos));
          s.pos = std::llround(target);
          if (static_cast<double>(s.pos) != target)
            move.fail("period", number(*period), "must lead to a whole number of pulses");
        } else {
          move.fail("period", number(*period),
                    "applies to a move to one target position only: leave it out");
        }
      },
      spec);
}

}  // namespace

Direction read_direction(TomlReader& move, bool modulo) {
  const auto direction = move.optional_choice("direction", direction_names);
  if (!direction) return Direction::shortest;
  if (!modulo)
    move.fail("direction", '"' + direction_names[*direction] + '"',
              "needs period, because only a modulo axis has a choice of direction: add period, "
              "or leave direction out");
  return directions[*direction];
}

double turned_target(TomlReader& move, const char* key, const MotionState& from, double to,
                     Direction direction, double period, const Bounds& bounds) {
  try {
    const ModuloTarget target = modulo_target(from, to, direction, period, bounds);
    if (target.status == MoveStatus::ok) return target.position;
    move.fail(key, number(to), explain(target.status));
  } catch (const InputError& error) {
    move.fail(error.key().c_str(), error.value(), error.rule());
  }
}

std::span<const ProfileReader> general_profiles() {
  return general;
}

MoveSpec read_move(TomlReader move, const Units& units) {
  std::vector<ProfileReader> all(general.begin(), general.end());
  for (const ProfileReader& reader : controller_profiles()) all.push_back(reader);
  const std::vector<std::string> names = [&] {
    std::vector<std::string> each;
    for (const ProfileReader& reader : all) each.emplace_back(reader.name);
    return each;
  }();
  MotionFields fields(move, units);
  MoveSpec spec = all[move.variant("profile", names)].read(fields);
  if (!std::holds_alternative<PointToPointSpec>(spec)) read_period(fields, spec);
  move.finish();
  return spec;
}

Dynamics read_dynamics(MotionFields& f, bool with_velocity) {
  Dynamics d;
  if (with_velocity) f.need("velocity", 1, d.velocity);
  f.need("acceleration", 2, d.acceleration);
  f.may("deceleration", 2, d.deceleration);
  f.may("jerk", 3, d.jerk);
  f.may("deceleration_jerk", 3, d.deceleration_jerk);
  return d;
}

}  // namespace jounce::spec_detail
