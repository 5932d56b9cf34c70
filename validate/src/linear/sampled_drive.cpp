// SPDX-License-Identifier: Apache-2.0
// A linear drive under a sampled controller. Between two instants at which the torque changes, the
// drive is autonomous, x' = A x with the commanded torque T_c as a constant state, and is solved by
// an exponential. At t_k = start + k cycle the controller reads the angle and computes
//
//     (1)  w_k = (th_k - th_(k-1)) / cycle                                    0 at the first
//     (2)  e_k = K_p (th_r - th_k) + k_v w_r - w_k
//     (3)  T_k = K_v e_k + z_k + k_a J a_r + k_f b w_r                        output at t_k + delay
//     (4)  z_(k+1) = z_k + K_v e_k cycle / T_i
//
// At one instant (to rounding) the order is: reading, torque, output. At a break the reference is
// its right limit. After its end it stands still.

#include "validate/src/linear/sampled_drive.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>

#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/ladder.hpp"

namespace jounce::validate_detail {
namespace {

constexpr double same_instant = 1e-9;  // share of a cycle

class SampledRun {
 public:
  SampledRun(const Trajectory& reference, const Drive& drive)
      : reference_(reference),
        drive_(drive),
        k_(drive.controller),
        radians_(2 * std::numbers::pi / drive.position_per_rev),
        system_(balanced(open_drive(drive))),
        ladder_(system_, 2, {}, k_.cycle),
        z_(ladder_.zero()),
        origin_(reference.jet(reference.start())[0]),
        slack_(same_instant * k_.cycle) {
    ladder_.place(Segment{}, 0, z_);
    const OpenRest rest = open_rest(drive);
    const auto set = [&](Eigen::Index state, double value) {
      z_(state) = value / system_.scale(state);
    };
    for (std::size_t i = 0; i < rest.angles.size(); ++i)
      set(static_cast<Eigen::Index>(i), rest.angles[i]);
    for (Eigen::Index i = 2 * static_cast<Eigen::Index>(rest.angles.size()); i < system_.states();
         ++i)
      set(i, rest.torque);  // commanded, and given by the current loop
    if (k_.integral_time > 0) integral_ = rest.torque;
  }

  ExactRun along(std::span<const double> times) {
    const double end = reference_.end();
    std::size_t next = 0;
    bool ended = false;
    while (next < times.size() || !ended) {
      const double output = next < times.size() ? times[next] : forever;
      const double stop = ended ? forever : end;
      const double now = std::min({reading(), switching(), stop, output});
      go_to(now, !ended);
      if (reading() <= now + slack_) read();
      if (switching() <= now + slack_) switch_torque();
      if (stop <= now + slack_) ended = true, finish();
      if (output <= now + slack_) run_.samples.push_back(sample(times[next++]));
    }
    return std::move(run_);
  }

 private:
  static constexpr double forever = std::numeric_limits<double>::infinity();

  [[nodiscard]] double instant(double cycles) const {
    return reference_.start() + cycles * k_.cycle;
  }
  [[nodiscard]] double reading() const { return instant(readings_); }
  [[nodiscard]] double switching() const {
    return given_ < readings_ ? instant(given_) + k_.delay : forever;
  }

  /// Times are relative to the start, so that errors do not accumulate.
  void go_to(double t, bool within) {
    const double step = t - reference_.start() - gone_;
    if (step <= 0) return;
    gone_ += ladder_.advance(z_, step, std::span(&square_, within ? 1 : 0));
  }

  [[nodiscard]] Jet reference_at(double t) const {
    if (t >= reference_.end() - slack_) return {end_position(), 0, 0, 0};
    const auto breaks = reference_.breaks();
    const auto after = std::lower_bound(breaks.begin(), breaks.end(), t - slack_);
    return reference_.jet(*after <= t + slack_ ? *after : t);
  }

  [[nodiscard]] double end_position() const {
    return reference_.jet(reference_.end(), Side::left)[0];
  }

  [[nodiscard]] double output(DriveRow row) const { return ladder_.outputs().row(row).dot(z_); }

  void read() {
    const Jet r = reference_at(reading());
    const double angle = output(motor_row);
    const double speed = readings_ == 0 ? 0 : (angle - angle_) / k_.cycle;         // (1)
    const double error = k_.position_gain * (radians_ * (r[0] - origin_) - angle)  // (2)
                         + k_.velocity_feed_forward * radians_ * r[1] - speed;
    commands_.push_back(k_.velocity_gain * error + integral_  // (3)
                        + k_.torque_feed_forward * total_inertia(drive_) * radians_ * r[2] +
                        k_.friction_feed_forward * total_friction(drive_) * radians_ * r[1]);
    if (k_.integral_time > 0)
      integral_ += k_.velocity_gain * error * k_.cycle / k_.integral_time;  // (4)
    angle_ = angle;
    ++readings_;
  }

  void switch_torque() {
    z_(system_.states() - 1) = commands_.front() / system_.scale(system_.states() - 1);
    commands_.pop_front();
    ++given_;
  }

  void finish() {
    run_.rms_torque = std::sqrt(std::max(0.0, square_.sum) / reference_.length());
    run_.end_following_error = end_position() - origin_ - output(motor_row) / radians_;
  }

  [[nodiscard]] DriveSample sample(double t) const {
    const double r = t < reference_.end() ? reference_.jet(t)[0] : end_position();
    const double motor = origin_ + output(motor_row) / radians_;
    return {t,
            r,
            motor,
            origin_ + output(load_row) / radians_,
            output(torque_row),
            r - motor,
            output(velocity_row)};
  }

  const Trajectory& reference_;
  const Drive& drive_;
  const Controller& k_;
  double radians_;
  LinearSystem system_;
  Ladder ladder_;
  Eigen::VectorXd z_;
  double origin_;
  double slack_;
  double gone_ = 0;
  ProductIntegral square_{torque_row, torque_row};
  double readings_ = 0;  // made so far
  double given_ = 0;     // commands output so far
  double angle_ = 0;
  double integral_ = 0;
  std::deque<double> commands_;
  ExactRun run_;
};

}  // namespace

ExactRun sampled_run(const Trajectory& reference, const Drive& drive,
                     std::span<const double> times) {
  return SampledRun(reference, drive).along(times);
}

}  // namespace jounce::validate_detail
