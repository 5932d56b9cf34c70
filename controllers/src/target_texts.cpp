// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/listed.hpp"
#include "jounce/base/units.hpp"
#include "jounce/controllers/table_target.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
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
std::string instead_of_pulses(const std::string& name, const std::string& text,
                              const std::string& unit) {
  if (unit.empty() || is_quantity(text, unit) || !is_quantity(text, "pulse")) return "";
  return "; give the size of a pulse, such as " + name + " \"0.001 " + unit + '"';
}

std::optional<double> number_of(const std::string& name, const std::string& text,
                                const std::string& unit) {
  if (text.empty()) return std::nullopt;
  try {
    const double value = quantity(text, unit);
    require_positive(name.c_str(), value);
    return value;
  } catch (const InputError& error) {
    throw InputError(name, text, error.rule() + instead_of_pulses(name, text, unit));
  }
}

}  // namespace

bool TargetTexts::any() const {
  if (most) return true;
  for (const std::string* text :
       {&controller, &tolerance, &velocity_tolerance, &spacing, &x_step, &p_step, &v_step})
    if (!text->empty()) return true;
  return false;
}

Target target_of(const TargetTexts& texts, Domain axis, Interpolation rule, const Units& units,
                 const MemberName& name_of) {
  const auto named = [&](const char* member) { return name_of ? name_of(member) : member; };
  const auto number = [&](const char* member, const std::string& text, const std::string& unit) {
    return number_of(named(member), text, unit);
  };
  Target target;
  const auto x_step = number("x_step", texts.x_step, units.x);
  if (const ControllerTable* controller = controller_table(texts.controller)) {
    if (controller->axis != axis)
      throw InputError(named("controller"), texts.controller,
                       std::string("needs a table over ") + (controller->axis == Domain::master
                                                                 ? "a master, such as a cam"
                                                                 : "time, such as a move"));
    if (controller->rule != rule)
      throw InputError(named("controller"), texts.controller,
                       "needs " + named("rule") + " " + name(controller->rule));
    target = target_of(*controller, units, x_step, named("x_step"));
  } else if (!texts.controller.empty()) {
    throw InputError(named("controller"), texts.controller,
                     "must be one of " + listed(controller_tables(), &ControllerTable::name));
  }
  const std::string rate = rate_unit(units.position, units.x, 1);
  target.rule = rule;
  target.tolerance = number("tolerance", texts.tolerance, units.position);
  target.velocity_tolerance = number("velocity_tolerance", texts.velocity_tolerance, rate);
  if (texts.most) target.most = texts.most;
  target.spacing = number("spacing", texts.spacing, units.x).value_or(0);
  target.x_step = x_step.value_or(target.x_step);
  target.p_step = number("p_step", texts.p_step, units.position).value_or(0);
  target.v_step = number("v_step", texts.v_step, rate).value_or(0);
  return target;
}

}  // namespace jounce
