// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/signal.hpp"

namespace jounce {

/// Returns the derivatives with respect to time of f(x(t)), by the chain rule. `f` is the value
/// with its derivatives with respect to x, at x(t); `x` is the position with its derivatives with
/// respect to time. For equations (1) to (3), see Followed.
inline Jet chained(const Jet& f, const Jet& x) {
  return {f[0], f[1] * x[1],                                                  // (1)
          f[2] * x[1] * x[1] + f[1] * x[2],                                   // (2)
          f[3] * x[1] * x[1] * x[1] + 3 * f[2] * x[1] * x[2] + f[1] * x[3]};  // (3)
}

/// True if a master moves backwards on the given side of an instant. The first derivative of x that
/// is not zero determines the direction, so a master at rest that is about to move backwards counts
/// as moving backwards.
inline bool backwards(const Jet& x, Side side = Side::right) {
  const double s = side == Side::right ? 1 : -1;
  if (x[1] != 0) return x[1] < 0;
  if (x[2] != 0) return s * x[2] < 0;
  return x[3] < 0;
}

/// Throws InputError if the master passes more than 2e6 breaks of a cam in the periods `first` to
/// `last`, or reaches the period 1e15. Both limits are far beyond any machine. The check prevents
/// the program from running out of memory.
void require_few_periods(double first, double last, std::size_t breaks);

/// The motion over time of a slave that follows a master: cam(master(t)). It is a Signal.
///
///     TrapezoidSpec travel{.to = 1080, .velocity = 200, .acceleration = 1000};
///     const Followed slave(cam, trapezoid(travel).curve());
///     Motion now = slave.at(0.5);
///
/// The chain rule includes the master's acceleration and jerk (f: cam, x: master):
///
///     (1)  y'   = f' x'
///     (2)  y''  = f'' x'^2 + f' x''
///     (3)  y''' = f''' x'^3 + 3 f'' x' x'' + f' x'''
///
/// The breaks are the breaks of the master, and every instant at which the master passes a break of
/// the cam. While the master moves backwards, the one-sided values of the cam from the right and
/// from the left are exchanged.
/// Throws InputError if the master leaves a cam that refuses positions outside, and like
/// require_few_periods().
class Followed {
 public:
  Followed(Cam cam, Trajectory master);

  [[nodiscard]] double start() const { return master_.start(); }
  [[nodiscard]] double end() const { return master_.end(); }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  /// Returns the position of the slave at t (s), and its derivatives with respect to time.
  [[nodiscard]] Jet jet(double t, Side side = Side::right) const;
  [[nodiscard]] Motion at(double t, Side side = Side::right) const {
    return point<OverTime>(jet(t, side));
  }

  [[nodiscard]] const Cam& cam() const { return cam_; }
  [[nodiscard]] const Trajectory& master() const { return master_; }

 private:
  Cam cam_;
  Trajectory master_;
  std::vector<double> breaks_;
};

static_assert(Signal<Trajectory> && Signal<Cam> && Signal<Followed>);

}  // namespace jounce
