// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/kkt.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "jounce/profiles/detail/elimination.hpp"

#include "optimize/src/solvers/forms.hpp"

// The matrix K (kkt.hpp) is indefinite if there are equalities. A small number on its diagonal,
// plus for x and minus for the multipliers, makes it quasidefinite. L D L' then exists in any order
// (Vanderbei 1995), and the order can be chosen for sparsity alone. Iterative refinement removes
// the effect of the small number.

namespace jounce::optimize_detail {
namespace {

constexpr int refinements = 8;

Kkt::Matrix rows_of(const std::vector<Form>& forms, std::size_t unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < forms.size(); ++k)
    for (const Form::Term& t : forms[k].terms)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(t.index), t.factor);
  Kkt::Matrix rows(static_cast<Eigen::Index>(forms.size()), static_cast<Eigen::Index>(unknowns));
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

/// Calls visit(i, j, product) for the lower half of row' row.
template <class Rows, class Visit>
void each_product(const Rows& rows, Eigen::Index row, const Visit& visit) {
  for (typename Rows::InnerIterator i(rows, row); i; ++i)
    for (typename Rows::InnerIterator j(rows, row); j && j.col() <= i.col(); ++j)
      visit(i.col(), j.col(), i.value() * j.value());
}

/// All rows of G x + s = h. A round constraint has the rows (0, forms) and h = (most, ...).
std::vector<Form> all_constraints(const ConvexProgram& p) {
  std::vector<Form> all = p.constraints;
  for (const RoundConstraint& round : p.round) {
    all.push_back({-round.most, {}});
    all.insert(all.end(), round.forms.begin(), round.forms.end());
  }
  return all;
}

ConeShape cones_of(const ConvexProgram& p) {
  ConeShape shape{static_cast<Eigen::Index>(p.constraints.size()), {}};
  for (const RoundConstraint& round : p.round)
    shape.round.push_back(static_cast<Eigen::Index>(round.forms.size()) + 1);
  return shape;
}

}  // namespace

Kkt::Kkt(const ConvexProgram& p, double regular)
    : cones_(cones_of(p)),
      g_(rows_of(all_constraints(p), p.slope.size())),
      a_(rows_of(p.equalities, p.slope.size())),
      f_(rows_of(p.squares, p.slope.size())),
      rows_(g_),
      q_(Eigen::Map<const Vector>(p.slope.data(), static_cast<Eigen::Index>(p.slope.size()))),
      h_(-constants_of(all_constraints(p))),
      b_(-constants_of(p.equalities)),
      factor_(a_.rows() > 0 && regular == 0 ? SparseFactor::Method::pivoting
                                            : SparseFactor::Method::cholesky) {
  q_ += 2 * (f_.transpose() * constants_of(p.squares));
  find_pattern(a_.rows() > 0 ? regular : 0);
}

void Kkt::find_pattern(double added) {
  const Eigen::Index n = g_.cols();
  const Eigen::Index all = n + a_.rows();
  regular_ = Vector::Constant(all, -added);
  regular_.head(n).setConstant(added);

  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < all; ++i) entries.emplace_back(i, i, regular_[i]);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Matrix::InnerIterator i(a_, j); i; ++i) entries.emplace_back(n + i.row(), j, i.value());
  const Eigen::SparseMatrix<double, Eigen::RowMajor> f(f_);
  for (Eigen::Index k = 0; k < f.rows(); ++k)
    each_product(
        f, k, [&](Eigen::Index i, Eigen::Index j, double v) { entries.emplace_back(i, j, 2 * v); });
  for (Eigen::Index k = 0; k < rows_.rows(); ++k)
    each_product(rows_, k,
                 [&](Eigen::Index i, Eigen::Index j, double) { entries.emplace_back(i, j, 0); });
  k_.resize(all, all);
  k_.setFromTriplets(entries.begin(), entries.end());
  fixed_.assign(k_.valuePtr(), k_.valuePtr() + k_.nonZeros());

  const auto* outer = k_.outerIndexPtr();
  const auto* inner = k_.innerIndexPtr();
  for (Eigen::Index k = 0; k < rows_.rows(); ++k)
    each_product(rows_, k, [&](Eigen::Index i, Eigen::Index j, double) {
      place_.push_back(std::lower_bound(inner + outer[j], inner + outer[j + 1], i) - inner);
    });
  factor_.find_pattern(k_);
}

bool Kkt::factorize(const ConeScaling& w) {
  const Vector d = w.diagonal();
  u_.clear();
  for (const Vector& r : w.rank_ones()) {
    Vector& u = u_.emplace_back(Vector::Zero(k_.rows()));
    u.head(g_.cols()) = g_.transpose() * r;
  }
  std::copy(fixed_.begin(), fixed_.end(), k_.valuePtr());
  std::size_t next = 0;
  for (Eigen::Index k = 0; k < rows_.rows(); ++k)
    each_product(rows_, k, [&](Eigen::Index, Eigen::Index, double v) { add(next, v * d[k]); });
  if (!factor_.factorize(k_)) return false;
  factorize_rank_ones();
  return true;
}

void Kkt::factorize_rank_ones() {
  const auto n = static_cast<Eigen::Index>(u_.size());
  solved_u_.resize(k_.rows(), n);
  for (Eigen::Index i = 0; i < n; ++i)
    solved_u_.col(i) = factor_.solve(u_[static_cast<std::size_t>(i)]);
  small_ = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    small_.row(i) += u_[static_cast<std::size_t>(i)].transpose() * solved_u_;
}

Kkt::Vector Kkt::times(const Vector& v) const {
  Vector all = k_.selfadjointView<Eigen::Lower>() * v - regular_.cwiseProduct(v);
  for (const Vector& u : u_) all += u.dot(v) * u;
  return all;
}

Kkt::Vector Kkt::back(const Vector& r) const {
  Vector v = factor_.solve(r);
  if (u_.empty()) return v;
  Vector along(static_cast<Eigen::Index>(u_.size()));
  for (Eigen::Index i = 0; i < along.size(); ++i) along[i] = u_[static_cast<std::size_t>(i)].dot(v);
  return v - solved_u_ * profiles_detail::eliminated(small_, std::move(along));
}

Kkt::Vector Kkt::solve(const Vector& r) const {
  Vector v = back(r);
  if (a_.rows() == 0 && u_.empty()) return v;
  Vector left = r - times(v);
  double size = left.lpNorm<Eigen::Infinity>();
  for (int round = 0; round < refinements && size > 0; ++round) {
    const Vector better = v + back(left);
    const Vector rest = r - times(better);
    if (!(rest.lpNorm<Eigen::Infinity>() < size)) break;
    v = better;
    left = rest;
    size = rest.lpNorm<Eigen::Infinity>();
  }
  return v;
}

Kkt::Vector Kkt::curved(const Vector& x) const {
  return 2 * (f_.transpose() * (f_ * x));
}

}  // namespace jounce::optimize_detail
