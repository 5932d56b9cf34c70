// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/encoder.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::encoder_test {
namespace {

TEST(Encoder, CountsDown) {
  EncoderReading line({.resolution = 0.5});
  EXPECT_EQ(line(1.25), 1.0);
  EXPECT_EQ(line(-0.1), -0.5);
  EXPECT_TRUE(std::isnan(line(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(EncoderReading()(1.25), 1.25);
}

// 1e5 samples: the mean to 5 sigma of its own, the variance to 5 of its own, sqrt(2 / n).
TEST(Encoder, NoiseIsWhiteNormalAndTheSameForASeed) {
  EncoderReading a({.noise = 2, .seed = 9}), b({.noise = 2, .seed = 9}), c({.noise = 2, .seed = 8});
  constexpr int n = 100'000;
  double sum = 0, square = 0, lagged = 0, before = 0;
  int beyond = 0, other = 0;
  for (int i = 0; i < n; ++i) {
    const double x = a(0) / 2;
    ASSERT_EQ(2 * x, b(0));
    other += 2 * x != c(0);
    sum += x;
    square += x * x;
    lagged += x * before;
    before = x;
    beyond += std::abs(x) > 2;
  }
  EXPECT_EQ(other, n);
  EXPECT_LT(std::abs(sum / n), 5 / std::sqrt(n));
  EXPECT_NEAR(square / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_LT(std::abs(lagged / n), 5 / std::sqrt(n));
  EXPECT_NEAR(beyond / double{n}, 0.0455, 5 * std::sqrt(0.0455 / n)) << "erfc(sqrt(2))";
}

TEST(Encoder, RejectsMagnitudesThatAreNone) {
  EXPECT_THROW(EncoderReading({.resolution = -1}), InputError);
  EXPECT_THROW(EncoderReading({.noise = NAN}), InputError);
}

/// A drive that returns preset feedback.
class Puppet final : public AxisDrive {
 public:
  void command(const DriveSetpoint& setpoint) noexcept override { told = setpoint.position; }
  Feedback feedback() noexcept override {
    ++asked;
    return says;
  }
  Feedback says;
  double told = 0;
  int asked = 0;
};

TEST(ObservedDrive, IsReadOnceACycleAndIgnoredInAFault) {
  const auto puppet = std::make_shared<Puppet>();
  ObservedDrive drive(puppet);
  EXPECT_TRUE(std::isnan(drive.position()));
  puppet->says.position = 5;
  EXPECT_EQ(drive.feedback().position, 5);
  EXPECT_EQ(drive.position(), 5);
  EXPECT_EQ(drive.position(), 5);
  EXPECT_EQ(puppet->asked, 1);
  drive.command({.position = 7});
  EXPECT_EQ(puppet->told, 7);
  puppet->says.fault = true;
  EXPECT_EQ(drive.feedback().position, 5) << "the axis gets all of it";
  EXPECT_TRUE(std::isnan(drive.position())) << "a follower uses no position of a faulty drive";
}

}  // namespace
}  // namespace jounce::encoder_test
