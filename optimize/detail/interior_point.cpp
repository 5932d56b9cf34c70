#include "jounce/optimize/detail/interior_point.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "jounce/optimize/detail/kkt.hpp"

// With Q x + q the gradient of the objective, G x + s = h the constraints with multipliers y, and
// A x = b the equalities with multipliers v,
//
//   (1)  Q x + q + G' y + A' v = 0,   G x + s - h = 0,   A x - b = 0,   s_k y_k = mu,   s, y > 0
//
// is solved by Newton's method while mu falls to zero. Without ds and dy a step is
//
//   (2)  (Q + G' D G) dx + A' dv = -r_dual - G' ((y r_primal - r_s) / s),   D = diag(y / s),
//        A dx = -r_equal,   ds = -r_primal - G dx,   dy = (-r_s - y ds) / s
//
// Twice with one factorisation: first with mu = 0, which tells how far mu may be lowered and the
// second-order term ds dy, then with both put in (Mehrotra 1992).

namespace jounce::optimizer {
namespace {

using Vector = Kkt::Vector;

constexpr int max_iterations = 100;
constexpr int patience = 8;    ///< iterations without progress
constexpr double good = 1e-8;  ///< a residual that is not worth another attempt
constexpr std::array regular{1e-8, 0.0};

/// The longest step, at most 1, that keeps v + step * dv >= 0.
double longest(const Vector& v, const Vector& dv) {
  double step = 1;
  for (Eigen::Index k = 0; k < v.size(); ++k)
    if (dv[k] < 0) step = std::min(step, -v[k] / dv[k]);
  return step;
}

struct Step {
  Vector x, s, y, v;
};

class Newton {
 public:
  Newton(const ConvexProgram& p, const std::vector<double>& start, double added)
      : kkt_(p, added),
        at_{Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size())),
            {},
            {},
            Vector::Zero(kkt_.b().size())} {
    at_.s = (kkt_.h() - kkt_.g() * at_.x).cwiseMax(0.1);
    at_.y = at_.s.cwiseInverse() / static_cast<double>(std::max<Eigen::Index>(at_.s.size(), 1));
  }

  ConvexSolution run(const SolveOptions& options) {
    double best = worst();
    double nearest = infeasibility();
    Step kept = at_;
    int rounds = 0;
    for (int since = 0; rounds < max_iterations && best > options.precision && since < patience;
         ++rounds) {
      if (options.go_on && !options.go_on()) break;
      if (!advance()) break;
      ++since;
      if (infeasibility() < 0.9 * nearest) {  // complementarity may rise meanwhile
        nearest = infeasibility();
        since = 0;
      }
      if (worst() < best) {
        best = worst();
        kept = at_;
        since = 0;
      }
    }
    return {{kept.x.begin(), kept.x.end()},
            {kept.y.begin(), kept.y.end()},
            {kept.v.begin(), kept.v.end()},
            rounds,
            best};
  }

 private:
  [[nodiscard]] double mu() const {
    return at_.s.size() > 0 ? at_.s.dot(at_.y) / static_cast<double>(at_.s.size()) : 0;
  }
  [[nodiscard]] Vector dual() const {
    return kkt_.curved(at_.x) + kkt_.q() + kkt_.g().transpose() * at_.y +
           kkt_.a().transpose() * at_.v;
  }
  [[nodiscard]] Vector primal() const { return kkt_.g() * at_.x + at_.s - kkt_.h(); }
  [[nodiscard]] Vector equal() const { return kkt_.a() * at_.x - kkt_.b(); }
  [[nodiscard]] double infeasibility() const {
    return std::max({largest(dual()), largest(primal()), largest(equal())});
  }
  [[nodiscard]] double worst() const { return std::max(at_.s.dot(at_.y), infeasibility()); }
  static double largest(const Vector& v) { return v.size() > 0 ? v.lpNorm<Eigen::Infinity>() : 0; }

  [[nodiscard]] Step step(const Vector& r_s) const {  // (2)
    const auto& [x, s, y, v] = at_;
    const Vector r = (y.cwiseProduct(primal()) - r_s).cwiseQuotient(s);
    Vector right(x.size() + v.size());
    right << -dual() - kkt_.g().transpose() * r, -equal();
    const Vector solved = kkt_.solve(right);
    Step d;
    d.x = solved.head(x.size());
    d.v = solved.tail(v.size());
    d.s = -primal() - kkt_.g() * d.x;
    d.y = (-r_s - y.cwiseProduct(d.s)).cwiseQuotient(s);
    return d;
  }

  bool advance() {
    auto& [x, s, y, v] = at_;
    if (!kkt_.factorise(y.cwiseQuotient(s))) return false;
    const Vector complementary = s.cwiseProduct(y);
    const Step first = step(complementary);
    const double reach = std::min(longest(s, first.s), longest(y, first.y));
    const double before = complementary.sum();
    const double left = before > 0 ? (s + reach * first.s).dot(y + reach * first.y) / before : 0;
    const Vector target = Vector::Constant(s.size(), left * left * left * mu());
    const Step d = step(complementary + first.s.cwiseProduct(first.y) - target);
    const double room = std::min(longest(s, d.s), longest(y, d.y));
    const double along = s.size() > 0 ? 0.99 * room : 1;
    if (!d.x.allFinite()) return false;
    x += along * d.x;
    s += along * d.s;
    y += along * d.y;
    v += along * d.v;
    return true;
  }

  Kkt kkt_;
  Step at_;
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

ConvexSolution solve(const ConvexProgram& program, const std::vector<double>& start,
                     const SolveOptions& options) {
  ConvexSolution best = Newton(program, start, regular.front()).run(options);
  for (std::size_t k = 1;
       options.thorough && k < regular.size() && best.residual > std::max(good, options.precision);
       ++k) {
    ConvexSolution other = Newton(program, start, regular[k]).run(options);
    other.iterations += best.iterations;
    if (other.residual < best.residual) best = std::move(other);
  }
  return best;
}

}  // namespace jounce::optimizer
