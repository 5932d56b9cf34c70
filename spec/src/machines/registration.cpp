// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::array<std::string, 2> edges{"rising", "falling"};
const std::array<std::string, 2> correction_sides{"master", "slave"};
const std::array<std::string, 2> reactions{"fault", "hold"};

}  // namespace

std::optional<LiveRegistrationSpec> read_registration(TomlReader& top, const Units& units,
                                                      const std::string& master_unit) {
  auto table = top.optional_table("registration");
  if (!table) return std::nullopt;
  if (master_unit.empty())
    table->fail("period", "", "needs units.master: add units = { position = ..., master = ... }");
  LiveRegistrationSpec spec;
  Registration& window = spec.correction;
  spec.input = static_cast<int>(table->optional_whole("input").value_or(spec.input));
  spec.rising = table->optional_choice("edge", edges).value_or(0) == 0;
  spec.period = table->number("period", master_unit);
  spec.mark = table->number("mark", master_unit);
  spec.window = table->number("window", master_unit);
  spec.search = table->optional_number("search", master_unit).value_or(0);
  window.window_from = table->number("correct_from", master_unit);
  window.window_length = table->number("correct_length", master_unit);
  const bool of_slave = table->optional_choice("of", correction_sides).value_or(0) == 1;
  spec.add_to = of_slave ? CorrectionOf::slave : CorrectionOf::master;
  window.most = table->number("most", of_slave ? units.position : master_unit);
  if (of_slave) spec.ratio = table->number("ratio", rate_unit(units.position, master_unit, 1));
  if (!of_slave && table->has("ratio"))
    table->fail("ratio", "", "applies to of = \"slave\" only: leave it out");
  spec.gain = table->optional_number("gain", "1").value_or(spec.gain);
  window.law = read_law(*table, "law").value_or(window.law);
  spec.misses = static_cast<int>(table->optional_whole("misses").value_or(spec.misses));
  spec.on_loss = static_cast<MarkLoss>(table->optional_choice("on_loss", reactions).value_or(0));
  table->finish();
  if (spec.input < 1 || spec.input > 4)
    table->fail("input", std::to_string(spec.input), "must be 1 to 4");
  try {
    return LiveRegistration(spec).spec();
  } catch (const InputError& error) {
    table->fail(error.key().c_str(), error.value(), error.rule());
  }
}

}  // namespace jounce::spec_detail
