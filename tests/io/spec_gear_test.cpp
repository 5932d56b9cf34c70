#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/io/make.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string spec(const std::string& gear) {
  return "jounce = 1\nkind = \"gear\"\nunits = { position = \"mm\", master = \"deg\" }\n" + gear;
}

TEST(GearSpec, MakesALineThatGoesOnFromWhereItEnds) {
  const Made made =
      make(parse_spec(spec("[gear]\nnumerator = -4\ndenominator = 3\nmaster_period = 360\n"), "g"));
  const Cam& cam = std::get<Cam>(made.curve);
  EXPECT_EQ(cam.outside(), Outside::advance);
  EXPECT_EQ(cam.jet(90)[0], -120);
  EXPECT_EQ(cam.jet(360e9 + 90)[0], -480e9 - 120);
  EXPECT_EQ(made.segments, std::vector<std::string>{"1 gear"});
  ASSERT_EQ(made.zones.size(), 1U);
}

TEST(GearSpec, RefusesADenominatorOfNought) {
  try {
    parse_spec(spec("[gear]\nnumerator = 1\ndenominator = 0\nmaster_period = 360\n"), "g.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "g.toml:6:15: gear.denominator = 0: must be at least 1");
  }
}

}  // namespace
}  // namespace jounce
