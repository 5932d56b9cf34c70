// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {
namespace {

using enum NumberRule;

constexpr const char* inertia_unit = "kg m^2";
constexpr const char* damping = "N m s/rad";

/// Collects the numbers of one part after another.
class Collector {
 public:
  void enter(std::string part) { part_ = std::move(part); }

  void add(const char* key, const char* unit, double& value, NumberRule rule = not_negative) {
    found_.push_back({part_ + key, unit, &value, rule});
  }

  void add(Friction& f) {
    add("friction.viscous", damping, f.viscous);
    add("friction.coulomb", "N m", f.coulomb);
    add("friction.breakaway", "N m", f.breakaway);
    add("friction.stribeck_velocity", "rad/s", f.stribeck_velocity);
  }

  [[nodiscard]] std::vector<DriveNumber> take() { return std::move(found_); }

 private:
  std::string part_;
  std::vector<DriveNumber> found_;
};

void add(Collector& all, Motor& m) {
  all.enter("motor.");
  all.add("inertia", inertia_unit, m.inertia, positive);
  all.add(m.friction);
  all.add("torque_limit", "N m", m.torque_limit, positive);
  all.add("rated_torque", "N m", m.rated_torque);
  all.add("rated_velocity", "rad/s", m.rated_velocity);
  all.add("max_velocity", "rad/s", m.max_velocity);
  all.add("torque_constant", "N m/A", m.torque_constant);
  all.add("resistance", "ohm", m.resistance);
  all.add("thermal_time", "s", m.thermal_time);
  all.add("current_lag", "s", m.current_lag);
}

void add(Collector& all, Mass& m, std::size_t number) {
  all.enter("mass[" + std::to_string(number) + "].");
  all.add("stiffness", "N m/rad", m.stiffness);
  all.add("damping", damping, m.damping);
  all.add("backlash", "rad", m.backlash);
  all.add("efficiency", "1", m.efficiency, share);
  all.add("inertia", inertia_unit, m.inertia, positive);
  all.add(m.friction);
  all.add("load_torque", "N m", m.load_torque, any);
  all.add("gravity_torque", "N m", m.gravity_torque, any);
  all.add("gravity_angle", "rad", m.gravity_angle, any);
  all.add("gravity_ratio", "1", m.gravity_ratio, any);
}

void add(Collector& all, Pendulum& p) {
  all.enter("pendulum.");
  all.add("frequency", "Hz", p.frequency, positive);
  all.add("damping", "1", p.damping);
  all.add("share", "1", p.share, share);
}

void add(Collector& all, Controller& c) {
  all.enter("controller.");
  all.add("position_gain", "1/s", c.position_gain, positive);
  all.add("velocity_gain", damping, c.velocity_gain, positive);
  all.add("integral_time", "s", c.integral_time);
  all.add("velocity_feed_forward", "1", c.velocity_feed_forward);
  all.add("torque_feed_forward", "1", c.torque_feed_forward);
  all.add("friction_feed_forward", "1", c.friction_feed_forward);
  all.add("cycle", "s", c.cycle);
  all.add("delay", "s", c.delay);
  all.add("encoder_counts", "1/rev", c.encoder_counts);
}

void require(const DriveNumber& number) {
  switch (const char* key = number.key.c_str(); number.rule) {
    case any:
      return require_finite(key, *number.value);
    case not_negative:
      return require_not_negative(key, *number.value);
    case positive:
      return require_positive(key, *number.value);
    case share: {
      const bool whole = number.key != "pendulum.share";  // not the whole of a mass may swing
      const bool good = *number.value > 0 && (whole ? *number.value <= 1 : *number.value < 1);
      if (!good)
        throw InputError(
            number.key, *number.value,
            std::string("must be greater than 0 and ") + (whole ? "at most 1" : "less than 1"));
    }
  }
}

void require_valid(const std::string& part, const Friction& f) {
  if (f.breakaway != 0 && f.breakaway < f.coulomb)
    throw InputError(
        part + "friction.breakaway", f.breakaway,
        "must be at least coulomb = " + number(f.coulomb) + ", or 0 for the same value");
}

/// Relations between two numbers.
void require_valid(const Motor& m) {
  require_valid("motor.", m.friction);
  if (m.max_velocity != 0 && !(m.max_velocity > m.rated_velocity))
    throw InputError("motor.max_velocity", m.max_velocity,
                     "must be greater than rated_velocity = " + number(m.rated_velocity));
  if (m.thermal_time != 0 && m.rated_torque == 0)
    throw InputError("motor.thermal_time", m.thermal_time,
                     "needs rated_torque: add it, or leave thermal_time out");
  if (m.resistance != 0 && m.torque_constant == 0)
    throw InputError("motor.resistance", m.resistance,
                     "needs torque_constant: add it, or leave resistance out");
}

void require_valid(const Mass& m, const std::string& part) {
  require_valid(part, m.friction);
  if (m.stiffness > 0) return;
  const auto need_shaft = [&](const char* key, double value, double none) {
    if (value != none)
      throw InputError(
          part + key, value,
          std::string("needs stiffness, without which the mass is rigid: add it, or leave ") + key +
              " out");
  };
  need_shaft("damping", m.damping, 0);
  need_shaft("backlash", m.backlash, 0);
  need_shaft("efficiency", m.efficiency, 1);
}

}  // namespace

std::vector<DriveNumber> numbers(Drive& drive) {
  Collector all;
  add(all, drive.motor);
  for (std::size_t i = 0; i < drive.train.size(); ++i) add(all, drive.train[i], i + 1);
  add(all, drive.controller);
  if (drive.pendulum) add(all, *drive.pendulum);
  all.enter("");
  all.add("position_per_rev", "u/rev", drive.position_per_rev, positive);
  return all.take();
}

void require_valid(const Drive& drive) {
  Drive copy = drive;  // numbers() returns places to write to
  for (const DriveNumber& number : numbers(copy)) require(number);
  require_valid(drive.motor);
  for (std::size_t i = 0; i < drive.train.size(); ++i)
    require_valid(drive.train[i], "mass[" + std::to_string(i + 1) + "].");
  if (drive.pendulum && drive.train.empty())
    throw InputError("pendulum.share", drive.pendulum->share,
                     "needs a mass from which the pendulum hangs");
  if (drive.controller.encoder_counts != 0 && drive.controller.cycle == 0)
    throw InputError(
        "controller.encoder_counts", drive.controller.encoder_counts,
        "needs cycle, because only a sampled controller has encoder counts: add it, or leave "
        "encoder_counts out");
}

Drive wittenstein_premo_2d() {
  Drive drive;
  Motor& m = drive.motor;
  m.inertia = 0.83e-4;
  m.torque_limit = 5.53;
  m.rated_torque = 1.46;
  m.rated_velocity = 2490 / 5.53;                     // the greatest power at the peak torque
  m.max_velocity = 7023 * 2 * std::numbers::pi / 60;  // without load
  m.torque_constant = 0.52;
  m.resistance = 1.5 * 3.72;  // three phases with half the resistance between the terminals
  m.thermal_time = 17.4 * 60;
  drive.controller.position_gain = 40;
  drive.controller.velocity_gain = 200 * 2 * m.inertia;
  drive.controller.integral_time = 0.02;
  drive.position_per_rev = 360;
  return drive;
}

Drive servo_400w() {
  Drive drive;
  drive.motor.inertia = 4e-5;
  drive.motor.friction.viscous = 1e-4;
  drive.motor.torque_limit = 3.8;
  Mass load;
  load.stiffness = 50;
  load.damping = 5e-3;
  load.inertia = 2e-4;
  load.friction.viscous = 1e-4;
  drive.train = {load};
  drive.controller.position_gain = 40;
  drive.controller.velocity_gain = 0.05;
  drive.controller.integral_time = 0.02;
  drive.position_per_rev = 360;
  return drive;
}

}  // namespace jounce
