// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "jounce/cam/fit/fit.hpp"

namespace jounce::cam_detail {

/// Distances of a cam from points, as shares of the tolerances of the points.
struct Deviation {
  double worst = std::numeric_limits<double>::infinity();  ///< the greatest distance
  double rms = std::numeric_limits<double>::infinity();    ///< root mean square
  /// index of the point with the greatest distance
  std::size_t where = 0;
  [[nodiscard]] bool fits() const { return worst <= 1; }
};

/// A number of a spec that a fit may change. All its places change by the same amount.
struct Parameter {
  enum class Kind { master, slave, geo_velocity, geo_acceleration, inflection, straight };
  Kind kind = Kind::master;
  std::vector<std::size_t> at;  ///< numbers of knots; for inflection and straight, of the segment
  double scale = 1;             ///< magnitude of the number
};

/// Knot of a spec by its number; 0 is the start.
CamKnot& knot(CamSpec& spec, std::size_t number);
const CamKnot& knot(const CamSpec& spec, std::size_t number);

/// The number of a knot or a segment that a parameter of this kind changes.
double* field(CamSpec& spec, Parameter::Kind kind, std::size_t at);

/// Returns or sets the value of a parameter (at its first place).
double value(const CamSpec& spec, const Parameter& parameter);
void change(CamSpec& spec, const Parameter& parameter, double by);

/// Returns the deviation at these points (indices of the measured points). Infinite if the spec is
/// not a cam.
Deviation deviation(const CamSpec& spec, const MeasuredCam& measured,
                    const std::vector<std::size_t>& points);

/// Returns the place between two adjacent points at which the cam leaves the points most, or
/// nullopt if it stays near their lines. A cam that passes each point may still oscillate between
/// them. Near: within twice the tolerance, and the bend of the points.
std::optional<double> oscillation(const CamSpec& spec, const MeasuredCam& measured,
                                  const std::vector<std::size_t>& points);

/// Sets the parameters to the values with the least sum of squares, by the method of Levenberg and
/// Marquardt, and returns the deviation.
Deviation refine(CamSpec& spec, const std::vector<Parameter>& parameters,
                 const MeasuredCam& measured, const std::vector<std::size_t>& points);

}  // namespace jounce::cam_detail
