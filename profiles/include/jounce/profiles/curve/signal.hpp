// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Common interface of curves, tables and followed cams. A signal has a domain [start, end];
/// ascending breaks, including both ends, at which a derivative may jump; and a jet (the value with
/// three derivatives) at every position. Functions that sample, validate or stream accept any
/// signal.
template <class S>
concept Signal = requires(const S& signal, double x, Side side) {
  { signal.start() } -> std::convertible_to<double>;
  { signal.end() } -> std::convertible_to<double>;
  { signal.breaks() } -> std::convertible_to<std::span<const double>>;
  { signal.jet(x, side) } -> std::same_as<Jet>;
};

}  // namespace jounce
