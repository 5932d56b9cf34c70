#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/QR>
#include <Eigen/SparseCholesky>

#include "jounce/optimize/detail/figure_rows.hpp"

// A response y is known by what it gives for shapes. It is affine in the shape, so with z_k the shapes of
// a basis and c_k their coordinates
//
//   (1)  y(z) = y(0) + sum_k c_k (y(z_k) - y(0)) = y(0) + R z
//
// One coordinate at a time is no spline, but pieces apart: what that costs, jumps of the position, cancels
// in any spline. Rows a of R are therefore taken as they are within the joints E z = 0:
//
//   (2)  a <- a - E' (E E')^-1 E a
//
// (A basis of splines instead, what a jump of the top derivative becomes to the end, loses all digits.)
//
// Lifted. Many instants may look at a few numbers: a vibration after the end is the state there, four or
// five. A narrow ceiling over them all has next to no inside, and each of its planes all coordinates in
// it. With R = Q T, Q of r orthonormal columns (pivoted Householder: rows of T fall), and unknowns v in
// the unit u of what is asked,
//
//   (3)  u v = T z + Q' y(0),    y = u Q v + (1 - Q Q') y(0)
//
// a ceiling is of size one in v however low it is, its planes have r numbers, and mean squares are
//
//   (4)  |y|^2 = u^2 |v|^2 + |(1 - Q Q') y(0)|^2
//
// What T has below `noise` of its largest row is rounding of the response.

namespace jounce::optimizer {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double noise = 1e-13;
constexpr double accuracy = 1e-10;   ///< of y, in what is natural: what joints leave
constexpr double nothing = 1e-9;     ///< of the same
constexpr double steepest = 1e7;     ///< of (3), in v
constexpr Index to_begin_with = 32;  ///< instants
constexpr std::array signs{1.0, -1.0};

using Respond = std::function<std::vector<double>(const std::vector<Segment>&)>;

Respond responding(const std::function<std::vector<double>(const Trajectory&)>& of, double begin) {
  return [of, begin](const std::vector<Segment>& shape) { return of(Trajectory(shape, begin)); };
}

double largest(const std::vector<double>& y) {
  double peak = 0;
  for (const double v : y) {
    if (std::isnan(v)) return v;  // std::max would lose it
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

double rms(const std::vector<double>& y) {
  double sum = 0;
  for (const double v : y) sum += v * v;
  return y.empty() ? 0 : std::sqrt(sum / static_cast<double>(y.size()));
}

/// y = constant + factor x, where x begins at unknown `first`.
struct Affine {
  VectorXd constant;
  MatrixXd factor;  ///< a row for each number of y
  std::size_t first = 0;
  double natural = 1;

  [[nodiscard]] Form row(Index i, double sign) const {
    Form form{sign * constant[i], {}};
    for (Index k = 0; k < factor.cols(); ++k)
      if (factor(i, k) != 0)
        form.terms.push_back({first + static_cast<std::size_t>(k), sign * factor(i, k)});
    return form;
  }
};

/// (2), of every row.
MatrixXd without_joints(const MatrixXd& rows, const SplineSpace& space) {
  const std::vector<Form> joints = space.joints();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const Form::Term& t : joints[i].terms)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(t.index), t.factor);
  Eigen::SparseMatrix<double> e(static_cast<Index>(joints.size()), rows.cols());
  e.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> square = e * e.transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(square);
  MatrixXd left = rows.transpose();
  for (int round = 0; round < 2; ++round) left -= e.transpose() * solver.solve(e * left);
  return left.transpose();
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

/// (3): y in unknowns of its own, which `own` ties to the coordinates.
Affine lifted(const Affine& y, std::size_t first, double unit, std::vector<Form>& own) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(y.factor);
  qr.setThreshold(noise);
  const Index rank = qr.rank();
  const MatrixXd q = qr.householderQ() * MatrixXd::Identity(y.factor.rows(), rank);
  const MatrixXd t = q.transpose() * y.factor;
  const VectorXd c = q.transpose() * y.constant;
  for (Index k = 0; k < rank; ++k) {
    const double size = std::max(t.row(k).lpNorm<Eigen::Infinity>() / steepest, unit);
    Form form{c[k] / size, {{first + static_cast<std::size_t>(k), -unit / size}}};
    for (Index j = 0; j < t.cols(); ++j)
      form.terms.push_back({static_cast<std::size_t>(j), t(k, j) / size});
    own.push_back(std::move(form));
  }
  return {y.constant - q * c, unit * q, first, y.natural};
}

/// A figure of 0 counts in what is natural.
double unit_of(const Lift& lift, const FigureRows& rows) {
  const double unit = lift.at_most ? *lift.at_most : std::abs(rows.value(lift.given));
  return unit > nothing * rows.natural ? unit : rows.natural;
}

Affine rows_in(const Respond& respond, const SplineSpace& space, const Lift* lift,
               FigureRows& rows) {
  Affine y = affine(respond, space);
  rows.natural = y.natural;
  rows.nothing = nothing;
  rows.accuracy = accuracy;
  return lift ? lifted(y, lift->first, unit_of(*lift, rows), rows.own) : y;
}

}  // namespace

FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space, const Lift* lift) {
  const Respond respond = responding(figure.of, space.knots().front());
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return rms(respond(shape)); }};
  const Affine y = rows_in(respond, space, lift, rows);
  const double share = 1 / std::sqrt(static_cast<double>(y.constant.size()));
  if (!lift) {
    for (Index i = 0; i < y.constant.size(); ++i)
      rows.squares.push_back(scaled(y.row(i, 1), share));
    return rows;
  }
  rows.squares.push_back({share * y.constant.norm(), {}});  // (4)
  for (std::size_t k = 0; k < rows.own.size(); ++k)
    rows.squares.push_back(
        {0, {{lift->first + k, share * y.factor.col(static_cast<Index>(k)).norm()}}});
  return rows;
}

FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space, const Lift* lift) {
  const Respond respond = responding(figure.of, space.knots().front());
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return largest(respond(shape)); }};
  const Affine y = rows_in(respond, space, lift, rows);
  const Index every = std::max(y.constant.size() / to_begin_with, Index{1});
  for (Index i = 0; i < y.constant.size(); i += every)
    for (const double sign : signs) rows.start.push_back(y.row(i, sign));
  rows.cuts = [respond, y](const std::vector<Segment>& shape, double level) {
    const std::vector<double> now = respond(shape);
    std::vector<Form> planes;
    const auto magnitude = [&](std::size_t i) { return std::abs(now[i]); };
    for (std::size_t i = 0; i < now.size(); ++i) {  // local peaks alone: neighbours are alike
      if (!(magnitude(i) > level)) continue;
      if (i > 0 && magnitude(i - 1) > magnitude(i)) continue;
      if (i + 1 < now.size() && magnitude(i + 1) >= magnitude(i)) continue;
      planes.push_back(y.row(static_cast<Index>(i), now[i] > 0 ? 1 : -1));
    }
    return planes;
  };
  return rows;
}

}  // namespace jounce::optimizer
