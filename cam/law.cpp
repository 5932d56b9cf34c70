#include "jounce/cam/law.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "jounce/profiles/curve.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::array laws{Law::line,         Law::dwell,         Law::quintic,
                          Law::poly345,      Law::modified_sine, Law::modified_trapezoid,
                          Law::inclined_sine};

/// amplitude * sin over [from, to] rad, as a segment of the given length.
Segment sine_piece(double length, double from, double to) {
  Segment f;
  f.length = length;
  f.sines = 1;
  f.sine[0] = {1, to - from, from};
  return f;
}

Segment constant_piece(double length, double level) {
  Segment f;
  f.length = length;
  f.c[0] = level;
  return f;
}

}  // namespace

const char* name(Law law) {
  switch (law) {
    case Law::line:
      return "line";
    case Law::dwell:
      return "dwell";
    case Law::quintic:
      return "quintic";
    case Law::poly345:
      return "345";
    case Law::modified_sine:
      return "modified_sine";
    case Law::modified_trapezoid:
      return "modified_trapezoid";
    case Law::inclined_sine:
      break;
  }
  return "inclined_sine";
}

std::span<const Law> all_laws() {
  return laws;
}

std::optional<Law> law_named(std::string_view wanted) {
  const auto it =
      std::find_if(laws.begin(), laws.end(), [&](Law law) { return name(law) == wanted; });
  return it == laws.end() ? std::nullopt : std::optional(*it);
}

bool is_rest_to_rest(Law law) {
  return law != Law::line && law != Law::quintic;
}

std::vector<Segment> scca(double b, double c, double d) {
  require_not_negative("b", b);
  require_not_negative("c", c);
  require_not_negative("d", d);
  if (std::abs(b + c + d - 1) > 1e-12) throw InputError("b + c + d", b + c + d, "must be 1");
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<Segment> acceleration;
  if (b > 0) acceleration.push_back(sine_piece(b / 2, 0, quarter));
  if (c > 0) acceleration.push_back(constant_piece(c / 2, 1));
  if (d > 0) acceleration.push_back(sine_piece(d / 2, quarter, 2 * quarter));

  // Two integrations give the rise over the first half for a peak of 1; the stroke fixes the scale,
  // and the second half is the point reflection of the first.
  const Cam unscaled = integral(integral(Cam(acceleration)));
  const Cam first = scaled(unscaled, 0.5 / unscaled.jet(unscaled.end(), Side::left)[0]);
  const Cam second = shifted(scaled(reversed(first), -1), 0, 1);
  const Cam whole = concatenated(first, second);
  return {whole.segments().begin(), whole.segments().end()};
}

std::vector<Segment> normalised(Law law) {
  switch (law) {
    case Law::line:
      return {line(1, 0, 1)};
    case Law::poly345:
      return {quintic(1, 0, 0, 0, 1, 0, 0)};
    case Law::modified_sine:
      return scca(0.25, 0, 0.75);
    case Law::modified_trapezoid:
      return scca(0.25, 0.5, 0.25);
    case Law::inclined_sine: {
      Segment f = line(1, 0, 1);
      f.sines = 1;
      f.sine[0] = {-1 / (2 * std::numbers::pi), 2 * std::numbers::pi, 0};
      return {f};
    }
    case Law::dwell:
    case Law::quintic:
      break;
  }
  assert(false && "dwell and quintic have no normalised form");
  return {};
}

}  // namespace jounce
