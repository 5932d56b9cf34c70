// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// Units of measure as people write them: "mm", "deg", "pulse/s", "kg cm^2", "1/s", "N m s/rad".
///
/// Units: m with mm, um, cm, in; rad with deg, arcmin, arcsec, rev; pulse (also count, inc); s with
/// ms, us, ns, min, h; kg with g; N, J, W; Hz with kHz, MHz; rpm (rev/min), cpm (cycles: 1/min); A, V, ohm; and their
/// products, quotients and powers. Meters, radians and pulses are different dimensions: none converts into another.

/// True if the text is a unit. The empty text is not.
bool is_unit(std::string_view text);

/// True if both are units of one quantity: "mm/s" and "m/min".
bool is_convertible(std::string_view unit, std::string_view other);

/// True for a unit of a position: of length or of angle, or pulses.
bool is_position_unit(std::string_view unit);

/// Factor from the unit `from` to `to`. Throws InputError (key "unit") if either is not a unit or they do
/// not measure the same thing.
double conversion(std::string_view from, std::string_view to);

/// A number with or without a unit ("12.5", "12.5 mm/s", "-3e2 deg") as a number of `unit`; without
/// one it already is in `unit`. Throws InputError (no key; the rule names the error and which
/// unit is expected): not a number, not finite, not a unit, a unit that measures something else.
double quantity(std::string_view text, std::string_view unit);

/// The unit that the text of such a number names: "mm/s". Empty if it names none, or begins with no number.
std::string_view quantity_unit(std::string_view text);

/// position / x^order, as people write it: "mm", "mm/deg", "mm/deg^2". An empty position is a pure
/// number, "1/s"; without x there is nothing to divide by.
std::string rate_unit(const std::string& position, const std::string& x, int order);

}  // namespace jounce
