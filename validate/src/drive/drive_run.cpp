// SPDX-License-Identifier: Apache-2.0
// The run of a drive along a reference. These rules apply to CVODES. Each is the result of a
// measured failure without it:
//
// - the reference is locked to the interval between two breaks, and every break is a stop;
// - at a step of position, velocity or acceleration the solver restarts; at higher knots it continues
//   (a thousand restarts in a fine table would cost more accuracy than the knots);
// - no step is longer than 0.3 of the interval, and a solver that leaves a long dwell with a longer step
//   restarts: it would step over a short move and report success;
// - a switching element (torque limit, backlash, dry friction) is a mode, set at the start and at every
//   restart, and changed by root finding or by the check after each step;
// - the torque of a sampled controller steps at each of its instants, so each is a stop and a restart.

#include "validate/src/drive/drive_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/drive/heat.hpp"
#include "validate/src/drive/observer.hpp"
#include "validate/src/drive/switches.hpp"
#include "validate/src/linear/course.hpp"
#include "validate/src/linear/locked_reference.hpp"
#include "validate/src/linear/sampled_controller.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::validate_detail {
namespace {

class RunningDrive {
 public:
  RunningDrive(const SignalView& reference, const Drive& drive, const DriveOptions& options,
               const std::vector<double>& start)
      : options_(options),
        origin_(reference.start()),
        end_(reference.end()),
        closest_(shortest_time(origin_, end_ + options.settle)),
        pieces_(pieces(reference, closest_)),
        size_(scales(pieces_)),
        standstill_{pieces_.back().at(end_)[0], {end_, end_ + options.settle}},
        model_(drive),
        run_size_(model_, size_),
        switches_(model_, options.tolerance, run_size_.torque, run_size_.speed),
        begin_(start.empty() ? Jet{pieces_.front().at(origin_)[0], 0, 0, 0}
                             : pieces_.front().at(origin_)),
        reference_(origin_, pieces_.front(), begin_),
        solver_(ode(), settings(), 0, start.empty() ? at_rest() : start),
        observer_(model_, options, origin_, end_ + options.settle - origin_) {
    if (model_.sampled()) sampled_.emplace(model_);
  }

  DriveRun result() {
    bool ok = true;
    for (auto piece = pieces_.begin(); ok && piece != pieces_.end(); ++piece) ok = follow(*piece);
    if (ok) finish_reference();
    if (ok && options_.settle > closest_) {
      observer_.settle(end_);
      const SignalView standstill(standstill_);
      follow({&standstill, end_, end_ + options_.settle});
    }
    const auto state = solver_.state();
    return {finish(), {state.begin(), state.end()}};
  }

 private:
  Ode ode() {
    Ode ode;
    ode.rhs = [this](double t, const double* y, double* dy) { model_.rhs(at(t), y, dy); };
    ode.jacobian = [this](double t, const double* y, double* dfdy) {
      model_.jacobian(at(t), y, dfdy);
    };
    ode.event = [this](double t, const double* y, double* g) { switches_.evaluate(at(t), y, g); };
    ode.events = switches_.events();
    return ode;
  }

  /// Absolute tolerances as shares of the scale of each state. With these, the positions are within 1e-9 of the
  /// stroke (measured against matrix exponentials).
  [[nodiscard]] SolverOptions settings() const {
    const double tolerance = options_.tolerance;
    std::vector<double> absolute(model_.size(), 3e-4 * tolerance * run_size_.torque);
    for (std::size_t i = 0; i < model_.integral(); i += 2) {
      absolute[i] = 3e-4 * tolerance * run_size_.angle;
      absolute[i + 1] = 5e-4 * tolerance * run_size_.speed;
    }
    const double integral = 0.1 * tolerance * (end_ - origin_) * run_size_.torque;
    absolute[model_.torque_squared()] = integral * run_size_.torque;
    absolute[model_.work()] = integral * run_size_.speed;
    // the many restarts of a sampled controller add up
    const double relative = model_.sampled() ? 0.1 * tolerance : tolerance;
    return {Method::bdf, relative, std::move(absolute), closest_, options_.max_steps};
  }

  std::vector<double> at_rest() {
    std::vector<double> y(model_.size());
    model_.rest(begin_, y.data());
    return y;
  }

  const Jet& at(double t) { return reference_.at(t); }

  [[nodiscard]] double next_stop(const SignalPiece& piece) const {
    const double end = piece.end - origin_;
    return sampled_ ? std::min(end, sampled_->next()) : end;
  }

  /// One interval of the reference; false if the solver gave up.
  bool follow(const SignalPiece& piece) {
    if (reference_.enter(piece, size_, model_, switches_, solver_)) {
      static_cast<void>(update());
      solver_.restart(solver_.time());
    }
    for (;;) {
      act();
      const Step step = solver_.step(next_stop(piece));
      if (step == Step::failed) return false;
      observer_.step(solver_, piece);
      if (update(step == Step::event ? solver_.crossings() : std::span<const int>{}))
        solver_.restart(solver_.time());
      if (step == Step::stop && piece.end - origin_ - solver_.time() <= closest_) break;
    }
    reference_.leave();
    return true;
  }

  /// Performs the due actions of the sampled controller.
  void act() {
    if (!sampled_ || sampled_->next() > solver_.time() + closest_) return;
    const int before = model_.mode().torque;
    sampled_->act(solver_.time(), closest_, at(solver_.time()), solver_.state());
    note_saturation(before);
    static_cast<void>(update());
    solver_.restart(solver_.time());
  }

  bool update(std::span<const int> crossed = {}) {
    const int before = model_.mode().torque;
    const bool changed = switches_.update(at(solver_.time()), solver_.state().data(), crossed);
    note_saturation(before);
    return changed;
  }

  void note_saturation(int before) {
    const int mode = model_.mode().torque;
    if (mode == before) return;
    const double now = origin_ + solver_.time();
    if (before != 0) saturation_.back().to = now;
    if (mode == 0) return;
    const double speed = model_.motor_speed(at(solver_.time()), solver_.state().data());
    saturation_.push_back({now, now, mode, model_.weakened(mode, speed)});
  }

  void finish_reference() {
    rms_torque_ = std::sqrt(solver_.state()[model_.torque_squared()] / (end_ - origin_));
    end_following_error_ = -solver_.state()[0] / model_.radians_per_unit();
  }

  DriveResult finish() {
    DriveResult result;
    observer_.finish(options_.tolerance * model_.radians_per_unit() * size_.peak[1], result);
    result.integration = solver_.integration();
    result.integration.reached = origin_ + solver_.time();
    accept(result.integration);
    if (model_.mode().torque != 0) saturation_.back().to = result.integration.reached;
    result.rms_torque = rms_torque_;
    add_current(result, model_.drive().motor, solver_.state()[model_.torque_squared()]);
    result.end_following_error = end_following_error_;
    result.saturation = std::move(saturation_);
    result.impacts = switches_.impacts();
    return result;
  }

  /// A success code proves nothing: checks that the end was reached, and that no interval was stepped over.
  void accept(Integration& integration) const {
    if (!integration.ok()) return;
    const double end = end_ + options_.settle;
    if (std::abs(integration.reached - end) > 2 * closest_) {
      integration.reason = "the solver stopped before the end";
    } else if (integration.steps < 2 * static_cast<long>(pieces_.size())) {
      integration.reason = "fewer than two steps in each interval";
    }
    if (!integration.reason.empty()) integration.ended = Ended::failed;
    if (integration.ok()) integration.reached = end;
  }

  const DriveOptions& options_;
  double origin_;
  double end_;
  double closest_;
  std::vector<SignalPiece> pieces_;
  Scales size_;
  Standstill standstill_;
  DriveModel model_;
  DriveScales run_size_;
  Switches switches_;
  Jet begin_;  // the reference before this instant
  LockedReference reference_;
  OdeSolver solver_;
  Observer observer_;
  std::optional<SampledController> sampled_ = {};
  std::vector<Saturation> saturation_;
  double rms_torque_ = 0;
  double end_following_error_ = 0;
};

}  // namespace

DriveRun run(const SignalView& reference, const Drive& drive, const DriveOptions& options,
             const std::vector<double>& start) {
  return RunningDrive(reference, drive, options, start).result();
}

}  // namespace jounce::validate_detail
