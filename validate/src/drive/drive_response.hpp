// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// The recorded outputs of an axis.
enum Output : std::size_t { position, velocity, torque, load, outputs };

/// A drive's answer to a reference at given times, with derivatives by the logarithms of numbers.
struct DriveResponse {
  Integration integration;
  /// value[output][sample]: u, u/s, N m, u; positions as deviations from the reference
  std::vector<std::vector<double>> value;
  /// by[output][j * samples + sample]: d value / d log |number j|
  std::vector<std::vector<double>> by;
};

/// The drive that differs from `start` in some of its numbers, with the controller's feed-forward
/// torque as it was: see identify(). Both spans of one size; keys are known to exist.
Drive with_numbers(const Drive& start, std::span<const std::string> keys,
                   std::span<const double> values);

struct ResponseSpec {
  const Drive* start;                 ///< the controller's feed-forward is that of this one
  std::span<const std::string> keys;  ///< keys of the numbers that differ from it
  std::span<const double> values;     ///< values of them
  std::span<const double> times;  ///< ascending, on the reference's axis; after its end it holds
  double tolerance = 1e-8;
};

/// From rest at the reference's start to the last of the times. An integration that fails is an
/// outcome; then there are no values.
DriveResponse respond(const SignalView& reference, const ResponseSpec& spec);

}  // namespace jounce::validate_detail
