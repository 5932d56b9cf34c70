// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/comparison.hpp"

#include <gmock/gmock.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::comparison_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Version version(double top, const Units& units = {"deg", "mm"}, double size = 1) {
  const Cam cam({quintic(120, 0, 0, 0, top * size, 0, 0), line(240, top * size, top * size)}, 0,
                Extrapolation::hold);
  return {"cam", cam, {units, true, {}}};
}

TEST(Comparison, EqualVersionsAreEqual) {
  const Comparison same = compare(version(50), version(50));
  EXPECT_TRUE(same.equal());
  EXPECT_THAT(to_text(same), HasSubstr("equal except for rounding"));
}

TEST(Comparison, ConvertsUnitsAndReportsIt) {
  const Comparison c = compare(version(50), version(50, {"deg", "m"}, 1e-3));
  for (const Change& change : c.changes) EXPECT_TRUE(change.none());
  ASSERT_EQ(c.remarks.size(), 1U);
  EXPECT_EQ(c.remarks[0].what, "unit of the position");
  EXPECT_FALSE(c.equal());
  EXPECT_THROW((void)compare(version(50), version(50, {"deg", "s"})), InputError);
  EXPECT_TRUE(compare(version(50, {"", ""}), version(50)).equal()) << "unknown units do not count";
}

TEST(Comparison, ConvertsLimits) {
  Version before = version(50);
  Version after = version(50, {"rad", "mm"});
  before.limits = Limits{.velocity = 1, .jerk = 1};
  const Version rad = in_units(before, after.labels.units);
  const double deg = 57.295779513082323;
  EXPECT_NEAR(*rad.limits->velocity, deg, 1e-13);
  EXPECT_NEAR(*rad.limits->jerk, deg * deg * deg, 1e-9);
  EXPECT_NEAR(std::get<Cam>(rad.curve).end(), 360 / deg, 1e-14);
}

TEST(Comparison, ToleranceIsAShareOrANumberOfAQuantity) {
  const Version a = version(50);
  const Version b = version(50.05);  // a thousandth more
  EXPECT_FALSE(compare(a, b).equal());
  EXPECT_TRUE(compare(a, b, {.share = 1.01e-3}).equal());
  EXPECT_FALSE(compare(a, b, {.share = 0.99e-3}).equal());
  EXPECT_TRUE(compare(a, b, {.of = {0.051}}).equal()) << "the other quantities are not judged";
  EXPECT_FALSE(compare(a, b, {.of = {0.049}}).equal());
  EXPECT_FALSE(compare(a, b, {.share = 0, .of = {0.051}}).equal()) << "now they are";
}

TEST(Comparison, NamesChangedTexts) {
  Version before = version(50);
  Version after = version(50);
  before.limits = Limits{.position_max = 60, .velocity = 1};
  after.limits = Limits{.velocity = 1.5};
  after.curve = with(std::get<Cam>(after.curve), Extrapolation::refuse);
  const Comparison c = compare(before, after);
  EXPECT_FALSE(c.equal());
  const std::string text = to_text(c);
  EXPECT_THAT(text, HasSubstr("! outside: hold -> refuse"));
  EXPECT_THAT(text, HasSubstr("! limit position_max: 60 mm -> none"));
  EXPECT_THAT(text, HasSubstr("! limit geo_velocity: 1 mm/deg -> 1.5 mm/deg"));
  after.limits = std::nullopt;
  EXPECT_THAT(to_text(compare(before, after)), Not(HasSubstr("limit")));
}

TEST(Comparison, DistinguishesNumbers) {
  const std::string text = to_text(compare(version(50), version(50.0000001)));
  EXPECT_THAT(text, HasSubstr("50 -> 50.0000001"));
  EXPECT_THAT(text, HasSubstr("~ knot 2 at 120 deg, position 50 -> 50.0000001"));
}

TEST(Comparison, OfTheSpecThatAKnotWasMovedIn) {
  Spec spec = read_spec(JOUNCE_SOURCE_DIR "/examples/pmc600-cam/cam.toml");
  const Cam before = std::get<Cam>(*make(spec).curve);
  std::get<CamSpec>(spec.subject).segments[2].end.slave = 95;
  const Cam after = std::get<Cam>(*make(spec).curve);
  const Labels labels{spec.units, true, {}};
  const Comparison c = compare({"a", before, labels}, {"b", after, labels});
  EXPECT_DOUBLE_EQ(c.changes[0].largest.value, -5);
  EXPECT_NEAR(c.changes[0].largest.where, 280, 1e-6);
  ASSERT_EQ(c.knots.size(), 1U);
  EXPECT_THAT(to_json(c), HasSubstr("\"what\":\"changed\",\"before\":{\"knot\":4"));
}

TEST(Comparison, OfDifferentAxesIsRejected) {
  const Trajectory move({line(1, 0, 1)});
  EXPECT_THROW((void)compare(version(50), {"move", move, {{"s", "mm"}, false, {}}}), InputError);
}

}  // namespace
}  // namespace jounce::comparison_test
