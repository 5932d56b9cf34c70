// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/inverse.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::inverse_test {
namespace {

using testing::HasSubstr;

/// 40 mm by the 3-4-5 law over 0 to 120 deg, a hold, and back over 180 to 300 deg.
Input pusher() {
  return read_inputs(JOUNCE_SOURCE_DIR "/examples/cam-algebra/last-year.toml").front();
}

double poly345(double z) {
  return z * z * z * (10 + z * (-15 + 6 * z));
}

TEST(InverseOfACam, ListsAllPlacesOfASlavePosition) {
  const auto places = places_of_slave(pusher(), "2 cm");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0].master.from, 60, 1e-12);
  EXPECT_EQ(places[0].segment, "1 push");
  EXPECT_NEAR(places[1].master.from, 240, 1e-12);
  const auto held = places_of_slave(pusher(), "40");
  ASSERT_EQ(held.size(), 1U);
  EXPECT_EQ(held[0].master.from, 120);
  EXPECT_EQ(held[0].master.to, 180);
  EXPECT_TRUE(places_of_slave(pusher(), "41").empty());
  EXPECT_EQ(test::key_of([] { (void)places_of_slave(pusher(), "2 deg"); }), "slave");
}

TEST(InverseOfACam, ItsTableKeepsTheTolerance) {
  const Input inverse =
      inverse_of(pusher(), {.at = "60 deg", .from = "1", .to = "39 mm", .tolerance = "0.01 deg"});
  EXPECT_EQ(inverse.table.units.x, "mm");
  EXPECT_EQ(inverse.table.units.position, "deg");
  const Cam table = inverse.table.table.curve<OverMaster>();
  double worst = 0;
  for (double y = 1; y <= 39; y += 0.01) {
    const double master = table.at(y).position;
    // Distance from the true inverse, by one step of Newton's method from so near.
    const double slope = 40 * 30 * std::pow(master / 120 * (1 - master / 120), 2) / 120;
    worst = std::max(worst, std::abs((40 * poly345(master / 120) - y) / slope));
  }
  EXPECT_GT(worst, 1e-5);
  EXPECT_LE(worst, inverse.error->position * (1 + 1e-6));
  EXPECT_LE(inverse.error->position, 0.01);
}

TEST(InverseOfACam, ErrorsNameTheOptionAndWhatToDo) {
  const auto error = [](const InverseTexts& texts) {
    return test::error_of([&] { (void)inverse_of(pusher(), texts); }, "no error");
  };
  EXPECT_EQ(
      error({}),
      "at: is missing: the cam has 2 rises and falls. Give a master position inside the one that "
      "you need (0 to 120, 180 to 300 deg), such as 60 deg");
  EXPECT_EQ(error({.at = "330"}),
            "at = 330 deg: must lie in a rise or fall of the slave, 0 to 120, 180 to 300 deg");
  EXPECT_EQ(
      error({.at = "60"}),
      "from: is missing: the rise or fall begins where the slave is at rest, so the slope of the "
      "inverse is infinite: give a position between 0 and 40 mm");
  EXPECT_EQ(error({.at = "60", .from = "0"}),
            "from = 0 mm: is where the slave is at rest, so the slope of the inverse is infinite: "
            "give a position between 0 and 40 mm");
  EXPECT_EQ(error({.at = "60", .from = "1", .to = "41"}),
            "to = 41 mm: must lie within the rise or fall, 0 to 40 mm");
  EXPECT_EQ(error({.at = "60", .from = "5", .to = "4"}),
            "to = 4 mm: must be greater than --from = 5 mm");
  EXPECT_EQ(error({.at = "60", .from = "1", .to = "2", .tolerance = "-1"}),
            "tolerance = -1: must be greater than 0");
}

TEST(InverseOfACam, TheAnswerDependsOnWhatIsAsked) {
  const InverseAnswer branches = inverse_answer(pusher(), "", "", {});
  EXPECT_THAT(branches.text, HasSubstr("the inverse has 2 branches\n"
                                       "  rise from 0 to 120 deg: slave 0 to 40 mm\n"
                                       "  fall from 180 to 300 deg: slave 0 to 40 mm\n"));
  EXPECT_FALSE(branches.table);
  const InverseAnswer places = inverse_answer(pusher(), "20mm", "", {});
  EXPECT_EQ(places.text, "60 deg (segment 1 push)\n240 deg (segment 3 return)\n");
  EXPECT_FALSE(inverse_answer(pusher(), "50mm", "", {}).found);
  const InverseAnswer table =
      inverse_answer(pusher(), "", "x.csv", {.at = "60", .from = "1", .to = "39"});
  ASSERT_TRUE(table.table);
  EXPECT_THAT(table.text, HasSubstr("pusher, inverse of the rise: "));
  const Input move = read_inputs(JOUNCE_SOURCE_DIR "/examples/generators/03-move.toml").front();
  EXPECT_EQ(test::key_of([&] { (void)inverse_answer(move, "", "", {}); }), "FILE");
}

}  // namespace
}  // namespace jounce::inverse_test
