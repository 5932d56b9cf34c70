#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jounce/profiles/segment.hpp"

namespace jounce {

/// The motion laws (VDI 2143). The first three take their shape from their end points; the others
/// are rest to rest.
enum class Law {
  line,                ///< straight line: constant velocity
  dwell,               ///< the slave stands still
  quintic,             ///< general 5th degree from position, velocity, acceleration at both ends
  poly345,             ///< 3-4-5 polynomial: lowest rms jerk; Cv 15/8, Ca 10/sqrt(3)
  modified_sine,       ///< lowest Cv of the smooth laws: 1.7596; Ca 5.5280
  modified_trapezoid,  ///< lowest Ca of the smooth laws: 4.8881; Cv 2
  inclined_sine,       ///< cycloid (Bestehorn): smooth and quiet; Cv 2, Ca 2 pi
};

/// "line", "dwell", "quintic", "345", "modified_sine", ...: the words of the spec.
const char* name(Law law);
std::optional<Law> law_named(std::string_view name);
std::span<const Law> all_laws();

/// Whether the law begins and ends with velocity and acceleration zero.
bool is_rest_to_rest(Law law);

/// The law over z in [0, 1], from 0 to 1: one or more segments whose lengths sum to 1. For line and
/// the rest-to-rest laws only.
std::vector<Segment> normalised(Law law);

/// The sine-constant-cosine acceleration family: a quarter sine over the share b of each half, a
/// constant over c, a quarter cosine over d; b + c + d = 1, each >= 0. Its members are the parabola
/// (0,1,0), simple sine (0,0,1), cycloid (1/2,0,1/2), modified sine (1/4,0,3/4) and modified
/// trapezoid (1/4,1/2,1/4). Source: R. Norton, Cam Design and Manufacturing Handbook, ch. 3.
std::vector<Segment> scca(double b, double c, double d);

}  // namespace jounce
