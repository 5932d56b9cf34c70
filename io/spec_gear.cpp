#include "jounce/io/detail/spec_parts.hpp"

namespace jounce::detail {

GearSpec read_gear(TomlReader gear, const Units& units) {
  GearSpec spec;
  spec.numerator = gear.whole("numerator");
  spec.denominator = gear.optional_whole("denominator").value_or(1);
  spec.master_period = gear.number("master_period", units.x);
  if (spec.denominator < 1)
    gear.fail("denominator", std::to_string(spec.denominator), "must be at least 1");
  if (!(spec.master_period > 0))
    gear.fail("master_period", number(spec.master_period), "must be greater than 0");
  gear.finish();
  return spec;
}

}  // namespace jounce::detail
