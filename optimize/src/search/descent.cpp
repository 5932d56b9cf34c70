// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/descent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include <nlopt.hpp>

#include "optimize/src/solvers/forgiving.hpp"

// Why SLSQP: the peaks of a figure are an epigraph with as many active rows as there are coefficients, a
// vertex, at which sequential quadratic programming converges quadratically. In whitened variables it needs
// 0.1 s for 50 coefficients and 2000 rows and 2.2 s for 200 and 4000, and agrees with an interior point
// method to 6 digits; MMA and CCSAQ end up to 40 times off with a success code, COBYLA needs seconds for
// 20 coefficients.

namespace jounce::optimizer {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t most_quantities = 4;

struct Run {
  const DescentProgram& program;
  nlopt::opt& solver;
  const std::function<bool()>& go_on;
  VectorXd y = {};
  VectorXd gradient = {};
  int evaluations = 0;
  bool finite = true;
  std::exception_ptr trouble = nullptr;
  std::vector<double> last = {};  ///< the x before the solver lost its way into NaN
  bool lost = false;

  [[nodiscard]] Index unknowns() const { return program.unknowns; }

  double objective(const double* x, double* slope) {
    y = Map<const VectorXd>(x, unknowns());
    gradient.setZero(unknowns());
    double sum = 0;
    for (const Mean& mean : program.means) sum += mean.evaluate(y, 1, gradient);
    for (std::size_t k = 0; k < program.weight.size(); ++k)
      sum += program.weight[k] * x[unknowns() + static_cast<Index>(k)];
    if (slope) {
      Map<VectorXd>(slope, unknowns()) = gradient;
      std::copy(program.weight.begin(), program.weight.end(), slope + unknowns());
    }
    return sum;
  }

  void constraints(std::span<double> result, std::size_t n, const double* x, double* slope) {
    y = Map<const VectorXd>(x, unknowns());
    for (std::size_t i = 0; i < result.size(); ++i) {
      gradient.setZero(unknowns());
      double* own = slope ? slope + i * n : nullptr;
      if (own) std::fill(own, own + n, 0.0);
      if (i < program.rows.size())
        result[i] = row(program.rows[i], x, own);
      else
        result[i] = ceiling(program.ceilings[i - program.rows.size()]);
      if (own) Map<VectorXd>(own, unknowns()) = gradient;
    }
    ++evaluations;
  }

 private:
  double row(const DescentRow& row, const double* x, double* slope) {
    const double value = row.evaluate(y, gradient);
    if (!row.t) return value;
    const auto t = unknowns() + static_cast<Index>(*row.t);
    if (slope) slope[t] = -1;
    return value - x[t];
  }

  double ceiling(const Mean& mean) { return mean.evaluate(y, 1, gradient) - mean.offset; }
};

/// An exception must not pass NLopt, which would lose it; a NaN must not stay, which it would take for
/// satisfied.
template <class Evaluate>
void guarded(Run& run, const Evaluate& evaluate) {
  try {
    if (!run.lost) evaluate();
  } catch (...) {
    run.trouble = std::current_exception();
  }
  if (run.trouble || !run.finite || run.lost) run.solver.force_stop();
}

/// SLSQP steps to NaN where its rows are almost dependent.
void watch(Run& run, const double* x, std::size_t n) {
  if (std::all_of(x, x + n, [](double each) { return std::isfinite(each); }))
    run.last.assign(x, x + n);
  else
    run.lost = true;
}

double objective(unsigned n, const double* x, double* slope, void* data) {
  auto& run = *static_cast<Run*>(data);
  watch(run, x, n);
  double value = 0;
  guarded(run, [&] {
    value = run.objective(x, slope);
    run.finite = run.finite && std::isfinite(value);
  });
  return value;
}

void constraints(unsigned m, double* result, unsigned n, const double* x, double* slope,
                 void* data) {
  auto& run = *static_cast<Run*>(data);
  watch(run, x, n);
  guarded(run, [&] {
    if (!run.go_on()) run.solver.force_stop();
    run.constraints({result, m}, n, x, slope);
    for (unsigned i = 0; i < m && !run.lost; ++i)
      run.finite = run.finite && std::isfinite(result[i]);
  });
}

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
  const std::size_t rows = program.rows.size() + program.ceilings.size();
  nlopt::opt solver(nlopt::LD_SLSQP, static_cast<unsigned>(x.size()));
  Run run{program, solver, go_on};
  solver.set_min_objective(objective, &run);
  if (rows > 0)
    solver.add_inequality_mconstraint(constraints, &run, std::vector<double>(rows, 1e-10));
  solver.set_xtol_rel(1e-12);
  solver.set_ftol_rel(1e-12);
  solver.set_maxeval(max_evaluations);
  optimize_forgiving(solver, x, run.trouble);
  if (run.lost) x = run.last;
  Descended result{Map<const VectorXd>(x.data(), y.size()),
                   Map<const VectorXd>(x.data() + y.size(), extra), std::max(run.evaluations, 1),
                   run.finite};
  result.finite = result.finite && result.y.allFinite() && result.t.allFinite();
  return result;
}

}  // namespace jounce::optimizer
