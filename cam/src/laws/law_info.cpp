// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cassert>

#include "jounce/cam/laws/law.hpp"

namespace jounce {
namespace {

constexpr std::array laws{
    LawInfo{Law::line, "line", "Straight line", Ends::straight, false,
            "in step with the master: cutting, sealing, printing at constant speed",
            "constant velocity, exactly",
            "the velocity steps unless the segments before and after the line end at its velocity "
            "(quintic, or any law with the ends R, G)"},
    LawInfo{Law::dwell, "dwell", "Dwell", Ends::standing, false, "the slave waits",
            "no motion, no load", "none"},
    LawInfo{
        Law::quintic, "quintic", "5th degree polynomial", Ends::given, false,
        "between any two states; the law of most controllers' cam editors (Poly5, XYVA)",
        "accepts every velocity and acceleration at its ends; least rms jerk for the given ends",
        "may overshoot its end positions; `jounce check` then warns"},
    LawInfo{Law::septic, "septic", "7th degree polynomial", Ends::given, false,
            "like quintic, but with a continuous jerk (Poly7)",
            "jerk 0 at both ends: little excitation",
            "higher peaks of velocity and acceleration than quintic"},
    LawInfo{Law::nonic, "nonic", "9th degree polynomial", Ends::given, false,
            "like septic, with jounce 0 at both ends", "the smoothest joints",
            "the highest peaks of quintic, septic and nonic"},
    LawInfo{Law::polynomial, "polynomial", "Free polynomial", Ends::given, false,
            "one polynomial through `points` and their derivatives inside the segment",
            "infinitely smooth inside; meets all given values exactly, up to degree 11",
            "oscillates if points are close together or contradict each other"},
    LawInfo{Law::cubic_spline, "cubic_spline", "Cubic spline", Ends::moving_free, false,
            "measured or taught `points`, for controllers with cubic (PVT) tables",
            "continuous acceleration at all points", "the jerk steps at every point"},
    LawInfo{Law::quintic_spline, "quintic_spline", "Quintic spline", Ends::given, false,
            "measured or taught `points`, with a tolerance if they are noisy",
            "least rms jerk of all curves through the points; continuous jerk and jounce",
            "an outlier also bends the curve around it"},
    LawInfo{
        Law::hermite, "hermite", "Piecewise polynomial", Ends::given, false,
        "`points` with geo_velocity and geo_acceleration, as in XYVA tables and in the results of "
        "`jounce optimize`; quintic pieces, or pieces of degree 7 if the points have a geo_jerk",
        "any shape, exactly; a point changes only the two pieces next to it",
        "depending on the given numbers, the jerk may step at every point"},
    LawInfo{Law::b_spline, "b_spline", "B-spline, Bezier curve", Ends::given, false,
            "a curve from CAD, as `control` values, with inner `knots` and a `degree`; without "
            "knots a Bezier curve",
            "the curve of the CAD system, exactly; a control value changes only the pieces near it",
            "the curve passes only through the first and the last control value"},
    LawInfo{Law::cubic, "cubic", "2-3 polynomial", Ends::moving_free, false,
            "when the heat of the motor is the limit, and acceleration steps are permitted",
            "lowest rms acceleration of all laws; low peak velocity",
            "acceleration steps at both ends"},
    LawInfo{Law::poly345, "345", "3-4-5 polynomial", Ends::moving, true,
            "general purpose, medium speed",
            "lowest rms jerk of all laws from rest to rest; simple to compute on every controller",
            "peak acceleration 21.5 % above the least that is possible with its peak jerk"},
    LawInfo{Law::poly4567, "4567", "4-5-6-7 polynomial", Ends::moving, true,
            "high speed with an elastic follower", "jerk begins and ends at 0: little vibration",
            "high peak velocity and acceleration"},
    LawInfo{Law::poly56789, "56789", "5-6-7-8-9 polynomial", Ends::moving, true,
            "very high speed; the output of a polydyne cam", "jerk and jounce begin and end at 0",
            "the highest peak velocity and acceleration of the polynomials here"},
    LawInfo{Law::parabola, "parabola", "Quadratic parabola", Ends::moving_free, true,
            "slow machines; a lower bound for comparison", "lowest possible peak acceleration",
            "acceleration steps three times, which causes noise and vibration"},
    LawInfo{Law::simple_sine, "simple_sine", "Simple sine (harmonic)", Ends::moving_free, true,
            "back and forth without a dwell (U-U), like a crank",
            "lowest dynamic torque of the sine laws; only one harmonic",
            "acceleration steps next to a dwell"},
    LawInfo{Law::inclined_sine, "inclined_sine", "Inclined sine (Bestehorn, cycloid)", Ends::moving,
            true, "high speed, light loads", "smooth and quiet: low residual vibration",
            "high peak acceleration, and high torque on the master (Cm)"},
    LawInfo{Law::modified_sine, "modified_sine", "Modified sine", Ends::moving, true,
            "indexers and heavy loads; the usual first choice",
            "low peak velocity, and the lowest torque on the master (Cm) of the smooth laws; "
            "tolerant of manufacturing errors",
            "a little more acceleration than the modified trapezoid"},
    LawInfo{Law::modified_sine_gg, "modified_sine_gg", "Modified sine G-G", Ends::moving, true,
            "from one constant velocity to another, as in the cam editors of controllers; between "
            "two rests the same as modified_sine",
            "four pieces of sines, with the velocity peak at the inflection",
            "jerk steps at the inflection if the velocities at its ends differ"},
    LawInfo{Law::modified_trapezoid, "modified_trapezoid", "Modified acceleration trapezoid",
            Ends::moving, true, "when the peak torque of the motor is the limit",
            "lowest peak acceleration of the smooth laws",
            "high peak velocity, and high torque on the master (Cm); more vibration than "
            "modified sine"},
    LawInfo{Law::modified_constant_velocity, "modified_constant_velocity",
            "Modified constant velocity", Ends::moving, true,
            "long strokes when the speed is the limit; a process in the middle of the stroke",
            "low peak velocity: the speed is constant over the share `straight` of the segment "
            "(default 1/2)",
            "high acceleration at both ends"},
    LawInfo{Law::scca, "scca", "Sine-constant-cosine acceleration", Ends::moving_free, true,
            "a law of your own, with `shares` of sine, constant and cosine acceleration, and a "
            "share `straight` of constant speed",
            "varies continuously from one classical law to another",
            "without a share of sine, its acceleration steps at both ends"},
    LawInfo{Law::gutman13, "gutman_13", "Gutman 1-3", Ends::moving, true,
            "high speed with a known natural frequency of the drive",
            "only two harmonics: no excitation above the third harmonic",
            "more jerk than inclined sine"},
    LawInfo{Law::freudenstein13, "freudenstein_13", "Freudenstein 1-3", Ends::moving, true,
            "like Gutman 1-3", "two harmonics, less jerk than Gutman 1-3",
            "a little more acceleration than Gutman 1-3"},
    LawInfo{Law::freudenstein135, "freudenstein_135", "Freudenstein 1-3-5", Ends::moving, true,
            "like Gutman 1-3", "three harmonics: lower acceleration than 1-3",
            "excites up to the fifth harmonic"},
    LawInfo{Law::triple_harmonic, "triple_harmonic", "Triple harmonic", Ends::moving, true,
            "a law of your own, with the amplitudes of two `harmonics` of the acceleration; the "
            "third amplitude follows",
            "only three harmonics; with the default, the jerk is 0 at both ends and in the middle",
            "unsuitable amplitudes give high peaks, or a reversal"},
    LawInfo{Law::minimum_peak_jerk, "minimum_peak_jerk", "Minimum peak jerk (perfect spline)",
            Ends::moving, true, "when the jerk is the limit; a lower bound for comparison",
            "lowest possible peak jerk: 32", "high acceleration; the jerk steps inside"},
    LawInfo{Law::sine_straight, "sine_straight", "Sine-straight", Ends::moving_free, true,
            "back and forth without a dwell (U-U), with constant speed over the share `straight` "
            "(default 1/2)",
            "low peak velocity", "acceleration steps next to a dwell"},
    LawInfo{Law::harmonic_combination, "harmonic_combination", "Harmonic combination",
            Ends::rest_to_reversal, true, "from a dwell to a reversal, and back (R-U, U-R)",
            "low acceleration, because there is no stop at the reversal; adjustable by "
            "`inflection`, or by the acceleration at the knot of the reversal",
            "acceleration steps at the reversal unless the next segment begins with the same "
            "acceleration"},
    LawInfo{Law::harmonic_combination_gu, "harmonic_combination_gu", "Harmonic combination G-U",
            Ends::moving_to_reversal, true,
            "from a constant velocity to a reversal, and back (G-U, U-G)",
            "like harmonic_combination, joined to a line",
            "acceleration steps at the reversal unless the next segment begins with the same "
            "acceleration"},
    LawInfo{Law::modified_trapezoid_ru, "modified_trapezoid_ru", "Modified trapezoid R-U",
            Ends::rest_to_reversal, true, "like harmonic_combination, with lower peak acceleration",
            "lowest peak acceleration of the R-U laws here", "higher peak velocity"},
    LawInfo{Law::double_harmonic, "double_harmonic", "Double harmonic", Ends::rest_to_reversal,
            false, "slow start from a dwell to a reversal", "only two harmonics; gentle start",
            "at the reversal, twice the peak acceleration of the simple sine"},
    LawInfo{Law::eighth_degree, "eighth_degree", "8th degree polynomial R-U",
            Ends::rest_to_reversal, false, "valve cams: from a dwell to a reversal",
            "equal peaks of acceleration and deceleration, no jerk at the reversal",
            "the shape cannot be adjusted"},
};

}  // namespace

std::span<const LawInfo> all_laws() {
  return laws;
}

const LawInfo& info(Law law) {
  const LawInfo& found = laws[static_cast<std::size_t>(law)];
  assert(found.law == law && "the table is in the order of the enum");
  return found;
}

const char* name(Law law) {
  return info(law).name;
}

std::optional<Law> law_named(std::string_view wanted) {
  const auto it = std::find_if(laws.begin(), laws.end(),
                               [&](const LawInfo& law) { return law.name == wanted; });
  return it == laws.end() ? std::nullopt : std::optional(it->law);
}

bool is_spline(Law law) {
  return law == Law::cubic_spline || law == Law::quintic_spline;
}

bool takes_points(Law law) {
  return law == Law::polynomial || law == Law::hermite || is_spline(law);
}

bool has_own_shape(Law law) {
  return !takes_points(law) && law != Law::b_spline;
}

bool takes_jerk(Law law) {
  return law == Law::septic || law == Law::nonic;
}

bool reverses(Ends ends) {
  return ends == Ends::rest_to_reversal || ends == Ends::moving_to_reversal;
}

}  // namespace jounce
