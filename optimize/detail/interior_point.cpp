#include "jounce/optimize/detail/interior_point.hpp"

#include <algorithm>

#include <Eigen/Sparse>

// With Q x + q the gradient of the objective, G x + s = h the constraints and y their multipliers,
//
//   (1)  Q x + q + G' y = 0,   G x + s - h = 0,   s_k y_k = mu,   s, y > 0
//
// is solved by Newton's method while mu falls to zero. Without ds and dy a step is
//
//   (2)  (Q + G' D G) dx = -r_dual - G' ((y r_primal - r_s) / s),   D = diag(y / s),
//        ds = -r_primal - G dx,   dy = (-r_s - y ds) / s
//
// Twice with one factorisation: first with mu = 0, which tells how far mu may be lowered and the
// second-order term ds dy, then with both put in (Mehrotra 1992).

namespace jounce::optimizer {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

constexpr int max_iterations = 100;
constexpr double precision = 1e-11;

Matrix rows_of(const std::vector<Form>& forms, std::size_t unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < forms.size(); ++k)
    for (const Form::Term& t : forms[k].terms)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(t.index), t.factor);
  Matrix rows(static_cast<Eigen::Index>(forms.size()), static_cast<Eigen::Index>(unknowns));
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

Vector constants_of(const std::vector<Form>& forms) {
  Vector c(static_cast<Eigen::Index>(forms.size()));
  for (std::size_t k = 0; k < forms.size(); ++k)
    c[static_cast<Eigen::Index>(k)] = forms[k].constant;
  return c;
}

/// The longest step, at most 1, that keeps v + step * dv >= 0.
double longest(const Vector& v, const Vector& dv) {
  double step = 1;
  for (Eigen::Index k = 0; k < v.size(); ++k)
    if (dv[k] < 0) step = std::min(step, -v[k] / dv[k]);
  return step;
}

struct Step {
  Vector x, s, y;
};

class Newton {
 public:
  Newton(const ConvexProgram& p, const std::vector<double>& start)
      : g_(rows_of(p.constraints, p.slope.size())),
        h_(-constants_of(p.constraints)),
        q_(Eigen::Map<const Vector>(p.slope.data(), static_cast<Eigen::Index>(p.slope.size()))),
        x_(Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()))) {
    const Matrix f = rows_of(p.squares, p.slope.size());
    quadratic_ = 2 * Matrix(f.transpose() * f);
    q_ += 2 * (f.transpose() * constants_of(p.squares));
    s_ = (h_ - g_ * x_).cwiseMax(0.1);
    y_ = s_.cwiseInverse() / static_cast<double>(s_.size());
  }

  ConvexSolution run() {
    double best = worst();
    Step kept{x_, s_, y_};
    int rounds = 0;
    for (int since = 0; rounds < max_iterations && best > precision && since < 5; ++rounds) {
      if (!advance()) break;
      ++since;
      if (worst() < best) {
        best = worst();
        kept = {x_, s_, y_};
        since = 0;
      }
    }
    return {{kept.x.begin(), kept.x.end()}, {kept.y.begin(), kept.y.end()}, rounds};
  }

 private:
  [[nodiscard]] double mu() const { return s_.dot(y_) / static_cast<double>(s_.size()); }
  [[nodiscard]] Vector dual() const { return quadratic_ * x_ + q_ + g_.transpose() * y_; }
  [[nodiscard]] Vector primal() const { return g_ * x_ + s_ - h_; }
  [[nodiscard]] double worst() const {
    return std::max(
        {s_.dot(y_), dual().lpNorm<Eigen::Infinity>(), primal().lpNorm<Eigen::Infinity>()});
  }

  [[nodiscard]] Step step(const Vector& r_s) const {  // (2)
    const Vector r = ((y_.cwiseProduct(primal()) - r_s).cwiseQuotient(s_));
    Step d;
    d.x = factor_.solve(-dual() - g_.transpose() * r);
    d.s = -primal() - g_ * d.x;
    d.y = (-r_s - y_.cwiseProduct(d.s)).cwiseQuotient(s_);
    return d;
  }

  bool advance() {
    const Matrix m = quadratic_ + Matrix(g_.transpose() * y_.cwiseQuotient(s_).asDiagonal() * g_);
    factor_.compute(m);
    if (factor_.info() != Eigen::Success) return false;
    const Vector complementary = s_.cwiseProduct(y_);
    const Step first = step(complementary);
    const double reach = std::min(longest(s_, first.s), longest(y_, first.y));
    const double left = (s_ + reach * first.s).dot(y_ + reach * first.y) / complementary.sum();
    const Vector target = Vector::Constant(s_.size(), left * left * left * mu());
    const Step d = step(complementary + first.s.cwiseProduct(first.y) - target);
    const double along = 0.99 * std::min(longest(s_, d.s), longest(y_, d.y));
    if (!d.x.allFinite()) return false;
    x_ += along * d.x;
    s_ += along * d.s;
    y_ += along * d.y;
    return true;
  }

  Matrix g_, quadratic_;
  Vector h_, q_, x_, s_, y_;
  Eigen::SimplicialLDLT<Matrix> factor_;
};

}  // namespace

double Form::at(const std::vector<double>& x) const {
  double sum = constant;
  for (const Term& t : terms) sum += t.factor * x[t.index];
  return sum;
}

Form scaled(Form f, double factor) {
  f.constant *= factor;
  for (Form::Term& t : f.terms) t.factor *= factor;
  return f;
}

ConvexSolution solve(const ConvexProgram& program, const std::vector<double>& start) {
  return Newton(program, start).run();
}

}  // namespace jounce::optimizer
