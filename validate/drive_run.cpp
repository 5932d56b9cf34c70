// The run of a drive along a reference. What CVODES must be told, each point a measured failure
// otherwise:
//
// - the reference is locked to the interval between two breaks, and every break is a stop;
// - at a step of position, velocity or acceleration the solver begins anew; at higher knots it goes
//   on (a thousand restarts in a fine table would cost more accuracy than the knots);
// - no step is longer than 0.3 of the interval, and a solver that comes out of a long dwell with a
//   longer one begins anew: it would step over a short move and call that success;
// - the torque limit is a mode, set at the start and at every restart, changed where root finding
//   or the check after each step says so.

#include "jounce/validate/detail/drive_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/validate/detail/drive_model.hpp"
#include "jounce/validate/detail/observer.hpp"
#include "jounce/validate/detail/piece.hpp"
#include "jounce/validate/detail/solver.hpp"

namespace jounce::detail {
namespace {

constexpr double longest_step = 0.3;  // of an interval; no law has its zeros at these multiples
constexpr double rounding = 1e-12;    // a step of position or velocity below this is none
constexpr double smooth = 1e-4;       // a step of acceleration below this is left to error control

/// What a reference is after its end.
struct Standstill {
  double position;
  std::array<double, 2> interval;

  [[nodiscard]] double start() const { return interval[0]; }
  [[nodiscard]] double end() const { return interval[1]; }
  [[nodiscard]] std::span<const double> breaks() const { return interval; }
  [[nodiscard]] Jet jet(double, Side) const { return {position, 0, 0, 0}; }
};

class Run {
 public:
  Run(const SignalView& reference, const Drive& drive, const DriveOptions& options)
      : drive_(drive),
        options_(options),
        origin_(reference.start()),
        end_(reference.end()),
        closest_(shortest(reference, options)),
        pieces_(pieces(reference, closest_)),
        size_(scales(pieces_)),
        standstill_{pieces_.back().at(end_)[0], {end_, end_ + options.settle}},
        model_(drive),
        piece_(pieces_.front()),
        before_{pieces_.front().at(origin_)[0], 0, 0, 0},
        solver_(ode(), settings(), 0, DriveModel::Values{}),
        observer_(model_, origin_, end_ + options.settle - origin_, options.samples) {}

  DriveResult result() {
    bool ok = true;
    for (auto piece = pieces_.begin(); ok && piece != pieces_.end(); ++piece) ok = follow(*piece);
    DriveResult result;
    if (ok) finish_reference(result);
    if (ok && options_.settle > closest_) {
      observer_.settle();
      const SignalView standstill(standstill_);
      follow({&standstill, end_, end_ + options_.settle});
    }
    finish(result);
    return result;
  }

 private:
  static double shortest(const SignalView& reference, const DriveOptions& options) {
    const double from = reference.start();
    const double to = reference.end() + options.settle;
    return std::max(rounding * (to - from), 16 * std::numeric_limits<double>::epsilon() *
                                                std::max(std::abs(from), std::abs(to)));
  }

  Ode ode() {
    Ode ode;
    ode.rhs = [this](double t, const double* y, double* dy) { model_.rhs(at(t), y, dy); };
    ode.jacobian = [this](double t, const double* y, double* dfdy) {
      model_.jacobian(at(t), y, dfdy);
    };
    ode.event = [this](double t, const double* y, double* g) {
      const double asked = model_.commanded(at(t), y);
      g[0] = asked - threshold(1, 1);
      g[1] = asked + threshold(-1, 1);
    };
    ode.events = 2;
    return ode;
  }

  [[nodiscard]] SolverOptions settings() const {
    const auto scale = [](double s) { return s > 0 && std::isfinite(s) ? s : 1; };
    const double least = 1e-3 * options_.tolerance;
    const double radians = model_.radians_per_unit();
    const double angle = least * scale(radians * size_.range);
    const double speed = least * scale(radians * size_.peak[1]);
    const double torque =
        scale(radians * (model_.inertia() * size_.peak[2] + model_.friction() * size_.peak[1]));
    return {
        Method::bdf,
        options_.tolerance,
        {angle, speed, angle, speed, least * torque, least * torque * torque * (end_ - origin_)},
        closest_,
        options_.max_steps};
  }

  [[nodiscard]] Jet at(double t) const { return piece_.at(origin_ + t); }

  /// The size of torque at which the limit of the given sign is entered or, in that mode, left: a
  /// band of `widths` tolerances about the limit keeps rounding from switching to and fro.
  [[nodiscard]] double threshold(int sign, double widths) const {
    const double band = widths * options_.tolerance;
    return drive_.motor.torque_limit * (model_.mode() == sign ? 1 - band : 1 + band);
  }

  /// One interval of the reference; false if the solver gave up.
  bool follow(const Piece& piece) {
    enter(piece);
    for (;;) {
      const Step step = solver_.step(piece.end - origin_);
      if (step == Step::failed) return false;
      observer_.step(solver_, piece);
      const int mode = mode_after(step);
      if (mode != model_.mode()) {
        change_mode(mode);
        solver_.restart(solver_.time());
      }
      if (step == Step::stop) break;
    }
    before_ = piece.at(piece.end);
    return true;
  }

  /// Locks the reference to the piece. The axis moves on as it is where the reference steps, so the
  /// deviations step.
  void enter(const Piece& piece) {
    piece_ = piece;
    const Jet r = piece.at(piece.begin);
    const auto stepped = [&](std::size_t k, double scale, double share) {
      return !(std::abs(r[k] - before_[k]) <= share * scale);
    };
    const bool first = solver_.integration().restarts == 0;
    const double cap = longest_step * piece.length();
    solver_.limit_step(cap);
    if (first || stepped(0, size_.range, rounding) || stepped(1, size_.peak[1], rounding) ||
        stepped(2, size_.peak[2], smooth) || solver_.next_step() > 2 * cap) {
      const double radians = model_.radians_per_unit();
      auto y = solver_.state();
      y[DriveModel::motor] -= radians * (r[0] - before_[0]);
      y[DriveModel::load] -= radians * (r[0] - before_[0]);
      y[DriveModel::motor_speed] -= radians * (r[1] - before_[1]);
      y[DriveModel::load_speed] -= radians * (r[1] - before_[1]);
      change_mode(mode_after(Step::stop));
      solver_.restart(solver_.time());
    }
  }

  /// The mode that the present state is in. An event tells by its direction; what it cannot see
  /// (two crossings in one step, a start on the limit) tells the torque itself.
  int mode_after(Step step) {
    int mode = model_.mode();
    if (step == Step::event) {
      if (solver_.crossing(0) != 0) return solver_.crossing(0) > 0 ? 1 : 0;
      if (solver_.crossing(1) != 0) return solver_.crossing(1) < 0 ? -1 : 0;
    }
    const double asked = model_.commanded(at(solver_.time()), solver_.state().data());
    if (mode != 0 && mode * asked < threshold(mode, 2)) mode = 0;
    if (mode == 0 && std::abs(asked) > drive_.motor.torque_limit * (1 + 2 * options_.tolerance))
      mode = asked > 0 ? 1 : -1;
    return mode;
  }

  void change_mode(int mode) {
    if (mode == model_.mode()) return;
    const double now = origin_ + solver_.time();
    if (model_.mode() != 0) saturation_.back().to = now;
    if (mode != 0) saturation_.push_back({now, now, mode});
    model_.set_mode(mode);
  }

  void finish_reference(DriveResult& result) {
    const auto y = solver_.state();
    result.rms_torque = std::sqrt(y[DriveModel::torque_squared] / (end_ - origin_));
    result.end_following_error = -y[DriveModel::motor] / model_.radians_per_unit();
  }

  void finish(DriveResult& result) {
    result.integration = solver_.integration();
    result.integration.reached = origin_ + solver_.time();
    accept(result.integration);
    if (model_.mode() != 0) saturation_.back().to = result.integration.reached;
    result.torque = observer_.torque();
    result.following_error = observer_.following_error();
    result.residual = observer_.residual();
    const double speed = model_.radians_per_unit() * size_.peak[1];
    result.residual_frequency = observer_.frequency(options_.tolerance * speed);
    result.saturation = std::move(saturation_);
    result.samples = observer_.take_samples();
  }

  /// A success code proves nothing: the end must be reached, and no interval stepped over.
  void accept(Integration& integration) const {
    if (!integration.ok()) return;
    const double end = end_ + options_.settle;
    if (std::abs(integration.reached - end) > 2 * closest_) {
      integration.reason = "the solver stopped short of the end";
    } else if (integration.steps < 2 * static_cast<long>(pieces_.size())) {
      integration.reason = "fewer steps than two an interval";
    }
    if (!integration.reason.empty()) integration.ended = Ended::failed;
    if (integration.ok()) integration.reached = end;
  }

  const Drive& drive_;
  const DriveOptions& options_;
  double origin_;
  double end_;
  double closest_;
  std::vector<Piece> pieces_;
  Scales size_;
  Standstill standstill_;
  DriveModel model_;
  Piece piece_;
  Jet before_;
  Solver solver_;
  Observer observer_;
  std::vector<Saturation> saturation_;
};

}  // namespace

DriveResult run(const SignalView& reference, const Drive& drive, const DriveOptions& options) {
  return Run(reference, drive, options).result();
}

}  // namespace jounce::detail
