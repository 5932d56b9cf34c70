#include "jounce/validate/detail/drive_model.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace jounce::detail {
namespace {

constexpr std::size_t size = DriveModel::size;

TEST(DriveModel, JacobianIsTheDerivativeOfTheRightHandSide) {
  const Jet reference{3, 50, -700, 0};
  const DriveModel::Values at{0.1, -2, 0.11, 3, 0.2, 0.05};
  for (const double integral_time : {0.0, 0.02})
    for (const int mode : {-1, 0, 1}) {
      Drive drive = servo_400w();
      drive.controller.integral_time = integral_time;
      drive.controller.velocity_feed_forward = 0.8;
      DriveModel model(drive);
      model.set_mode(mode);
      std::array<double, size * size> jacobian{};
      model.jacobian(reference, at.data(), jacobian.data());
      for (std::size_t column = 0; column < size; ++column) {
        const double h = 1e-4;  // the right-hand side is quadratic: central differences are exact
        DriveModel::Values above = at;
        DriveModel::Values below = at;
        above[column] += h;
        below[column] -= h;
        DriveModel::Values f{};
        DriveModel::Values g{};
        model.rhs(reference, above.data(), f.data());
        model.rhs(reference, below.data(), g.data());
        for (std::size_t row = 0; row < size; ++row) {
          const double slope = (f[row] - g[row]) / (2 * h);
          EXPECT_NEAR(jacobian[column * size + row], slope, 1e-6 * (1 + std::abs(slope)))
              << row << ", " << column << ", mode " << mode;
        }
      }
    }
}

}  // namespace
}  // namespace jounce::detail
