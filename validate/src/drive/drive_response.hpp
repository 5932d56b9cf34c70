// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Outputs of an axis that can be recorded.
enum Output : std::size_t { position, velocity, torque, load, outputs };

/// The response of a drive to a reference at given times, with derivatives with respect to the
/// logarithms of numbers.
struct DriveResponse {
  Integration integration;  ///< statistics of the integration
  /// value[output][sample]: u, u/s, N m, u. Positions are deviations from the reference.
  std::vector<std::vector<double>> value;
  /// by[output][j * samples + sample]: d value / d log |number j|.
  std::vector<std::vector<double>> by;
};

/// Returns the drive that differs from `start` in some of its numbers, with the same feed-forward
/// torque of the controller: see identify(). Both spans have the same size; the keys must exist.
Drive with_numbers(const Drive& start, std::span<const std::string> keys,
                   std::span<const double> values);

/// Options of respond().
struct ResponseSpec {
  const Drive* start;  ///< the drive that determines the feed-forward of the controller
  std::span<const std::string> keys;  ///< keys of the numbers that differ from `start`
  std::span<const double> values;     ///< their values
  /// s, ascending, on the time axis of the reference, which holds after its end.
  std::span<const double> times;
  double tolerance = 1e-8;  ///< relative tolerance of the integration
};

/// Computes the response from rest at the start of the reference to the last time. If the
/// integration fails, the result has no values.
DriveResponse respond(const SignalView& reference, const ResponseSpec& spec);

}  // namespace jounce::validate_detail
