// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// The motion laws of cams (VDI 2143; Norton, Cam Design and Manufacturing Handbook, ch. 2-5).
/// docs/laws.md is the guide to choosing one; `jounce laws` prints it.
enum class Law {
  line,            ///< straight line, constant velocity
  dwell,           ///< the slave stands still
  quintic,         ///< polynomial of degree 5 from position, velocity and acceleration at both ends
  septic,          ///< degree 7: like quintic, with a given jerk at both ends; default 0
  nonic,           ///< degree 9: like septic, with jounce 0 at both ends
  polynomial,      ///< through points and derivatives inside the segment; up to degree 11
  cubic_spline,    ///< cubic pieces through points
  quintic_spline,  ///< quintic pieces through points, with the least rms jerk
  hermite,         ///< polynomial pieces through points with given derivatives
  b_spline,        ///< control values and knots; without inner knots a Bezier curve
  cubic,           ///< 2-3 polynomial
  poly345,         ///< 3-4-5 polynomial
  poly4567,        ///< 4-5-6-7 polynomial
  poly56789,       ///< 5-6-7-8-9 polynomial
  parabola,        ///< constant acceleration, then constant deceleration
  simple_sine,     ///< harmonic (half a cosine)
  inclined_sine,   ///< cycloid
  modified_sine,   ///< modified sine
  modified_sine_gg,            ///< modified sine between two constant velocities, of sines only
  modified_trapezoid,          ///< modified trapezoid
  modified_constant_velocity,  ///< modified sine around a straight part
  scca,                        ///< sine, constant and cosine acceleration in given shares; see
                               ///< scca() below
  gutman13,                    ///< Gutman: two harmonics
  freudenstein13,              ///< Freudenstein: two harmonics
  freudenstein135,             ///< Freudenstein: three harmonics
  triple_harmonic,             ///< three harmonics of the acceleration, in given amplitudes
  minimum_peak_jerk,           ///< perfect spline: the lowest peak jerk
  sine_straight,               ///< U-U: half a cosine, with a straight line in its middle
  harmonic_combination,        ///< R-U: half a modified sine, then a quarter cosine
  harmonic_combination_gu,     ///< G-U: like harmonic_combination, from a constant velocity
  modified_trapezoid_ru,       ///< R-U: half a modified trapezoid, then constant deceleration
  double_harmonic,             ///< R-U: two harmonics
  eighth_degree,               ///< R-U: polynomial of degree 8
};

/// States that a law permits at its ends. Letters of VDI 2143: R rest, G constant velocity, U
/// reversal, B motion.
enum class Ends {
  given,        ///< B: the knots give velocity and acceleration
  straight,     ///< G: the law requires the mean velocity of the segment
  standing,     ///< R: rest, and no stroke
  moving,       ///< R or G: any velocity, with acceleration 0
  moving_free,  ///< any velocity; the law determines the acceleration
  /// R at one end, U at the other; the law determines the acceleration at the reversal.
  rest_to_reversal,
  /// like rest_to_reversal, with any velocity and acceleration 0 in place of R
  moving_to_reversal,
};

/// True for a law with a reversal at one end: rest_to_reversal and moving_to_reversal.
bool reverses(Ends ends);

/// Facts about a law, for specs, the guide and error messages.
struct LawInfo {
  Law law = Law::line;
  const char* name = "";      ///< the word of the spec: "modified_sine"
  const char* title = "";     ///< the name in words: "Modified sine"
  Ends ends = Ends::given;    ///< permitted states at its ends
  bool inflection = false;    ///< true if the law accepts LawForm::inflection
  const char* use = "";       ///< typical use
  const char* strength = "";  ///< advantages
  const char* weakness = "";  ///< disadvantages
};

/// All laws, in the order of the enum.
std::span<const LawInfo> all_laws();
const LawInfo& info(Law law);                         ///< facts about a law
const char* name(Law law);                            ///< the word of the spec
std::optional<Law> law_named(std::string_view name);  ///< the law of a word; nullopt if unknown

/// Shape parameters of a law. An omitted value is the law's default.
struct LawForm {
  /// lambda in (0, 1): the share of the segment before its inflection, where the velocity peaks.
  std::optional<double> inflection = {};
  /// Share of constant velocity, in [0, 1): for scca (default 0), modified_constant_velocity and
  /// sine_straight (default 1/2).
  std::optional<double> straight = {};
  /// For scca, which requires them: shares of sine, constant and cosine in each half; each >= 0,
  /// sum 1.
  std::optional<std::array<double, 3>> shares = {};
  /// For triple_harmonic: amplitudes of the first two harmonics of the acceleration, for a stroke
  /// and a length of 1; default [9 pi / 4, 0]. The third amplitude follows from them.
  std::optional<std::array<double, 2>> harmonics = {};
};

/// Throws InputError if the law does not accept the form, if `inflection` or `straight` is out of
/// range, or if the shares of scca are missing. The values of the shares are checked by pieces().
void require_valid(Law law, const LawForm& form);

/// A piece of a law over z in [0, 1], as shapes that are multiplied by the values at the ends of
/// the law. Every law is linear in these values. With the stroke h = p1 - p0, the length L, and the
/// velocity v, acceleration a and jerk j with respect to the master at both ends (0: start, 1:
/// end),
///
///     f = p0 + h rise + v0 L enter + v1 L leave + a0 L^2 bend_in + a1 L^2 bend_out
///         + j0 L^3 jerk_in + j1 L^3 jerk_out
///
/// So `rise` is the law from 0 to 1, from rest to rest. If a law does not use a value, the shape of
/// this value is zero. The lengths of all pieces of a law have the sum 1.
struct LawPiece {
  Segment rise = {};      ///< factor of the stroke h
  Segment enter = {};     ///< factor of v0 L
  Segment leave = {};     ///< factor of v1 L
  Segment bend_in = {};   ///< factor of a0 L^2
  Segment bend_out = {};  ///< factor of a1 L^2
  Segment jerk_in = {};   ///< factor of j0 L^3; septic and nonic only
  Segment jerk_out = {};  ///< factor of j1 L^3; septic and nonic only
};

/// Returns the pieces of a law. polynomial, hermite, b_spline and the splines have no pieces,
/// because their shape follows from their points or control values. dwell is a line without stroke.
/// An R-U law begins at rest and ends at the reversal. Throws InputError if the law does not accept
/// the form, or if a value is out of range.
std::vector<LawPiece> pieces(Law law, const LawForm& form = {});

/// Returns the rise of a law from 0 to 1: segments whose lengths have the sum 1.
std::vector<Segment> normalized(Law law, const LawForm& form = {});

/// False for the laws through points, and for b_spline. True if pieces() supports the law.
bool has_own_shape(Law law);
bool takes_points(Law law);  ///< true for polynomial, hermite, cubic_spline and quintic_spline
bool takes_jerk(Law law);    ///< true for the laws with a given jerk at their ends: septic, nonic
bool is_spline(Law law);     ///< true for cubic_spline and quintic_spline

/// Returns the rise with sine-constant-cosine acceleration (SCCA). Each half has a quarter sine
/// over the share b, a constant over c, and a quarter cosine over d; b + c + d = 1, each >= 0.
/// Between the halves the velocity is constant over the share `straight`, in [0, 1), of the whole.
/// The laws of this family are, as (b, c, d): parabola (0, 1, 0), simple sine (0, 0, 1), cycloid
/// (1/2, 0, 1/2), modified sine (1/4, 0, 3/4), modified trapezoid (1/4, 1/2, 1/4); and with a
/// straight share, modified constant velocity (1/4, 0, 3/4) and sine-straight (0, 0, 1). Throws
/// InputError for a negative share, and for a sum of b, c and d other than 1. Requires straight
/// < 1. Source: R. Norton, Cam Design and Manufacturing Handbook, ch. 3.
std::vector<Segment> scca(double b, double c, double d, double straight = 0);

/// Returns the inflection lambda with which an R-U or G-U law ends with the normalized acceleration
/// f''(1) = -`deceleration` (stroke 1, length 1). `velocity`: the normalized velocity f'(0), below
/// greatest_velocity(law). Requires a law that accepts an inflection, and a deceleration above
/// least_deceleration(law), which belongs to lambda = 0 (asserted).
double inflection_for(Law law, double deceleration, double velocity = 0);
/// Returns the deceleration -f''(1) of an R-U or G-U law for lambda = 0, at any velocity.
double least_deceleration(Law law);
/// Returns the normalized velocity f'(0) of a G-U law for lambda = 1, where the law has no second
/// part. With this velocity, no inflection gives a deceleration.
double greatest_velocity(Law law);

}  // namespace jounce
