// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/timing/not_limited.hpp"

// The line is passed in steps. A step from q to q + h is accepted if the joints stay in their ranges
// on all of it. With b >= |d joint/ds| on the step, s = (position - q) / h, and the joint positions
// p0, p1 at its ends,
//
//     (1)  joint <= (p0 + p1 + b) / 2        joint >= (p0 + p1 - b) / 2
//
// A rejected step is halved, an accepted one is doubled. The line ends where the step would be
// shorter than the rounding of its coordinates.

namespace jounce {
namespace {

using JointJets = std::array<Jet, max_axes>;
using JointPlaces = std::array<double, max_axes>;

using path_detail::unlimited;

/// Distance that the joints keep from the ends of their ranges, in their unit: the tolerance of
/// fitted joints (JointSpace), twice.
constexpr double joint_margin = 2e-9;
constexpr int first_steps = 64;     ///< steps of the line, if each is accepted
constexpr int step_samples = 8;     ///< in each step, for a map without bounds
constexpr double shortest = 1e-11;  ///< step at the end of the line, relative to its coordinates
/// Excess of an enclosure of the velocities over their values at the ends of a short step.
constexpr double enclosure_excess = 2;

class ReachLine {
 public:
  ReachLine(const AxisMap& map, std::span<const Limits> joints, const Point& from,
            const Point& direction, double length, double velocity)
      : map_(map), joints_(joints), from_(from), direction_(direction) {
    step_ = length / first_steps;
    length_ = length;
    double size = std::min(length, 1.0);
    for (std::size_t i = 0; i < map.axes(); ++i) size = std::max(size, std::abs(from[i]));
    least_ = shortest * size;
    if (state_at(0, here_) != MapState::ok) return;
    starts_ = true;
    for (std::size_t j = 0; j < map_.joints(); ++j) place_[j] = here_[j][0];
    set_ranges();
    slowest_ = singular_margin * (std::isfinite(velocity) ? velocity : permitted(here_));
  }

  Reach run() {
    Reach found = reach_;
    found.end = LineEnd::out_of_reach;
    if (starts_) {
      while (reach_.length < length_) {
        const double h = std::min(step_, length_ - reach_.length);
        if (const auto why = obstacle(h)) {
          found = *why;
          if (h <= least_) break;
          step_ = h / 2;
        } else {
          reach_.length = h < length_ - reach_.length ? reach_.length + h : length_;
          step_ = 2 * h;
        }
      }
    }
    if (reach_.length >= length_) return {.length = length_};
    found.length = reach_.length;
    return found;
  }

 private:
  MapState state_at(double q, JointJets& joints) const {
    JointJets point{};
    for (std::size_t i = 0; i < map_.axes(); ++i)
      point[i] = {from_[i] + direction_[i] * q, direction_[i], 0, 0};
    return map_.jets(std::span(point).first(map_.axes()), std::span(joints).first(map_.joints()));
  }

  /// A joint that already stands at the end of its range, or beyond it, may leave it.
  void set_ranges() {
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      low_[j] = joints_[j].position_min
                    ? std::min(*joints_[j].position_min + joint_margin, place_[j])
                    : -unlimited;
      high_[j] = joints_[j].position_max
                     ? std::max(*joints_[j].position_max - joint_margin, place_[j])
                     : unlimited;
    }
  }

  /// The velocity of the tool that the joints permit.
  [[nodiscard]] double permitted(const JointJets& joints) const {
    double velocity = unlimited;
    for (std::size_t j = 0; j < map_.joints(); ++j)
      if (joints_[j].velocity && joints[j][1] != 0)
        velocity = std::min(velocity, *joints_[j].velocity / std::abs(joints[j][1]));
    return velocity;
  }

  /// The greatest velocity of a joint per velocity of the tool that keeps the margin.
  [[nodiscard]] double fastest(std::size_t j) const {
    if (!joints_[j].velocity || !std::isfinite(slowest_)) return unlimited;
    return std::max(*joints_[j].velocity / slowest_, std::abs(here_[j][1]));
  }

  /// The reason against the next step of length h; nullopt: it is accepted.
  std::optional<Reach> obstacle(double h) {
    JointJets there{};
    if (const MapState state = state_at(reach_.length + h, there); state != MapState::ok)
      return Reach{.end = state == MapState::singular ? LineEnd::singular : LineEnd::out_of_reach,
                   .joint = fastest_joint()};
    JointPlaces place{};
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      const double turn = map_.turn(j);
      place[j] = there[j][0];
      if (turn > 0) place[j] += turn * std::round((place_[j] - place[j]) / turn);
    }
    const auto travel = travels(h, place);
    if (!travel) return Reach{.end = LineEnd::out_of_reach};
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      const double middle = (place_[j] + place[j]) / 2;  // (1)
      const double half = (*travel)[j] / 2;
      const double most = fastest(j);
      if ((*travel)[j] > enclosure_excess * most * h ||
          std::abs(there[j][1]) > most * (1 + profiles_detail::rounded_sum))
        return Reach{.end = LineEnd::singular, .joint = j};
      const double rounding = profiles_detail::rounded_sum * std::max(1.0, std::abs(place_[j]));
      if (middle + half > high_[j] + rounding)
        return Reach{.end = LineEnd::joint_limit, .joint = j, .limit = *joints_[j].position_max};
      if (middle - half < low_[j] - rounding)
        return Reach{.end = LineEnd::joint_limit, .joint = j, .limit = *joints_[j].position_min};
    }
    here_ = there;
    place_ = place;
    return std::nullopt;
  }

  [[nodiscard]] std::size_t fastest_joint() const {
    std::size_t fastest = 0;
    for (std::size_t j = 1; j < map_.joints(); ++j)
      if (std::abs(here_[j][1]) > std::abs(here_[fastest][1])) fastest = j;
    return fastest;
  }

  /// A bound of the travel of each joint on a step: its length, forth and back. Nullopt: the step is
  /// too long for a bound.
  std::optional<JointPlaces> travels(double h, const JointPlaces& place) const {
    JointPlaces travel{};
    std::array<Segment, max_axes> line{};
    for (std::size_t i = 0; i < map_.axes(); ++i) {
      line[i].length = h;
      line[i].degree = 1;
      line[i].c[0] = from_[i] + direction_[i] * reach_.length;
      line[i].c[1] = direction_[i] * h;
    }
    std::array<JointBounds, max_axes> bounds{};
    if (map_.bounds(std::span(line).first(map_.axes()), std::span(bounds).first(map_.joints()))) {
      for (std::size_t j = 0; j < map_.joints(); ++j) {
        const double turn = map_.turn(j);
        if (!std::isfinite(bounds[j].first) || (turn > 0 && !(bounds[j].first < turn / 4)))
          return std::nullopt;
        travel[j] = bounds[j].first;
      }
      return travel;
    }
    for (std::size_t j = 0; j < map_.joints(); ++j) travel[j] = std::abs(place[j] - place_[j]);
    if (map_.linear() != nullptr) return travel;
    JointJets inside{};
    for (int i = 1; i < step_samples; ++i) {
      if (state_at(reach_.length + h * i / step_samples, inside) != MapState::ok)
        return std::nullopt;
      for (std::size_t j = 0; j < map_.joints(); ++j)
        travel[j] = std::max(travel[j], std::abs(inside[j][1]) * h);
    }
    return travel;
  }

  const AxisMap& map_;
  std::span<const Limits> joints_;
  const Point& from_;
  const Point& direction_;
  Reach reach_;  // so far
  double length_ = 0, step_ = 0, least_ = 0;
  double slowest_ = 0;   // velocity of the tool at the singular margin
  bool starts_ = false;  // the joints reach the start
  JointJets here_{};     // at the end of the part so far
  JointPlaces place_{};  // of the joints there, without jumps by whole turns
  JointPlaces low_{}, high_{};
};

}  // namespace

Reach reach(const AxisMap& map, std::span<const Limits> joints, const Point& from,
            const Point& direction, double length, double velocity) {
  return ReachLine(map, joints, from, direction, length, velocity).run();
}

}  // namespace jounce
