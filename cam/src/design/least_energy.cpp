// SPDX-License-Identifier: Apache-2.0
#include "cam/src/design/least_energy.hpp"

#include <cassert>

#include <Eigen/Cholesky>

// Between two knots at distance h, the m states at both ends define the polynomial of degree 2m -
// 1. Its energy, the integral of the square of the m-th derivative, is a quadratic form in u = (p0,
// v0, a0, p1, v1, a1). With S = diag(1, h, h^2, 1, h, h^2):
//
//   (1)  energy = u' S K S u / h^(2m - 1),   K the matrices below (h = 1)
//
// The sum over all intervals is least if its gradient with respect to every free state vanishes:
//
//   (2)  A x = -g    A: the sum of (1) without the rows and columns of fixed states
//                    g: the gradient with every free derivative zero
//
// By partial integration, the gradient with respect to p_i is twice the jump of the (2m - 1)-th
// derivative at knot i, that with respect to v_i twice the jump of the next lower one, and so on.
// So the solution of (2) joins the pieces as smoothly as a spline. A is positive definite and
// couples only neighbors: blocks of 3 x 3 along the diagonal. In a periodic curve the first knot is
// also a neighbor of the last one, so it is eliminated last, as a border of the chain of the
// others:
//
//   (3)  D_i x_i + O_i x_(i+1) + O_(i-1)' x_(i-1) + B_i x_0 = r_i,   i = 1 ...
//
// Cholesky's method needs no pivots here, and is independent of the scaling of the unknowns.

namespace jounce::cam_detail {
namespace {

using Block = Eigen::Matrix3d;
using Column = Eigen::Vector3d;
using Element = Eigen::Matrix<double, 6, 6>;
using States = Eigen::Matrix<double, 6, 1>;

/// Equation (1) for h = 1.
Element unit_energy(Energy energy) {
  Element k;
  if (energy == Energy::jerk)
    k << 720, 360, 60, -720, 360, -60,   //
        360, 192, 36, -360, 168, -24,    //
        60, 36, 9, -60, 24, -3,          //
        -720, -360, -60, 720, -360, 60,  //
        360, 168, 24, -360, 192, -36,    //
        -60, -24, -3, 60, -36, 9;
  else
    k << 12, 6, 0, -12, 6, 0,   //
        6, 4, 0, -6, 2, 0,      //
        0, 0, 0, 0, 0, 0,       //
        -12, -6, 0, 12, -6, 0,  //
        6, 2, 0, -6, 4, 0,      //
        0, 0, 0, 0, 0, 0;
  return k;
}

/// The system (2) of the knots, in the order of (3); the unit of master is the mean interval.
class System {
 public:
  System(const std::vector<EnergyKnot>& knots, Energy energy, bool periodic)
      : knots_(knots),
        unknowns_(knots.size() - (periodic ? 1 : 0)),
        unit_((knots.back().master - knots.front().master) / static_cast<double>(knots.size() - 1)),
        energy_(energy),
        kernel_(unit_energy(energy)),
        diagonal_(unknowns_, Block::Zero()),
        next_(unknowns_, Block::Zero()),
        border_(unknowns_, Block::Zero()),
        right_(unknowns_, Column::Zero()) {
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) add(i);
    for (std::size_t i = 0; i < unknowns_; ++i)
      for (int k = 0; k < 3; ++k)
        if (fixed(i, k)) diagonal_[i](k, k) = 1;
  }

  /// Returns the increments of the states of each unknown knot.
  std::vector<std::array<double, 3>> solve() {
    for (std::size_t i = 1; i < unknowns_; ++i) eliminate(i);
    std::vector<Column> x(unknowns_, Column::Zero());
    x[0] = Eigen::LLT<Block>(diagonal_[0]).solve(right_[0]);
    for (std::size_t i = unknowns_; --i > 0;) {
      x[i] = right_[i] - border_[i] * x[0];
      if (i + 1 < unknowns_) x[i] -= next_[i] * x[i + 1];
    }
    std::vector<std::array<double, 3>> states;
    for (const Column& c : x) states.push_back({c[0], c[1] / unit_, c[2] / (unit_ * unit_)});
    return states;
  }

 private:
  [[nodiscard]] bool fixed(std::size_t knot, int k) const {
    return knots_[knot].fixed[static_cast<std::size_t>(k)] ||
           (energy_ == Energy::acceleration && k == 2);
  }

  /// Adds the contribution of one interval to (2).
  void add(std::size_t i) {
    const std::size_t j = i + 1 < unknowns_ ? i + 1 : i + 1 - unknowns_;
    const double h = (knots_[i + 1].master - knots_[i].master) / unit_;
    States scale;
    scale << 1, h, h * h, 1, h, h * h;
    Element k = scale.asDiagonal() * kernel_ * scale.asDiagonal();
    k /= energy_ == Energy::jerk ? h * h * h * h * h : h * h * h;
    States gradient = k * given(i);
    for (int r = 0; r < 6; ++r)
      if (fixed(r < 3 ? i : j, r % 3)) {
        k.row(r).setZero();
        k.col(r).setZero();
        gradient[r] = 0;
      }
    diagonal_[i] += k.topLeftCorner<3, 3>();
    diagonal_[j] += k.bottomRightCorner<3, 3>();
    right_[i] -= gradient.head<3>();
    right_[j] -= gradient.tail<3>();
    couple(i, j, k.topRightCorner<3, 3>());
  }

  void couple(std::size_t i, std::size_t j, const Block& k) {
    if (i == 0 && j == 0)
      diagonal_[0] += k + k.transpose();
    else if (i == 0)
      border_[j] += k.transpose();
    else if (j == 0)
      border_[i] += k;
    else
      next_[i] = k;
  }

  /// The states at the ends of an interval: values relative to its start, free derivatives zero.
  [[nodiscard]] States given(std::size_t i) const {
    States u = States::Zero();
    u[3] = knots_[i + 1].state[0] - knots_[i].state[0];
    double power = unit_;
    for (int k = 1; k < 3; ++k, power *= unit_) {
      const auto order = static_cast<std::size_t>(k);
      if (knots_[i].fixed[order]) u[k] = knots_[i].state[order] * power;
      if (knots_[i + 1].fixed[order]) u[3 + k] = knots_[i + 1].state[order] * power;
    }
    if (energy_ == Energy::acceleration) u[2] = u[5] = 0;
    return u;
  }

  /// Eliminates x_i from the equations of x_(i+1) and x_0; stores it as a function of them.
  void eliminate(std::size_t i) {
    const Eigen::LLT<Block> factor(diagonal_[i]);
    assert(factor.info() == Eigen::Success);
    const Block next = factor.solve(next_[i]);
    const Block border = factor.solve(border_[i]);
    const Column right = factor.solve(right_[i]);
    diagonal_[0] -= border_[i].transpose() * border;
    right_[0] -= border_[i].transpose() * right;
    if (i + 1 < unknowns_) {
      diagonal_[i + 1] -= next_[i].transpose() * next;
      border_[i + 1] -= next_[i].transpose() * border;
      right_[i + 1] -= next_[i].transpose() * right;
    }
    next_[i] = next;
    border_[i] = border;
    right_[i] = right;
  }

  const std::vector<EnergyKnot>& knots_;
  std::size_t unknowns_;
  double unit_;
  Energy energy_;
  Element kernel_;
  std::vector<Block> diagonal_, next_, border_;
  std::vector<Column> right_;
};

/// First and last knot of a periodic curve: a state fixed in one is fixed in both.
void close(std::vector<EnergyKnot>& knots) {
  EnergyKnot& a = knots.front();
  EnergyKnot& b = knots.back();
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) (a.fixed[k] ? b : a).state[k] = (a.fixed[k] ? a : b).state[k];
    a.fixed[k] = b.fixed[k] = a.fixed[k] || b.fixed[k];
  }
}

/// Two knots with given values only: all parabolas through them have jerk 0. Selects the line.
void straighten(std::vector<EnergyKnot>& knots) {
  constexpr std::array values{true, false, false};
  if (knots.size() > 2 || knots[0].fixed != values || knots[1].fixed != values) return;
  for (EnergyKnot& knot : knots) {
    knot.state[1] = (knots[1].state[0] - knots[0].state[0]) / (knots[1].master - knots[0].master);
    knot.state[2] = 0;
    knot.fixed = {true, true, true};
  }
}

}  // namespace

void minimize(std::vector<EnergyKnot>& knots, Energy energy, bool periodic) {
  assert(knots.size() >= 2);
  if (periodic)
    close(knots);
  else
    straighten(knots);
  const auto found = System(knots, energy, periodic).solve();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const auto& x = found[i < found.size() ? i : 0];
    for (std::size_t k = 0; k < 3; ++k)
      if (!knots[i].fixed[k]) knots[i].state[k] = x[k] + (k == 0 ? knots[i].state[0] : 0);
  }
}

std::vector<Segment> segments_between(const std::vector<EnergyKnot>& knots, Energy energy) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double length = knots[i + 1].master - knots[i].master;
    const auto& a = knots[i].state;
    const auto& b = knots[i + 1].state;
    segments.push_back(energy == Energy::jerk ? quintic(length, a[0], a[1], a[2], b[0], b[1], b[2])
                                              : cubic(length, a[0], a[1], b[0], b[1]));
  }
  return segments;
}

double square_jerk(const std::vector<Segment>& segments) {
  double total = 0;
  for (const Segment& f : segments) {
    // Coefficients about the middle of the segment: j0 + j1 s + j2 s^2 = q + p t + j2 t^2, t = s -
    // 1/2
    const double j0 = 6 * f.c[3], j1 = 24 * f.c[4], j2 = 60 * f.c[5];
    const double q = j0 + j1 / 2 + j2 / 4, p = j1 + j2;
    const double mean = q + j2 / 12;
    const double h = f.length;
    total += (mean * mean + p * p / 12 + j2 * j2 / 180) / (h * h * h * h * h);
  }
  return total;
}

}  // namespace jounce::cam_detail
