// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/descent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "optimize/src/solvers/local_solver.hpp"

// Why SLSQP: the peaks of a figure are an epigraph with as many active rows as there are
// coefficients, and sequential quadratic programming converges quadratically at such a vertex. In
// whitened variables it takes 0.1 s for 50 coefficients and 2000 rows and 2.2 s for 200 and 4000,
// and agrees with an interior point method to 6 digits. MMA and CCSAQ end at values up to 40 times
// too high and report success. COBYLA takes seconds for 20 coefficients.

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::VectorXd;

constexpr std::size_t most_quantities = 4;

/// The functions of a program, at (y, t).
struct DescentRun {
  const DescentProgram& program;
  const std::function<bool()>& go_on;
  VectorXd y = {};
  VectorXd gradient = {};
  int evaluations = 0;
  bool finite = true;
  std::vector<double> last = {};  ///< the last finite x
  bool lost = false;              ///< true after an x with NaN

  [[nodiscard]] Index unknowns() const { return program.unknowns; }

  double objective(std::span<const double> x, std::span<double> slope) {
    require_finite(x);
    y = Map<const VectorXd>(x.data(), unknowns());
    gradient.setZero(unknowns());
    double sum = 0;
    for (const Mean& mean : program.means) sum += mean.evaluate(y, 1, gradient);
    for (std::size_t k = 0; k < program.weight.size(); ++k)
      sum += program.weight[k] * x[static_cast<std::size_t>(unknowns()) + k];
    if (!slope.empty()) {
      Map<VectorXd>(slope.data(), unknowns()) = gradient;
      std::copy(program.weight.begin(), program.weight.end(), slope.begin() + unknowns());
    }
    finite = finite && std::isfinite(sum);
    if (!finite) throw StopSolver{};
    return sum;
  }

  void constraints(std::span<const double> x, std::span<double> result, std::span<double> slope) {
    require_finite(x);
    const bool going = go_on();
    y = Map<const VectorXd>(x.data(), unknowns());
    for (std::size_t i = 0; i < result.size(); ++i) {
      gradient.setZero(unknowns());
      const auto own = slope.empty() ? slope : slope.subspan(i * x.size(), x.size());
      std::fill(own.begin(), own.end(), 0.0);
      if (i < program.rows.size())
        result[i] = row(program.rows[i], x, own);
      else
        result[i] = ceiling(program.ceilings[i - program.rows.size()]);
      if (!own.empty()) Map<VectorXd>(own.data(), unknowns()) = gradient;
      finite = finite && std::isfinite(result[i]);
    }
    ++evaluations;
    if (!finite || !going) throw StopSolver{};
  }

 private:
  /// Throws for an x with NaN. SLSQP steps there if its rows are almost dependent, and NaN would count as a
  /// constraint that holds.
  void require_finite(std::span<const double> x) {
    lost = !std::all_of(x.begin(), x.end(), [](double each) { return std::isfinite(each); });
    if (lost) throw StopSolver{};
    last.assign(x.begin(), x.end());
  }

  double row(const DescentRow& row, std::span<const double> x, std::span<double> slope) {
    const double value = row.evaluate(y, gradient);
    if (!row.t) return value;
    const std::size_t t = static_cast<std::size_t>(unknowns()) + *row.t;
    if (!slope.empty()) slope[t] = -1;
    return value - x[t];
  }

  double ceiling(const Mean& mean) { return mean.evaluate(y, 1, gradient) - mean.offset; }
};

}  // namespace

double PlaceRow::evaluate(const VectorXd& y, double factor, Eigen::Ref<VectorXd> gradient) const {
  std::array<double, most_quantities> value{};
  std::array<double, most_quantities> slope{};
  for (std::size_t k = 0; k < q.size(); ++k) value[k] = q[k].at(y);
  const double g = figure->g(x, sign, {value.data(), q.size()}, {slope.data(), q.size()});
  for (std::size_t k = 0; k < q.size(); ++k)
    if (slope[k] != 0 && factor != 0) gradient += factor * slope[k] * q[k].slope;
  return g;
}

double DescentRow::evaluate(const VectorXd& y, Eigen::Ref<VectorXd> gradient) const {
  if (place) return factor * place->evaluate(y, factor, gradient) - offset;
  gradient += factor * linear.slope;
  return factor * linear.at(y) - offset;
}

VectorXd least_t(const DescentProgram& program, const VectorXd& y) {
  VectorXd t = VectorXd::Zero(static_cast<Index>(program.weight.size()));
  VectorXd ignored = VectorXd::Zero(program.unknowns);
  for (const DescentRow& row : program.rows)
    if (row.t) {
      double& least = t[static_cast<Index>(*row.t)];
      least = std::max(least, row.evaluate(y, ignored));
    }
  return t;
}

double Mean::evaluate(const VectorXd& y, double by, Eigen::Ref<VectorXd> gradient) const {
  VectorXd total = VectorXd::Zero(y.size());
  double sum = 0;
  for (const DenseRow& form : forms) {
    const double g = form.at(y);
    sum += g * g;
    total += 2 * g * form.slope;
  }
  VectorXd own(y.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    own.setZero();
    const double g = places[k].evaluate(y, 1, own);
    sum += weight[k] * (root ? g * g : g);
    total += weight[k] * (root ? 2 * g : 1.0) * own;
  }
  if (!root) {
    gradient += by * factor * total;
    return factor * sum;
  }
  const double value = std::sqrt(sum);
  if (value > 0) gradient += by * factor / (2 * value) * total;
  return factor * value;
}

Descended descend(const DescentProgram& program, const VectorXd& y, int max_evaluations,
                  const std::function<bool()>& go_on) {
  const Index extra = static_cast<Index>(program.weight.size());
  const VectorXd t = least_t(program, y);
  std::vector<double> x(y.begin(), y.end());
  x.insert(x.end(), t.begin(), t.end());
  DescentRun run{program, go_on};
  x = run_local_solver(
      {.objective = [&](auto at, auto slope) { return run.objective(at, slope); },
       .constraints = [&](auto at, auto rows, auto slope) { run.constraints(at, rows, slope); },
       .rows = program.rows.size() + program.ceilings.size(),
       .row_tolerance = 1e-10,
       .x_relative = 1e-12,
       .objective_relative = 1e-12,
       .max_evaluations = max_evaluations},
      std::move(x));
  if (run.lost) x = run.last;
  Descended result{Map<const VectorXd>(x.data(), y.size()),
                   Map<const VectorXd>(x.data() + y.size(), extra), std::max(run.evaluations, 1),
                   run.finite};
  result.finite = result.finite && result.y.allFinite() && result.t.allFinite();
  return result;
}

}  // namespace jounce::optimize_detail
