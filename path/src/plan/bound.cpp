// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/timing/box.hpp"
#include "path/src/timing/not_limited.hpp"

// A lower bound of the duration on a given path without a limit of jerk. Let B = q'^2, so dB/dq = 2
// q''. The path is divided into cells. On a cell, r' of an axis is in [p, P] and r'' in [c, C]
// (exact ranges). With p > 0 (or mirrored),
//
//   (1)  q'' = (r_tt - r'' B) / r' <= (A - c B) / p   if that is positive, so dB/dq <= 2 (f + s B)
//   (2)  B(h) <= B(0) e^(2 s h) + f (e^(2 s h) - 1) / s      by comparison of solutions
//   (3)  on a circle with a bound of the whole acceleration:  B = A R sin(2 q / R + const)
//   (4)  at a point, because one q'' must satisfy both axes i and k with r'_i, r'_k > 0:
//        B (r''_k / r'_k - r''_i / r'_i) <= A_k / r'_k + A_i / r'_i
//
// A forward and a backward pass of (2) and (3), under (4) and the velocity limits, give upper
// bounds of B at the ends of the cells, and the greatest slope within them. The integral of dq /
// sqrt(B) with these is a lower bound of the duration.

namespace jounce {
namespace {

using profiles_detail::rounded_input;

using path_detail::unlimited;

constexpr double short_cell = 1e-12;  ///< in (2) the cell is as short as if its slope were 0
/// Share of the path's velocity: an axis below it gives no slope.
constexpr double slow_axis = 1e-9;
constexpr std::size_t block = 1024;  ///< pieces whose cells exist at the same time
/// dB/dq <= 2 (f + s B) over a cell, for each axis that limits it.
struct Growth {
  double f, s;
};

struct Cell {
  double length = 0;
  double most = unlimited;  ///< bound of B over the cell, from velocities along the path
  std::array<Growth, max_axes + 1> up{}, down{};
  std::size_t ups = 0, downs = 0;
  double total = unlimited;  ///< bound of the total acceleration
  double curvature = 0;      ///< constant curvature of a circle with unit speed; 0: none
};

double grown(const Cell& cell, std::span<const Growth> growth, double B) {
  double most = unlimited;
  for (const auto& [f, s] : growth) {
    const double x = 2 * s * cell.length;
    const double factor = std::abs(x) < short_cell ? 2 * cell.length : std::expm1(x) / s;
    // A negative slope is replaced by 0, because (1) holds with p only if the slope is positive.
    most = std::min(most, f + s * B > 0 ? B * std::exp(x) + f * factor : B);
  }
  if (cell.total < unlimited && cell.curvature > 0) {
    const double peak = cell.total / cell.curvature;
    const double angle = std::asin(std::min(B / peak, 1.0)) + 2 * cell.curvature * cell.length;
    most = std::min(most, angle < std::numbers::pi / 2 ? peak * std::sin(angle) : peak);
  }
  return most;
}

/// The greatest dB/dq over a cell in which B runs from `from` to `cell.most`.
double steepest(const Cell& cell, std::span<const Growth> growth, double from) {
  double most = unlimited;
  for (const auto& [f, s] : growth)
    most = std::min(most, 2 * (f + std::max(0.0, s > 0 ? s * cell.most : 0.0)));
  if (cell.total < unlimited) {
    const double normal = std::min(cell.curvature * from, cell.total);
    most = std::min(most, 2 * std::sqrt((cell.total - normal) * (cell.total + normal)));
  }
  return most;
}

/// Time over the distance x, if B is linear from b0 to b1.
double linear_time(double x, double b0, double b1) {
  return x > 0 ? 2 * x / (std::sqrt(b0) + std::sqrt(b1)) : 0;
}

double least_time(const Cell& cell, double b0, double b1) {
  const double h = cell.length;
  const double up = steepest(cell, std::span(cell.up).first(cell.ups), b0);
  const double down = steepest(cell, std::span(cell.down).first(cell.downs), b1);
  const double top = cell.most;
  const double rise = up < unlimited ? std::max(0.0, (top - b0) / up) : 0;
  const double fall = down < unlimited ? std::max(0.0, (top - b1) / down) : 0;
  if (rise + fall <= h && top < unlimited)
    return linear_time(rise, b0, top) + linear_time(fall, top, b1) +
           (h - rise - fall) / std::sqrt(top);
  if (up == unlimited || down == unlimited) return 0;
  const double x = up + down > 0 ? std::clamp((b1 + down * h - b0) / (up + down), 0.0, h) : h;
  const double peak = b0 + up * x;
  return linear_time(x, b0, peak) + linear_time(h - x, peak, b1);
}

class Bound {
 public:
  Bound(const Plan& plan, int cells)
      : plan_(plan),
        all_(rates_of(plan.given().limits, plan.path().axes(), plan.given().path_axes)),
        rates_(all_),
        cells_(cells) {}

  double run() {
    double time = 0;
    for (const LawInterval& s : plan_.law().stretches())
      if (s.pieces == 0) {
        time += s.duration;
        rests_.push_back(s.start);
      }
    for (const LawInterval& s : plan_.law().stretches())
      if (s.pieces > 0 && s.v0 == 0) rests_.push_back(s.start);
    std::sort(rests_.begin(), rests_.end());
    forward();
    return time + backward();
  }

 private:
  /// The bounds of B at the ends of all cells, from the caps and the forward pass.
  void forward() {
    const auto pieces = plan_.path().pieces();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (k % block == 0) block_.clear();
      if (std::binary_search(rests_.begin(), rests_.end(), pieces[k].start)) most_.back() = 0;
      const std::size_t first = block_.size();
      append(k, &most_);
      if (k + 1 == pieces.size()) most_.back() = 0;
      double* b = most_.data() + (most_.size() - 1 - (block_.size() - first));
      for (std::size_t i = first; i < block_.size(); ++i, ++b) {
        const Cell& cell = block_[i];
        b[1] = std::min(b[1], grown(cell, std::span(cell.up).first(cell.ups), b[0]));
      }
    }
  }

  /// The backward pass; returns the bound of the duration of all cells.
  double backward() {
    const std::size_t pieces = plan_.path().pieces().size();
    double time = 0;
    double* b = most_.data() + most_.size() - 1;  // at the end of the cell
    for (std::size_t first = (pieces - 1) / block * block;; first -= block) {
      if (first + block < pieces) {  // the last block is still there
        block_.clear();
        for (std::size_t k = first; k < first + block; ++k) append(k, nullptr);
      }
      for (std::size_t i = block_.size(); i-- > 0; --b) {
        const Cell& cell = block_[i];
        b[-1] = std::min(b[-1], grown(cell, std::span(cell.down).first(cell.downs), b[0]));
        time += least_time(cell, b[-1], b[0]);
      }
      if (first == 0) return time;
    }
  }

  /// Appends the cells of piece k to the block, and the caps at their ends to `caps`, if given.
  void append(std::size_t k, std::vector<double>* caps) {
    const Path& path = plan_.path();
    const PathPiece& piece = path.pieces()[k];
    const PathSettings& settings = plan_.given().settings[piece.settings];
    const int count = piece.kind == PieceKind::line ? 1 : cells_;
    rates_ = rates_on(all_, piece, plan_.given().settings, is_corner(piece));
    std::array<std::vector<Segment>, max_axes> axes;
    for (std::size_t i = 0; i < path.axes(); ++i) path.segments(k, i, axes[i]);
    const double feed = std::min(feed_of(piece, plan_.given().settings), rates_.path.velocity);
    for (int c = 0; c < count; ++c) {
      Cell cell;
      cell.length = piece.length / count;
      cell.most = feed * feed;
      cell.total = rates_.path.total_acceleration;
      const double u0 = piece.length * c / count;
      const double u1 = c + 1 == count ? piece.length : piece.length * (c + 1) / count;
      for (std::size_t i = 0; i < path.axes(); ++i) add_axis(i, axes[i], u0, u1, cell);
      const PathLimits& p = rates_.path;
      const double up = std::min({p.acceleration, settings.acceleration});
      double down = std::min({p.deceleration, settings.deceleration});
      if (down == unlimited) down = up;
      if (up < unlimited) cell.up[cell.ups++] = {up, 0};
      if (down < unlimited) cell.down[cell.downs++] = {down, 0};
      curvature_of(k, (u0 + u1) / 2, cell);
      block_.push_back(cell);
      if (caps == nullptr) continue;
      caps->back() = std::min(caps->back(), cell.most);
      caps->push_back(std::min(cell.most, cap_at(k, u1)));
    }
  }

  void curvature_of(std::size_t k, double u, Cell& cell) const {
    if (plan_.path().pieces()[k].kind != PieceKind::arc) return;
    std::array<Jet, max_axes> jet{};
    plan_.path().jets(k, u, std::span(jet).first(rates_.axes));
    double speed = 0;
    double bend = 0;
    for (std::size_t i = 0; i < rates_.path_axes; ++i) {
      speed += jet[i][1] * jet[i][1];
      bend += jet[i][2] * jet[i][2];
    }
    if (std::abs(speed - 1) < rounded_input) cell.curvature = std::sqrt(bend) * (1 - rounded_input);
  }

  /// Adds (1) of one axis over [u0, u1] of a piece.
  void add_axis(std::size_t i, const std::vector<Segment>& segments, double u0, double u1,
                Cell& cell) const {
    double p = unlimited, P = -unlimited, c = unlimited, C = -unlimited;
    double start = 0;
    for (const Segment& f : segments) {
      const double s0 = std::max(0.0, (u0 - start) / f.length);
      const double s1 = std::min(1.0, (u1 - start) / f.length);
      start += f.length;
      if (!(s0 < s1)) continue;
      const Segment g = part(f, s0, s1);
      const Range slope = segment_range(g, 0, g.length, 1);
      const Range bend = segment_range(g, 0, g.length, 2);
      p = std::min(p, slope.min.value);
      P = std::max(P, slope.max.value);
      c = std::min(c, bend.min.value);
      C = std::max(C, bend.max.value);
    }
    if (P < 0) {
      p = -P;
      c = -std::exchange(C, -c);
    }
    const double least = p > 0 ? p : 0;
    if (least > 0)
      cell.most = std::min(cell.most, rates_.velocity[i] * rates_.velocity[i] / (least * least));
    const double A = rates_.acceleration[i];
    if (!(least > 0) || A == unlimited) return;
    cell.up[cell.ups++] = {A / least, -c / least};
    cell.down[cell.downs++] = {A / least, C / least};
  }

  /// The limit by (4) and by the velocities of the axes.
  [[nodiscard]] double cap_at(std::size_t k, double u) const {
    std::array<Jet, max_axes> jet{};
    const std::size_t n = rates_.axes;
    plan_.path().jets(k, u, std::span(jet).first(n));
    double most = unlimited;
    std::size_t fastest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (std::abs(jet[i][1]) > std::abs(jet[fastest][1])) fastest = i;
    for (std::size_t i = 0; i < n; ++i) {
      const double sign = jet[i][1] < 0 ? -1 : 1;
      const double p = sign * jet[i][1];
      const double c = sign * jet[i][2];
      const double A = rates_.acceleration[i];
      if (p > 0) most = std::min(most, rates_.velocity[i] * rates_.velocity[i] / (p * p));
      if (p <= slow_axis) {  // |p q'' + c v^2| <= A, and (4) of the fastest axis limits q''
        const double share = p > 0 ? p / std::abs(jet[fastest][1]) : 0;
        const double slope = std::abs(c) - share * std::abs(jet[fastest][2]);
        const double rest = share > 0 ? share * rates_.acceleration[fastest] : 0;
        if (slope > 0) most = std::min(most, (A + rest) / slope);
      }
      for (std::size_t m = 0; m < n; ++m) {
        const double sign_m = jet[m][1] < 0 ? -1 : 1;
        const double p_m = sign_m * jet[m][1];
        const double c_m = sign_m * jet[m][2];
        if (m == i || p <= slow_axis || p_m <= slow_axis) continue;
        const double slope = c_m / p_m - c / p;
        if (slope > 0) most = std::min(most, (rates_.acceleration[m] / p_m + A / p) / slope);
      }
    }
    const double normal = std::min(rates_.path.normal_acceleration, rates_.path.total_acceleration);
    if (normal < unlimited && plan_.path().pieces()[k].kind == PieceKind::arc) {
      Cell cell;
      curvature_of(k, u, cell);
      if (cell.curvature > 0) most = std::min(most, normal / cell.curvature);
    }
    return most;
  }

  const Plan& plan_;
  Rates all_;
  Rates rates_;  ///< on the piece that is examined
  int cells_;
  std::vector<double> rests_;
  std::vector<double> most_{0};  ///< greatest B at the ends of the cells
  /// The cells of the last `block` pieces: those of a long path would take 12 kB for each corner.
  std::vector<Cell> block_;
};

}  // namespace

double lower_bound(const Plan& plan, int cells) {
  return Bound(plan, std::max(cells, 1)).run();
}

}  // namespace jounce
