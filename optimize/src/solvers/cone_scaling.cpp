// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/cone_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Calls visit(first, size, number of the cone).
template <class Visit>
void each_cone(const ConeShape& shape, const Visit& visit) {
  Index first = shape.linear;
  for (std::size_t k = 0; k < shape.round.size(); first += shape.round[k++])
    visit(first, shape.round[k], k);
}

/// |b| <= a: a^2 - |b|^2, without the cancellation of squares.
template <class V>
double determinant(const V& v) {
  const double b = v.tail(v.size() - 1).norm();
  return (v[0] - b) * (v[0] + b);
}

template <class V>
double length(const V& v) {
  return std::sqrt(std::max(determinant(v), std::numeric_limits<double>::min()));
}

/// The longest step along d within one cone, at most `most`: |b + t d_b|^2 = (a + t d_a)^2.
template <class V, class D>
double longest_in_cone(const V& v, const D& d, double most) {
  const Index n = v.size() - 1;
  const double a = determinant(d);
  const double b = v[0] * d[0] - v.tail(n).dot(d.tail(n));
  const double c = std::max(determinant(v), 0.0);
  double step = d[0] < 0 ? std::min(most, -v[0] / d[0]) : most;
  const double under = b * b - a * c;
  if (under < 0) return step;
  // a t^2 + 2 b t + c = 0, its least positive root
  const double q = -(b + std::copysign(std::sqrt(under), b));
  for (const double t : {a != 0 ? q / a : -1.0, q != 0 ? c / q : -1.0})
    if (t > 0) step = std::min(step, t);
  return step;
}

}  // namespace

VectorXd unit_of(const ConeShape& shape) {
  Index size = shape.linear;
  for (const Index n : shape.round) size += n;
  VectorXd e = VectorXd::Zero(size);
  e.head(shape.linear).setOnes();
  each_cone(shape, [&](Index first, Index, std::size_t) { e[first] = 1; });
  return e;
}

VectorXd product(const ConeShape& shape, const VectorXd& a, const VectorXd& b) {
  VectorXd p = a.cwiseProduct(b);
  each_cone(shape, [&](Index first, Index size, std::size_t) {
    const Index n = size - 1;
    p[first] = a.segment(first, size).dot(b.segment(first, size));
    p.segment(first + 1, n) =
        a[first] * b.segment(first + 1, n) + b[first] * a.segment(first + 1, n);
  });
  return p;
}

VectorXd quotient(const ConeShape& shape, const VectorXd& p, const VectorXd& a) {
  VectorXd q = p.cwiseQuotient(a);
  each_cone(shape, [&](Index first, Index size, std::size_t) {
    const Index n = size - 1;
    const auto rest = a.segment(first + 1, n);
    const double det =
        std::max(determinant(a.segment(first, size)), std::numeric_limits<double>::min());
    q[first] = (a[first] * p[first] - rest.dot(p.segment(first + 1, n))) / det;
    q.segment(first + 1, n) = (p.segment(first + 1, n) - q[first] * rest) / a[first];
  });
  return q;
}

VectorXd inverse(const ConeShape& shape, const VectorXd& a) {
  return quotient(shape, unit_of(shape), a);
}

double longest(const ConeShape& shape, const VectorXd& v, const VectorXd& dv) {
  double step = 1;
  for (Index k = 0; k < shape.linear; ++k)
    if (dv[k] < 0) step = std::min(step, -v[k] / dv[k]);
  each_cone(shape, [&](Index first, Index size, std::size_t) {
    step = longest_in_cone(v.segment(first, size), dv.segment(first, size), step);
  });
  return step;
}

VectorXd inside(const ConeShape& shape, VectorXd v, double least) {
  v.head(shape.linear) = v.head(shape.linear).cwiseMax(least);
  each_cone(shape, [&](Index first, Index size, std::size_t) {
    const double b = v.segment(first + 1, size - 1).norm();
    v[first] = std::max(v[first], b + 1);
  });
  return v;
}

ConeScaling::ConeScaling(const ConeShape& shape, const VectorXd& s, const VectorXd& y)
    : shape_(shape), root_(s.head(shape.linear).cwiseQuotient(y.head(shape.linear)).cwiseSqrt()) {
  each_cone(shape, [&](Index first, Index size, std::size_t) {
    const double of_s = length(s.segment(first, size));
    const double of_y = length(y.segment(first, size));
    VectorXd a = s.segment(first, size) / of_s;
    VectorXd b = y.segment(first, size) / of_y;
    const double c = std::sqrt((1 + a.dot(b)) / 2);
    b.tail(size - 1) *= -1;
    VectorXd w = (a + b) / (2 * c);
    w[0] = std::sqrt(1 + w.tail(size - 1).squaredNorm());  // w' J w = 1 in spite of rounding
    w_.push_back(std::move(w));
    size_.push_back(std::sqrt(of_s / of_y));
  });
}

/// W (a, b) = e (w0 a + w1 . b, b + w1 (a + w1 . b / (1 + w0))). W^-1 has -w1 and 1/e instead.
VectorXd ConeScaling::times(const VectorXd& v) const {
  VectorXd all = v;
  all.head(shape_.linear) = root_.cwiseProduct(v.head(shape_.linear));
  each_cone(shape_, [&](Index first, Index size, std::size_t k) {
    const auto w = w_[k].tail(size - 1);
    const double a = v[first];
    const double along = w.dot(v.segment(first + 1, size - 1));
    all[first] = size_[k] * (w_[k][0] * a + along);
    all.segment(first + 1, size - 1) =
        size_[k] * (v.segment(first + 1, size - 1) + (a + along / (1 + w_[k][0])) * w);
  });
  return all;
}

VectorXd ConeScaling::inverse(const VectorXd& v) const {
  VectorXd all = v;
  all.head(shape_.linear) = v.head(shape_.linear).cwiseQuotient(root_);
  each_cone(shape_, [&](Index first, Index size, std::size_t k) {
    const auto w = w_[k].tail(size - 1);
    const double a = v[first];
    const double along = w.dot(v.segment(first + 1, size - 1));
    all[first] = (w_[k][0] * a - along) / size_[k];
    all.segment(first + 1, size - 1) =
        (v.segment(first + 1, size - 1) + (along / (1 + w_[k][0]) - a) * w) / size_[k];
  });
  return all;
}

VectorXd ConeScaling::inverse_squared(const VectorXd& v) const {
  return inverse(inverse(v));
}

VectorXd ConeScaling::diagonal() const {
  VectorXd d = unit_of(shape_);
  d.head(shape_.linear) = root_.cwiseAbs2().cwiseInverse();
  each_cone(shape_, [&](Index first, Index size, std::size_t k) {
    d[first] = 0;
    d.segment(first + 1, size - 1).setConstant(1 / (size_[k] * size_[k]));
  });
  return d;
}

std::vector<VectorXd> ConeScaling::rank_ones() const {
  std::vector<VectorXd> all;
  each_cone(shape_, [&](Index first, Index size, std::size_t k) {
    VectorXd r = VectorXd::Zero(unit_of(shape_).size());
    r.segment(first + 1, size - 1) = std::sqrt(2.0) / size_[k] * w_[k].tail(size - 1);
    all.push_back(std::move(r));
  });
  return all;
}

}  // namespace jounce::optimize_detail
