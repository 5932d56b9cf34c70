// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "optimize/src/program/auxiliary_variables.hpp"

// A response y that is affine in the shape is determined by its values for a set of shapes. With
// z_k the shapes of a basis and c_k their coordinates
//
//   (1)  y(z) = y(0) + sum_k c_k (y(z_k) - y(0)) = y(0) + R z
//
// With auxiliary variables v in the unit u (equation (2) of auxiliary_variables.cpp),
// y = u Q v + (1 - Q Q') y(0), and mean squares are
//
//   (2)  |y|^2 = u^2 |v|^2 + |(1 - Q Q') y(0)|^2

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double accuracy = 1e-10;   ///< share of the natural size of y that the joints leave
constexpr double nothing = 1e-9;     ///< share of the natural size of y
constexpr Index to_begin_with = 32;  ///< instants

using Respond = std::function<std::vector<double>(const std::vector<Segment>&)>;

Respond responding(const std::function<std::vector<double>(const Trajectory&)>& of, double begin) {
  return [of, begin](const std::vector<Segment>& shape) { return of(Trajectory(shape, begin)); };
}

double largest(const std::vector<double>& y) {
  double peak = 0;
  for (const double v : y) {
    if (std::isnan(v)) return v;  // std::max would ignore it
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

double rms(const std::vector<double>& y) {
  double sum = 0;
  for (const double v : y) sum += v * v;
  return y.empty() ? 0 : std::sqrt(sum / static_cast<double>(y.size()));
}

/// (1).
Affine affine(const Respond& respond, const SplineSpace& space) {
  const auto response = [&](const Coordinates& z) {
    const std::vector<double> y = respond(space.segments(z));
    return VectorXd(Eigen::Map<const VectorXd>(y.data(), static_cast<Index>(y.size())));
  };
  Affine y{response(Coordinates(space.size(), 0)), {}};
  y.factor = MatrixXd::Zero(y.constant.size(), static_cast<Index>(space.size()));
  const std::size_t at_the_end = space.index(space.pieces(), 0);  // in no segment
  for (std::size_t k = 0; k < at_the_end; ++k) {
    Coordinates z(space.size(), 0);
    z[k] = 1;
    y.factor.col(static_cast<Index>(k)) = response(z) - y.constant;
  }
  y.factor = without_joints(y.factor, space);
  const double size =
      std::max(y.constant.lpNorm<Eigen::Infinity>(), y.factor.lpNorm<Eigen::Infinity>());
  y.natural = size > 0 ? size : 1;
  return y;
}

Affine rows_in(const Respond& respond, const SplineSpace& space, const Auxiliary* auxiliary,
               FigureRows& rows) {
  Affine y = affine(respond, space);
  rows.natural = y.natural;
  rows.nothing = nothing;
  rows.accuracy = accuracy;
  return auxiliary ? with_auxiliary_variables(y, *auxiliary, rows) : y;
}

}  // namespace

FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary) {
  const Respond respond = responding(figure.of, space.knots().front());
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return rms(respond(shape)); }};
  const Affine y = rows_in(respond, space, auxiliary, rows);
  const double share = 1 / std::sqrt(static_cast<double>(y.constant.size()));
  if (!auxiliary) {
    for (Index i = 0; i < y.constant.size(); ++i)
      rows.squares.push_back(scaled(y.row(i, 1), share));
    return rows;
  }
  rows.squares.push_back({share * y.constant.norm(), {}});  // (2)
  for (std::size_t k = 0; k < rows.definitions.size(); ++k)
    rows.squares.push_back(
        {0, {{auxiliary->first + k, share * y.factor.col(static_cast<Index>(k)).norm()}}});
  return rows;
}

FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space, const Auxiliary* auxiliary) {
  const Respond respond = responding(figure.of, space.knots().front());
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return largest(respond(shape)); }};
  const Affine y = rows_in(respond, space, auxiliary, rows);
  const Index every = std::max(y.constant.size() / to_begin_with, Index{1});
  for (Index i = 0; i < y.constant.size(); i += every)
    for (const double sign : {1.0, -1.0}) rows.start.push_back(y.row(i, sign));
  rows.cuts = [respond, y](const std::vector<Segment>& shape, double level) {
    const std::vector<double> now = respond(shape);
    std::vector<Form> planes;
    const auto magnitude = [&](std::size_t i) { return std::abs(now[i]); };
    for (std::size_t i = 0; i < now.size(); ++i) {  // only local peaks: neighbors are nearly equal
      if (!(magnitude(i) > level)) continue;
      if (i > 0 && magnitude(i - 1) > magnitude(i)) continue;
      if (i + 1 < now.size() && magnitude(i + 1) >= magnitude(i)) continue;
      planes.push_back(y.row(static_cast<Index>(i), now[i] > 0 ? 1 : -1));
    }
    return planes;
  };
  return rows;
}

}  // namespace jounce::optimize_detail
