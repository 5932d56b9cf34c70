// SPDX-License-Identifier: Apache-2.0
// A follower of mass m at x, behind a linkage whose massless tip is at s. The cam surface is at y.
// Positive is away from the center of the cam. Lengths in m.
//
//     (1)  N = k_l (s - x) + c_l (s' - x')                        force of the linkage
//     (2)  m x'' = N - k_s x - c_s x' - F_0                       mass
//     (3)  on the cam:   s = y, while N > 0
//     (4)  in the air:   N = 0, so that the tip creeps: d' = -(k_l / c_l) d,  d = s - x
//          (c_l = 0: d = 0), while s > y
//
// The tip has no mass: when it lands, only N steps, by c_l (y' - s'). The integrated variable is
// the compression e = y - x, which is small while the follower follows the cam:
//
//     (5)  e'' = y'' + (k_s (y - e) + c_s (y' - e') + F_0 - N) / m
//     (6)  gap = s - y = d - e
//
// The event is N = 0 on the cam and gap = 0 in the air. At rest in equilibrium on the cam
//
//     (7)  e = (k_s y + F_0) / (k_l + k_s)

#include "validate/src/witness/follower_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "validate/src/drive/peak.hpp"
#include "validate/src/linear/course.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_input;

class FollowerModel {
 public:
  enum State { compression, rate, tip, size };
  using Values = std::array<double, size>;

  explicit FollowerModel(const SpringFollower& f) : f_(f) {}

  bool flying = false;

  /// The lift in m.
  [[nodiscard]] Jet lift(Jet y) const {
    for (double& v : y) v *= f_.meters_per_unit;
    return y;
  }

  [[nodiscard]] double rest(double y) const {  // (7)
    return (f_.spring_stiffness * y + f_.preload) / (f_.linkage_stiffness + f_.spring_stiffness);
  }

  [[nodiscard]] double linkage(const double* s) const {  // (1), (3)
    return f_.linkage_stiffness * s[compression] + f_.linkage_damping * s[rate];
  }
  [[nodiscard]] double force(const double* s) const { return flying ? 0 : linkage(s); }
  [[nodiscard]] double gap(const double* s) const {  // (6)
    return flying ? s[tip] - s[compression] : 0;
  }
  [[nodiscard]] double tip_rate(const double* s) const {  // (4)
    return flying && f_.linkage_damping > 0 ? -f_.linkage_stiffness / f_.linkage_damping * s[tip]
                                            : 0;
  }
  [[nodiscard]] double event(const double* s) const { return flying ? gap(s) : linkage(s); }

  void rhs(const Jet& y, const double* s, double* ds) const {
    const double back = f_.spring_stiffness * (y[0] - s[compression]) +
                        f_.spring_damping * (y[1] - s[rate]) + f_.preload;
    ds[compression] = s[rate];
    ds[rate] = y[2] + (back - force(s)) / f_.mass;  // (5)
    ds[tip] = tip_rate(s);
  }

  void jacobian(double* dfdy) const {
    const double on = flying ? 0 : 1;
    dfdy[rate * size + compression] = 1;
    dfdy[compression * size + rate] = -(f_.spring_stiffness + on * f_.linkage_stiffness) / f_.mass;
    dfdy[rate * size + rate] = -(f_.spring_damping + on * f_.linkage_damping) / f_.mass;
    if (flying && f_.linkage_damping > 0)
      dfdy[tip * size + tip] = -f_.linkage_stiffness / f_.linkage_damping;
  }

  [[nodiscard]] double radian() const {
    return std::sqrt(f_.mass / (f_.linkage_stiffness + f_.spring_stiffness));
  }

 private:
  const SpringFollower& f_;
};

class RunningFollower {
 public:
  RunningFollower(const SignalView& lift, const SpringFollower& follower,
                  const FollowerOptions& options)
      : follower_(follower),
        options_(options),
        origin_(lift.start()),
        end_(lift.end()),
        closest_(shortest_time(origin_, end_ + options.settle)),
        pieces_(pieces(lift, closest_)),
        size_(scales(pieces_)),
        standstill_{pieces_.back().at(end_)[0], {end_, end_ + options.settle}},
        model_(follower),
        piece_(pieces_.front()),
        before_{pieces_.front().at(origin_)[0], 0, 0, 0},
        spacing_(options.samples > 1
                     ? (end_ + options.settle - origin_) / static_cast<double>(options.samples - 1)
                     : 0),
        solver_(ode(), settings(), 0, start()) {
    result_.least_force.value = std::numeric_limits<double>::infinity();
    result_.samples.reserve(options.samples);
  }

  FollowerResult result() {
    bool ok = true;
    for (auto piece = pieces_.begin(); ok && piece != pieces_.end(); ++piece) ok = along(*piece);
    if (ok && options_.settle > closest_) {
      settling_ = true;
      const SignalView standstill(standstill_);
      along({&standstill, end_, end_ + options_.settle});
    }
    result_.integration = solver_.integration();
    result_.integration.reached = origin_ + solver_.time();
    if (model_.flying) result_.flights.back().to = result_.integration.reached;
    return std::move(result_);
  }

 private:
  Ode ode() {
    Ode ode;
    ode.rhs = [this](double t, const double* s, double* ds) { model_.rhs(at(t), s, ds); };
    ode.jacobian = [this](double, const double*, double* dfdy) { model_.jacobian(dfdy); };
    ode.event = [this](double, const double* s, double* g) { g[0] = model_.event(s); };
    ode.events = 1;
    return ode;
  }

  [[nodiscard]] FollowerModel::Values start() const {
    const double e = model_.rest(model_.lift(before_)[0]);
    if (!(e > 0))
      throw InputError("preload", follower_.preload,
                       "must be greater than " +
                           number(0 - follower_.spring_stiffness * model_.lift(before_)[0]) +
                           ", so that it presses the follower on the cam at the start of the lift");
    return {e, 0, 0};
  }

  [[nodiscard]] SolverOptions settings() const {
    const double e = model_.rest(model_.lift(before_)[0]);
    const double least = 1e-3 * options_.tolerance;
    const double lift = model_.lift(size_.peak)[2] * model_.radian() * model_.radian();
    const double length = std::max(e, lift);
    return {Method::bdf,
            options_.tolerance,
            {least * length, least * length / model_.radian(), least * length},
            closest_,
            options_.max_steps};
  }

  [[nodiscard]] Jet at(double t) const { return model_.lift(piece_.at(origin_ + t)); }

  bool along(const SignalPiece& piece) {
    enter(piece);
    for (;;) {
      const Step step = solver_.step(piece.end - origin_);
      if (step == Step::failed) return false;
      watch();
      if (switched(step)) solver_.restart(solver_.time());
      if (step == Step::stop) break;
    }
    before_ = piece.at(piece.end);
    return true;
  }

  /// Mass and tip stay where they are when the cam steps.
  void enter(const SignalPiece& piece) {
    piece_ = piece;
    const Jet y = piece.at(piece.begin);
    const double cap = longest_step * std::min(piece.length(), model_.radian());
    solver_.limit_step(cap);
    const bool first = solver_.integration().restarts == 0;
    if (!(first || steps(before_, y, size_) || solver_.next_step() > 2 * cap)) return;
    auto s = solver_.state();
    const double meters = follower_.meters_per_unit;
    s[FollowerModel::compression] += meters * (y[0] - before_[0]);
    s[FollowerModel::rate] += meters * (y[1] - before_[1]);
    if (!model_.flying && model_.linkage(s.data()) < 0) take_off();
    solver_.restart(solver_.time());
  }

  /// Lifts the follower off the cam or sets it down. The sign itself decides cases that an event cannot detect
  /// (a start on zero).
  bool switched(Step step) {
    const double* s = solver_.state().data();
    const bool event = step == Step::event;
    if (!model_.flying) {
      const double least = -10 * options_.tolerance * result_.greatest_force.value;
      if (!(event && solver_.crossing(0) < 0) && model_.linkage(s) >= least) return false;
      take_off();
    } else {
      const double most =
          -10 * options_.tolerance * (model_.rest(model_.lift(before_)[0]) + height_);
      if (!(event && solver_.crossing(0) < 0) && model_.gap(s) >= most) return false;
      land();
    }
    return true;
  }

  void take_off() {
    auto s = solver_.state();
    s[FollowerModel::tip] = s[FollowerModel::compression];
    const double now = origin_ + solver_.time();
    result_.flights.push_back({now, now, 0, 0});
    if (result_.least_force.value > 0) result_.least_force = {0, now};
    height_ = 0;
    model_.flying = true;
  }

  void land() {
    auto s = solver_.state();
    Flight& flight = result_.flights.back();
    flight.to = origin_ + solver_.time();
    flight.impact_speed = std::abs(s[FollowerModel::rate] - model_.tip_rate(s.data()));
    s[FollowerModel::tip] = 0;
    model_.flying = false;
    see_force(model_.linkage(s.data()), flight.to);
  }

  void see_force(double force, double where) {
    if (force < result_.least_force.value) result_.least_force = {std::max(force, 0.0), where};
    raise(result_.greatest_force, force, where);
  }

  /// Evaluates the step just made.
  void watch() {
    const double h = (solver_.time() - solver_.before()) / 2;
    if (h == 0) return;
    const double t = origin_ + solver_.before();
    std::array<double, 3> force{}, gap{}, swing{};
    for (std::size_t i = 0; i < 3; ++i) {
      FollowerModel::Values s{};
      const double u = i == 2 ? solver_.time() : solver_.before() + static_cast<double>(i) * h;
      solver_.interpolate(u, s);
      force[i] = model_.force(s.data());
      gap[i] = model_.gap(s.data());
      swing[i] = model_.rest(at(u)[0]) - s[FollowerModel::compression];
    }
    if (model_.flying) {
      see_parabola(gap, t, h, [&](double g, double) { height_ = std::max(height_, g); });
      result_.flights.back().height = height_ / follower_.meters_per_unit;
    } else {
      see_parabola(force, t, h, [&](double f, double where) { see_force(f, where); });
    }
    if (settling_)
      see_parabola(swing, t, h, [&](double x, double where) {
        raise(result_.residual, x / follower_.meters_per_unit, where);
      });
    sample();
  }

  void sample() {
    const double unit = 1 / follower_.meters_per_unit;
    const double slack = rounded_input * spacing_;
    while (result_.samples.size() < options_.samples) {
      const double t = static_cast<double>(result_.samples.size()) * spacing_;
      if (t > solver_.time() + slack) return;
      FollowerModel::Values s{};
      const double inside = std::clamp(t, solver_.before(), solver_.time());
      solver_.interpolate(inside, s);
      const double y = at(inside)[0];
      result_.samples.push_back({origin_ + t, unit * y, unit * (y - s[FollowerModel::compression]),
                                 std::max(0.0, model_.force(s.data())),
                                 unit * std::max(0.0, model_.gap(s.data()))});
    }
  }

  const SpringFollower& follower_;
  const FollowerOptions& options_;
  double origin_;
  double end_;
  double closest_;
  std::vector<SignalPiece> pieces_;
  Scales size_;
  Standstill standstill_;
  FollowerModel model_;
  SignalPiece piece_;
  Jet before_;
  double spacing_;
  OdeSolver solver_;
  FollowerResult result_;
  double height_ = 0;  // m
  bool settling_ = false;
};

}  // namespace

FollowerResult run(const SignalView& lift, const SpringFollower& follower,
                   const FollowerOptions& options) {
  return RunningFollower(lift, follower, options).result();
}

}  // namespace jounce::validate_detail
