// SPDX-License-Identifier: Apache-2.0 The mathematics of the witness. Consider an interval of
// length L that begins at b, with s = (x - b) / L, and J the size of the jerk j there. The state
// (p, v, a) at b continues as a parabola; q is the difference that the jerk adds to it:
//
//     (1)  q1' = q2,   q2' = q3,   q3' = j(b + L s) / J,      q(0) = 0
//     (2)  p(x) = p + v u + a u^2 / 2 + J L^3 q1(s)           u = L s
//          v(x) = v + a u             + J L^2 q2(s)
//          a(x) = a                   + J L   q3(s)
//
// This is y = (p, v, a), y' = (v, a, j) in other variables. The tolerance of the solver then
// applies to the difference that the interval adds and not to the size of the position, and the
// solver works without units.
//
// The values of the signal have the relative rounding error eps, and its breaks and the places
// between them, of size X, the error eps X. The growth of these errors since the start is computed
// together with the state:
//
//     (3)  at a break       d_p += eps (|p| + X |v|),  d_v += eps (|v| + X |a|),
//                           d_a += eps (|a| + X |j|)
//     (4)  over an interval d_p += L d_v + L^2 d_a / 2,  d_v += L d_a
//
// A value that is compared also has the error (3) of its own place. Within an interval, the error of
// the place changes the jerk by eps X |j'|. If V is the total variation of the jerk, the integral of
// this error over the interval is at most
//
//     (5)  d_a += eps X V
//
// In (1), this is a share eps X V / (J L). The error of the integration must be smaller, after the
// about one hundred steps of the solver and also near the start of the interval. The solver limits the
// error of each step, so its tolerance is
//
//     (6)  tolerance = 0.002 eps X V / (J L)
//
// With a much smaller one, the solver would divide its steps to follow the rounding of the place.

#include "jounce/validate/witness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

#include "validate/src/peak_finding.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce {
namespace {

using validate_detail::OdeSolver;
using validate_detail::SignalPiece;

constexpr double finest_witness = 1e-15;  ///< least tolerance that a caller may choose

/// Chebyshev points: stops that force the solver to evaluate every interval, at places that are not all zeros
/// of any sine of whole periods.
constexpr std::array stops{0.0954915028125263, 0.3454915028125263, 0.6545084971874737,
                           0.9045084971874737, 1.0};

constexpr double eps = 4 * std::numeric_limits<double>::epsilon();
constexpr double step_share = 0.002;  ///< (6)

struct State {
  double p = 0;
  double v = 0;
  double a = 0;
};

void require_valid(const WitnessOptions& options) {
  require_positive("limit", options.limit);
  if (!(options.tolerance >= finest_witness && options.tolerance <= 1e-3))
    throw InputError("tolerance", options.tolerance, "must be between 1e-15 and 1e-3");
  if (options.max_steps < 1)
    throw InputError("max_steps", std::to_string(options.max_steps), "must be at least 1");
}

/// Scales of the jerk in an interval, for which a few places are enough.
struct JerkScale {
  double size = 0;       ///< J, the greatest magnitude
  double variation = 0;  ///< V, the total variation
};

JerkScale jerk_scale(const SignalPiece& piece) {
  double before = piece.at(piece.begin)[3];
  JerkScale jerk{std::abs(before), 0};
  for (const double s : stops) {
    const double here = piece.at(piece.begin + s * piece.length())[3];
    jerk.size = std::max(jerk.size, std::abs(here));
    jerk.variation += std::abs(here - before);
    before = here;
  }
  return std::isfinite(jerk.size) && std::isfinite(jerk.variation) ? jerk : JerkScale{};
}

/// (1) and (2), for one piece after another.
class JerkIntegral {
 public:
  JerkIntegral(const SignalPiece& first, const WitnessOptions& options)
      : piece_(first),
        tolerance_(options.tolerance),
        solver_(ode(), {validate_detail::Method::adams, 1e-3, {1, 1, 1}, 0, options.max_steps}, 0,
                std::array{0.0, 0.0, 0.0}) {}

  /// `x` is the size of the piece's breaks, which are accurate to eps x.
  void enter(const SignalPiece& piece, const JerkScale& jerk, double x) {
    piece_ = piece;
    size_ = jerk.size > 0 ? jerk.size : 1;
    const double rounding = eps * x * jerk.variation / (size_ * piece.length());
    const double tolerance = std::clamp(step_share * rounding, tolerance_, 1e-3);  // (6)
    solver_.tolerate(tolerance, std::array{tolerance, tolerance, tolerance});
    std::ranges::fill(solver_.state(), 0.0);
    solver_.restart(0);
  }

  /// Integrates to s; false if the solver gave up.
  bool reach(double s) {
    validate_detail::Step step = validate_detail::Step::inside;
    while (step == validate_detail::Step::inside) step = solver_.step(s);
    return step == validate_detail::Step::stop;
  }

  /// (2) at the present place of the integration, from the state at the interval's begin.
  State carried(const State& y) {
    const double length = piece_.length();
    const double u = solver_.time() * length;
    const auto q = solver_.state();
    const double add = size_ * length;
    return {y.p + u * (y.v + u * y.a / 2) + add * length * length * q[0],
            y.v + u * y.a + add * length * q[1], y.a + add * q[2]};
  }

  /// The present place of the integration.
  [[nodiscard]] double reached() const {
    const double s = solver_.time();
    return s == 1 ? piece_.end : piece_.begin + s * piece_.length();
  }
  [[nodiscard]] const Integration& integration() const { return solver_.integration(); }

 private:
  validate_detail::Ode ode() {
    validate_detail::Ode ode;
    ode.rhs = [this](double s, const double* q, double* dq) {
      dq[0] = q[1];
      dq[1] = q[2];
      dq[2] = piece_.at(piece_.begin + s * piece_.length())[3] / size_;
    };
    ode.jacobian = [](double, const double*, double* j) {
      j[1 * 3 + 0] = 1;  // column by column
      j[2 * 3 + 1] = 1;
    };
    return ode;
  }

  SignalPiece piece_;
  double tolerance_;
  double size_ = 1;
  OdeSolver solver_;
};

/// Keeps the worst value, relative to its own limit; a difference that is not finite is the worst.
void compare(Disagreement& worst, double integrated, double signal, double where, double limit,
             double drift) {
  const double difference = std::abs(integrated - signal);
  const double relative = difference == 0 ? 0 : difference / worst.scale;
  const double allowed = worst.scale > 0 ? std::max(limit, drift / worst.scale) : limit;
  if (worst.limit == 0 || !(relative / allowed <= worst.relative / worst.limit))
    worst = {relative, where, integrated, signal, worst.scale, allowed};
}

/// The witness, which follows the signal.
class Walk {
 public:
  Walk(const std::vector<SignalPiece>& pieces, const WitnessOptions& options, Witness& witness)
      : options_(options), witness_(witness), jerk_(pieces.front(), options) {
    before_ = pieces.front().at(pieces.front().begin);
    y_ = {before_[0], before_[1], before_[2]};
  }

  /// Advances over one interval and its first break; false if the solver gave up.
  bool cross(const SignalPiece& piece) {
    const double x = std::max(std::abs(piece.begin), std::abs(piece.end));
    const JerkScale jerk = jerk_scale(piece);
    step(piece.at(piece.begin), std::max(jerk.size, std::abs(before_[3])), x);
    jerk_.enter(piece, jerk, x);
    drift_.a += eps * x * jerk.variation;  // (5)
    for (const double s : stops) {
      if (!jerk_.reach(s)) return false;
      compare_at(piece.at(jerk_.reached()), s * piece.length());
    }
    y_ = jerk_.carried(y_);
    drift_ = drifted(piece.length());
    before_ = piece.at(piece.end);
    return true;
  }

  [[nodiscard]] Integration integration() const {
    Integration integration = jerk_.integration();
    integration.reached = jerk_.reached();
    return integration;
  }

 private:
  /// The declared step, and (3).
  void step(const Jet& after, double jerk, double x) {
    y_.a += after[2] - before_[2];
    if (options_.velocity_steps) y_.v += after[1] - before_[1];
    const auto size = [&](std::size_t k) {
      return std::max(std::abs(after[k]), std::abs(before_[k]));
    };
    drift_ = sum(drift_, rounding_of({size(0), size(1), size(2), jerk}, x));
  }

  /// (3)
  static State rounding_of(const Jet& f, double x) {
    return {eps * (std::abs(f[0]) + x * std::abs(f[1])),
            eps * (std::abs(f[1]) + x * std::abs(f[2])),
            eps * (std::abs(f[2]) + x * std::abs(f[3]))};
  }
  static State sum(const State& a, const State& b) { return {a.p + b.p, a.v + b.v, a.a + b.a}; }

  [[nodiscard]] State drifted(double u) const {
    return {drift_.p + u * (drift_.v + u * drift_.a / 2), drift_.v + u * drift_.a,
            drift_.a};  // (4)
  }

  void compare_at(const Jet& f, double u) {
    const State here = jerk_.carried(y_);
    const double x = jerk_.reached();
    const State drift = sum(drifted(u), rounding_of(f, std::abs(x)));
    compare(witness_.position, here.p, f[0], x, options_.limit, drift.p);
    compare(witness_.velocity, here.v, f[1], x, options_.limit, drift.v);
    compare(witness_.acceleration, here.a, f[2], x, options_.limit, drift.a);
  }

  const WitnessOptions& options_;
  Witness& witness_;
  JerkIntegral jerk_;
  Jet before_;
  State y_;
  State drift_;
};

Finding finding_of(const char* rule, const char* quantity, const Disagreement& worst,
                   const char* advice) {
  Finding finding;
  finding.rule = rule;
  finding.quantity = quantity;
  finding.where = worst.where;
  finding.value = worst.relative;
  finding.limit = worst.limit;
  finding.margin = (worst.limit - worst.relative) / worst.limit;
  finding.broken = !(worst.relative <= worst.limit);
  if (finding.broken) finding.advice = advice;
  return finding;
}

Report report_of(const Witness& w, bool over_master) {
  const auto& names = over_master ? OverMaster::names : OverTime::names;
  Report report;
  report.findings = {
      finding_of("witness/position", names[0], w.position,
                 "make the velocity the derivative of the position"),
      finding_of("witness/velocity", names[1], w.velocity,
                 "make the acceleration the derivative of the velocity, without steps"),
      finding_of("witness/acceleration", names[2], w.acceleration,
                 "make the jerk the derivative of the acceleration")};
  if (!w.integration.ok())
    report.findings.push_back(
        validate_detail::integration_finding("witness/integration", "jerk", w.integration));
  sort(report);
  return report;
}

}  // namespace

Witness witness(const SignalView& signal, const WitnessOptions& options) {
  require_valid(options);
  const auto pieces = validate_detail::pieces(signal);
  const validate_detail::Scales size = validate_detail::scales(pieces);
  Witness result;
  result.position.scale = size.range;
  result.velocity.scale = size.peak[1];
  result.acceleration.scale = size.peak[2];
  Walk walk(pieces, options, result);
  bool ok = true;
  for (auto piece = pieces.begin(); ok && piece != pieces.end(); ++piece) ok = walk.cross(*piece);
  result.integration = walk.integration();
  result.report = report_of(result, signal.over_master());
  return result;
}

}  // namespace jounce
