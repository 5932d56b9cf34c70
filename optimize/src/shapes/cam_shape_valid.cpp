// SPDX-License-Identifier: Apache-2.0
// Validation of a cam with free shapes.
#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/optimize/cam_shape.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/shapes/cam_run.hpp"

namespace jounce {
namespace {

std::string key_of(std::size_t segment, const char* field) {
  return "segment[" + std::to_string(segment + 1) + "].free." + field;
}

void require_shapes(const CamShapeProblem& problem) {
  if (problem.shapes.empty())
    throw InputError("shapes", "", "are missing: free at least one segment");
  for (std::size_t i = 0; i < problem.shapes.size(); ++i) {
    const FreeShape& shape = problem.shapes[i];
    if (shape.segment >= problem.cam.segments.size())
      throw InputError(key_of(shape.segment, "shape"), std::to_string(shape.pieces),
                       "is not the number of a segment");
    if (i > 0 && shape.segment <= problem.shapes[i - 1].segment)
      throw InputError(key_of(shape.segment, "shape"), std::to_string(shape.pieces),
                       "free segments must ascend");
    if (shape.pieces < 1 || shape.pieces > 2000)
      throw InputError(key_of(shape.segment, "shape"), std::to_string(shape.pieces),
                       "must be 1 to 2000 pieces");
    if (shape.continuity < 2 || shape.continuity > 6)
      throw InputError(key_of(shape.segment, "continuity"), std::to_string(shape.continuity),
                       "must be 2 to 6 continuous derivatives");
    if (shape.continuity != problem.shapes.front().continuity)
      throw InputError(key_of(shape.segment, "continuity"), std::to_string(shape.continuity),
                       "must be the same in all free segments");
    const auto& knots = problem.cam;
    const double from =
        shape.segment == 0 ? knots.start.slave : knots.segments[shape.segment - 1].end.slave;
    if (shape.monotone && from == knots.segments[shape.segment].end.slave)
      throw InputError(key_of(shape.segment, "monotone"), "true", "needs a segment with a stroke");
  }
}

std::string knot_key(std::size_t knot) {
  return knot == 0 ? "start.free" : "segment[" + std::to_string(knot) + "].free";
}

void require_ends(const CamShapeProblem& problem) {
  const auto runs = optimize_detail::runs_of(problem);
  for (const FreeShape& shape : problem.shapes) {
    if (shape.end_jerk == EndJerk::as_given) continue;
    const auto at_end = [&](const optimize_detail::CamRunOf& run) {
      return !run.closed &&
             (run.segments.front() == shape.segment || run.segments.back() == shape.segment);
    };
    if (std::none_of(runs.begin(), runs.end(), at_end))
      throw InputError(key_of(shape.segment, "ends.jerk"), "",
                       "applies only to the first and the last segment of a run of free segments");
    if (shape.end_jerk == EndJerk::zero && shape.continuity < 3)
      throw InputError(key_of(shape.segment, "ends.jerk"), "0", "needs a continuity of 3 or more");
  }
}

bool is_free(const CamShapeProblem& problem, std::size_t segment) {
  return std::any_of(problem.shapes.begin(), problem.shapes.end(),
                     [&](const FreeShape& s) { return s.segment == segment; });
}

/// A knot may change only where every adjacent segment is free.
bool is_reached(const CamShapeProblem& problem, std::size_t knot) {
  const std::size_t last = problem.cam.segments.size();
  const bool wraps = problem.cam.periodic;
  const bool before = knot > 0 ? is_free(problem, knot - 1) : !wraps || is_free(problem, last - 1);
  const bool after = knot < last ? is_free(problem, knot) : !wraps || is_free(problem, 0);
  return before && after;
}

void require_knots(const CamShapeProblem& problem) {
  const std::size_t last = problem.cam.segments.size();
  for (const FreeKnot& free : problem.knots) {
    const std::string key = knot_key(free.knot);
    if (free.master)
      throw InputError(key + ".master", "",
                       "cannot be free next to free shapes: free either the shape, or the masters "
                       "of knots between laws");
    if (free.knot > last || !is_reached(problem, free.knot))
      throw InputError(key, "", "every segment next to a free knot must have a free shape");
    const bool closed = problem.cam.periodic && problem.shapes.size() == last;
    if (closed && free.knot % last == 0 && free.slave)
      throw InputError(key + ".slave", "",
                       "cannot be free at the seam of a cam whose segments are all free");
    for (const auto& [name, bound] : {std::pair{".slave", free.slave},
                                      {".geo_velocity", free.geo_velocity},
                                      {".geo_acceleration", free.geo_acceleration}})
      if (bound && !(bound->lower <= bound->upper))
        throw InputError(key + name, number(bound->lower) + " to " + number(bound->upper),
                         "must be [least, greatest], in this order");
  }
}

void require_corridors(const CamShapeProblem& problem) {
  const auto runs = optimize_detail::runs_of(problem);
  for (std::size_t i = 0; i < problem.corridors.size(); ++i) {
    const Corridor& c = problem.corridors[i];
    const std::string key = "corridor[" + std::to_string(i + 1) + "]";
    if (!(c.from <= c.to))
      throw InputError(key + ".from", c.from, "must be at most to = " + number(c.to));
    const bool met = std::any_of(runs.begin(), runs.end(),
                                 [&](const auto& run) { return optimize_detail::meets(c, run); });
    if (met) continue;
    std::string ranges;
    for (const auto& run : runs)
      ranges += (ranges.empty() ? "" : ", ") + number(run.knots.front().master) + " to " +
                number(run.knots.back().master);
    throw InputError(key + (c.from == c.to ? ".at" : ".from"), c.from,
                     "must lie in a segment with a free shape: " + ranges);
  }
}

}  // namespace

void require_valid(const CamShapeProblem& problem) {
  require_shapes(problem);
  (void)resolved_knots(problem.cam);
  require_knots(problem);
  require_ends(problem);
  require_valid(problem.limits);
  if (problem.minimize.empty()) throw InputError("minimize", "", "must name at least one figure");
  for (const auto& stage : problem.minimize)
    if (stage.empty() || (stage.size() > 1 && problem.minimize.size() > 1))
      throw InputError("minimize", std::to_string(stage.size()),
                       "must be either weighted figures, or figures in order of priority");
  require_corridors(problem);
  if (!(problem.concession >= 0 && problem.concession <= 1))
    throw InputError("tolerance", problem.concession, "must be between 0 and 1");
}

}  // namespace jounce
