// SPDX-License-Identifier: Apache-2.0
#include "path/src/maps/fitted_joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/septic.hpp"
#include "path/src/maps/joints_at.hpp"
#include "path/src/timing/not_limited.hpp"

// The joints f over a part of the path, s in [0, 1], are replaced by the polynomial p of degree 7
// with the values and three derivatives of f at both ends:
//
//   (1)  |f - p| = |f^(8)(z)| / 8! (s (1 - s))^4 <= max |f^(8)| / 8! / 256
//
// The map encloses f^(8) over the whole part. p is the motion that is played: velocities,
// accelerations and jerks of the joints are those of p, so their limits hold exactly, and (1)
// bounds the distance of the tool from its path.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

using path_detail::unlimited;
constexpr int deepest = 44;                 ///< greatest number of halvings
constexpr std::size_t most_parts = 100000;  ///< greatest number of polynomials of a command
constexpr int deepest_box = 6;  ///< greatest number of halvings that make boxes more even
/// A part must permit at least this share of the velocity at its ends.
constexpr double even = 0.85;
/// rad of an arc; up to this angle, a polynomial of degree 11 is exact to rounding.
constexpr double widest = 0.25;
constexpr int samples = 8;  ///< number of samples in each part, for a map without bounds
constexpr double joint_rounding = 8e-15;

using Axes = std::array<Segment, max_axes>;
using Jets = std::array<Jet, max_axes>;

/// A sine as a polynomial.
Segment polynomial(const Segment& f) {
  if (f.sines == 0) return f;
  return profiles_detail::hermite(f.length, profiles_detail::taylor(f, 0),
                                  profiles_detail::taylor(f, 1));
}

Derivatives magnitudes(const Jets& jets, std::size_t n) {
  Derivatives d;
  for (std::size_t i = 0; i < n; ++i) {
    d.first[i] = std::abs(jets[i][1]);
    d.second[i] = std::abs(jets[i][2]);
    d.third[i] = std::abs(jets[i][3]);
  }
  return d;
}

Derivatives bounds_of(std::span<const Segment> axes, std::size_t path_axes) {
  Derivatives d;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisPeaks peak = peaks_of(axes[i]);
    d.first[i] = peak.direction;
    d.second[i] = peak.curvature;
    d.third[i] = peak.rate;
  }
  bound_vectors(axes.first(path_axes), d);
  return d;
}

class Fitting {
 public:
  Fitting(Path path, std::span<const Unit> units, const JointSpace& joints, const Rates& rates,
          const Program& program)
      : path_(std::move(path)),
        tool_units_(units),
        joints_(joints),
        map_(*joints.map),
        rates_(reserved(rates)),
        program_(program),
        n_(path_.axes()),
        all_(n_ + map_.joints()) {}

  Jointed run(std::vector<JunctionMark> marks) {
    for (std::size_t k = 0; k < tool_units_.size(); ++k)
      if (k == 0 || tool_units_[k].piece != tool_units_[k - 1].piece)
        add(k);  // not each part of an arc
    fit_.pieces = pieces_.size();
    if (fit_.proven) fit_.sample_step = 0;
    Rounded out{Path(all_, std::move(pieces_), std::move(numbers_)), std::move(units_),
                std::move(marks)};
    return {std::move(out), std::move(path_), fit_};
  }

 private:
  /// A part of a piece.
  struct Part {
    Axes tool;
    double start = 0;  ///< q
    double length = 0;
  };

  [[nodiscard]] const PathSettings& settings(std::size_t unit) const {
    return program_.settings()[path_.pieces()[tool_units_[unit].piece].settings];
  }

  void add(std::size_t k) {
    unit_ = k;
    first_ = true;
    before_ = pieces_.size();
    const PathPiece& piece = path_.pieces()[tool_units_[k].piece];
    std::array<std::vector<Segment>, max_axes> segments;
    for (std::size_t i = 0; i < n_; ++i) path_.segments(tool_units_[k].piece, i, segments[i]);
    double start = piece.start;
    for (std::size_t m = 0; m < segments[0].size(); ++m) {
      Part part;
      for (std::size_t i = 0; i < n_; ++i) part.tool[i] = segments[i][m];
      part.start = start;
      part.length = segments[0][m].length;
      divide(part, 0);
      start += part.length;
    }
  }

  MapState state_at(const Part& part, double s, Jets& point, Jets& joint) const {
    for (std::size_t i = 0; i < n_; ++i) point[i] = evaluate(part.tool[i], s);
    return path_detail::joints_at(map_, point, joint);
  }

  /// Rejects a map without bounds whose first derivatives are not those of its values.
  void require_derivatives(const Part& part) const {
    if (fit_.proven) return;
    constexpr double step = 1e-4;   // of the part, on both sides of its middle
    constexpr double share = 0.01;  // greater than the change of a derivative over the two steps
    Jets point{};
    Jets before{};
    Jets after{};
    Jets here{};
    if (state_at(part, 0.5 - step, point, before) != MapState::ok ||
        state_at(part, 0.5 + step, point, after) != MapState::ok ||
        state_at(part, 0.5, point, here) != MapState::ok)
      return;
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      double change = after[j][0] - before[j][0];
      if (const double turn = map_.turn(j); turn > 0) change -= turn * std::round(change / turn);
      const double mean = change / (2 * step * part.length);
      const double allowed = share * std::max(std::abs(mean), std::abs(here[j][1])) +
                             joint_rounding * std::abs(here[j][0]) / (step * part.length);
      if (std::abs(mean - here[j][1]) > allowed)
        throw InputError("map", path_detail::text_of(point, map_.axes()),
                         "is a point at which jets() gives joint " + std::to_string(j + 1) +
                             " the first derivative " + six_digits(here[j][1]) +
                             ", but its values change by " + six_digits(mean) +
                             ": correct the derivatives");
    }
  }

  [[noreturn]] void fail(const Part& part, double s, MapState state) const {
    Jets point{};
    Jets joint{};
    static_cast<void>(state_at(part, s, point, joint));
    const std::string where =
        ", at " + six_digits(part.start + s * part.length) + " along the path";
    const bool at_start = !(part.start + s * part.length > 0);
    throw InputError(
        at_start ? "start" : "point", path_detail::text_of(point, map_.axes()),
        state == MapState::out_of_reach
            ? "is out of reach of the joints" + where + ": move the path or the machine"
            : "is a singular position of the joints" + where +
                  ": their velocities have no bound there; keep the path away from it")
        .at({}, at_start ? 0 : path_.pieces()[tool_units_[unit_].piece].line);
  }

  /// Reports that the map is defined at `good` and not at `bad`.
  [[noreturn]] void fail_between(const Part& part, double good, double bad) const {
    Jets point{};
    Jets joint{};
    const MapState beyond = state_at(part, bad, point, joint);
    for (int i = 0; i < 60; ++i) {
      const double middle = (good + bad) / 2;
      (state_at(part, middle, point, joint) == MapState::ok ? good : bad) = middle;
    }
    fail(part, bad, beyond);
  }

  /// Reports why the fit does not converge. Over so short a part, a joint has one velocity, unless it is singular.
  [[noreturn]] void fail_to_fit(const Part& part, const Jets& begin, const Jets& end,
                                double error) const {
    require_derivatives(part);
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      const double mean = (end[j][0] - begin[j][0]) / part.length;
      const double size = std::max(std::abs(begin[j][0]), std::abs(end[j][0]));
      const auto [least, most] = std::minmax({begin[j][1], mean, end[j][1]});
      const double allowed =
          std::max(std::abs(least), std::abs(most)) / 2 + joint_rounding * size / part.length;
      if (!std::isfinite(error) || !std::isfinite(allowed) || most - least > allowed)
        fail(part, 1, MapState::singular);
    }
    throw InputError("tolerance", joints_.tolerance,
                     "is below the error of the fitted joints, which is " + six_digits(error) +
                         " in their unit at " + six_digits(part.start) +
                         " along the path: give a greater tolerance")
        .at({}, path_.pieces()[tool_units_[unit_].piece].line);
  }

  /// Rejects a command of too many parts. The axis that moves farthest is named.
  [[noreturn]] void fail_to_end(const Part& part) const {
    require_derivatives(part);
    const std::size_t k = tool_units_[unit_].piece;
    const PathPiece& piece = path_.pieces()[k];
    const Point from = path_.point(k, 0);
    const Point to = path_.point(k, piece.length);
    std::size_t farthest = 0;
    const auto travel = [&](std::size_t i) { return std::abs(to[i] - from[i]); };
    for (std::size_t i = 1; i < map_.axes(); ++i)
      if (travel(i) > travel(farthest)) farthest = i;
    throw InputError("to[" + std::to_string(farthest + 1) + "]",
                     "a travel of " + six_digits(travel(farthest)),
                     "needs more than " + std::to_string(most_parts) +
                         " polynomials for the joints, the limit for a command: correct the end, "
                         "or divide the command")
        .at({}, piece.line);
  }

  /// Removes jumps of angles by whole turns: between this part and the previous one, and between
  /// its start and its end.
  void join(Jets& begin, Jets& end) const {
    for (std::size_t j = 0; j < map_.joints(); ++j) {
      const double turn = map_.turn(j);
      if (!(turn > 0)) continue;
      if (begun_) begin[j][0] += turn * std::round((last_[j][0] - begin[j][0]) / turn);
      end[j][0] += turn * std::round((begin[j][0] - end[j][0]) / turn);
    }
  }

  /// Bound of the distance of the fitted joints from the map; infinite if the part is too long.
  double error_of(const Part& part, const Axes& fitted) {
    std::array<JointBounds, max_axes> bounds{};
    double error = 0;
    const std::size_t m = map_.joints();
    if (map_.bounds(std::span(part.tool).first(map_.axes()), std::span(bounds).first(m))) {
      for (std::size_t j = 0; j < m; ++j) {
        const double turn = map_.turn(j);
        if (!std::isfinite(bounds[j].eighth) || (turn > 0 && !(bounds[j].first < turn / 4)))
          return unlimited;
        error = std::max(error, septic_error * bounds[j].eighth *
                                    (1 + rounded_sum));  // (1), with rounded constants
      }
      return error;
    }
    fit_.proven = false;
    Jets point{};
    Jets joint{};
    for (int i = 1; i < samples; ++i) {
      const double s = static_cast<double>(i) / samples;
      if (state_at(part, s, point, joint) != MapState::ok) fail_between(part, 0, s);
      for (std::size_t j = 0; j < m; ++j) {
        double off = value(fitted[j], s) - joint[j][0];
        if (const double turn = map_.turn(j); turn > 0) off -= turn * std::round(off / turn);
        error = std::max(error, std::abs(off));
      }
    }
    return error;
  }

  void divide(const Part& part, int depth) {
    rates_.require_wanted();
    Jets point{};
    Jets begin{};
    Jets end{};
    if (const MapState state = state_at(part, 0, point, begin); state != MapState::ok)
      fail(part, 0, state);
    if (state_at(part, 1, point, end) != MapState::ok) fail_between(part, 0, 1);
    double angle = 0;
    for (std::size_t i = 0; i < n_; ++i)
      if (part.tool[i].sines > 0) angle = std::max(angle, std::abs(part.tool[i].sine[0].angle));
    join(begin, end);
    Axes fitted;
    for (std::size_t j = 0; j < map_.joints(); ++j)
      fitted[j] = septic(part.length, begin[j], end[j]);
    const double error = angle <= widest ? error_of(part, fitted) : unlimited;
    if (!(error <= joints_.tolerance)) {
      if (depth >= deepest) fail_to_fit(part, begin, end, error);
      return halves(part, depth);
    }
    Axes axes;
    for (std::size_t i = 0; i < n_; ++i) axes[i] = polynomial(part.tool[i]);
    std::copy_n(fitted.begin(), map_.joints(), axes.begin() + static_cast<std::ptrdiff_t>(n_));
    const Derivatives bounds = bounds_of(std::span(axes).first(all_), rates_.path_axes);
    if (!tool_units_[unit_].box.constant && depth < deepest_box &&
        !is_even(part, bounds, begin, end))
      return halves(part, depth);
    double size = 0;
    for (std::size_t j = 0; j < map_.joints(); ++j)
      size = std::max({size, std::abs(begin[j][0]), std::abs(end[j][0])});
    fit_.error = std::max(fit_.error, error + joint_rounding * size);
    fit_.sample_step = std::max(fit_.sample_step, part.length / samples);
    emit(part, axes, bounds);
    last_ = end;
    begun_ = true;
  }

  void halves(const Part& part, int depth) {
    for (const double from : {0.0, 0.5}) {
      Part half;
      for (std::size_t i = 0; i < n_; ++i)
        half.tool[i] = jounce::part(part.tool[i], from, from + 0.5);
      half.start = part.start + from * part.length;
      half.length = part.length / 2;
      divide(half, depth + 1);
    }
  }

  /// True if the bounds over the part permit about the same velocity as its ends.
  [[nodiscard]] bool is_even(const Part& part, const Derivatives& bounds, const Jets& begin,
                             const Jets& end) const {
    const double feed = std::min(settings(unit_).velocity, rates_.path.velocity);
    double at_ends = feed;
    for (const double s : {0.0, 1.0}) {
      Jets jets{};
      for (std::size_t i = 0; i < n_; ++i) jets[i] = evaluate(part.tool[i], s);
      std::copy_n((s == 0 ? begin : end).begin(), map_.joints(),
                  jets.begin() + static_cast<std::ptrdiff_t>(n_));
      at_ends = std::min(at_ends, velocity_with(rates_, magnitudes(jets, all_), 0, 0));
    }
    return velocity_with(rates_, bounds, 0, 0) >= even * at_ends;
  }

  [[nodiscard]] Box box_of(const Part& part, const Axes& axes, const Derivatives& bounds) const {
    const Unit& unit = tool_units_[unit_];
    if (!unit.box.constant)
      return curve_box(rates_, settings(unit_), bounds,
                       std::max(path_.pieces()[unit.piece].length, 20 * part.length));
    Box box = blend_box(rates_, std::span(axes).first(all_));
    const PathSettings& here = settings(unit_);
    double feed = std::min(here.velocity, rates_.path.velocity);
    if (unit_ > 0) feed = std::min(feed, settings(unit_ - 1).velocity);
    if (here.corner == Corner::velocity) feed = std::min(feed, here.value);
    box.velocity = std::min(box.velocity, feed / bounds.speed);
    return box;
  }

  void emit(const Part& part, const Axes& axes, const Derivatives& bounds) {
    if (pieces_.size() - before_ >= most_parts) fail_to_end(part);
    const Unit& unit = tool_units_[unit_];
    PathPiece piece = path_.pieces()[unit.piece];
    piece.start = part.start;
    piece.length = part.length;
    piece.data = next_index(numbers_);
    piece.kind = PieceKind::curve;
    append_curve(std::span(axes).first(all_), numbers_);
    Unit added = unit;
    added.length = part.length;
    added.box = box_of(part, axes, bounds);
    added.piece = static_cast<std::uint32_t>(pieces_.size());
    if (!first_) {
      added.entry = unlimited;
      added.dwell = 0;
    }
    first_ = false;
    pieces_.push_back(piece);
    units_.push_back(added);
  }

  Path path_;  ///< path of the tool
  std::span<const Unit> tool_units_;
  const JointSpace& joints_;
  const AxisMap& map_;
  Rates rates_;
  const Program& program_;
  std::size_t n_, all_;
  std::size_t unit_ = 0;
  std::size_t before_ = 0;  ///< number of parts before this unit
  bool first_ = true, begun_ = false;
  Jets last_{};
  MapFit fit_{0, true, 0, 0};
  std::vector<PathPiece> pieces_;
  std::vector<double> numbers_;
  std::vector<Unit> units_;
};

}  // namespace

Jointed fitted_joints(Path path, Rounded tool, const JointSpace& joints, const Rates& rates,
                      const Program& program) {
  return Fitting(std::move(path), tool.units, joints, rates, program)
      .run(std::move(tool.junctions));
}

}  // namespace jounce
