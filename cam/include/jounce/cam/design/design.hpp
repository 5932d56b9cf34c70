// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Knot between two segments of a cam: master position m, slave position u, and the slave's
/// derivatives by master position (u/m, u/m^2). An omitted derivative follows from the adjacent
/// laws; otherwise it is zero (or chosen: see boundaries.hpp).
struct CamKnot {
  double master = 0;
  double slave = 0;
  std::optional<double> geo_velocity = {};
  std::optional<double> geo_acceleration = {};
};

/// A condition of a law through points inside its segment. Splines take positions alone; hermite
/// takes slave, geo_velocity and geo_acceleration at each, and geo_jerk at all or none. A point at
/// an end of the segment gives the derivatives that the knot omits, and its geo_jerk.
struct CamPoint {
  double master = 0;
  std::optional<double> slave = {};
  std::optional<double> geo_velocity = {};
  std::optional<double> geo_acceleration = {};
  std::optional<double> geo_jerk = {};  ///< also at the segment's ends
  double tolerance = 0;                 ///< u, >= 0, of the slave; quintic_spline alone
};

/// One segment: its law, and the knot at its end. It begins at the end of the previous one.
struct CamSegment {
  Law law = Law::quintic;
  CamKnot end;
  std::string name = {};  ///< for reports; may be empty
  LawForm form = {};
  /// For polynomial, cubic_spline, quintic_spline, hermite; ascending.
  std::vector<CamPoint> points = {};
};

/// A cam as an engineer specifies it: a start and a list of segments.
struct CamSpec {
  CamKnot start;
  std::vector<CamSegment> segments;
  bool periodic = false;  ///< wraps from the last knot to the first; otherwise holds its end value
  /// For a periodic cam on a rotary slave: one turn of the slave, u. The cam then ends a whole
  /// number of turns from its start, and continues from there (Extrapolation::advance).
  std::optional<double> slave_period = {};
};

/// The segment of `spec` that each segment of design(spec) belongs to (a law may need several).
struct CamDesign {
  Cam cam;
  std::vector<std::size_t> origin;
};

/// All knots of the spec, start included, with every derivative filled in. Precedence: the value of
/// the knot; the value that an adjacent line, dwell or law from rest demands; the value that an
/// adjacent law defines itself (a sine's reversal, a spline's end), if the neighbor accepts it;
/// zero. The first and last knot of a periodic cam are one.
///
/// A law with different ends (R-U) has its rest at the side with acceleration zero. If it takes an
/// inflection and the knot of its reversal gives the acceleration, the inflection follows from
/// that.
///
/// Throws InputError if master positions do not ascend, a derivative contradicts an adjacent law
/// (beyond 1e-9 of the slope), a dwell moves, a law does not accept its form, a reversal meets a
/// rest, no inflection gives the requested acceleration, or the slave does not end on a whole turn.
std::vector<CamKnot> resolved_knots(const CamSpec& spec);

/// The exact cam. Throws like resolved_knots.
CamDesign design(const CamSpec& spec);

/// Parts of each segment of the spec: linear in the values at its knots (law.hpp), as long as no
/// law's side or inflection follows from them. Throws like resolved_knots, and for a law through
/// points.
std::vector<std::vector<LawPiece>> shapes(const CamSpec& spec);

/// Returns the transition of a segment of the spec, counted from 0: "R-G", "U-R", ... (VDI 2143).
/// The letters are derived from the cam's own values, to 1e-9 of their peaks in the segment: R
/// rest, G velocity, U acceleration (reversal), B both.
std::string transition(const CamDesign& made, std::size_t segment);

}  // namespace jounce
