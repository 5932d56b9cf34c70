// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {
namespace {

void set_tolerance(Tolerance& tolerance, const std::string& text, const Labels& labels) {
  const auto equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const auto& names = labels.over_master ? OverMaster::names : OverTime::names;
  const auto name = std::find(names.begin(), names.end(), key);
  if (equals == std::string::npos) tolerance.share = csv_number(text);
  if (equals == std::string::npos ? !tolerance.share : name == names.end())
    throw InputError(
        "tolerance", text,
        std::string("must be a share, such as 1e-6, or KEY=VALUE with one of the keys ") +
            names[0] + ", " + names[1] + ", " + names[2] + ", " + names[3]);
  try {
    double value = tolerance.share.value_or(0);
    if (name == names.end() && !(value <= 1))
      throw InputError("", value, "is a share of the range, so it must be at most 1");
    if (name != names.end()) {
      value = quantity(text.substr(equals + 1), labels.unit_of(key));
      tolerance.of[static_cast<std::size_t>(name - names.begin())] = value;
    }
    require_not_negative("", value);
  } catch (const InputError& error) {
    throw InputError("tolerance", text, error.rule());
  }
}

}  // namespace

Tolerance tolerance_of(const std::vector<std::string>& texts, const Labels& labels) {
  Tolerance tolerance;
  for (const std::string& text : texts) set_tolerance(tolerance, text, labels);
  return tolerance;
}

bool tolerance_fits(const std::string& text, const Labels& labels) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return true;
  const std::string key = text.substr(0, equals);
  const auto has_key = [&](const auto& names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  const bool own = labels.over_master ? has_key(OverMaster::names) : has_key(OverTime::names);
  const bool other = labels.over_master ? has_key(OverTime::names) : has_key(OverMaster::names);
  if (!own) return !other;
  const std::string unit(quantity_unit(text.substr(equals + 1)));
  return !is_unit(unit) || is_convertible(unit, labels.unit_of(key));
}

}  // namespace jounce
