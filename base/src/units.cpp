// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>

#include <udunits2.h>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// UDUNITS-2 provides the grammar, the products and the conversion of units. The units are declared
// here and not read from its XML database, for two reasons: its radian is dimensionless, so degrees
// would be accepted for pulses, and a tool that starts a hundred times a minute in CI should not
// parse XML each time.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

class System {
 public:
  System() : system_(ut_new_system()) {
    ut_set_error_message_handler(ut_ignore);
    for (const char* symbol : {"m", "rad", "s", "kg", "A", "pulse"}) {
      const Unit base(ut_new_base_unit(system_));
      ut_map_symbol_to_unit(symbol, UT_UTF8, base.get());  // keeps a copy
    }
    constexpr double pi = 3.14159265358979323846;
    define("mm", 1e-3, "m"), define("um", 1e-6, "m"), define("nm", 1e-9, "m"),
        define("cm", 1e-2, "m"), define("in", 0.0254, "m"), define("inch", 1, "in"),
        define("inches", 1, "in"), define("ft", 0.3048, "m"), define("yd", 0.9144, "m");
    define("deg", pi / 180, "rad"), define("rev", 2 * pi, "rad");
    define("arcmin", pi / 10800, "rad"), define("arcsec", pi / 648000, "rad");
    define("count", 1, "pulse"), define("inc", 1, "pulse");
    define("ms", 1e-3, "s"), define("us", 1e-6, "s"), define("ns", 1e-9, "s"),
        define("min", 60, "s"), define("h", 3600, "s");
    define("g", 1e-3, "kg");
    define("N", 1, "kg.m/s^2"), define("J", 1, "N.m"), define("W", 1, "J/s"),
        define("Hz", 1, "1/s"), define("kHz", 1e3, "Hz"), define("MHz", 1e6, "Hz");
    define("rpm", 1, "rev/min"), define("cpm", 1, "1/min"), define("V", 1, "W/A"),
        define("ohm", 1, "V/A");
  }

  ~System() { ut_free_system(system_); }
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  [[nodiscard]] Unit parse(std::string_view text) const {
    // A number alone parses as a dimensionless unit, and an offset ("m @ 3") as a shifted one:
    // neither is a unit to us, except the 1 of "1/s".
    if (text.empty() || text.find('@') != std::string_view::npos) return nullptr;
    if (!text.starts_with("1/") && text.find_first_of("0123456789.+-") == 0) return nullptr;
    if (text.find_first_not_of("0123456789.+-eE ") == std::string_view::npos) return nullptr;
    if (std::count(text.begin(), text.end(), '(') != std::count(text.begin(), text.end(), ')'))
      return nullptr;
    return Unit(ut_parse(system_, std::string(text).c_str(), UT_UTF8));
  }

 private:
  void define(const char* symbol, double factor, const char* of) const {
    const Unit base(ut_parse(system_, of, UT_UTF8));
    const Unit scaled(ut_scale(factor, base.get()));
    ut_map_symbol_to_unit(symbol, UT_UTF8, scaled.get());
  }

  ut_system* system_;
};

/// UDUNITS-2 parses with global variables.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

const System& units() {
  static const System system;
  return system;
}

Unit require_unit(std::string_view text) {
  Unit unit = units().parse(text);
  if (!unit)
    throw InputError(
        "unit", std::string(text),
        "is not a known unit; known are m mm um cm in ft yd, rad deg rev, pulse, s ms us ns "
        "min h, kg g, N J W, Hz kHz MHz, rpm cpm, A V ohm and their products");
  return unit;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A quantity in its two parts.
struct Parts {
  std::optional<double> value;  ///< none: the text begins with no finite number
  std::string_view unit;
};

Parts parts_of(std::string_view text) {
  const std::string_view whole = trimmed(text);
  double value = 0;
  const char* begin = whole.data() + (whole.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, whole.data() + whole.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {};
  return {value, trimmed(whole.substr(static_cast<std::size_t>(end - whole.data())))};
}

/// True for a unit with a number of its own, such as "mm 3": udunits would multiply by it.
bool has_second_number(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool begins = i == 0 || unit[i - 1] == ' ' || unit[i - 1] == '*';
    if (begins && unit[i] >= '0' && unit[i] <= '9' && unit.substr(i, 2) != "1/") return true;
  }
  return false;
}

}  // namespace

bool is_unit(std::string_view text) {
  const std::lock_guard lock(one_at_a_time());
  return units().parse(text) != nullptr;
}

double conversion(std::string_view from, std::string_view to) {
  if (from == to) return 1;
  const std::lock_guard lock(one_at_a_time());
  const Unit a = require_unit(from);
  const Unit b = require_unit(to);
  if (ut_are_convertible(a.get(), b.get()) == 0)
    throw InputError("unit", std::string(from), "cannot be converted to " + std::string(to));
  const std::unique_ptr<cv_converter, decltype(&cv_free)> converter(
      ut_get_converter(a.get(), b.get()), &cv_free);
  // 1/s converts into s by inversion; only a plain factor is a change of unit.
  const double factor = cv_convert_double(converter.get(), 1);
  if (std::abs(cv_convert_double(converter.get(), 2) - 2 * factor) > rounded_sum * std::abs(factor))
    throw InputError("unit", std::string(from), "cannot be converted to " + std::string(to));
  return factor;
}

bool is_convertible(std::string_view unit, std::string_view other) {
  try {
    return conversion(unit, other) > 0;
  } catch (const InputError&) {
    return false;
  }
}

bool is_position_unit(std::string_view unit) {
  return is_convertible(unit, "m") || is_convertible(unit, "rad") || is_convertible(unit, "pulse");
}

double quantity(std::string_view text, std::string_view unit) {
  const auto [value, given] = parts_of(text);
  const std::string shown = '"' + std::string(text) + '"';
  if (!value)
    throw InputError(
        "", shown,
        "must be a finite number, with or without a unit" +
            (unit.empty() || unit == "1" ? std::string()
                                         : ", such as \"12.5 " + std::string(unit) + '"'));
  if (given.empty()) return *value;
  if (const std::size_t comma = text.find(',');
      comma < text.size() - 1 && text[comma + 1] >= '0' && text[comma + 1] <= '9') {
    std::string with_point(text);
    with_point[comma] = '.';
    throw InputError("", shown, "has a decimal comma: write a point, \"" + with_point + '"');
  }
  if (!is_unit(given) || has_second_number(given))
    throw InputError(
        "", shown,
        '"' + std::string(given) + "\" is not a known unit; give the value " +
            (unit == "1" || unit.empty() ? "without a unit" : "in " + std::string(unit)));
  try {
    return *value * conversion(given, unit);
  } catch (const InputError&) {
    throw InputError(
        "", shown,
        std::string(given) + " is not a unit of this quantity: give the value " +
            (unit == "1" || unit.empty() ? "without a unit" : "in " + std::string(unit)));
  }
}

std::string_view quantity_unit(std::string_view text) {
  return parts_of(text).unit;
}

std::string rate_unit(const std::string& position, const std::string& x, int order) {
  if (order == 0 || x.empty()) return position;
  std::string unit = (position.empty() ? "1" : position) + "/" +
                     (x.find('/') == std::string::npos ? x : "(" + x + ")");
  if (order > 1) unit += "^" + std::to_string(order);
  return unit;
}

}  // namespace jounce
