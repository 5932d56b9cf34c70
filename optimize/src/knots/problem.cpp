// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "jounce/cam/detail/quadrature.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/knots/free_quantities.hpp"

namespace jounce {
namespace {

using optimize_detail::Quantity;

constexpr std::array objectives{Objective::peak_acceleration, Objective::peak_jerk,
                                Objective::rms_acceleration};

/// True if `law`, which begins or ends at a knot, fixes the quantity there.
bool fixes(Law law, Quantity quantity) {
  const Ends ends = info(law).ends;
  switch (quantity) {
    case Quantity::master:
      return ends == Ends::straight || reverses(ends);
    case Quantity::slave:
      return ends == Ends::straight || ends == Ends::standing || reverses(ends);
    case Quantity::geo_velocity:
      return ends != Ends::given && ends != Ends::moving && ends != Ends::moving_free;
    default:
      return ends != Ends::given;
  }
}

void require_law_leaves_free(const CamSpec& cam, std::size_t knot, Quantity quantity,
                             const std::string& key, double given) {
  const std::size_t last = cam.segments.size();
  const auto consider = [&](std::size_t segment) {
    const Law law = cam.segments[segment].law;
    if (fixes(law, quantity))
      throw InputError(key, given,
                       std::string("cannot be free: the law `") + name(law) + "` of segment " +
                           std::to_string(segment + 1) +
                           " fixes it. Leave it out; `shape = 60` instead frees the shape of a "
                           "segment");
  };
  // A law that determines its acceleration passes it on to an adjacent polynomial. A free quantity
  // would change that acceleration too, and the problem would not be linear in the free quantities.
  const auto hands_over = [&](std::size_t segment) {
    if (info(cam.segments[segment].law).ends != Ends::moving_free) return;
    const std::size_t before = segment > 0 ? segment - 1 : (cam.periodic ? last - 1 : last);
    const std::size_t after = segment + 1 < last ? segment + 1 : (cam.periodic ? 0 : last);
    for (const std::size_t beside : {before, after})
      if (beside < last && beside != segment && info(cam.segments[beside].law).ends == Ends::given)
        throw InputError(key, given,
                         std::string("cannot be free: the acceleration of the law `") +
                             name(cam.segments[segment].law) + "` of segment " +
                             std::to_string(segment + 1) + " would change that of segment " +
                             std::to_string(beside + 1) + " beside it");
  };
  const bool seam = cam.periodic && (knot == 0 || knot == last);
  const auto look = [&](std::size_t segment) {
    consider(segment);
    hands_over(segment);
  };
  if (knot > 0 || seam) look(knot > 0 ? knot - 1 : last - 1);
  if (knot < last || seam) look(knot < last ? knot : 0);
}

/// True if the slave position of a knot between two segments can be free.
bool can_be_free(const CamSpec& cam, std::size_t knot) {
  try {
    require_law_leaves_free(cam, knot, Quantity::slave, "", 0);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// Advice for a spec without a free quantity: the key that frees one.
std::string what_to_free(const CamSpec& cam) {
  const auto knots = optimize_detail::knots_of(cam);
  const auto stroke = [&](std::size_t i) {
    const std::size_t slave = optimize_detail::index(Quantity::slave);
    return std::abs(knots[i + 1][slave] - knots[i][slave]);
  };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < cam.segments.size(); ++i)
    if (stroke(i) > stroke(longest)) longest = i;
  std::string text = "add free = { shape = 60 } to segment " + std::to_string(longest + 1) +
                     " to free its shape, and minimize = [\"peak geo_jerk\"] to [optimize]";
  for (std::size_t knot = 1; knot < cam.segments.size(); ++knot)
    if (can_be_free(cam, knot))
      return text + ", or free = { slave = [LEAST, GREATEST] } to segment " + std::to_string(knot) +
             " to free the knot at its end";
  return text;
}

void require_bound(const CamProblem& problem, const FreeKnot& free, Quantity quantity,
                   double given) {
  const auto& bound = optimize_detail::bound_of(free, quantity);
  if (!bound) return;
  const std::string key = optimize_detail::free_key(free.knot, quantity);
  require_finite((key + ".lower").c_str(), bound->lower);
  require_finite((key + ".upper").c_str(), bound->upper);
  const std::string interval = "[" + number(bound->lower) + ", " + number(bound->upper) + "]";
  if (bound->lower > bound->upper)
    throw InputError(key, interval, "must be [least, greatest], in this order");
  if (given < bound->lower || given > bound->upper)
    throw InputError(key, interval, "must contain the given value, " + number(given));
  if (quantity == Quantity::master && (free.knot == 0 || free.knot == problem.cam.segments.size()))
    throw InputError(
        key, interval,
        "cannot be free: the first and the last knot of the cam are fixed. Leave it out");
  require_law_leaves_free(problem.cam, free.knot, quantity, key, given);
}

void require_free(const CamProblem& problem) {
  const auto knots = optimize_detail::knots_of(problem.cam);
  const std::size_t last = knots.size() - 1;
  std::vector<bool> named(knots.size());
  for (const FreeKnot& free : problem.free) {
    const std::string key = optimize_detail::free_key(free.knot);
    if (free.knot > last)
      throw InputError(key, static_cast<double>(free.knot),
                       "must be at most " + std::to_string(last) + ", the number of segments");
    if (named[free.knot])
      throw InputError(
          key, static_cast<double>(free.knot),
          problem.cam.periodic && (free.knot == 0 || free.knot == last)
              ? "start and last knot of a periodic cam are the same knot: name one of them, once"
              : "names a knot twice");
    named[free.knot] = true;
    if (problem.cam.periodic && (free.knot == 0 || free.knot == last))
      named.front() = named.back() = true;
    for (const Quantity q : optimize_detail::quantities)
      require_bound(problem, free, q, knots[free.knot][optimize_detail::index(q)]);
  }
  const auto freedom = optimize_detail::freedom(problem);
  if (std::none_of(freedom.begin(), freedom.end(), optimize_detail::any))
    throw InputError("free", "", "nothing is free to optimize: " + what_to_free(problem.cam));
}

void require_objectives(const std::vector<Objective>& minimize) {
  if (minimize.empty())
    throw InputError("minimize", "",
                     "must name at least one objective, such as [\"peak geo_jerk\"]");
  for (std::size_t i = 1; i < minimize.size(); ++i)
    if (std::find(minimize.begin(), minimize.begin() + static_cast<std::ptrdiff_t>(i),
                  minimize[i]) != minimize.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError("minimize[" + std::to_string(i + 1) + "]", name(minimize[i]),
                       "is named twice");
}

double integral_of_square(const Segment& f) {
  return f.length * cam_detail::integral([&](double s) {
           const double y = value(f, s);
           return y * y;
         });
}

}  // namespace

const char* name(Objective objective) {
  switch (objective) {
    case Objective::peak_acceleration:
      return "peak geo_acceleration";
    case Objective::peak_jerk:
      return "peak geo_jerk";
    case Objective::rms_acceleration:
      break;
  }
  return "rms geo_acceleration";
}

std::optional<Objective> objective_named(std::string_view wanted) {
  for (const Objective objective : objectives)
    if (name(objective) == wanted) return objective;
  return std::nullopt;
}

double value_of(Objective objective, const Cam& cam) {
  if (objective != Objective::rms_acceleration)
    return std::abs(extrema(cam, objective == Objective::peak_acceleration ? 2 : 3).peak().value);
  double total = 0;
  for (const Segment& f : cam.segments()) total += integral_of_square(derivative(derivative(f)));
  return std::sqrt(total / cam.length());
}

void require_valid(const CamProblem& problem) {
  static_cast<void>(resolved_knots(problem.cam));  // throws for an invalid cam
  require_valid(problem.limits);
  require_free(problem);
  require_objectives(problem.minimize);
  require_valid(problem.options);
  require_not_negative("ramp", problem.ramped.ramp);
  require_valid(problem.ramped.limits);
}

}  // namespace jounce
