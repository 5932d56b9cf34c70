// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Common interface of curves, tables and followed cams. A signal has a domain [start, end],
/// ascending breaks where a derivative may jump (both ends included), and a jet (the value with
/// three derivatives) at every position. Sampling, validation and streaming take any signal.
template <class S>
concept Signal = requires(const S& signal, double x, Side side) {
  { signal.start() } -> std::convertible_to<double>;
  { signal.end() } -> std::convertible_to<double>;
  { signal.breaks() } -> std::convertible_to<std::span<const double>>;
  { signal.jet(x, side) } -> std::same_as<Jet>;
};

}  // namespace jounce
