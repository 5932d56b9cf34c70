// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/drive_model.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace jounce::validate_detail {
namespace {

constexpr Jet reference{3, 50, -700, 0};

/// Everything at once: four bodies, gaps, all friction, gravity, a gear, delay, lag, pendulum.
Drive everything() {
  Drive drive = servo_400w();
  drive.motor.friction = {1e-4, 0.02, 0.03, 2};
  drive.motor.rated_velocity = 1;
  drive.motor.max_velocity = 30;
  drive.motor.current_lag = 1e-4;
  drive.controller.velocity_feed_forward = 0.8;
  drive.controller.friction_feed_forward = 1;
  drive.controller.delay = 2e-3;
  Mass& load = drive.train[0];
  load.backlash = 0.01;
  load.efficiency = 0.9;
  load.friction = {1e-4, 0.1, 0.2, 5};
  load.load_torque = 0.3;
  load.gravity_torque = 0.4;
  load.gravity_angle = 0.5;
  load.gravity_ratio = 0.7;
  drive.train.push_back(drive.train[0]);
  drive.train[1].stiffness = 30;
  drive.pendulum = Pendulum{5, 0.1, 0.4};
  return drive;
}

void expect_jacobian(DriveModel& model, const std::string& what) {
  const std::size_t size = model.size();
  std::vector<double> at(size);
  for (std::size_t i = 0; i < size; ++i) at[i] = 0.1 * std::sin(1.0 + 2.7 * static_cast<double>(i));
  std::vector<double> jacobian(size * size, 0.0);
  model.jacobian(reference, at.data(), jacobian.data());
  for (std::size_t column = 0; column < size; ++column) {
    const double h = 1e-5;
    std::vector<double> above = at;
    std::vector<double> below = at;
    above[column] += h;
    below[column] -= h;
    std::vector<double> f(size);
    std::vector<double> g(size);
    model.rhs(reference, above.data(), f.data());
    model.rhs(reference, below.data(), g.data());
    for (std::size_t row = 0; row < size; ++row) {
      const double slope = (f[row] - g[row]) / (2 * h);
      EXPECT_NEAR(jacobian[column * size + row], slope, 1e-6 * (1 + std::abs(slope)) + 1e-4)
          << row << ", " << column << ", " << what;
    }
  }
}

TEST(DriveModel, JacobianIsTheDerivativeOfTheRightHandSide) {
  for (const double integral_time : {0.0, 0.02})
    for (const int torque : {-1, 0, 1}) {
      Drive drive = servo_400w();
      drive.controller.integral_time = integral_time;
      drive.controller.velocity_feed_forward = 0.8;
      DriveModel model(drive);
      model.mode().torque = torque;
      expect_jacobian(model, "torque " + std::to_string(torque));
    }
}

TEST(DriveModel, JacobianOfEverythingAtOnceToo) {
  for (const int torque : {-1, 0, 1})
    for (const int slip : {-1, 0, 1})
      for (const int contact : {-1, 0, 1}) {
        DriveModel model(everything());
        model.mode() = {torque, 1, {slip, slip, slip, 0}, {0, contact, -contact, 0}};
        expect_jacobian(model,
                        std::to_string(torque) + std::to_string(slip) + std::to_string(contact));
      }
}

TEST(DriveModel, JacobianOfASampledDrive) {
  Drive drive = everything();
  drive.controller.cycle = 1e-3;
  drive.motor.current_lag = 0;
  DriveModel model(drive);
  model.hold(0.5);
  expect_jacobian(model, "sampled");
}

TEST(DriveModel, RestIsAnEquilibrium) {
  for (const double integral_time : {0.0, 0.02}) {
    Drive drive = everything();
    drive.controller.integral_time = integral_time;
    DriveModel model(drive);
    std::vector<double> y(model.size());
    model.rest({90, 0, 0, 0}, y.data());
    for (std::size_t i = 0; i < model.train().size(); ++i)
      EXPECT_NEAR(model.net(i, {90, 0, 0, 0}, y.data()), 0, 1e-12) << i;
    std::vector<double> dy(model.size());
    model.rhs({90, 0, 0, 0}, y.data(), dy.data());
    for (std::size_t i = 0; i < model.torque_squared(); ++i) EXPECT_NEAR(dy[i], 0, 1e-8) << i;
  }
}

}  // namespace
}  // namespace jounce::validate_detail
