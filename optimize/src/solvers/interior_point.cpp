// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/interior_point.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "optimize/src/solvers/cone_scaling.hpp"
#include "optimize/src/solvers/kkt.hpp"

// Let Q x + q be the gradient of the objective, G x + s = h the constraints with multipliers y, and
// A x = b the equalities with multipliers v. The equations
//
//   (1)  Q x + q + G' y + A' v = 0,   G x + s - h = 0,   A x - b = 0,   s o y = mu e,   s, y inside their cones
//
// are solved by Newton's method while mu decreases to zero. o is Jordan's product and e its unit;
// for linear constraints they are the product of numbers and 1 (cone_scaling.hpp).
// With W y = W^-1 s = l, and u the vector whose product with l is r, a step is
//
//   (2)  (Q + G' W^-2 G) dx + A' dv = -r_dual - G' (W^-2 r_primal - W^-1 u),
//        A dx = -r_equal,   ds = -r_primal - G dx,   dy = -W^-2 ds - W^-1 u
//
// One factorization serves two steps. The first, with r = l o l, determines how far mu may be
// lowered, and the second-order term (W^-1 ds) o (W dy). The second step includes both (Mehrotra
// 1992; for cones: L. Vandenberghe, The CVXOPT linear and quadratic cone program solvers, 2010).

namespace jounce::optimize_detail {
namespace {

using Vector = Kkt::Vector;

constexpr int max_iterations = 100;
constexpr int patience = 8;    ///< iterations without progress
constexpr double good = 1e-8;  ///< a residual that needs no further attempt

/// The start of a solution: the number added to the diagonal (Kkt), and mu; 0: small, one over the number of
/// constraints. Near the boundary of a cone a small mu makes short steps.
struct Beginning {
  double regular = 0;
  double mu = 0;
};
constexpr std::array beginnings{Beginning{1e-8, 0}, Beginning{0, 0}, Beginning{1e-8, 1}};

/// Unknowns and equalities of the largest program with row exchanges. A factorization cannot be interrupted,
/// and its time grows with the square of the size: 0.6 s here, 9 s at four times the size.
constexpr std::size_t most_pivoted = 6000;

bool is_too_large(const ConvexProgram& p, const Beginning& begin) {
  return begin.regular == 0 && !p.equalities.empty() &&
         p.slope.size() + p.equalities.size() > most_pivoted;
}

struct Step {
  Vector x, s, y, v;
};

class Newton {
 public:
  Newton(const ConvexProgram& p, const std::vector<double>& start, const Beginning& begin)
      : kkt_(p, begin.regular),
        cones_(kkt_.cones()),
        at_{Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size())),
            {},
            {},
            Vector::Zero(kkt_.b().size())} {
    const bool large = begin.mu > 0 || !cones_.round.empty();
    at_.s = inside(cones_, kkt_.h() - kkt_.g() * at_.x, begin.mu > 0 ? 1 : 0.1);
    at_.y = inverse(cones_, at_.s) / (large ? 1.0 : std::max(cones_.degree(), 1.0));
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
      if (infeasibility() < 0.9 * nearest) {  // complementarity may increase meanwhile
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
            {kept.y.begin(), kept.y.begin() + cones_.linear},
            round_multipliers(kept.y),
            {kept.v.begin(), kept.v.end()},
            rounds,
            best};
  }

 private:
  [[nodiscard]] std::vector<std::vector<double>> round_multipliers(const Vector& y) const {
    std::vector<std::vector<double>> all;
    auto at = y.begin() + cones_.linear;
    for (const Eigen::Index size : cones_.round) {
      all.emplace_back(at + 1, at + size);
      at += size;
    }
    return all;
  }
  [[nodiscard]] double mu() const {
    return at_.s.size() > 0 ? at_.s.dot(at_.y) / cones_.degree() : 0;
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

  /// (2), for the u of a step.
  [[nodiscard]] Step step(const ConeScaling& w, const Vector& u) const {
    const auto& [x, s, y, v] = at_;
    const Vector scaled_u = w.inverse(u);
    Vector right(x.size() + v.size());
    right << -dual() - kkt_.g().transpose() * (w.inverse_squared(primal()) - scaled_u), -equal();
    const Vector solution = kkt_.solve(right);
    Step d;
    d.x = solution.head(x.size());
    d.v = solution.tail(v.size());
    d.s = -primal() - kkt_.g() * d.x;
    d.y = -w.inverse_squared(d.s) - scaled_u;
    return d;
  }

  [[nodiscard]] double reach(const Step& d) const {
    return std::min(longest(cones_, at_.s, d.s), longest(cones_, at_.y, d.y));
  }

  bool advance() {
    auto& [x, s, y, v] = at_;
    const ConeScaling w(cones_, s, y);
    if (!kkt_.factorize(w)) return false;
    const Vector l = w.times(y);
    const Step first = step(w, l);
    const double along = reach(first);
    const double before = s.dot(y);
    const double left = before > 0 ? (s + along * first.s).dot(y + along * first.y) / before : 0;
    const Vector second = product(cones_, w.inverse(first.s), w.times(first.y)) -
                          left * left * left * mu() * unit_of(cones_);
    const Step d = step(w, l + quotient(cones_, second, l));
    if (!d.x.allFinite()) return false;
    const double length = s.size() > 0 ? 0.99 * reach(d) : 1;
    x += length * d.x;
    s += length * d.s;
    y += length * d.y;
    v += length * d.v;
    return true;
  }

  Kkt kkt_;
  ConeShape cones_;
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
  ConvexSolution best = Newton(program, start, beginnings.front()).run(options);
  for (std::size_t k = 1; options.thorough && k < beginnings.size() &&
                          best.residual > std::max(good, options.precision);
       ++k) {
    if (options.go_on && !options.go_on()) break;
    if (is_too_large(program, beginnings[k])) continue;
    ConvexSolution other = Newton(program, start, beginnings[k]).run(options);
    other.iterations += best.iterations;
    if (other.residual < best.residual) best = std::move(other);
  }
  return best;
}

}  // namespace jounce::optimize_detail
