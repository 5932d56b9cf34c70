// SPDX-License-Identifier: Apache-2.0
#include "cli/common/target_options.hpp"

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/option_names.hpp"

namespace jounce::cli {
namespace {

/// True if a text is a quantity of this unit.
bool is_quantity(const std::string& text, const std::string& unit) {
  try {
    (void)quantity(text, unit);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// Advice for a length or an angle that is given in pulses.
std::string instead_of_pulses(const std::string& member, const std::string& text,
                              const std::string& unit) {
  if (unit.empty() || is_quantity(text, unit) || !is_quantity(text, "pulse")) return "";
  return "; give the size of a pulse, such as " + option_of(member) + " \"0.001 " + unit + '"';
}

std::optional<double> number_of(const char* member, const std::string& text,
                                const std::string& unit) {
  if (text.empty()) return std::nullopt;
  try {
    const double value = quantity(text, unit);
    require_positive(member, value);
    return value;
  } catch (const InputError& error) {
    throw InputError(option_of(member), text, error.rule() + instead_of_pulses(member, text, unit));
  }
}

}  // namespace

bool TargetOptions::any() const {
  if (most) return true;
  for (const std::string* option : {&controller, &tolerance, &velocity_tolerance, &spacing,
                                    &resolution, &position_resolution, &velocity_resolution})
    if (!option->empty()) return true;
  return false;
}

std::vector<Option> add_target_options(const Verb& verb, TargetOptions& options) {
  std::vector<std::string> names;
  for (const ControllerTable& each : controller_tables()) names.emplace_back(each.name);
  return {
      verb.option("--controller", options.controller,
                  "New knots: the best table that this controller can use")
          .check(one_of(names)),
      verb.option(
          "--tolerance", options.tolerance,
          "New knots: the fewest that keep the position within this tolerance; default: unchanged"),
      verb.option("--velocity-tolerance", options.velocity_tolerance,
                  "The same for the velocity (of a cam: geo_velocity)"),
      verb.option("--most", options.most,
                  "Maximum number of new knots; without a tolerance, the table with the smallest "
                  "error, or close to it"),
      verb.option("--spacing", options.spacing, "Least distance between new knots"),
      verb.option("--resolution", options.resolution,
                  "New knots at multiples of this, such as 1ms"),
      verb.option("--position-resolution", options.position_resolution,
                  "Round their positions to multiples of this, such as 1pulse"),
      verb.option("--velocity-resolution", options.velocity_resolution,
                  "Round their velocities to multiples of this")};
}

std::optional<Interpolation> rule_of(const TargetOptions& options) {
  const ControllerTable* controller = controller_table(options.controller);
  return controller ? std::optional(controller->rule) : std::nullopt;
}

Target target_of(const TargetOptions& options, Domain axis, Interpolation rule,
                 const Units& units) {
  Target target;
  const auto x_step = number_of("x_step", options.resolution, units.x);
  if (const ControllerTable* controller = controller_table(options.controller)) {
    if (controller->axis != axis)
      throw InputError("--controller", options.controller,
                       std::string("needs a table over ") + (controller->axis == Domain::master
                                                                 ? "a master, such as a cam"
                                                                 : "time, such as a move"));
    if (controller->rule != rule)
      throw InputError("--controller", options.controller,
                       std::string("needs --rule ") + name(controller->rule));
    target = jounce::target_of(*controller, units, x_step, "--resolution");
  }
  const std::string rate = rate_unit(units.position, units.x, 1);
  target.rule = rule;
  target.tolerance = number_of("tolerance", options.tolerance, units.position);
  target.velocity_tolerance = number_of("velocity_tolerance", options.velocity_tolerance, rate);
  if (options.most) target.most = options.most;
  target.spacing = number_of("spacing", options.spacing, units.x).value_or(0);
  target.x_step = x_step.value_or(target.x_step);
  target.p_step = number_of("p_step", options.position_resolution, units.position).value_or(0);
  target.v_step = number_of("v_step", options.velocity_resolution, rate).value_or(0);
  return target;
}

}  // namespace jounce::cli
