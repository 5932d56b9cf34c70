#include <utility>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/units.hpp"
#include "jounce/pvt/controllers.hpp"

namespace jounce::detail {

AxisSpec read_axis(TomlReader axis, const Units& units) {
  AxisSpec spec;
  spec.cycle = axis.optional_number("cycle", "s").value_or(spec.cycle);
  if (!(spec.cycle >= 1e-5 && spec.cycle <= 1))
    axis.fail("cycle", number(spec.cycle), "must be between 10 us and 1 s");
  spec.position = axis.optional_number("position", units.position).value_or(0);
  axis.finish();
  return spec;
}

Table read_knots(TomlReader& top, const Units& units, Rule rule) {
  Columns columns;
  for (TomlReader& knot : top.tables("knot")) {
    columns.x.push_back(knot.number("time", units.x));
    columns.p.push_back(knot.number("position", units.position));
    if (rule != Rule::linear)
      columns.v.push_back(knot.number("velocity", rate_unit(units.position, units.x, 1)));
    if (rule == Rule::quintic_hermite)
      columns.a.push_back(knot.number("acceleration", rate_unit(units.position, units.x, 2)));
    knot.finish();
  }
  static const std::vector<std::string> controllers{"himc"};
  if (top.optional_choice("controller", controllers)) himc::require_pvt(columns);
  return Table(Axis::time, rule, read_outside(top, true), std::move(columns));
}

}  // namespace jounce::detail
