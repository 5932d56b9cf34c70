// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// Greatest size of the numbers of all curves of chart_data(), bytes. If the segments need more,
/// the data has the exact extrema of blocks of segments instead.
constexpr std::size_t most_chart_bytes = 700'000;

/// Returns the numbers behind figure_of(input, before) as JSON, for Chart::data. The script of the
/// page evaluates the segments, so it shows exactly the values of the library.
///
/// The document has one or two views: the view of the figure and, for a cam whose spec has a
/// [master], the slave over time with [limits.slave]. A view has the axis, the panels (unit,
/// limits, exact extrema), the names of the segments, the switches, and the curves. A curve has
/// `start` and `pieces`: [length, [c0, c1, ...], [amplitude, angle, phase, ...]], see Segment.
/// Numbers have the digits that restore the same double. A curve that is too large
/// (most_chart_bytes) has `edges`, and `low` and `high`: the exact extrema of the value and of its
/// derivatives between two edges.
///
/// Throws InputError (key "before") like figure_of() (input_figure.hpp).
std::string chart_data(const Input& input, const std::optional<Input>& before = std::nullopt);

}  // namespace jounce
