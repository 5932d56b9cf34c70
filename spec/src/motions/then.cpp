// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <vector>

#include "jounce/controllers/himc/himc.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

/// Throws InputError if the controller that the operator names does not accept the filter.
template <class Require>
void require_of_himc(TomlReader& then, const Require& require) {
  try {
    require();
  } catch (const InputError& error) {
    then.fail(error.key().c_str(), error.value(), error.rule());
  }
}

Operator read_moving_average(MotionFields& f) {
  return MovingAverageSpec{f.reader().number("window", f.units().x)};
}

Operator read_shaper(MotionFields& f) {
  const std::vector<std::string> kinds{"zv", "zvd", "ei"};
  TomlReader& then = f.reader();
  ShaperSpec s;
  s.kind = static_cast<ShaperKind>(then.choice("kind", kinds));
  s.mode.frequency = then.number("frequency", "Hz");
  f.may_in("damping", "1", s.mode.damping);
  if (s.kind == ShaperKind::ei) f.may_in("tolerance", "1", s.tolerance);
  const std::vector<std::string> controllers{"himc", "himc_group"};
  if (const auto of = then.optional_choice("controller", controllers))
    require_of_himc(then, [&] { himc::require_in_shape(s, static_cast<himc::FilterOf>(*of)); });
  return s;
}

Operator read_notch(MotionFields& f) {
  NotchSpec s;
  s.frequency = f.reader().number("frequency", "Hz");
  f.may_in("damping", "1", s.damping);
  f.may_in("mode_damping", "1", s.mode_damping);
  f.may_in("settled", "1", s.settled);
  const std::vector<std::string> controllers{"himc"};
  if (f.reader().optional_choice("controller", controllers))
    require_of_himc(f.reader(), [&] { himc::require_vsf(s); });
  return s;
}

Operator read_retime(MotionFields&) {
  return RetimeSpec{};
}

Operator read_override(MotionFields& f) {
  OverrideSpec s;
  f.may_in("factor", "1", s.factor);
  f.may_in("maximum", "1", s.maximum);
  for (TomlReader& each : f.reader().tables("request")) {
    s.requests.push_back({each.number("time", f.units().x), each.number("factor", "1")});
    each.finish();
  }
  return s;
}

ChangeSpec read_change(MotionFields& f, ChangeSpec::To to) {
  ChangeSpec c{.to = to};
  c.past = f.reader().optional_number("past", f.units().position);
  if (c.past && f.reader().has("time"))
    f.reader().fail("past", number(*c.past), "replaces time: leave out one of the two");
  if (!c.past) c.time = f.reader().number("time", f.units().x);
  c.dynamics = read_dynamics(f, to != ChangeSpec::To::velocity);
  return c;
}

Operator read_new_target(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::target);
  f.need("to", 0, c.value);
  return c;
}

Operator read_new_velocity(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::velocity);
  f.need("velocity", 1, c.value);
  return c;
}

Operator read_move_additive(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::additive);
  f.need("distance", 0, c.value);
  return c;
}

Operator read_move_superimposed(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::superimposed);
  f.need("distance", 0, c.value);
  c.abort = f.optional_time("abort");
  return c;
}

/// The unit of the axis of this name; without a name, the unit of the only axis, or of the spec.
const std::string& unit_of(const std::string& axis, std::span<const AxisPart> parts) {
  const auto named = std::find_if(parts.begin(), parts.end(),
                                  [&](const AxisPart& part) { return part.name == axis; });
  return (named == parts.end() ? parts.front() : *named).units.position;
}

/// Reads values in the unit of the corrected axis, and the grid in the units of its references.
Operator read_compensation(MotionFields& f, std::span<const AxisPart> parts) {
  TomlReader& then = f.reader();
  CompensateSpec s;
  s.axis = then.optional_text("axis").value_or("");
  const std::string& unit = unit_of(s.axis, parts);
  s.tolerance = then.optional_number("tolerance", unit);
  s.table = read_correction_grid(then, unit, [&](TomlReader& reference) {
    s.references.push_back(reference.optional_text("axis").value_or(""));
    return unit_of(s.references.back().empty() ? s.axis : s.references.back(), parts);
  });
  return s;
}

/// HIMC filters a motion by InShape or by the VSF, once (HMPL manual 15.1). `active`: the operator
/// with a controller so far; "": none.
void require_one_himc_filter(TomlReader& then, const std::string& name, std::string& active) {
  if (!then.has("controller") || (name != "shaper" && name != "notch")) return;
  const auto filter = [](const std::string& of) { return of == "shaper" ? "InShape" : "the VSF"; };
  if (!active.empty())
    then.fail("controller", "",
              std::string("is a second filter of HIMC: ") + filter(active) +
                  " is active, and excludes " + (active == name ? "a second one" : filter(name)) +
                  " (error 0x83aa00c8): keep one of the two");
  active = name;
}

struct OperatorReader {
  const char* name;
  Operator (*read)(MotionFields& fields);
};
constexpr std::array operators{OperatorReader{"moving_average", read_moving_average},
                               OperatorReader{"shaper", read_shaper},
                               OperatorReader{"notch", read_notch},
                               OperatorReader{"retime", read_retime},
                               OperatorReader{"override", read_override},
                               OperatorReader{"new_target", read_new_target},
                               OperatorReader{"new_velocity", read_new_velocity},
                               OperatorReader{"move_additive", read_move_additive},
                               OperatorReader{"move_superimposed", read_move_superimposed}};

}  // namespace

std::vector<Operator> read_then(TomlReader& top, const Spec& spec) {
  std::vector<std::string> names;
  for (const OperatorReader& each : operators) names.emplace_back(each.name);
  names.emplace_back("compensation");
  const std::vector<AxisPart> parts = spec.parts();
  std::vector<Operator> all;
  std::string himc_filter;
  top.for_each("then", [&](TomlReader& then) {
    MotionFields fields(then, spec.units);
    const std::size_t chosen = then.variant("operator", names);
    require_one_himc_filter(then, names[chosen], himc_filter);
    all.push_back(chosen < operators.size() ? operators[chosen].read(fields)
                                            : read_compensation(fields, parts));
    then.finish();
  });
  return all;
}

}  // namespace jounce::spec_detail
