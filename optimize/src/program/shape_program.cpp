// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/src/solvers/certificate.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double smoothing_weight = 1e-5;  ///< weight of the figure that makes the solution unique
constexpr double certificate_range = 1e3;  ///< range of a certificate, in sizes of the solution

/// The greatest difference of each unknown of a better solution from this one.
std::vector<double> range_of(const ShapeModel& model, const ShapeProgram& p,
                             const ConvexSolution& s, double sum) {
  const std::size_t size = model.space.size();
  std::vector<double> largest(static_cast<std::size_t>(model.space.degree()) + 1, 1);
  for (std::size_t j = 0; j < size; ++j)
    largest[j % largest.size()] = std::max(largest[j % largest.size()], std::abs(s.x[j]));
  std::vector<double> all(s.x.size());
  for (std::size_t j = 0; j < size; ++j) all[j] = certificate_range * largest[j % largest.size()];
  for (std::size_t k = 0; k < model.definitions.size(); ++k) {
    all[size + k] = model.range_of_auxiliary(k, all);
    if (!p.slack)  // these hold where the constraints hold
      all[size + k] = std::min(all[size + k], model.auxiliary_most[k] + std::abs(s.x[size + k]));
  }
  for (std::size_t k = 0; k < p.column.size(); ++k)
    if (p.column[k]) all[*p.column[k]] = sum / model.terms[k].weight;
  if (p.slack) all[*p.slack] = 1 + std::abs(s.x[*p.slack]);
  return all;
}

/// The correction of a bound for constraints whose true limits are a little wider.
double held_off(const ShapeRows& rows, const ConvexSolution& s, const ShapeTask& task) {
  double sum = 0;
  std::size_t k = 0;  // rows in the order of program_of()
  for (const ShapeRow& row : rows.all())
    if (!row.term || task.terms)
      sum += row.off / task.slack_unit * std::max(s.multipliers[k++], 0.0);
  for (const auto& multipliers : s.round_multipliers)  // a ceiling is normalized to 1 here
    sum += 2 * RoundCeiling::off * norm(multipliers);
  return sum;
}

/// A ceiling on a norm, in units of its limit.
RoundConstraint constraint(const RoundCeiling& ceiling) {
  RoundConstraint round{1, {}};
  for (const Form& f : ceiling.rows.squares) round.forms.push_back(scaled(f, 1 / ceiling.held()));
  return round;
}

/// A row minus the level or the unknown of its term; a row without a term: minus the slack v.
Form constraint(const ShapeRow& row, const ShapeTask& task, const ShapeProgram& p) {
  const bool with_slack = !row.term && p.slack;
  Form form = with_slack ? scaled(row.form, 1 / task.slack_unit) : row.form;
  if (with_slack) form.terms.push_back({*p.slack, -1});
  if (row.term && p.column[*row.term]) form.terms.push_back({*p.column[*row.term], -1});
  if (row.term && task.level[*row.term]) form.constant -= *task.level[*row.term];
  return form;
}

}  // namespace

ShapeTask plain(const ShapeModel& model) {
  ShapeTask task;
  task.level.resize(model.terms.size());
  return task;
}

ShapeProgram program_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task) {
  ShapeProgram p;
  std::size_t unknowns = model.unknowns();
  for (std::size_t k = 0; k < model.terms.size(); ++k)
    p.column.push_back(task.level[k] || !task.terms || model.terms[k].rows.by_squares()
                           ? std::nullopt
                           : std::optional(unknowns++));
  if (task.elastic) p.slack = unknowns++;
  p.convex.slope.assign(unknowns, 0);
  for (std::size_t k = 0; k < p.column.size(); ++k)
    if (p.column[k]) p.convex.slope[*p.column[k]] = model.terms[k].weight;
  p.convex.squares = task.squares;
  p.convex.equalities = model.equalities;
  p.convex.equalities.insert(p.convex.equalities.end(), model.definitions.begin(),
                             model.definitions.end());
  for (const ShapeRow& row : rows.all())
    if (!row.term || task.terms) p.convex.constraints.push_back(constraint(row, task, p));
  if (task.round)
    for (const RoundCeiling& ceiling : model.round) p.convex.round.push_back(constraint(ceiling));
  if (p.slack) {
    p.convex.slope[*p.slack] = 1;
    p.convex.constraints.push_back({-1, {{*p.slack, -1}}});
  }
  return p;
}

double bound_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task,
                ShapeProgram program, const ConvexSolution& found, double sum) {
  if (task.elastic) program.convex.squares.clear();  // hint()
  return (weak_bound(program.convex, found, range_of(model, program, found, sum)) -
          held_off(rows, found, task)) *
         task.slack_unit;
}

std::vector<Form> hint(const SplineSpace& space) {
  const LinearQuantity top = derivative_of_shape(std::min(space.degree(), 5));
  std::vector<Form> squares = space.squares(top);
  const auto knots = space.knots();
  const double size = space.natural(top) * std::sqrt(knots.back() - knots.front());
  for (Form& f : squares) f = scaled(std::move(f), smoothing_weight / size);
  return squares;
}

}  // namespace jounce::optimize_detail
