// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

std::optional<Mode> read_polydyne(TomlReader& top) {
  auto table = top.optional_table("polydyne");
  if (!table) return std::nullopt;
  const Mode mode{table->number("frequency", "Hz"),
                  table->optional_number("damping", "1").value_or(0)};
  if (!(mode.frequency > 0))
    table->fail("frequency", number(mode.frequency), "must be greater than 0");
  if (mode.damping < 0 || mode.damping >= 1)
    table->fail("damping", number(mode.damping), "must be at least 0 and less than 1");
  table->finish();
  return mode;
}

}  // namespace jounce::spec_detail
