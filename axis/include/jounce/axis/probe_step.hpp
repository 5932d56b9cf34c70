// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace jounce {

/// The positions at one edge of a trigger input. u is the unit of the axis, m the unit of its
/// master.
struct Capture {
  std::uint8_t input = 0;  ///< number of the input, see command::TouchProbe
  bool rising = true;      ///< true: the input went on
  double age = 0;          ///< time from the edge to the instant of the tick, s, >= 0
  /// Commanded position at the edge, u; NaN: unknown.
  double commanded = std::numeric_limits<double>::quiet_NaN();
  /// Actual position at the edge, u: latched by the drive, or interpolated; NaN: unknown.
  double actual = std::numeric_limits<double>::quiet_NaN();
  /// Position of the live master at the edge, m; NaN: unknown.
  double master = std::numeric_limits<double>::quiet_NaN();

  /// The recorded position of MC_TouchProbe: the actual position; without one, the commanded
  /// position.
  [[nodiscard]] double position() const noexcept { return actual == actual ? actual : commanded; }
};

/// The touch probes of an axis in one tick.
struct ProbeStep {
  static constexpr std::size_t most_captures = 8;  ///< greatest number of captures in a tick

  std::uint8_t waiting = 0;  ///< bit k - 1: a touch probe waits for an edge of the input k
  std::uint8_t count = 0;    ///< number of captures
  std::uint64_t total = 0;   ///< number of captures since the axis started
  std::array<Capture, most_captures> capture{};  ///< the captures

  [[nodiscard]] std::span<const Capture> captures() const { return {capture.data(), count}; }
};

}  // namespace jounce
