// SPDX-License-Identifier: Apache-2.0
// Sensitivities against closed forms and against matrix exponentials.
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

#include "support/random.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::sensitivity_test {
namespace {

using validate_detail::Ode;
using validate_detail::OdeSolver;
using validate_detail::SolverOptions;
using validate_detail::Step;

SolverOptions settings(std::size_t states, double tolerance, double scale = 1) {
  SolverOptions options;
  options.relative = tolerance;
  options.absolute.assign(states, 1e-3 * tolerance * scale);
  options.closest = 1e-12;
  options.max_steps = 1'000'000;
  return options;
}

void run_to(OdeSolver& solver, double t) {
  for (int i = 0; i < 1'000'000; ++i) {
    const Step step = solver.step(t);
    ASSERT_NE(step, Step::failed) << solver.integration().reason;
    if (step == Step::stop) return;
  }
  FAIL() << "the solver does not reach t = " << t;
}

/// y' = -p y + q: y = q/p + (y0 - q/p) exp(-p t).
struct Decay {
  double p = 3;
  double q = 2;
  double y0 = 5;

  [[nodiscard]] Ode ode() const {
    Ode ode;
    ode.rhs = [this](double, const double* y, double* dy) { dy[0] = -p * y[0] + q; };
    ode.jacobian = [this](double, const double*, double* j) { j[0] = -p; };
    ode.by_parameter = [](double, const double* y, double* dfdp) {
      dfdp[0] = -y[0];
      dfdp[1] = 1;
    };
    ode.parameters = {3, 2};
    return ode;
  }
  [[nodiscard]] double by_p(double t) const {
    const double e = std::exp(-p * t);
    return -q / (p * p) * (1 - e) - t * (y0 - q / p) * e;
  }
  [[nodiscard]] double by_q(double t) const { return (1 - std::exp(-p * t)) / p; }
};

double decay_error(double tolerance) {
  const Decay decay;
  OdeSolver solver(decay.ode(), settings(1, tolerance), 0, std::array{decay.y0});
  run_to(solver, 1.5);
  return std::max(std::abs(solver.sensitivity(0)[0] - decay.by_p(1.5)),
                  std::abs(solver.sensitivity(1)[0] - decay.by_q(1.5)));
}

TEST(Sensitivity, OfALinearProblemIsItsClosedForm) {
  EXPECT_LT(decay_error(1e-8), 2e-7);
  EXPECT_LT(decay_error(1e-10), 2e-9);
}

TEST(Sensitivity, ErrorFollowsTheTolerance) {
  const double coarse = decay_error(1e-5);
  const double fine = decay_error(1e-9);
  EXPECT_GT(coarse, 1e-9);  // or the tolerance would not be what is controlled
  EXPECT_LT(fine, 1e-2 * coarse);
}

TEST(Sensitivity, IsInterpolatedInsideAStep) {
  const Decay decay;
  OdeSolver solver(decay.ode(), settings(1, 1e-10), 0, std::array{decay.y0});
  for (int i = 0; i < 200 && solver.time() < 0.5; ++i) {
    ASSERT_NE(solver.step(1), Step::failed);
    const double t = 0.3 * solver.before() + 0.7 * solver.time();
    std::array<double, 2> s{};
    solver.interpolate_sensitivities(t, s);
    EXPECT_NEAR(s[0], decay.by_p(t), 1e-7);
    EXPECT_NEAR(s[1], decay.by_q(t), 1e-7);
  }
  EXPECT_GE(solver.time(), 0.5);
}

/// At t = 1 the state jumps by p q: the sensitivities jump by q and p, and go on.
TEST(Sensitivity, ContinuesAfterAJumpThatDependsOnTheParameters) {
  const Decay decay;
  OdeSolver solver(decay.ode(), settings(1, 1e-10), 0, std::array{decay.y0});
  run_to(solver, 1);
  solver.state()[0] += decay.p * decay.q;
  solver.sensitivity(0)[0] += decay.q;
  solver.sensitivity(1)[0] += decay.p;
  solver.restart(1);
  run_to(solver, 1.5);
  const double e = std::exp(-decay.p * 0.5);
  const double jump = decay.p * decay.q;
  EXPECT_NEAR(solver.sensitivity(0)[0], decay.by_p(1.5) + (decay.q - 0.5 * jump) * e, 1e-8);
  EXPECT_NEAR(solver.sensitivity(1)[0], decay.by_q(1.5) + decay.p * e, 1e-8);
}

/// Van der Pol's oscillator, x'' = m (1 - x^2) x' - k x.
Ode van_der_pol(const std::array<double, 2>& p) {
  Ode ode;
  ode.rhs = [p](double, const double* y, double* dy) {
    dy[0] = y[1];
    dy[1] = p[0] * (1 - y[0] * y[0]) * y[1] - p[1] * y[0];
  };
  ode.jacobian = [p](double, const double* y, double* j) {
    j[1] = -2 * p[0] * y[0] * y[1] - p[1];
    j[2] = 1;
    j[3] = p[0] * (1 - y[0] * y[0]);
  };
  ode.by_parameter = [](double, const double* y, double* dfdp) {
    dfdp[1] = (1 - y[0] * y[0]) * y[1];
    dfdp[3] = -y[0];
  };
  return ode;
}

TEST(Sensitivity, OfASmoothProblemAgreesWithDifferences) {
  const std::array<double, 2> p{1.3, 2.1};
  const std::array start{0.7, -0.2};
  Ode ode = van_der_pol(p);
  ode.parameters = {p[0], p[1]};
  OdeSolver solver(ode, settings(2, 1e-10), 0, start);
  run_to(solver, 4);
  const auto end = [&](std::array<double, 2> q) {
    OdeSolver plain(van_der_pol(q), settings(2, 1e-12), 0, start);
    run_to(plain, 4);
    return std::array{plain.state()[0], plain.state()[1]};
  };
  for (std::size_t j = 0; j < 2; ++j) {
    constexpr double h = 1e-4;
    std::array<double, 2> up = p, down = p;
    up[j] += h;
    down[j] -= h;
    const auto a = end(up), b = end(down);
    for (std::size_t i = 0; i < 2; ++i) {
      const double difference = (a[i] - b[i]) / (2 * h);
      EXPECT_NEAR(solver.sensitivity(j)[i], difference, 1e-6 * (1 + std::abs(difference)));
    }
  }
}

TEST(Sensitivity, NotFiniteIsAnOutcome) {
  Decay decay;
  Ode ode = decay.ode();
  ode.by_parameter = [](double t, const double*, double* dfdp) {
    dfdp[0] = t < 0.5 ? 1 : std::nan("");
  };
  OdeSolver solver(ode, settings(1, 1e-8), 0, std::array{1.0});
  Step step = Step::inside;
  while (step == Step::inside) step = solver.step(1);
  EXPECT_EQ(step, Step::failed);
  EXPECT_EQ(solver.integration().ended, Ended::not_finite);
}

// ---- many parameters: knots of an input --------------------------------------------------------

/// Two masses on a shaft behind a stiff loop, driven by an acceleration that is linear between n + 1
/// knots: x' = A x + b u(t). The objective is the integral of x_load^2 and the load's end. Solved
/// exactly: with (u, u') as states every interval is a matrix exponential.
class Driven {
 public:
  static constexpr int states = 5;
  using Vector = Eigen::Matrix<double, states, 1>;

  explicit Driven(int intervals) : n(intervals), knots(static_cast<std::size_t>(n) + 1) {
    test::Random random(7);
    for (double& u : knots) u = random.uniform(-1, 1);
    constexpr double kp = 40, kv = 210, c = 1.25e6, d = 125, share = 0.2;
    a.setZero();
    a(0, 1) = 1;
    a.row(1) << -kv * kp - c * share, -kv - d * share, c * share, d * share, 1;
    a(2, 3) = 1;
    a.row(3) << c * share / 5, d * share / 5, -c * share / 5, -d * share / 5, 0;
    a.row(4) << -kv * kp * 50, -kv * 50, 0, 0, 0;
    b << 0, -1, 0, -1, 0;
  }

  [[nodiscard]] double interval() const { return 1.0 / n; }
  [[nodiscard]] double input(double t) const {
    const double s = std::min(std::max(t * n, 0.0), static_cast<double>(n));
    const int i = std::min(static_cast<int>(s), n - 1);
    const auto k = static_cast<std::size_t>(i);
    return knots[k] + (s - i) * (knots[k + 1] - knots[k]);
  }
  /// The two hats that are not zero at t.
  template <class Add>
  void hats(double t, Add add) const {
    const double s = std::min(std::max(t * n, 0.0), static_cast<double>(n));
    const int i = std::min(static_cast<int>(s), n - 1);
    add(static_cast<std::size_t>(i), 1 - (s - i));
    add(static_cast<std::size_t>(i) + 1, s - i);
  }

  [[nodiscard]] Ode ode() const {
    Ode ode;
    ode.rhs = [this](double t, const double* y, double* dy) {
      Eigen::Map<Vector>(dy, states) = a * Eigen::Map<const Vector>(y) + b * input(t);
    };
    ode.jacobian = [this](double, const double*, double* j) {
      Eigen::Map<Eigen::Matrix<double, states, states>>(j, states, states) = a;
    };
    return ode;
  }

  [[nodiscard]] Eigen::VectorXd exact_gradient() const;
  [[nodiscard]] Eigen::VectorXd forward_gradient(double tolerance) const;

  static constexpr double end_weight = 1e-3;
  int n;
  std::vector<double> knots;
  Eigen::Matrix<double, states, states> a;
  Vector b;
};

/// Gauss and Legendre's eight points on [0, 1].
constexpr std::array<std::array<double, 2>, 8> gauss{{{0.019855071751231884, 0.05061426814518813},
                                                      {0.10166676129318664, 0.11119051722668724},
                                                      {0.2372337950418355, 0.15685332293894363},
                                                      {0.4082826787521751, 0.18134189168918100},
                                                      {0.5917173212478249, 0.18134189168918100},
                                                      {0.7627662049581645, 0.15685332293894363},
                                                      {0.8983332387068134, 0.11119051722668724},
                                                      {0.9801449282487681, 0.05061426814518813}}};

/// All hats at once beside the state itself: one column each.
Eigen::VectorXd Driven::exact_gradient() const {
  constexpr int all = states + 2;
  using Square = Eigen::Matrix<double, all, all>;
  Square whole = Square::Zero();
  whole.topLeftCorner<states, states>() = a;
  whole.block<states, 1>(0, states) = b;
  whole(states, states + 1) = 1;
  std::array<Square, gauss.size()> to_node;
  for (std::size_t k = 0; k < gauss.size(); ++k)
    to_node[k] = (whole * (gauss[k][0] * interval())).exp();
  const Square to_end = (whole * interval()).exp();

  Eigen::Matrix<double, all, Eigen::Dynamic> x(all, n + 2);
  x.setZero();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n + 1);
  for (int i = 0; i < n; ++i) {
    x.bottomRows(2).setZero();  // rows of hat i and hat i + 1, and of their sum, the input
    const auto k = static_cast<std::size_t>(i);
    x(states, i) = 1;
    x(states + 1, i) = -n;
    x(states + 1, i + 1) = n;
    x(states, n + 1) = knots[k];
    x(states + 1, n + 1) = (knots[k + 1] - knots[k]) * n;
    for (std::size_t q = 0; q < gauss.size(); ++q) {
      const Eigen::RowVectorXd load = to_node[q].row(2) * x;
      gradient += 2 * gauss[q][1] * interval() * load(n + 1) * load.head(n + 1).transpose();
    }
    x = (to_end * x).eval();
  }
  return gradient + 2 * end_weight * x(2, n + 1) * x.row(2).head(n + 1).transpose();
}

Eigen::VectorXd Driven::forward_gradient(double tolerance) const {
  // the integral as a sixth state, so that the sensitivities alone make the gradient
  Ode plain = ode();
  Ode with_integral;
  with_integral.rhs = [plain](double t, const double* y, double* dy) {
    plain.rhs(t, y, dy);
    dy[5] = y[2] * y[2];
  };
  with_integral.jacobian = [this](double, const double* y, double* j) {
    for (int column = 0; column < states; ++column)
      for (int row = 0; row < states; ++row) j[column * 6 + row] = a(row, column);
    j[2 * 6 + 5] = 2 * y[2];
  };
  with_integral.by_parameter = [this](double t, const double*, double* dfdp) {
    hats(t, [&](std::size_t hat, double value) {
      for (int row = 0; row < states; ++row)
        dfdp[hat * 6 + static_cast<std::size_t>(row)] = b(row) * value;
    });
  };
  with_integral.parameters.assign(knots.size(), 1);
  SolverOptions options = settings(6, tolerance);
  options.absolute = {1e-5, 1e-3, 1e-5, 1e-3, 1e-1, 1e-10};
  for (double& absolute : options.absolute) absolute *= tolerance;
  OdeSolver solver(with_integral, options, 0, std::array<double, 6>{});
  solver.limit_step(interval());
  run_to(solver, 1);
  Eigen::VectorXd gradient(n + 1);
  for (std::size_t j = 0; j < knots.size(); ++j) {
    const auto s = solver.sensitivity(j);
    gradient(static_cast<Eigen::Index>(j)) = s[5] + 2 * end_weight * solver.state()[2] * s[2];
  }
  return gradient;
}

double relative_error(const Eigen::VectorXd& value, const Eigen::VectorXd& exact) {
  return (value - exact).norm() / exact.norm();
}

TEST(Sensitivity, OfFiftyKnotsIsThatOfMatrixExponentials) {
  const Driven driven(49);
  EXPECT_LT(relative_error(driven.forward_gradient(1e-8), driven.exact_gradient()), 1e-6);
}

}  // namespace
}  // namespace jounce::sensitivity_test
