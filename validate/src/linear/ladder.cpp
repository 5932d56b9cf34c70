// SPDX-License-Identifier: Apache-2.0
// The reference over a segment is r(u) = sum of c_k u^k + sum of a_i sin(o_i u + p_i). Its state
//
//     (1)  w = (1, r_0', r_0'', ..., r_0^(n),  s_1, k_1, s_2, k_2, ...)
//
// with r_0 the polynomial alone, s_i = a_i sin(o_i u + p_i), k_i = a_i cos(o_i u + p_i), obeys
//
//     (2)  w' = N w:   1' = 0,  (r_0^(j))' = r_0^(j+1),  s_i' = o_i k_i,  k_i' = -o_i s_i
//     (3)  (1, r', r'') = G w:   r' = r_0' + sum o_i k_i,  r'' = r_0'' - sum o_i^2 s_i
//
// With x' = A x + B (1, r', r'') the whole system is autonomous (Van Loan 1978, IEEE TAC 23(3)):
//
//     (4)  z = (x, w),  z' = M z,  M = [A, B G; 0, N],  y = [C, D G] z
//     (5)  z(t) = exp(M t) z(0)
//
// N is nilpotent or a rotation, and A may be any matrix. Nothing is inverted or diagonalized:
// repeated eigenvalues and resonance are no special cases. If the norms of A h and of every o_i h
// are below 1/2, the Taylor series of exp(M h) is exact to rounding in 16 terms, and
//
//     (6)  exp(M 2 h) = exp(M h)^2
//
// The integral of the product of two outputs, with p and q rows of [C, D G], doubles in the same way (Van Loan,
// eq. 1.4):
//
//     (7)  integral of (p z) (q z) over t = z(0)' W(t) z(0)
//     (8)  W(2 t) = W(t) + exp(M t)' W(t) exp(M t)
//     (9)  q exp(M u) z = sum of v_k (u / h)^k,  v_k = q (M h)^k z / k!,
//          whose product with another integrates to  u sum of v_i w_j (u / h)^(i+j) / (i + j + 1)
//
// The outputs at m equal steps s = h 2^j are one product with a matrix O_m, which is doubled in the
// same way:
//
//     (10) O_1 = [C, D G],  O_2m = (O_m; O_m exp(M m s)),  (y(t), y(t + s), ..., y(t + (m - 1) s)) = O_m z(t)

#include "validate/src/linear/ladder.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"

#include "validate/src/linear/exponential.hpp"
#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_sum;

constexpr double last_term = 1e-19;          ///< share of the sum
constexpr double reach = exponential_reach;  // norm of M h below
constexpr int terms = exponential_terms;
constexpr std::size_t most_products = 2;

/// (2) and (3), the polynomial's part first.
struct Chain {
  Eigen::MatrixXd n;
  Eigen::MatrixXd g;

  Chain(int degree, const std::vector<double>& frequencies) {
    const Eigen::Index polynomial = degree + 1;
    const auto sines = static_cast<Eigen::Index>(frequencies.size());
    n.setZero(polynomial + 2 * sines, polynomial + 2 * sines);
    g.setZero(LinearSystem::inputs, n.rows());
    for (Eigen::Index k = 1; k + 1 < polynomial; ++k) n(k, k + 1) = 1;
    g(LinearSystem::one, 0) = 1;
    g(LinearSystem::velocity, 1) = 1;
    g(LinearSystem::acceleration, 2) = 1;
    for (Eigen::Index i = 0; i < sines; ++i) {
      const double o = frequencies[static_cast<std::size_t>(i)];
      const Eigen::Index s = polynomial + 2 * i;
      const Eigen::Index k = s + 1;
      n(s, k) = o;
      n(k, s) = -o;
      g(LinearSystem::velocity, k) = o;
      g(LinearSystem::acceleration, s) = -o * o;
    }
  }
};

double frequency(const Segment& f, int sine) {
  return f.sine[static_cast<std::size_t>(sine)].angle / f.length;
}

double dot(const Eigen::MatrixXd& rows, Eigen::Index row, const Eigen::VectorXd& z) {
  double sum = 0;
  for (Eigen::Index k = 0; k < rows.cols(); ++k) sum += rows(row, k) * z(k);
  return sum;
}

/// The number of relevant terms of the series of exp(M t), where the norm of M t is at most `size`.
int terms_of(double size) {
  double term = 1;
  for (int k = 1; k < terms; ++k)
    if ((term *= size / k) < last_term) return k;
  return terms;
}

}  // namespace

Ladder::Ladder(const LinearSystem& system, int degree, std::vector<double> frequencies, double step)
    : states_(system.states()),
      degree_(std::max(2, degree)),
      frequencies_(std::move(frequencies)),
      h_(step),
      step_(step) {
  assert(step > 0);
  const Chain chain(degree_, frequencies_);
  const Eigen::Index size = states_ + chain.n.rows();
  m_.setZero(size, size);
  m_.topLeftCorner(states_, states_) = system.a;
  m_.topRightCorner(states_, chain.n.rows()).noalias() = system.b * chain.g;  // (4)
  m_.bottomRightCorner(chain.n.rows(), chain.n.rows()) = chain.n;
  outputs_.resize(system.outputs(), size);
  outputs_.leftCols(states_) = system.c;
  outputs_.rightCols(chain.n.rows()).noalias() = system.d * chain.g;
  double fastest = rate(system);
  for (const double o : frequencies_) fastest = std::max(fastest, std::abs(o));
  if (fastest * h_ > reach)
    step_rung_ = static_cast<std::size_t>(std::ceil(std::log2(fastest * h_ / reach)));
  h_ = std::ldexp(h_, -static_cast<int>(step_rung_));
  term_.resize(size);
  next_.resize(size);
}

bool Ladder::takes(const Segment& f) const {
  if (f.degree > degree_ || static_cast<std::size_t>(f.sines) != frequencies_.size()) return false;
  for (int i = 0; i < f.sines; ++i)
    if (frequency(f, i) != frequencies_[static_cast<std::size_t>(i)]) return false;
  return true;
}

void Ladder::place(const Segment& f, double u, Eigen::VectorXd& z) const {
  // Derivatives of the polynomial by s = u / length, by Horner's rule repeated.
  const double s = u / f.length;
  std::array<double, Segment::max_degree + 1> c = f.c;
  double factor = 1;
  z(states_) = 1;
  for (int k = 0; k <= degree_; ++k) {
    for (int i = f.degree - 1; i >= k; --i)
      c[static_cast<std::size_t>(i)] += s * c[static_cast<std::size_t>(i) + 1];
    if (k > 0) z(states_ + k) = k <= f.degree ? factor * c[static_cast<std::size_t>(k)] : 0;
    factor *= (k + 1) / f.length;
  }
  for (int i = 0; i < f.sines; ++i) {
    const SineTerm& sine = f.sine[static_cast<std::size_t>(i)];
    const double angle = sine.angle * s + sine.phase;
    const Eigen::Index row = states_ + degree_ + 1 + Eigen::Index{2} * i;
    z(row) = sine.amplitude * std::sin(angle);
    z(row + 1) = sine.amplitude * std::cos(angle);
  }
}

const Eigen::MatrixXd& Ladder::rung(std::size_t j) {
  if (rungs_.empty()) rungs_.push_back(exponential_series(m_ * h_));
  while (rungs_.size() <= j) rungs_.push_back(product(rungs_.back(), rungs_.back()));  // (6)
  return rungs_[j];
}

/// (9), for every z at once: column k is v_k.
Eigen::MatrixXd Ladder::series(Eigen::Index output) const {
  Eigen::MatrixXd v(m_.rows(), terms);
  v.col(0) = outputs_.row(output).transpose();
  for (int k = 1; k < terms; ++k)
    for (Eigen::Index j = 0; j < m_.cols(); ++j) v(j, k) = (h_ / k) * m_.col(j).dot(v.col(k - 1));
  return v;
}

const Eigen::MatrixXd& Ladder::integral(std::size_t j, Eigen::Index a, Eigen::Index b) {
  std::vector<Eigen::MatrixXd>& known = integrals_[{a, b}];
  if (known.empty()) {
    Eigen::MatrixXd weight(terms, terms);
    for (int i = 0; i < terms; ++i)
      for (int k = 0; k < terms; ++k) weight(i, k) = h_ / (i + k + 1);
    known.push_back(product(product(series(a), weight), series(b).transpose()));
  }
  while (known.size() <= j) {
    const Eigen::MatrixXd& w = known.back();
    const Eigen::MatrixXd& p = rung(known.size() - 1);
    known.emplace_back(w + product(p.transpose(), product(w, p)));  // (8)
  }
  return known[j];
}

void Ladder::read(const Eigen::VectorXd& z, double* y) const {
  multiply(outputs_, z.data(), outputs_.rows(), y);
}

const Eigen::MatrixXd& Ladder::ahead() {
  if (ahead_.size() > 0) return ahead_;
  ahead_ = outputs_;
  for (std::size_t j = 0; 1 << j < block; ++j) {  // (10)
    const Eigen::MatrixXd later = product(ahead_, rung(step_rung_ + j));
    Eigen::MatrixXd both(2 * later.rows(), later.cols());
    both << ahead_, later;
    ahead_.swap(both);
  }
  return ahead_;
}

void Ladder::read_ahead(const Eigen::VectorXd& z, int count, double* y) {
  assert(count >= 1 && count <= block);
  multiply(ahead(), z.data(), count * outputs_.rows(), y);
}

/// M z, with only those entries of the lower part that (2) has.
void Ladder::derivative(const Eigen::VectorXd& z, Eigen::VectorXd& by_time) const {
  multiply(m_, z.data(), states_, by_time.data());
  const Eigen::Index sines = states_ + degree_ + 1;
  by_time(states_) = 0;
  for (Eigen::Index k = states_ + 1; k + 1 < sines; ++k) by_time(k) = z(k + 1);
  by_time(sines - 1) = 0;
  for (std::size_t i = 0; i < frequencies_.size(); ++i) {
    const Eigen::Index s = sines + 2 * static_cast<Eigen::Index>(i);
    by_time(s) = frequencies_[i] * z(s + 1);
    by_time(s + 1) = -frequencies_[i] * z(s);
  }
}

void Ladder::rest(Eigen::VectorXd& z, double time, std::span<ProductIntegral> products) {
  assert(products.size() <= most_products);
  const int count = terms_of(reach * std::abs(time) / h_);
  std::array<std::array<std::array<double, terms>, 2>, most_products> v;  // (9); filled up to count
  term_ = z;
  for (int k = 0; k < count; ++k) {
    if (k > 0) {
      derivative(term_, next_);
      term_ = (time / k) * next_;
      z += term_;
    }
    for (std::size_t i = 0; i < products.size(); ++i) {
      v[i][0][static_cast<std::size_t>(k)] = dot(outputs_, products[i].a, term_);
      v[i][1][static_cast<std::size_t>(k)] = dot(outputs_, products[i].b, term_);
    }
  }
  const auto used = static_cast<std::size_t>(count);
  for (std::size_t p = 0; p < products.size(); ++p) {
    double sum = 0;
    for (std::size_t i = 0; i < used; ++i)
      for (std::size_t k = 0; k < used; ++k)
        sum += v[p][0][i] * v[p][1][k] / static_cast<double>(i + k + 1);
    products[p].sum += time * sum;
  }
}

Segment Ladder::polynomial(const Eigen::VectorXd& z, Eigen::Index row, double time) {
  Segment f;
  f.length = time;
  f.degree = Segment::max_degree;
  term_ = z;
  f.c[0] = dot(outputs_, row, term_);
  for (int k = 1; k <= f.degree; ++k) {
    derivative(term_, next_);
    term_ = (time / k) * next_;
    f.c[static_cast<std::size_t>(k)] = dot(outputs_, row, term_);
  }
  return f;
}

Eigen::MatrixXd Ladder::greatest() const {
  return exponential_series(m_.cwiseAbs() * h_);
}

double Ladder::advance(Eigen::VectorXd& z, double time, std::span<ProductIntegral> products) {
  const double whole = std::nearbyint(time / h_);
  const double left = time - whole * h_;
  const bool exactly = std::abs(left) <= rounded_sum * time;
  auto digits = static_cast<unsigned long long>(whole);
  for (std::size_t j = 0; digits != 0; ++j, digits >>= 1U) {
    if ((digits & 1U) == 0) continue;
    for (ProductIntegral& p : products) p.sum += form(integral(j, p.a, p.b), z);  // (7)
    const bool last = exactly && digits == 1;  // the reference need not be advanced
    multiply(rung(j), z.data(), last ? states_ : z.size(), term_.data());
    if (last)
      z.head(states_) = term_.head(states_);
    else
      z.swap(term_);
  }
  if (exactly) return whole * h_;
  rest(z, left, products);
  return time;
}

}  // namespace jounce::validate_detail
