// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"
#include "jounce/controllers/table_target.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

/// Reads the requirements of the controller. Its resolution of the first column, and its rule,
/// apply unless the spec states others.
Target read_controller(TomlReader& table, const Units& units, Domain axis, TableOptions& options) {
  const std::string resolution = spec_key(axis, "x_step");
  const auto x_step = table.optional_positive(resolution.c_str(), units.x);
  static const std::vector<std::string> names = controller_names();
  const auto choice = table.optional_choice("controller", names);
  if (!choice) return {.x_step = x_step.value_or(0)};
  const ControllerTable& controller = controller_tables()[*choice];
  const std::string word = '"' + names[*choice] + '"';
  if (controller.axis != axis)
    table.fail("controller", word,
               axis == Domain::time
                   ? "is for tables over a master, not over time: choose another controller"
                   : "is for tables over time, not over a master: choose another controller");
  if (options.rule.value_or(controller.rule) != controller.rule)
    table.fail("controller", word,
               std::string("needs rule = \"") + name(controller.rule) +
                   "\": change rule, or leave rule out");
  options.rule = controller.rule;
  try {
    return target_of(controller, units, x_step, resolution);
  } catch (const InputError& error) {
    table.fail("controller", error.value(), error.rule());
  }
}

}  // namespace

void read_target(TomlReader& table, const Units& units, Domain axis, TableOptions& options) {
  static const std::vector<std::string> spacings{"even", "fewest"};
  const auto key = [&](const char* member) { return spec_key(axis, member); };
  const std::string rate = rate_unit(units.position, units.x, 1);
  bool wanted = table.has("controller");
  for (const char* member : {"velocity_tolerance", "most", "spacing", "x_step", "p_step", "v_step"})
    wanted = wanted || table.has(key(member).c_str());
  const auto knots = table.optional_choice("knots", spacings);
  Target target = read_controller(table, units, axis, options);
  target.velocity_tolerance = table.optional_positive(key("velocity_tolerance").c_str(), rate);
  if (const auto most = table.optional_count("most")) target.most = *most;
  target.spacing = table.optional_positive("spacing", units.x).value_or(0);
  target.p_step = table.optional_positive(key("p_step").c_str(), units.position).value_or(0);
  target.v_step = table.optional_positive(key("v_step").c_str(), rate).value_or(0);
  if (!wanted && knots.value_or(0) == 0) return;
  if (knots == std::size_t{0})
    table.fail("knots", "\"even\"",
               "needs knots = \"fewest\": change knots, or leave this key out");
  if (options.intervals)
    table.fail("intervals", std::to_string(*options.intervals),
               "cannot be combined with knots = \"fewest\": give one of the two");
  options.target = target;
}

}  // namespace jounce::spec_detail
