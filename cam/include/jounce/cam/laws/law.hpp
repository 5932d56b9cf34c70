// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// The motion laws of cams (VDI 2143; Norton, Cam Design and Manufacturing Handbook, ch. 2-5).
/// docs/laws.md is the guide to choosing one; `jounce laws` prints it.
enum class Law {
  line,            ///< straight line: constant velocity
  dwell,           ///< the slave stands still
  quintic,         ///< 5th degree from position, velocity, acceleration at both ends
  septic,          ///< 7th degree: the same with jerk 0 at both ends
  nonic,           ///< 9th degree: the same with jerk and jounce 0 at both ends
  polynomial,      ///< through points and derivatives inside the segment: up to degree 11
  cubic_spline,    ///< cubic pieces through points
  quintic_spline,  ///< quintic pieces through points, least rms jerk
  hermite,         ///< polynomial pieces through points with their derivatives
  cubic,           ///< 2-3 polynomial
  poly345,         ///< 3-4-5 polynomial
  poly4567,        ///< 4-5-6-7 polynomial
  poly56789,       ///< 5-6-7-8-9 polynomial
  parabola,        ///< quadratic parabola: constant acceleration, then deceleration
  simple_sine,     ///< harmonic
  inclined_sine,   ///< cycloid (Bestehorn)
  modified_sine,
  modified_trapezoid,
  modified_constant_velocity,  ///< modified sine around a straight part
  scca,                        ///< sine, constant, cosine acceleration in given shares
  gutman13,                    ///< two harmonics
  freudenstein13,              ///< two harmonics
  freudenstein135,             ///< three harmonics
  minimum_peak_jerk,           ///< lowest peak jerk (perfect spline)
  sine_straight,               ///< U-U: half a cosine at each end of a line
  harmonic_combination,        ///< R-U: half a modified sine, then a quarter cosine
  modified_trapezoid_ru,       ///< R-U: half a modified trapezoid, then constant deceleration
  double_harmonic,             ///< R-U
  eighth_degree,               ///< R-U: 8th degree polynomial
};

/// Permitted ends of a law (VDI 2143 letters: R rest, G velocity, U acceleration, B both).
enum class Ends {
  given,             ///< B: velocity and acceleration of the knots
  straight,          ///< G at the slope of its own chord
  standing,          ///< R, and no stroke
  moving,            ///< G or R: any velocity, acceleration 0
  moving_free,       ///< any velocity; the acceleration follows from the law
  rest_to_reversal,  ///< R at one end; at the other U, whose acceleration follows from the law
};

/// Description of a law: the words of the spec, the guide and the error messages.
struct LawInfo {
  Law law = Law::line;
  const char* name = "";   ///< the word of the spec: "modified_sine"
  const char* title = "";  ///< "Modified sine"
  Ends ends = Ends::given;
  bool inflection = false;  ///< takes LawForm::inflection
  const char* use = "";
  const char* strength = "";
  const char* weakness = "";
};

/// All laws, in the order of the enum.
std::span<const LawInfo> all_laws();
const LawInfo& info(Law law);
const char* name(Law law);
std::optional<Law> law_named(std::string_view name);

/// The shape parameters of a law. An omitted value is the default of the law.
struct LawForm {
  /// lambda in (0, 1): the share of the segment before its inflection, the point of peak velocity.
  std::optional<double> inflection = {};
  /// Share of constant velocity, in [0, 1): of scca, modified_constant_velocity (1/2), and of
  /// sine_straight (1/2).
  std::optional<double> straight = {};
  /// scca: of each half, the shares of sine, constant and cosine; >= 0, their sum 1.
  std::optional<std::array<double, 3>> shares = {};
};

/// Throws InputError for a form that the law does not accept, or a value out of range.
void require_valid(Law law, const LawForm& form);

/// A piece of a law over z in [0, 1]: the law from 0 to 1 at rest, and the contribution of each
/// value at its ends. Every law is linear in these. With the stroke h = p1 - p0, the length L, and
/// velocity and acceleration by master position at both ends,
///
///     f = p0 + h rise + v0 L enter + v1 L leave + a0 L^2 bend_in + a1 L^2 bend_out
///
/// The shape of a value that the law does not take is zero. The lengths of all pieces sum to 1.
struct LawPiece {
  Segment rise;
  Segment enter;
  Segment leave;
  Segment bend_in;
  Segment bend_out;
};

/// The law as pieces. For all laws except polynomial, hermite and the splines, which have no shape
/// of their own; dwell is a line without stroke. R-U laws run from rest to the reversal. Throws
/// InputError for a form that the law does not accept, or a value out of range.
std::vector<LawPiece> pieces(Law law, const LawForm& form = {});

/// The rise alone, from 0 to 1: segments whose lengths sum to 1.
std::vector<Segment> normalised(Law law, const LawForm& form = {});

/// True if pieces() supports the law. The others go through points: polynomial, hermite, the
/// splines.
bool has_own_shape(Law law);
bool is_spline(Law law);

/// The sine-constant-cosine acceleration family: a quarter sine over the share b of each half, a
/// constant over c, a quarter cosine over d; b + c + d = 1, each >= 0. They surround an interval of
/// constant velocity over the share `straight` in [0, 1) of the whole. Its members are the parabola
/// (0,1,0), simple sine (0,0,1), cycloid (1/2,0,1/2), modified sine (1/4,0,3/4), modified trapezoid
/// (1/4,1/2,1/4), and with a straight share the modified constant velocity (1/4,0,3/4) and the U-U
/// sine-straight (0,0,1). Source: R. Norton, Cam Design and Manufacturing Handbook, ch. 3.
std::vector<Segment> scca(double b, double c, double d, double straight = 0);

/// lambda of an R-U law that ends with the normalized acceleration f''(1) = -`deceleration` (stroke
/// 1, length 1), which must be above least_deceleration(law), the value for lambda = 0. For the R-U
/// laws that take an inflection.
double inflection_for(Law law, double deceleration);
double least_deceleration(Law law);

}  // namespace jounce
