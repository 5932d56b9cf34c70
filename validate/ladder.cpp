// The reference over a segment is r(u) = sum of c_k u^k + sum of a_i sin(o_i u + p_i). Its state
//
//     (1)  w = (1, r_0', r_0'', ..., r_0^(n),  s_1, k_1, s_2, k_2, ...)
//
// with r_0 the polynomial alone, s_i = a_i sin(o_i u + p_i), k_i = a_i cos(o_i u + p_i), obeys
//
//     (2)  w' = N w:   1' = 0,  (r_0^(j))' = r_0^(j+1),  s_i' = o_i k_i,  k_i' = -o_i s_i
//     (3)  (1, r', r'') = G w:   r' = r_0' + sum o_i k_i,  r'' = r_0'' - sum o_i^2 s_i
//
// so that with x' = A x + B (1, r', r'') the whole is autonomous (Van Loan 1978, IEEE TAC 23(3)):
//
//     (4)  z = (x, w),  z' = M z,  M = [A, B G; 0, N],  y = [C, D G] z
//     (5)  z(t) = exp(M t) z(0)
//
// N is nilpotent or turns, A may be anything: nothing is inverted or diagonalised, hence repeated
// eigenvalues and resonance need no case of their own. With h such that A and every o_i times h
// stay below 1/2 in norm, the Taylor series of exp(M h) is exact to rounding in 16 terms, and
//
//     (6)  exp(M 2 h) = exp(M h)^2
//
// The integral of an output's square, q = a row of [C, D G], goes the same way (Van Loan, eq. 1.4):
//
//     (7)  integral of (q z)^2 over t = z(0)' W(t) z(0)
//     (8)  W(2 t) = W(t) + exp(M t)' W(t) exp(M t)
//     (9)  q exp(M u) z = sum of v_k (u / h)^k,  v_k = q (M h)^k z / k!,
//          whose square integrates to  u sum of v_i v_j (u / h)^(i+j) / (i + j + 1)

#include "jounce/validate/detail/ladder.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "jounce/validate/detail/exponential.hpp"

namespace jounce::detail {
namespace {

constexpr double reach = exponential_reach;  // norm of M h below
constexpr int terms = exponential_terms;

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

/// The first `rows` of y = p z. Plain loops: at these sizes a
/// general product costs more in preparation than in work.
void multiply(const Eigen::MatrixXd& p, const Eigen::VectorXd& z, Eigen::Index rows, double* y) {
  std::fill_n(y, rows, 0.0);
  for (Eigen::Index k = 0; k < p.cols(); ++k) {
    const double* column = p.data() + k * p.rows();
    const double factor = z[k];
    for (Eigen::Index i = 0; i < rows; ++i) y[i] += column[i] * factor;
  }
}

double frequency(const Segment& f, int sine) {
  return f.sine[static_cast<std::size_t>(sine)].angle / f.length;
}

/// How many terms of the series of exp(M t) count, where the norm of M t is at most `size`.
int terms_of(double size) {
  double term = 1;
  for (int k = 1; k < terms; ++k)
    if ((term *= size / k) < 1e-19) return k;
  return terms;
}

}  // namespace

Ladder::Ladder(const LinearSystem& system, int degree, std::vector<double> frequencies, double step)
    : states_(system.states()),
      degree_(std::max(2, degree)),
      frequencies_(std::move(frequencies)),
      h_(step) {
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
    h_ = std::ldexp(h_, -static_cast<int>(std::ceil(std::log2(fastest * h_ / reach))));
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
    z(states_ + degree_ + 1 + 2 * i) = sine.amplitude * std::sin(angle);
    z(states_ + degree_ + 2 + 2 * i) = sine.amplitude * std::cos(angle);
  }
}

const Eigen::MatrixXd& Ladder::rung(std::size_t j) {
  if (rungs_.empty()) rungs_.push_back(exponential_series(m_ * h_));
  while (rungs_.size() <= j) rungs_.push_back(rungs_.back() * rungs_.back());  // (6)
  return rungs_[j];
}

const Eigen::MatrixXd& Ladder::square(std::size_t j, Eigen::Index output) {
  if (squares_.empty()) {
    Eigen::MatrixXd v(m_.rows(), terms);  // (9), for every z at once
    v.col(0) = outputs_.row(output).transpose();
    for (int k = 1; k < terms; ++k) v.col(k).noalias() = m_.transpose() * v.col(k - 1) * (h_ / k);
    Eigen::MatrixXd weight(terms, terms);
    for (int i = 0; i < terms; ++i)
      for (int k = 0; k < terms; ++k) weight(i, k) = h_ / (i + k + 1);
    squares_.emplace_back(v * weight * v.transpose());
  }
  while (squares_.size() <= j) {
    const Eigen::MatrixXd& w = squares_.back();
    const Eigen::MatrixXd& p = rung(squares_.size() - 1);
    squares_.emplace_back(w + p.transpose() * w * p);  // (8)
  }
  return squares_[j];
}

void Ladder::read(const Eigen::VectorXd& z, double* y) const {
  multiply(outputs_, z, outputs_.rows(), y);
}

void Ladder::rest(Eigen::VectorXd& z, double time) const {
  const int count = terms_of(reach * std::abs(time) / h_);
  term_ = z;
  for (int k = 1; k < count; ++k) {
    multiply(m_, term_, m_.rows(), next_.data());
    term_ = (time / k) * next_;
    z += term_;
  }
}

double Ladder::rest_square(const Eigen::VectorXd& z, double time, Eigen::Index output) const {
  std::array<double, terms> v{};  // (9)
  Eigen::VectorXd term = z;
  for (int k = 0; k < terms; ++k) {
    v[static_cast<std::size_t>(k)] = outputs_.row(output).dot(term);
    term = (m_ * term * (time / (k + 1))).eval();
  }
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t k = 0; k < v.size(); ++k) sum += v[i] * v[k] / static_cast<double>(i + k + 1);
  return time * sum;
}

double Ladder::advance(Eigen::VectorXd& z, double time) {
  const double whole = std::nearbyint(time / h_);
  const double left = time - whole * h_;
  const bool exactly = std::abs(left) <= 1e-12 * time;
  auto digits = static_cast<unsigned long long>(whole);
  for (std::size_t j = 0; digits != 0; ++j, digits >>= 1U) {
    if ((digits & 1U) == 0) continue;
    const bool last = exactly && digits == 1;  // the reference need not follow
    multiply(rung(j), z, last ? states_ : z.size(), term_.data());
    if (last)
      z.head(states_) = term_.head(states_);
    else
      z.swap(term_);
  }
  if (exactly) return whole * h_;
  rest(z, left);
  return time;
}

double Ladder::advance(Eigen::VectorXd& z, double time, Eigen::Index output, double& sum) {
  const double whole = std::nearbyint(time / h_);
  const double left = time - whole * h_;
  auto digits = static_cast<unsigned long long>(whole);
  for (std::size_t j = 0; digits != 0; ++j, digits >>= 1U) {
    if ((digits & 1U) == 0) continue;
    sum += z.dot(square(j, output) * z);  // (7)
    z = (rung(j) * z).eval();
  }
  sum += rest_square(z, left, output);
  rest(z, left);
  return time;
}

}  // namespace jounce::detail
