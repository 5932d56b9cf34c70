// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Knot between two segments of a cam: master position m, slave position u there, and the slave's
/// derivatives by master position (u/m, u/m^2). A derivative left out follows from the laws beside
/// it, or else is zero (or chosen: see boundaries.hpp).
struct CamKnot {
  double master = 0;
  double slave = 0;
  std::optional<double> geo_velocity = {};
  std::optional<double> geo_acceleration = {};
};

/// A condition of a law through points inside its segment. Splines take positions alone; hermite
/// takes slave, geo_velocity and geo_acceleration at each, and geo_jerk at all or none. A point of it at
/// an end of the segment has the derivatives that the knot leaves out, and its geo_jerk.
struct CamPoint {
  double master = 0;
  std::optional<double> slave = {};
  std::optional<double> geo_velocity = {};
  std::optional<double> geo_acceleration = {};
  std::optional<double> geo_jerk = {};  ///< also at the segment's ends
  double tolerance = 0;                 ///< tolerance of slave, u, >= 0; quintic_spline alone
};

/// One segment: its law, and the knot where it ends. It begins where the one before ended.
struct CamSegment {
  Law law = Law::quintic;
  CamKnot end;
  std::string name = {};  ///< for reports; may be empty
  LawForm form = {};
  /// For polynomial, cubic_spline, quintic_spline, hermite; ascending.
  std::vector<CamPoint> points = {};
};

/// A cam as an engineer writes it down: a start and a list of segments.
struct CamSpec {
  CamKnot start;
  std::vector<CamSegment> segments;
  bool periodic = false;  ///< wraps from the last knot to the first; otherwise holds its end value
  /// For a periodic cam on a rotary slave: one turn of the slave, u. The cam then ends a whole number
  /// of turns from where it begins, and goes on from there (Extrapolation::advance).
  std::optional<double> slave_period = {};
};

/// The segment of `spec` that each segment of design(spec) belongs to (a law may need several).
struct CamDesign {
  Cam cam;
  std::vector<std::size_t> origin;
};

/// All knots of the spec, start included, with every derivative filled in. In this order: what the
/// knot gives; what a line, a dwell or a law from rest beside it demands; what a law that has its own
/// there brings (a sine's reversal, a spline's end) to a neighbour that takes it; zero. Start and
/// last knot of a periodic cam are one.
///
/// A law that starts and ends differently (R-U) turns its rest to the side where the acceleration is
/// zero. Where it takes an inflection and its reversal's knot gives the acceleration, the inflection
/// follows from that.
///
/// Throws InputError where master positions do not ascend, a derivative contradicts a law beside it
/// (beyond 1e-9 of the slope), a dwell moves, a law does not take its form, a reversal meets a rest,
/// no inflection gives the acceleration asked for, or the slave does not end on a whole turn.
std::vector<CamKnot> resolved_knots(const CamSpec& spec);

/// The exact cam. Throws as resolved_knots does.
CamDesign design(const CamSpec& spec);

/// Parts of each segment of the spec: linear in the values at its knots (law.hpp), as long as
/// no law's side or inflection follows from them. Throws as resolved_knots does, and for a law through
/// points.
std::vector<std::vector<LawPiece>> shapes(const CamSpec& spec);

/// The transition that a segment of the spec, counted from 0, is: "R-G", "U-R", ... (VDI 2143). The
/// letters are derived from the cam's own values, to 1e-9 of their peaks in the segment: R rest,
/// G velocity, U acceleration (reversal), B both.
std::string transition(const CamDesign& made, std::size_t segment);

}  // namespace jounce
