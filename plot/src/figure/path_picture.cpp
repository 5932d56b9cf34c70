// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/path_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/detail/path_cost.hpp"
#include "jounce/path/plan.hpp"

#include "plot/src/figure/path_points.hpp"

namespace jounce {
namespace {

constexpr double angle_a_part = 0.5;  // rad, on an arc
constexpr std::size_t marked_places = 5;

[[noreturn]] void fail(const std::string& plane, const std::string& rule) {
  throw InputError("plane", plane, rule);
}

std::size_t axis_named(const std::vector<Input>& axes, const std::string& name,
                       const std::string& plane) {
  const auto at = std::find_if(axes.begin(), axes.end(),
                               [&](const Input& input) { return input.axis == name; });
  if (at == axes.end())
    fail(plane,
         "must be the names of two axes of the path, separated by a comma, such as x,y: its axes "
         "are " +
             listed(axes, &Input::axis));
  return static_cast<std::size_t>(at - axes.begin());
}

/// Instants of a curve: its breaks, and where a sine in a segment has turned by a part of a circle.
void add_breaks(const Trajectory& curve, std::vector<double>& times) {
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const Segment& segment = curve.segments()[i];
    double angle = 0;
    for (int k = 0; k < segment.sines; ++k)
      angle = std::max(angle, std::abs(segment.sine[static_cast<std::size_t>(k)].angle));
    const int parts = std::max(1, static_cast<int>(std::min(angle / angle_a_part, 1e5)));
    for (int k = 0; k < parts; ++k) times.push_back(curve.breaks()[i] + segment.length * k / parts);
  }
  times.push_back(curve.end());
}

/// The pieces of a plan that are rapids of a G-code program, and the corners beside them.
class Rapids {
 public:
  Rapids(const Plan& plan, const Spec& spec) : plan_(&plan) {
    const auto& of = std::get<PathSpec>(spec.subject);
    if (of.rapids.empty() || !of.override_steps.empty())
      return;  // then times are not those of the plan
    bool before = false;
    for (const PathPiece& piece : plan.path().pieces()) {
      const bool listed = std::binary_search(of.rapids.begin(), of.rapids.end(), piece.line);
      const bool corner = piece.kind == PieceKind::turn || piece.kind == PieceKind::blend;
      rapid_.push_back(listed || (corner && before));
      before = listed;
    }
    if (std::find(rapid_.begin(), rapid_.end(), false) == rapid_.end()) rapid_.clear();
  }

  [[nodiscard]] bool any() const { return !rapid_.empty(); }
  [[nodiscard]] bool at(double t) const {
    if (rapid_.empty()) return false;
    const auto pieces = plan_->path().pieces();
    const auto behind =
        std::upper_bound(pieces.begin() + 1, pieces.end(), plan_->law().at(t).position,
                         [](double q, const PathPiece& piece) { return q < piece.start; });
    return rapid_[static_cast<std::size_t>(behind - pieces.begin()) - 1];
  }

 private:
  const Plan* plan_;
  std::vector<bool> rapid_ = {};
};

/// The greatest speed between the instants, without rapids.
double fastest_feed(const std::vector<double>& times, const std::function<DrawnPoint(double)>& at,
                    const Rapids& rapids) {
  double fastest = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double middle = (times[i - 1] + times[i]) / 2;
    if (rapids.at(middle)) continue;
    for (const double t : {times[i - 1], middle, times[i]})
      fastest = std::max(fastest, at(t).speed);
  }
  return fastest;
}

/// Puts the points of a path into a figure. `at` is its motion at an instant of `times`, which may
/// be in any order.
void draw(std::vector<double> times, const std::function<DrawnPoint(double)>& at,
          const Rapids& rapids, PathFigure& figure) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const double most = rapids.any() ? fastest_feed(times, at, rapids) : 0;
  double before = times.front();
  const auto shown = [&](double t) {
    DrawnPoint point = at(t);
    if (rapids.any()) point.speed = std::min(point.speed, most);
    return point;
  };
  for (const DrawnPoint& point : path_points(times, shown)) {
    figure.x.push_back(point.x);
    figure.y.push_back(point.y);
    figure.speed.push_back(point.speed);
    if (rapids.any()) figure.rapid.push_back(rapids.at((before + point.time) / 2));
    before = point.time;
  }
}

void add_marks(const Plan& plan, std::size_t x, std::size_t y, PathFigure& figure) {
  std::vector<SpeedLoss> losses = cost_of(plan, plan.corners()).losses;
  std::stable_sort(losses.begin(), losses.end(),
                   [](const SpeedLoss& a, const SpeedLoss& b) { return a.loss > b.loss; });
  losses.resize(std::min(losses.size(), marked_places));
  std::vector<Motion> axes(plan.path().axes());
  for (const SpeedLoss& loss : losses) {
    plan.at(std::min(loss.time, plan.duration()), axes);
    figure.marks.push_back({axes[x].position, axes[y].position,
                            (loss.cause == LossCause::start || loss.cause == LossCause::end)
                                ? name(loss.cause)
                                : "line " + std::to_string(loss.line)});
  }
}

PathFigure empty_figure(const Spec& spec, const std::string& x, const std::string& y,
                        const Units& units) {
  return {.title = spec.name,
          .x_label = x + " [" + units.position + "]",
          .y_label = y + " [" + units.position + "]",
          .speed_label = "speed [" + rate_unit(units.position, units.x, 1) + "]"};
}

}  // namespace

PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane) {
  if (axes.front().overlap)
    fail(plane,
         "is not possible for lines that overlap in time: leave out --plane, or overlap of [path]");
  if (!axes.front().plan)
    fail(plane, "needs a spec of kind \"path\" or a G-code program: leave it out");
  const Plan& plan = *axes.front().plan;
  const auto comma = plane.find(',');
  const std::size_t x = axis_named(axes, plane.substr(0, comma), plane);
  const std::size_t y =
      axis_named(axes, comma == std::string::npos ? "" : plane.substr(comma + 1), plane);
  const Units& units = axes[x].labels.units;
  if (axes[y].labels.units.position != units.position || x == y)
    fail(plane, "must name two different axes with the same unit");
  std::vector<const Trajectory*> curves;
  for (const Input& input : axes) curves.push_back(&std::get<Trajectory>(*input.curve));
  PathFigure figure = empty_figure(*axes.front().spec, axes[x].axis, axes[y].axis, units);
  std::vector<double> times;
  for (const Trajectory* curve : curves) add_breaks(*curve, times);
  draw(
      std::move(times),
      [&](double t) {
        double square = 0;
        for (std::size_t i = 0; i < plan.given().path_axes; ++i)
          square += std::pow(curves[i]->at(t).velocity, 2);
        return DrawnPoint{t, curves[x]->at(t).position, curves[y]->at(t).position,
                          std::sqrt(square)};
      },
      Rapids(plan, *axes.front().spec), figure);
  add_marks(plan, x, y, figure);
  return figure;
}

std::optional<PathFigure> path_figure(const Input& axis) {
  if (!axis.plan || axis.spec->axes.size() < 2) return std::nullopt;
  const Plan& plan = *axis.plan;
  PathFigure figure =
      empty_figure(*axis.spec, axis.spec->axes[0].name, axis.spec->axes[1].name, axis.spec->units);
  std::vector<double> times{0, plan.duration()};
  add_breaks(std::get<Trajectory>(*axis.curve), times);
  std::erase_if(times, [&](double t) { return t > plan.duration(); });
  std::vector<Motion> axes(plan.path().axes());
  draw(
      std::move(times),
      [&](double t) {
        plan.at(t, axes);
        double square = 0;
        for (std::size_t i = 0; i < plan.given().path_axes; ++i)
          square += std::pow(axes[i].velocity, 2);
        return DrawnPoint{t, axes[0].position, axes[1].position, std::sqrt(square)};
      },
      Rapids(plan, *axis.spec), figure);
  add_marks(plan, 0, 1, figure);
  return figure;
}

}  // namespace jounce
