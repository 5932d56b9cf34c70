// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/design.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/resolve.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

Extrapolation outside(const CamSpec& spec) {
  if (!spec.periodic) return Extrapolation::hold;
  return spec.slave_period ? Extrapolation::advance : Extrapolation::wrap;
}

char letter(double velocity, double acceleration, const Ranges& peaks) {
  const bool moves = std::abs(velocity) > rounded_input * std::abs(peaks[1].peak().value);
  const bool bends = std::abs(acceleration) > rounded_input * std::abs(peaks[2].peak().value);
  return moves ? (bends ? 'B' : 'G') : (bends ? 'U' : 'R');
}

}  // namespace

std::vector<CamKnot> resolved_knots(const CamSpec& spec) {
  std::vector<CamKnot> knots;
  for (const cam_detail::Placed& placed : cam_detail::resolve(spec)) {
    if (knots.empty()) knots.push_back(placed.from);
    knots.push_back(placed.to);
  }
  return knots;
}

CamDesign design(const CamSpec& spec) {
  std::vector<Segment> segments;
  std::vector<std::size_t> origin;
  for (const cam_detail::Placed& placed : cam_detail::resolve(spec)) {
    const auto made = cam_detail::built(placed);
    segments.insert(segments.end(), made.begin(), made.end());
    origin.resize(segments.size(), placed.index);
  }
  return {Cam(std::move(segments), spec.start.master, outside(spec)), std::move(origin)};
}

std::vector<std::vector<LawPiece>> shapes(const CamSpec& spec) {
  std::vector<std::vector<LawPiece>> all;
  for (const cam_detail::Placed& placed : cam_detail::resolve(spec)) {
    if (!has_own_shape(placed.spec->law))
      throw InputError("segment[" + std::to_string(placed.index + 1) + "].law",
                       name(placed.spec->law),
                       "is a spline through points: it has no shape of its own");
    all.push_back(cam_detail::shapes(placed));
  }
  return all;
}

std::string transition(const CamDesign& made, std::size_t segment) {
  const auto first = std::lower_bound(made.origin.begin(), made.origin.end(), segment);
  const auto last = std::upper_bound(first, made.origin.end(), segment);
  const auto index = [&](auto it) { return static_cast<std::size_t>(it - made.origin.begin()); };
  const Ranges peaks = segment_extrema(made.cam, index(first), index(last) - 1);
  const Jet from = evaluate(made.cam.segments()[index(first)], 0);
  const Jet to = evaluate(made.cam.segments()[index(last) - 1], 1);
  return {letter(from[1], from[2], peaks), '-', letter(to[1], to[2], peaks)};
}

}  // namespace jounce
