// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/program.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>

namespace jounce::proof {
namespace {

/// Slack for envelopes that admit only one motion: rounding must not make the program infeasible.
constexpr double loose = 1e-7;

/// Variables and rows, in units of their own, so that all are near 1.
class Program {
 public:
  Program(const Question& q, const std::vector<Real>& grid);
  Functional solve();

 private:
  void spread(Functional& f) const;
  void cruise(Functional& f, std::size_t begin, std::size_t end) const;
  static void hold(Functional::Instant& begin, Functional::Instant& end);
  /// Columns of an interval: jerk, then the state at its end.
  enum Column { jerk, acceleration, velocity, position, columns };

  void integrate(std::size_t i);
  void limit(std::size_t i);
  void reach(Column what, double target);
  void between(std::size_t i);
  int add_row(double lo, double hi);
  void set(int row, std::size_t i, Column what, double value) {
    row_.push_back(row);
    column_.push_back(static_cast<int>(i) * columns + what);
    value_.push_back(value);
  }
  /// Adds a state before interval i times a factor: a variable, or the start's on the other side.
  void before(int row, std::size_t i, Column what, double factor);
  [[nodiscard]] double scaled(Real x, Column what) const {
    return static_cast<double>(x / unit_[static_cast<std::size_t>(what)]);
  }

  const Question& q_;
  const std::vector<Real>& grid_;
  Real T_;
  std::array<Real, columns> unit_;
  const Envelope& top_;
  const Envelope& bottom_;
  std::vector<int> row_, column_;
  std::vector<double> value_, row_lo_, row_hi_, lo_, hi_;
};

Program::Program(const Question& q, const std::vector<Real>& grid)
    : q_(q), grid_(grid), T_(grid.back()), top_(q.top), bottom_(q.bottom) {
  const auto least = [](Real x, Real lo, Real hi) { return std::min({x, -lo, hi}); };
  const Bounds& b = q.bounds;
  const Real j = std::min(b.jerk_max, -b.jerk_min);
  const Real a = least(j * T_, b.acceleration_min, b.acceleration_max);
  const Real v = least(a * T_, b.velocity_min, b.velocity_max);
  unit_ = {j, a, v, v * T_};
  lo_.assign(grid.size() * columns + 1, -COIN_DBL_MAX);
  hi_.assign(grid.size() * columns + 1, COIN_DBL_MAX);
  lo_.back() = 0;  // the distance to the target
  for (std::size_t i = 0; i < grid.size(); ++i) {
    integrate(i);
    limit(i);
  }
  reach(acceleration, scaled(q.to.acceleration, acceleration));
  reach(velocity, scaled(q.to.velocity, velocity));
  if (q.position) reach(position, scaled(q.to.position - q.start.x, position));
  for (std::size_t i = 0; i < grid.size(); ++i) between(i);
}

int Program::add_row(double lo, double hi) {
  row_lo_.push_back(lo);
  row_hi_.push_back(hi);
  return static_cast<int>(row_lo_.size()) - 1;
}

void Program::before(int row, std::size_t i, Column what, double factor) {
  if (i > 0) return set(row, i - 1, what, factor);
  const std::array<Real, columns> start{0, q_.start.a, q_.start.v, 0};
  const double known = factor * scaled(start[static_cast<std::size_t>(what)], what);
  row_lo_[static_cast<std::size_t>(row)] -= known;
  row_hi_[static_cast<std::size_t>(row)] -= known;
}

void Program::integrate(std::size_t i) {
  const Real h = grid_[i] - (i > 0 ? grid_[i - 1] : 0);
  const auto in_units = [this](Real factor, int of, int to) {
    return static_cast<double>(factor * unit_[static_cast<std::size_t>(of)] /
                               unit_[static_cast<std::size_t>(to)]);
  };
  for (const Column what : {acceleration, velocity, position}) {
    const int row = add_row(0, 0);
    set(row, i, what, -1);
    Real factor = 1;  // factor of Taylor's series
    for (int lower = what; lower > jerk; --lower) {
      before(row, i, static_cast<Column>(lower), in_units(factor, lower, what));
      factor *= h / (what - lower + 1);
    }
    set(row, i, jerk, in_units(factor, jerk, what));
  }
}

void Program::limit(std::size_t i) {
  const Bounds& b = q_.bounds;
  const Real t = grid_[i];
  const Real a = q_.start.a;
  const auto range = [&](Column what, Real lo, Real hi) {
    const std::size_t column = i * columns + static_cast<std::size_t>(what);
    if (std::isfinite(lo)) lo_[column] = scaled(lo, what) - loose;
    if (std::isfinite(hi)) hi_[column] = scaled(hi, what) + loose;
  };
  range(jerk, b.jerk_min, b.jerk_max);
  range(acceleration, std::min<Real>(b.acceleration_min, a + b.jerk_max * t),
        std::max<Real>(b.acceleration_max, a + b.jerk_min * t));
  range(velocity, -bottom_.velocity(t), top_.velocity(t));
}

/// |state at T - target| <= distance.
void Program::reach(Column what, double target) {
  const std::size_t last = grid_.size() - 1;
  for (const int side : {1, -1}) {
    const int row = add_row(side > 0 ? -COIN_DBL_MAX : target, side > 0 ? target : COIN_DBL_MAX);
    set(row, last, what, 1);
    set(row, last + 1, jerk, -side);
  }
}

/// Replaces the pressures of two instants that follow each other by one on the whole stretch between
/// them: a limit that is kept at instants alone lets the motion pass it in between.
void Program::spread(Functional& f) const {
  const std::vector<Functional::Instant> point = f.at;
  std::size_t last = point.size();  // the last with a pressure
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Real m = point[i].velocity;
    const Real n = point[i].acceleration;
    if (m == 0 && n == 0) continue;
    if (last < i) {
      const bool level = (m > 0 ? top_ : bottom_).arc(point[last].t).j == 0;
      if (level && m * f.p > 0 && m * point[last].velocity > 0)
        cruise(f, last, i);
      else if (n * point[last].acceleration > 0 && last + 1 == i)
        hold(f.at[last], f.at[i]);
    }
    last = i;
  }
}

/// The start of a cruise has a pressure of its own; it contains half of the pressure on the
/// stretch.
void Program::cruise(Functional& f, std::size_t begin, std::size_t end) const {
  Functional::Instant& first = f.at[begin];
  if (first.before != Functional::Flat::velocity)
    first.velocity -= f.p * (f.at[end].t - first.t) / 2;
  first.acceleration = 0;
  for (std::size_t i = begin + 1; i <= end; ++i)
    f.at[i] = {f.at[i].t, 0, 0, Functional::Flat::velocity};
}

void Program::hold(Functional::Instant& begin, Functional::Instant& end) {
  begin.acceleration = end.acceleration = 0;
  end.before = Functional::Flat::acceleration;
}

/// The middle Bezier ordinate of the velocity on an interval: with it inside, so is all of the interval.
void Program::between(std::size_t i) {
  const Real begin = i > 0 ? grid_[i - 1] : 0;
  const Real half = (grid_[i] - begin) / 2;
  const auto ordinate = [&](const Envelope& e) {
    return e.velocity(begin) + half * e.arc(begin).acceleration(begin);
  };
  const Real lo = -ordinate(bottom_);
  const Real hi = ordinate(top_);
  const int row = add_row(std::isfinite(lo) ? scaled(lo, velocity) - loose : -COIN_DBL_MAX,
                          std::isfinite(hi) ? scaled(hi, velocity) + loose : COIN_DBL_MAX);
  before(row, i, velocity, 1);
  before(row, i, acceleration, static_cast<double>(half * unit_[acceleration] / unit_[velocity]));
}

Functional Program::solve() {
  std::vector<double> cost(lo_.size(), 0);
  cost.back() = 1;
  const CoinPackedMatrix matrix(true, row_.data(), column_.data(), value_.data(),
                                static_cast<CoinBigIndex>(row_.size()));
  ClpSimplex lp;
  lp.setLogLevel(0);
  lp.loadProblem(matrix, lo_.data(), hi_.data(), cost.data(), row_lo_.data(), row_hi_.data());
  lp.setPrimalTolerance(1e-9);
  lp.setDualTolerance(1e-9);
  lp.setMaximumIterations(20000);
  lp.primal();
  const double* price = lp.dualRowSolution();
  const double* reduced = lp.dualColumnSolution();
  // From `reach`: two rows each, after those of `integrate`.
  const std::size_t first = 3 * grid_.size();
  const auto weight = [&](std::size_t pair, Column what) {
    return (Real{price[first + 2 * pair]} + price[first + 2 * pair + 1]) /
           unit_[static_cast<std::size_t>(what)];
  };
  Functional f;
  f.a = weight(0, acceleration);
  f.v = weight(1, velocity);
  f.p = q_.position ? weight(2, position) : 0;
  const std::size_t middle = first + (q_.position ? 6 : 4);
  const auto in_between = [&](std::size_t i) {  // half of it for each end of an interval
    const Real r = i < grid_.size() ? -Real{price[middle + i]} : 0;
    return std::abs(r) > 1e-12L ? r / (2 * unit_[velocity]) : 0;
  };
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    const auto pressure = [&](Column what) {
      const std::size_t column = i * columns + static_cast<std::size_t>(what);
      const Real r = -Real{reduced[column]};
      const bool limited = (r > 0 ? hi_[column] : -lo_[column]) < COIN_DBL_MAX;
      return limited && std::abs(r) > 1e-12L ? r / unit_[static_cast<std::size_t>(what)] : 0;
    };
    f.at.push_back({grid_[i], pressure(velocity) + in_between(i) + in_between(i + 1),
                    pressure(acceleration), Functional::Flat::none});
  }
  spread(f);
  return f;
}

}  // namespace

Functional proposed(const Question& q, const std::vector<Real>& grid) {
  return Program(q, grid).solve();
}

}  // namespace jounce::proof
