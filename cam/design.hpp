#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/law.hpp"
#include "jounce/profiles/curve.hpp"

namespace jounce {

/// Where two segments of a cam meet: master position m, slave position u there, and the slave's
/// derivatives by master position (u/m, u/m^2). A derivative left out is the slope of a line that
/// begins or ends here, or else zero.
struct CamKnot {
  double master = 0;
  double slave = 0;
  std::optional<double> geo_velocity;
  std::optional<double> geo_acceleration;
};

/// One segment: its law, and the knot where it ends. It begins where the one before ended.
struct CamSegment {
  Law law = Law::quintic;
  CamKnot end;
  std::string name;  ///< for reports; may be empty
};

/// A cam as an engineer writes it down: a start and a list of segments.
struct CamSpec {
  CamKnot start;
  std::vector<CamSegment> segments;
  bool periodic = false;  ///< wraps from the last knot to the first; otherwise holds its end value
};

/// The segment of `spec` that each segment of design(spec) belongs to (a law may need several).
struct CamDesign {
  Cam cam;
  std::vector<std::size_t> origin;
};

/// All knots of the spec, start included, with every derivative filled in. Throws InputError where
/// master positions do not ascend, a derivative contradicts a line or a rest-to-rest law beside it
/// (beyond 1e-9 of the slope), or a dwell moves.
std::vector<CamKnot> resolved_knots(const CamSpec& spec);

/// The exact cam. Throws as resolved_knots does.
CamDesign design(const CamSpec& spec);

}  // namespace jounce
