// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/base/document.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/check/table_check.hpp"
#include "design/src/convert/for_controller.hpp"
#include "design/src/make/table_of.hpp"

namespace jounce {
namespace design_detail {
namespace {

/// Advice for counts that must become another quantity; "" for other units.
std::string size_of_a_count(const std::string& key, const std::string& unit,
                            const std::string& to) {
  if (!is_convertible(unit, "count") || !is_position_unit(to)) return "";
  return "; for a table from a file, give the size of one " + unit + ", such as " +
         (key == "master_unit" ? "--resolution " : "--position-resolution ") + "0.01" + to;
}

}  // namespace

using profiles_detail::rounded_input;

TableFile in_units(TableFile file, const Conversion& wanted) {
  const auto change = [](const char* key, std::string& unit, const std::string& to) {
    if (!to.empty() && !is_unit(to))
      throw InputError(
          key, to,
          "is not a known unit: give a length (mm m um nm cm in ft yd), an angle (rad deg rev), "
          "a time (s ms us ns min h), or pulse, count or inc");
    double factor = 1;
    try {
      if (!unit.empty() && !to.empty()) factor = conversion(unit, to);
    } catch (const InputError&) {
      throw InputError(key, to,
                       "cannot be converted from the unit of the table, " + unit +
                           size_of_a_count(key, unit, to));
    }
    if (!to.empty()) unit = to;
    return factor;
  };
  if (const double factor = change("master_unit", file.units.x, wanted.units.x); factor != 1)
    file.table = stretched(file.table, factor);
  if (const std::string& to = wanted.units.position; is_unit(to) && !is_position_unit(to))
    throw InputError("position_unit", to,
                     "is not a unit of position: give a length, an angle, or pulse, count or inc");
  const double factor = change("position_unit", file.units.position, wanted.units.position);
  Columns columns = file.table.columns();
  if (factor != 1)
    for (auto* column : {&columns.p, &columns.v, &columns.a})
      for (double& value : *column) value *= factor;
  const auto [least, most] = std::minmax_element(columns.p.begin(), columns.p.end());
  const bool closes =
      std::abs(columns.p.back() - columns.p.front()) <= rounded_input * (*most - *least);
  const Extrapolation repeated = closes ? Extrapolation::wrap : Extrapolation::advance;
  file.table = Table(file.table.axis(), file.table.rule(),
                     wanted.periodic ? repeated : file.table.outside(), std::move(columns));
  return file;
}

namespace {

TableLimits limits_of(const Input& input) {
  if (input.labels.over_master && input.spec) return table_limits(*input.spec);
  return {input.limits};
}

/// The error of new knots, with the units of its numbers.
InputError with_units(const InputError& error, const Units& units) {
  Document document;
  for (const char* key : {"tolerance", "p_step"}) document.units[key] = units.position;
  for (const char* key : {"velocity_tolerance", "v_step"})
    document.units[key] = rate_unit(units.position, units.x, 1);
  for (const char* key : {"spacing", "x_step"}) document.units[key] = units.x;
  return document.located(error);
}

}  // namespace

Sampled with_knots(const Input& input, const Conversion& wanted) try {
  return std::visit(
      [&](const auto& curve) {
        if (const auto& target = wanted.target) {
          if (target->tolerance) require_certifiable(curve, "tolerance", *target->tolerance);
          if (target->velocity_tolerance)
            require_certifiable(derivative(curve), "velocity_tolerance",
                                *target->velocity_tolerance);
          const TableLimits all = limits_of(input);
          return reduced(curve, *target, all.limits, all.ramped);
        }
        return wanted.intervals > 0 ? sample(curve, *wanted.rule, wanted.intervals)
                                    : sample(curve, *wanted.rule, input.table.table.columns().x);
      },
      *input.curve);
} catch (const InputError& error) {
  throw with_units(error, input.labels.units);
}

}  // namespace design_detail

Converted converted(const Input& input, const Conversion& conversion) {
  Conversion wanted = conversion;
  if (!wanted.rule)
    wanted.rule = wanted.format ? rule_of(*wanted.format) : Interpolation::cubic_hermite;
  if (wanted.format != nullptr) {
    Converted result = design_detail::for_controller(input, wanted);
    result.given_counts = wanted.given_counts;
    return result;
  }
  Converted result{input.table, input.error};
  if (wanted.target && wanted.intervals > 0)
    throw InputError("intervals", std::to_string(wanted.intervals),
                     "cannot be combined with a resolution or another requirement for new knots: "
                     "leave out one of the two");
  if (wanted.rule != input.table.table.rule() || wanted.target || wanted.intervals > 0) {
    Sampled made = design_detail::with_knots(input, wanted);
    result = {{std::move(made.table), input.table.units, input.table.provenance}, made.error};
    if (!wanted.target) result.limit = design_detail::default_tolerance(input);
  }
  result.exceeded = design_detail::check_converted(result.file.table, input);
  result.file = design_detail::in_units(std::move(result.file), wanted);
  result.given_counts = wanted.given_counts;
  return result;
}

}  // namespace jounce
