// SPDX-License-Identifier: Apache-2.0
// The run of a drive with forward sensitivities. The equations are those of DriveModel, and their
// derivatives by the state are its Jacobian. Derivatives by the logarithm of a parameter p are
// central differences of the right-hand side alone,
//
//     (1)  df/d(log p) = (f(p e^h) - f(p e^-h)) / 2h,    h = 6e-6
//
// with errors of order h^2 and of rounding / h, both about 1e-11. Runs of the integrator are not
// differenced: the errors of its steps would be larger than the differences.
//
// A mode changes when an event function g(t, y; p) crosses zero, at an instant that depends on p.
// With f- and f+ the right-hand sides before and after it, the sensitivities step (Rozenvasser,
// Avtomatika i Telemekhanika 1967; Galan, Feehery, Barton, Appl. Numer. Math. 31, 1999):
//
//     (2)  dt*/dp = -(dg/dy s + dg/dp) / (dg/dt along f-),      s+ = s- + (f- - f+) dt*/dp
//
// If the right-hand side is continuous (at a torque limit, or when a flank touches), the step is
// zero. If dry friction stops a body, its speed no longer depends on p. At a step of the reference,
// the deviations step by an amount that does not depend on p.

#include "validate/src/drive/drive_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/drive/switches.hpp"
#include "validate/src/linear/course.hpp"
#include "validate/src/linear/locked_reference.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::validate_detail {
namespace {

constexpr double difference = 6e-6;  // (1)
/// A model with its switches, which refer to it, so it cannot be moved.
struct Switched {
  DriveModel model;
  DriveScales scales;
  Switches switches;

  Switched(const Drive& drive, double tolerance, const Scales& of)
      : model(drive), scales(model, of), switches(model, tolerance, scales.torque, scales.speed) {}
  Switched(const Switched&) = delete;
  Switched& operator=(const Switched&) = delete;
};

class ResponseRun {
 public:
  ResponseRun(const SignalView& reference, const ResponseSpec& spec)
      : spec_(spec),
        origin_(reference.start()),
        closest_(shortest_time(origin_, std::max(reference.end(), spec.times.back()))),
        pieces_(pieces(reference, closest_)),
        size_(scales(pieces_)),
        standstill_{pieces_.back().at(reference.end())[0], {reference.end(), spec.times.back()}},
        held_(standstill_),
        here_(with_numbers(*spec.start, spec.keys, spec.values), spec.tolerance, size_),
        model_(here_.model),
        n_(model_.size()),
        begin_{pieces_.front().at(origin_)[0], 0, 0, 0},
        reference_(origin_, pieces_.front(), begin_),
        solver_(ode(), settings(), 0, at_rest()) {
    if (standstill_.end() - standstill_.start() > closest_)
      pieces_.push_back({&held_, standstill_.start(), standstill_.end()});
    events_[0].resize(static_cast<std::size_t>(here_.switches.events()));
    events_[1] = events_[2] = events_[0];
    move_numbers();
    answer_.value.assign(outputs, std::vector<double>(spec.times.size()));
    answer_.by.assign(outputs, std::vector<double>(spec.times.size() * spec.keys.size()));
    s_.resize(n_ * spec.keys.size());
    for (auto& scratch : scratch_) scratch.resize(n_);
  }

  DriveResponse result() {
    for (const SignalPiece& piece : pieces_)
      if (next_ < spec_.times.size() && !follow(piece)) break;
    answer_.integration = solver_.integration();
    answer_.integration.reached = origin_ + solver_.time();
    if (answer_.integration.ok() && next_ < spec_.times.size()) {
      answer_.integration.ended = Ended::failed;
      answer_.integration.reason = "the solver stopped before the end";
    }
    return std::move(answer_);
  }

 private:
  Ode ode() {
    Ode ode;
    ode.rhs = [this](double t, const double* y, double* dy) { model_.rhs(at(t), y, dy); };
    ode.jacobian = [this](double t, const double* y, double* dfdy) {
      model_.jacobian(at(t), y, dfdy);
    };
    ode.by_parameter = [this](double t, const double* y, double* dfdp) {
      const Jet& r = at(t);
      for (std::size_t j = 0; j < up_.size(); ++j) {
        double* column = dfdp + j * n_;
        up_[j]->model.rhs(r, y, column);
        down_[j]->model.rhs(r, y, scratch_[0].data());
        for (std::size_t i = 0; i < n_; ++i)
          column[i] = (column[i] - scratch_[0][i]) / (2 * difference);  // (1)
      }
    };
    ode.parameters.assign(spec_.keys.size(), 1);
    ode.event = [this](double t, const double* y, double* g) {
      here_.switches.evaluate(at(t), y, g);
    };
    ode.events = here_.switches.events();
    return ode;
  }

  [[nodiscard]] SolverOptions settings() const {
    const double least = 1e-3 * spec_.tolerance;
    std::vector<double> absolute(n_, least * here_.scales.torque);
    for (std::size_t i = 0; i < model_.integral(); i += 2) {
      absolute[i] = least * here_.scales.angle;
      absolute[i + 1] = least * here_.scales.speed;
    }
    for (std::size_t i = model_.torque_squared(); i < n_; ++i)
      absolute[i] = std::numeric_limits<double>::max();  // integrals without a tolerance
    return {Method::bdf, spec_.tolerance, std::move(absolute), closest_, 10'000'000};
  }

  std::vector<double> at_rest() {
    std::vector<double> y(n_);
    model_.rest(begin_, y.data());
    return y;
  }

  /// The models with changed numbers, and the sensitivities of the equilibrium at the start.
  void move_numbers() {
    std::vector<double> y(n_), other(n_);
    const auto moved = [&](std::size_t j, double by) {
      std::vector<double> values(spec_.values.begin(), spec_.values.end());
      values[j] *= std::exp(by);
      return std::make_unique<Switched>(with_numbers(*spec_.start, spec_.keys, values),
                                        spec_.tolerance, size_);
    };
    for (std::size_t j = 0; j < spec_.keys.size(); ++j) {
      up_.push_back(moved(j, difference));
      down_.push_back(moved(j, -difference));
      up_[j]->model.rest(begin_, y.data());
      down_[j]->model.rest(begin_, other.data());
      for (std::size_t i = 0; i < n_; ++i)
        solver_.sensitivity(j)[i] = (y[i] - other[i]) / (2 * difference);
    }
    share_mode();
  }

  void share_mode() {
    for (const auto& all : {&up_, &down_})
      for (const auto& other : *all) other->model.mode() = model_.mode();
  }

  const Jet& at(double t) { return reference_.at(t); }

  bool follow(const SignalPiece& piece) {
    enter(piece);
    for (;;) {
      const Step step = solver_.step(piece.end - origin_);
      if (step == Step::failed) return false;
      sample(piece);
      update(step == Step::event);
      if (step == Step::stop || next_ == spec_.times.size()) break;
    }
    reference_.leave();
    return true;
  }

  void enter(const SignalPiece& piece) {
    const bool anew = reference_.enter(piece, size_, model_, here_.switches, solver_);
    if (anew) static_cast<void>(here_.switches.update(at(solver_.time()), solver_.state().data()));
    share_mode();
    if (anew) solver_.restart(solver_.time());
  }

  /// Modes after a step; where they change the run begins anew.
  void update(bool event) {
    const double t = solver_.time();
    auto y = solver_.state();
    if (event) prepare_step_of_sensitivities();
    const auto crossed = event ? solver_.crossings() : std::span<const int>{};
    const std::vector<int> keep(crossed.begin(), crossed.end());
    model_.rhs(at(t), y.data(), scratch_[0].data());  // f-
    if (!here_.switches.update(at(t), y.data(), keep)) return;
    model_.rhs(at(t), y.data(), scratch_[1].data());  // f+
    for (std::size_t j = 0; event && j < up_.size(); ++j) {
      auto s = solver_.sensitivity(j);
      for (std::size_t i = 0; i < n_; ++i)
        s[i] += (scratch_[0][i] - scratch_[1][i]) * moves_[j];  // (2)
    }
    share_mode();
    solver_.restart(t);
  }

  /// (2): dt*/dp of the event that the step ended with.
  void prepare_step_of_sensitivities() {
    moves_.assign(up_.size(), 0);
    const auto crossed = solver_.crossings();
    const auto event = static_cast<std::size_t>(
        std::find_if(crossed.begin(), crossed.end(), [](int c) { return c != 0; }) -
        crossed.begin());
    if (event == crossed.size()) return;
    const double rate = event_rate(event);
    if (rate == 0) return;
    const Jet& r = at(solver_.time());
    const auto y = solver_.state();
    for (std::size_t j = 0; j < up_.size(); ++j) {
      const auto s = solver_.sensitivity(j);
      for (std::size_t i = 0; i < n_; ++i) {
        scratch_[0][i] = y[i] + difference * s[i];
        scratch_[1][i] = y[i] - difference * s[i];
      }
      up_[j]->switches.evaluate(r, scratch_[0].data(), events_[0].data());
      down_[j]->switches.evaluate(r, scratch_[1].data(), events_[1].data());
      moves_[j] = -(events_[0][event] - events_[1][event]) / (2 * difference) / rate;
    }
  }

  /// dg/dt along the run just before now, by a one-sided difference of second order within the step.
  double event_rate(std::size_t event) {
    const double now = solver_.time();
    const double h = 1e-3 * (now - solver_.before());
    if (!(h > 0)) return 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double t = now - static_cast<double>(k) * h;
      solver_.interpolate(t, scratch_[0]);
      here_.switches.evaluate(at(t), scratch_[0].data(), events_[k].data());
    }
    return (3 * events_[0][event] - 4 * events_[1][event] + events_[2][event]) / (2 * h);
  }

  /// The samples within the step just made.
  void sample(const SignalPiece& piece) {
    for (; next_ < spec_.times.size(); ++next_) {
      const double t = spec_.times[next_] - origin_;
      if (t > solver_.time() + closest_) return;
      take(std::clamp(t, solver_.before(), solver_.time()), piece);
    }
  }

  void take(double t, const SignalPiece& piece) {
    auto& y = scratch_[0];
    solver_.interpolate(t, y);
    solver_.interpolate_sensitivities(t, s_);
    const Jet r = piece.at(origin_ + t);
    const double unit = 1 / model_.radians_per_unit();
    const std::size_t load_angle = model_.load();
    answer_.value[position][next_] = y[0] * unit;
    answer_.value[velocity][next_] = y[1] * unit + r[1];
    answer_.value[torque][next_] = model_.torque(r, y.data());
    answer_.value[load][next_] = y[load_angle] * unit;
    for (std::size_t j = 0; j < up_.size(); ++j) {
      const double* s = s_.data() + j * n_;
      const std::size_t to = j * spec_.times.size() + next_;
      answer_.by[position][to] = s[0] * unit;
      answer_.by[velocity][to] = s[1] * unit;
      answer_.by[torque][to] = torque_by(j, r, y, s);
      answer_.by[load][to] = s[load_angle] * unit;
    }
  }

  /// d torque / d log p_j along the run: the number and the state move together.
  double torque_by(std::size_t j, const Jet& r, const std::vector<double>& y, const double* s) {
    auto& a = scratch_[1];
    auto& b = scratch_[2];
    for (std::size_t i = 0; i < n_; ++i) {
      a[i] = y[i] + difference * s[i];
      b[i] = y[i] - difference * s[i];
    }
    return (up_[j]->model.torque(r, a.data()) - down_[j]->model.torque(r, b.data())) /
           (2 * difference);
  }

  const ResponseSpec& spec_;
  double origin_;
  double closest_;
  std::vector<SignalPiece> pieces_;
  Scales size_;
  Standstill standstill_;
  SignalView held_;
  Switched here_;
  DriveModel& model_;
  std::size_t n_;
  std::vector<std::unique_ptr<Switched>> up_ = {}, down_ = {};
  Jet begin_;  // the reference before this instant
  LockedReference reference_;
  std::array<std::vector<double>, 3> scratch_ = {}, events_ = {};
  std::vector<double> moves_ = {};
  OdeSolver solver_;
  std::vector<double> s_ = {};
  std::size_t next_ = 0;
  DriveResponse answer_ = {};
};

}  // namespace

Drive with_numbers(const Drive& start, std::span<const std::string> keys,
                   std::span<const double> values) {
  Drive drive = start;
  for (const DriveNumber& number : numbers(drive))
    for (std::size_t j = 0; j < keys.size(); ++j)
      if (number.key == keys[j]) *number.value = values[j];
  drive.controller.torque_feed_forward *= DriveModel(start).inertia() / DriveModel(drive).inertia();
  return drive;
}

DriveResponse respond(const SignalView& reference, const ResponseSpec& spec) {
  return ResponseRun(reference, spec).result();
}

}  // namespace jounce::validate_detail
