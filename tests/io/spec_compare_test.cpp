#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/io/make.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
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
  EXPECT_EQ(compared(spec.compare->compare, std::get<Trajectory>(made.curve)).events.size(), 11U);
}

TEST(SpecCompare, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& compare) {
    try {
      (void)parse_spec(move + compare, "c.toml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(complaint("[compare]\nmode = \"fifo_time\"\npulse = 1\n"),
              ::testing::HasSubstr("compare.point: is missing"));
  EXPECT_THAT(complaint("[compare]\nmode = \"equal\"\nposition = 1\naxis = \"x\"\n"),
              ::testing::HasSubstr("compare.axis = \"x\": must name one of the spec's axes"));
  EXPECT_THAT(complaint("[compare]\nmode = \"equal\"\nposition = 1\npulse = 1\n"),
              ::testing::HasSubstr("compare.pulse"));
}

TEST(SpecCompensation, CorrectsTheMotion) {
  const Spec spec = parse_spec(
      move +
          "[[then]]\noperator = \"compensation\"\n"
          "reference = [{ base = 0, interval = 10, count = 4 }]\nvalues = [0, 0.1, -0.1, 0.2]\n",
      "c.toml");
  const auto curve = std::get<Trajectory>(make(spec).curve);
  EXPECT_NEAR(curve.jet(curve.end(), Side::left)[0], 30.2, 1e-12);
  EXPECT_EQ(curve.jet(0)[0], 0);
}

TEST(SpecCompensation, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& then) {
    try {
      (void)make(parse_spec(move + "[[then]]\noperator = \"compensation\"\n" + then, "c.toml"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(complaint("reference = [{ base = 0, interval = 10, count = 4 }]\n"
                        "values = [0, 0.1, -0.1, 0.2]\nmost = 0.15\n"),
              ::testing::HasSubstr("= 0.2: is beyond the greatest correction, 0.15"));
  EXPECT_THAT(complaint("reference = [{ base = 0, interval = 10, count = 4 }]\nvalues = [0, 1]\n"),
              ::testing::HasSubstr("then[1].values"));
  EXPECT_THAT(complaint("reference = [{ axis = \"y\", base = 0, interval = 10, count = 2 }]\n"
                        "values = [0, 1]\n"),
              ::testing::HasSubstr("must name one of the spec's axes"));
}

}  // namespace
}  // namespace jounce
