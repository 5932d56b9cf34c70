// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::compare_test {
namespace {

const std::string move =
    "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\", time = \"ms\" }\n"
    "[move]\nprofile = \"trapezoid\"\nto = 30\nvelocity = \"100 mm/s\"\n"
    "acceleration = \"1000 mm/s^2\"\n";

TEST(SpecCompare, ReadsAListInTheSpecsUnits) {
  const Spec spec = parse_spec(move +
                                   "[compare]\nmode = \"linear\"\nstart = 10\nincrement = 1\n"
                                   "count = 11\npulse = \"20 us\"\n"
                                   "device = { sampling_frequency = \"16 kHz\" }\n",
                               "c.toml");
  ASSERT_TRUE(spec.compare);
  EXPECT_EQ(spec.compare->compare.points.size(), 11U);
  EXPECT_NEAR(spec.compare->compare.pulse, 0.02, 1e-15);  // ms
  EXPECT_NEAR(spec.compare->device.sampling_frequency, 16, 1e-12);
  const Made made = make(spec);
  EXPECT_EQ(compared(spec.compare->compare, std::get<Trajectory>(*made.curve)).events.size(), 11U);
}

TEST(SpecCompare, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& compare) {
    return test::error_of([&] { (void)parse_spec(move + compare, "c.toml"); }, "none");
  };
  EXPECT_THAT(complaint("[compare]\nmode = \"fifo_time\"\npulse = 1\n"),
              ::testing::HasSubstr("compare.point: is missing"));
  EXPECT_THAT(
      complaint("[compare]\nmode = \"equal\"\nposition = 1\naxis = \"x\"\n"),
      ::testing::HasSubstr("compare.axis = \"x\": this spec has a single axis: leave axis out"));
  EXPECT_THAT(complaint("[compare]\nmode = \"equal\"\nposition = 1\npulse = 1\n"),
              ::testing::HasSubstr("compare.pulse"));
  EXPECT_EQ(
      complaint("[compare]\nmode = \"linear\"\nstart = 1\nincrement = 0\ncount = 2\npulse = 1\n"),
      "c.toml:12:13: compare.increment = 0 mm: must not be 0: all points would coincide");
}

TEST(SpecCompensation, CorrectsTheMotion) {
  const Spec spec = parse_spec(
      move +
          "[[then]]\noperator = \"compensation\"\n"
          "reference = [{ base = 0, interval = 10, count = 4 }]\nvalues = [0, 0.1, -0.1, 0.2]\n",
      "c.toml");
  const auto curve = std::get<Trajectory>(*make(spec).curve);
  EXPECT_NEAR(curve.jet(curve.end(), Side::left)[0], 30.2, 1e-12);
  EXPECT_EQ(curve.jet(0)[0], 0);
}

const std::string two_axes =
    "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\", time = \"s\" }\n"
    "[[axis]]\nname = \"x\"\nto = 90\nvelocity = 100\nacceleration = 1000\n"
    "[[axis]]\nname = \"y\"\nunit = \"cm\"\nto = 9\nvelocity = 10\nacceleration = 100\n";

TEST(SpecCompensation, CountsInTheAxesOwnUnits) {
  const Spec spec =
      parse_spec(two_axes +
                     "[[then]]\noperator = \"compensation\"\naxis = \"y\"\n"
                     "reference = [{ base = \"0 mm\", interval = \"30 mm\", count = 4 }]\n"
                     "values = [\"0 mm\", \"1 mm\", \"1 mm\", \"0.5 mm\"]\n",
                 "c.toml");
  const auto curve = std::get<Trajectory>(*make_axes(spec).at(1).curve);
  EXPECT_NEAR(curve.jet(curve.end(), Side::left)[0], 9.05, 1e-12);
  EXPECT_NEAR(curve.jet(curve.end() / 2)[0], 4.5 + 0.1, 1e-12);
}

TEST(SpecCompare, CountsInTheAxisOwnUnit) {
  const Spec spec = parse_spec(two_axes +
                                   "[compare]\naxis = \"y\"\nmode = \"equal\"\n"
                                   "position = \"50 mm\"\n",
                               "c.toml");
  EXPECT_EQ(spec.compare->compare.points.at(0).position, 5);
}

TEST(SpecCompensation, StatesTheErrorOfItsFit) {
  const std::string plate =
      two_axes +
      "[[then]]\noperator = \"compensation\"\naxis = \"x\"\nrule = \"cubic\"\n"
      "tolerance = 0.01\nreference = [{ base = 0, interval = 45, count = 3 }, "
      "{ axis = \"y\", base = 0, interval = 4.5, count = 3 }]\n"
      "values = [0, 1, 0, 1, 0, 1, 0, 2, 0]\n";
  const Made rough = std::move(make_axes(parse_spec(plate, "c.toml")).front());
  std::string finer = plate;
  finer.replace(finer.find("tolerance = 0.01"), 16, "tolerance = 1e-9");
  const Made fine = std::move(make_axes(parse_spec(finer, "c.toml")).front());
  const auto& exact = std::get<Trajectory>(*fine.curve);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = exact.end() * i / 1000;
    worst = std::max(worst, std::abs(rough.sampled.table.jet(std::min(t, rough.sampled.table.end()),
                                                             Side::left)[0] -
                                     exact.jet(t, Side::left)[0]));
  }
  EXPECT_LE(worst, rough.sampled.error.position + 1e-9);
}

TEST(SpecCompensation, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& then) {
    return test::error_of(
        [&] {
          (void)make(parse_spec(move + "[[then]]\noperator = \"compensation\"\n" + then, "c.toml"));
        },
        "none");
  };
  EXPECT_THAT(complaint("reference = [{ base = 0, interval = 10, count = 4 }]\n"
                        "values = [0, 0.1, -0.1, 0.2]\nmost = 0.15\n"),
              ::testing::HasSubstr("= 0.2 mm: exceeds the greatest correction, 0.15 mm"));
  EXPECT_THAT(complaint("reference = [{ base = 0, interval = 10, count = 4 }]\nvalues = [0, 1]\n"),
              ::testing::HasSubstr("then[1].values"));
  EXPECT_THAT(complaint("reference = [{ axis = \"y\", base = 0, interval = 10, count = 2 }]\n"
                        "values = [0, 1]\n"),
              ::testing::HasSubstr("must be the name of an axis of this spec"));
}

}  // namespace
}  // namespace jounce::compare_test
