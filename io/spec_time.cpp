#include "jounce/io/detail/spec_parts.hpp"

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

}  // namespace jounce::detail
