// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "jounce/design/make.hpp"
#include "jounce/spec/detail/drive_figures.hpp"

#include "design/src/make/cam_of.hpp"

// Makes the problem of a spec with free shapes: the values that its knots omit, and its limits over
// time.

namespace jounce {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_free(const ShapeSpec& shape, std::size_t segment) {
  for (const FreeShape& free : shape.shapes)
    if (free.segment == segment) return true;
  return false;
}

/// A knot between two free shapes states its slave position. The optimization chooses the
/// derivatives that it omits. In a periodic cam, the start and the last knot are one knot.
void free_what_is_left_out(const CamSpec& cam, const ShapeSpec& shape,
                           std::vector<FreeKnot>& knots) {
  const std::size_t last = cam.segments.size();
  for (std::size_t k = cam.periodic ? 0 : 1; k < last; ++k) {
    if (!is_free(shape, k) || !is_free(shape, k == 0 ? last - 1 : k - 1)) continue;
    FreeKnot* found = nullptr;
    for (FreeKnot& each : knots)
      if (each.knot % last == k) found = &each;
    if (found == nullptr) {
      found = &knots.emplace_back();
      found->knot = k;
    }
    const CamKnot& end = cam.segments[k == 0 ? last - 1 : k - 1].end;
    const auto given = [&](std::optional<double> CamKnot::*field) {
      return (end.*field).has_value() || (k == 0 && (cam.start.*field).has_value());
    };
    if (!found->geo_velocity && !given(&CamKnot::geo_velocity))
      found->geo_velocity = Bound{-infinite, infinite};
    if (!found->geo_acceleration && !given(&CamKnot::geo_acceleration))
      found->geo_acceleration = Bound{-infinite, infinite};
  }
}

/// The slave's derivatives over time at the master's full speed w, while its own acceleration is a:
/// f' w, f'' w^2 + f' a, f''' w^3 + 3 f'' w a.
std::array<LinearQuantity, 3> over_time(double w, double a) {
  return {LinearQuantity{"velocity", {0, w}, 0}, LinearQuantity{"acceleration", {0, a, w * w}, 0},
          LinearQuantity{"jerk", {0, 0, 3 * w * a, w * w * w}, 0}};
}

/// Adds [limits.slave] for the master at its full speed, also while it accelerates and decelerates.
void add_limits_over_time(const Spec& spec, std::vector<Corridor>& corridors) {
  (void)slave_limits_by_master(spec);
  if (!spec.master) return;
  const std::array rates{spec.slave.velocity, spec.slave.acceleration, spec.slave.jerk};
  const auto& cam = std::get<CamSpec>(spec.subject);
  const double most = spec.master->acceleration.value_or(0);
  for (const double a : {most, -most}) {
    const auto quantities = over_time(spec.master->velocity, a);
    for (std::size_t k = 0; k < rates.size(); ++k)
      if (rates[k] && (a == most || k > 0))
        corridors.push_back({quantities[k], cam.start.master, cam.segments.back().end.master,
                             Edge{-*rates[k], -*rates[k]}, Edge{*rates[k], *rates[k]}});
    if (most == 0) break;
  }
}

void refuse_figures_of_a_drive(const ShapeSpec& shape) {
  for (const ShapeFigureSpec& figure : shape.figures)
    if (drive_figure(figure.figure))
      throw InputError("minimize", '"' + figure.name + '"',
                       "is a figure of a drive: give its file with --against drive.toml");
}

CamShapeProblem problem_of(const Spec& spec, bool against_a_drive) {
  const ShapeSpec& shape = spec.optimize.shape;
  if (spec.polydyne)
    throw InputError("polydyne", "",
                     "cannot be combined with free shapes: leave one of the two out");
  CamShapeProblem problem;
  problem.cam = design_detail::cam_of(spec);
  problem.shapes = shape.shapes;
  problem.knots = spec.optimize.free;
  free_what_is_left_out(std::get<CamSpec>(spec.subject), shape, problem.knots);
  problem.limits = spec.limits;
  problem.corridors = shape.corridors;
  add_limits_over_time(spec, problem.corridors);
  problem.ceilings = shape.ceilings;
  problem.minimize = shape.minimize;
  problem.refine = shape.refine;
  problem.options.budget.seconds = spec.optimize.seconds;
  problem.options.seed = spec.optimize.seed.value_or(problem.options.seed);
  if (spec.optimize.tolerance) problem.concession = *spec.optimize.tolerance;
  if (against_a_drive) return problem;
  refuse_figures_of_a_drive(shape);
  require_valid(problem);
  return problem;
}

}  // namespace

CamShapeProblem make_shape_problem(const Spec& spec, bool against_a_drive) {
  if (!std::holds_alternative<CamSpec>(spec.subject)) throw nothing_free(spec);
  try {
    return problem_of(spec, against_a_drive);
  } catch (const InputError& error) {
    const bool own = error.key().starts_with("corridor") || error.key().starts_with("minimize") ||
                     error.key().starts_with("tolerance");
    throw spec.document.located(
        InputError((own ? "optimize." : "") + error.key(), error.value(), error.rule()));
  }
}

}  // namespace jounce
