// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/least_peak.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"

#include "optimize/src/knots/affine_cam.hpp"
#include "optimize/src/solvers/interior_point.hpp"

// Between two knots the slave position is linear in the states at both. With x the free
// derivatives,
//
//   (1)  minimize t   subject to   |f''(m; x)| <= t   at every m
//
// is a linear program with infinitely many constraints. It is solved with finitely many m: first
// the knots and a few points between them, then also the places where the exact extrema of the
// solution exceed t, until no extremum exceeds t by a share of 1e-9 (an exchange method). Then,
// with T = (1 + 1e-6) t, in the same way
//
//   (2)  minimize the integral of f'''^2   subject to   |f''(m; x)| <= T   at every m,
//
// where the integral over a segment, of a polynomial of degree 4, is Gauss's rule with three points.
//
// Certificate: let y_k >= 0, sum y_k = 1, belong to constraints sign_k f''(m_k; x) <= t. Then for every x
//
//   (3)  max |f''| >= sum y_k sign_k f''(m_k; x) = b + r . (x - x0),   x0 the solution
//
// With the multipliers of (1), r is zero except for rounding. An x better than x0 has |f''| <= T.
// Its accelerations therefore differ from those of x0 by at most 2 T, and its velocities by at most
// 2 T times the length of an adjacent segment (somewhere in it, f' equals the slope of the chord):
//
//   (4)  least peak >= b - sum |r_j| 2 T (1 or length_j)

namespace jounce {
namespace {

using optimize_detail::AffineCam;
using optimize_detail::ConvexProgram;
using optimize_detail::ConvexSolution;
using optimize_detail::Form;

constexpr double slack = 1e-6;  ///< share of the peak that may be given up for less jerk
constexpr double met = 1e-9;    ///< relative excess of a peak that counts as rounding
constexpr int max_exchanges = 30;
constexpr std::array first_peak_places{0.0,  0.067, 0.25, 0.5,
                                       0.75, 0.933, 1.0};  ///< first places in a segment

/// A place where |f''| is bounded.
struct Place {
  std::size_t segment = 0;
  double s = 0;  ///< in [0, 1]
  double sign = 1;
};

/// (1) and (2) for one cam.
class Exchange {
 public:
  explicit Exchange(const AffineCam& affine, std::size_t segments) : cam_(affine) {
    for (std::size_t i = 0; i < segments; ++i) {
      if (!affine.moves(i)) continue;
      for (const double s : first_peak_places)
        for (const double sign : {1.0, -1.0}) places_.push_back({i, s, sign});
    }
  }

  /// Solves (1): returns t, in units of the peak, and sets x and the certificate.
  double least() {
    x_.assign(cam_.unknowns().size() + 1, 0);
    x_.back() = 1;
    for (int round = 0; round < max_exchanges; ++round) {
      ConvexProgram program{std::vector<double>(x_.size(), 0), {}, {}};
      program.slope.back() = 1;
      for (const Place& p : places_) {
        program.constraints.push_back(bounded(p, 0));
        program.constraints.back().terms.push_back({x_.size() - 1, -1});
      }
      const ConvexSolution found = run(program);
      bound_ = std::max(bound_, certificate(program, found.multipliers));
      if (!exchange(x_.back())) break;
    }
    const double t = x_.back();
    x_.pop_back();
    return t;
  }

  /// (2).
  void smooth(double t) {
    const auto squares = of_size_one(cam_.square_jerk());
    for (int round = 0; round < max_exchanges; ++round) {
      ConvexProgram program{std::vector<double>(x_.size(), 0), squares, {}};
      for (const Place& p : places_) program.constraints.push_back(bounded(p, t));
      run(program);
      if (!exchange(t)) break;
    }
  }

  [[nodiscard]] double bound() const { return bound_; }
  [[nodiscard]] int solutions() const { return solutions_; }
  [[nodiscard]] const std::vector<double>& x() const { return x_; }

 private:
  /// The same minimum, scaled so that the sum is 1 at the present x.
  [[nodiscard]] std::vector<Form> of_size_one(std::vector<Form> squares) const {
    double sum = 0;
    for (const Form& f : squares) sum += f.at(x_) * f.at(x_);
    if (sum == 0) return squares;
    for (Form& f : squares) f = scaled(f, 1 / std::sqrt(sum));
    return squares;
  }

  /// sign f'' - t at a place.
  [[nodiscard]] Form bounded(const Place& p, double t) const {
    Form f = scaled(cam_.derivative(p.segment, p.s, 2), p.sign);
    f.constant -= t;
    return f;
  }

  ConvexSolution run(const ConvexProgram& program) {
    ConvexSolution found = optimize_detail::solve(program, x_);
    x_ = found.x;
    solutions_ += found.iterations;
    return found;
  }

  /// (4), in units of the peak. Any cam better than the given one, whose peak is 1, has T <= 1.
  [[nodiscard]] double certificate(const ConvexProgram& program, std::vector<double> y) const {
    double sum = 0;
    for (const double v : y) sum += v;
    double b = 0;
    std::vector<double> r(x_.size(), 0);
    std::vector<double> at = x_;
    at.back() = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      b += y[k] / sum * program.constraints[k].at(at);
      for (const Form::Term& t : program.constraints[k].terms) r[t.index] += y[k] / sum * t.factor;
    }
    for (std::size_t j = 0; j + 1 < r.size(); ++j)
      b -= std::abs(r[j]) * 2 * cam_.unknowns()[j].reach;
    return b;
  }

  /// Adds the extrema beyond t, in units of the peak. Returns true if there were any.
  bool exchange(double t) {
    const CamDesign made = design(cam_.at(x_));
    bool any = false;
    for (std::size_t k = 0; k < made.origin.size(); ++k) {
      if (!cam_.moves(made.origin[k])) continue;
      const Range range = segment_extrema(made.cam, k)[2];
      for (const auto& [sign, e] : {std::pair{1.0, range.max}, {-1.0, range.min}}) {
        if (sign * e.value <= cam_.peak() * t * (1 + met)) continue;
        const double s = (e.where - made.cam.breaks()[k]) / made.cam.segments()[k].length;
        places_.push_back({made.origin[k], std::clamp(s, 0.0, 1.0), sign});
        any = true;
      }
    }
    return any;
  }

  const AffineCam& cam_;
  std::vector<Place> places_;
  std::vector<double> x_;
  double bound_ = 0;
  int solutions_ = 0;
};

/// The peak of the segments that no free derivative changes.
double floor_of(const CamSpec& spec, const AffineCam& affine) {
  const CamDesign made = design(spec);
  double peak = 0;
  for (std::size_t k = 0; k < made.origin.size(); ++k)
    if (!affine.moves(made.origin[k]))
      peak = std::max(peak, std::abs(segment_extrema(made.cam, k)[2].peak().value));
  return peak;
}

}  // namespace

LeastPeak filled_for_least_peak(const CamSpec& spec) {
  LeastPeak answer{filled(spec, Fill::minimum_jerk), 0, 0, 0};
  const AffineCam affine(answer.cam, free_derivatives(spec));
  const double floor = floor_of(answer.cam, affine);
  if (!affine.unknowns().empty() && !affine.straight()) {
    Exchange exchange(affine, spec.segments.size());
    const double least = exchange.least();
    answer.cam = affine.at(exchange.x());
    const double allowed = std::max(least * (1 + slack), floor / affine.peak());
    exchange.smooth(allowed);
    const CamSpec smooth = affine.at(exchange.x());
    if (optimize_detail::peak_of(smooth) <= affine.peak() * allowed * (1 + 2 * met))
      answer.cam = smooth;
    answer.bound = exchange.bound() * affine.peak();
    answer.solutions = exchange.solutions();
  }
  answer.peak = optimize_detail::peak_of(answer.cam);
  answer.bound = std::min(answer.peak, std::max(answer.bound, floor));
  return answer;
}

}  // namespace jounce
