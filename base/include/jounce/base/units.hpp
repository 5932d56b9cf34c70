// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Units of measure as people write them: "mm", "deg", "pulse/s", "kg cm^2", "1/s", "N m s/rad".
/// These units can be multiplied, divided and raised to powers:
/// - length: m, mm, um, cm, in, ft, yd;
/// - angle: rad, deg, arcmin, arcsec, rev;
/// - pulses: pulse (also count, inc);
/// - time: s, ms, us, ns, min, h;
/// - frequency: Hz, kHz, MHz;
/// - other quantities: kg, g, N, J, W, A, V, ohm.
///
/// Lengths, angles and pulses are different dimensions: a unit of one does not convert to a unit of
/// another.

/// True if the text is a unit. The empty text is not a unit.
bool is_unit(std::string_view text);

/// True if the two texts are units of the same quantity: "mm/s" and "m/min".
bool is_convertible(std::string_view unit, std::string_view other);

/// True for a unit of position: a length, an angle, or pulses.
bool is_position_unit(std::string_view unit);
/// Returns the factor from the unit `from` to the unit `to`. Throws InputError (key "unit") if one
/// of the texts is not a unit, or if the units have different dimensions.
double conversion(std::string_view from, std::string_view to);

/// Returns a number with or without a unit ("12.5", "12.5 mm/s", "-3e2 deg"), converted to `unit`.
/// A number without a unit is already in `unit`. Throws InputError for text that is not a number, a
/// number that is not finite, an unknown unit, or a unit of another dimension. The error has no
/// key; its rule states the error and the expected unit.
double quantity(std::string_view text, std::string_view unit);

/// Returns the unit in a text that quantity() accepts: "mm/s". Empty if the text has no unit, or
/// does not begin with a number.
std::string_view quantity_unit(std::string_view text);
/// Returns the unit position / x^order, as people write it: "mm", "mm/deg", "mm/deg^2". With an
/// empty `position`, the numerator is a pure number: "1/s". With an empty `x`, returns `position`.
std::string rate_unit(const std::string& position, const std::string& x, int order);

}  // namespace jounce
