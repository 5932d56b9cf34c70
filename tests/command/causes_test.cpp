// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/detail/causes.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/command/commands.hpp"
#include "jounce/command/detail/refusal_text.hpp"

namespace jounce::causes_test {
namespace {

using testing::ElementsAreArray;
using testing::EndsWith;

/// "stopped = 80", for each enumerator of the header.
std::vector<std::string> enumerators() {
  std::ifstream header(JOUNCE_SOURCE_DIR "/command/include/jounce/command/cause.hpp");
  std::vector<std::string> found;
  for (std::string line; std::getline(header, line);)
    if (std::smatch m; std::regex_match(line, m, std::regex("  (\\w+ = \\d+),")))
      found.push_back(m[1]);
  return found;
}

TEST(Causes, EachHasItsEntry) {
  std::vector<std::string> entries;
  for (const CauseInfo& one : all_causes())
    entries.push_back(std::string(one.name) + " = " + std::to_string(static_cast<int>(one.cause)));
  EXPECT_GT(entries.size(), 60U);
  auto wanted = enumerators();
  std::sort(wanted.begin(), wanted.end());
  std::sort(entries.begin(), entries.end());
  EXPECT_THAT(entries, ElementsAreArray(wanted));
}

TEST(Causes, EachHasASentenceAndARemedy) {
  for (const CauseInfo& one : all_causes()) {
    EXPECT_THAT(one.meaning, EndsWith(".")) << one.name;
    EXPECT_THAT(one.remedy, EndsWith(".")) << one.name;
    EXPECT_STREQ(meaning(one.cause), one.meaning);
  }
}

TEST(Causes, ARemedyOfAnOrderSuitsItsKind) {
  EXPECT_EQ(remedy_of_order(Cause::position_limit, CommandKind::move_velocity),
            "Jog in the other direction.");
  EXPECT_EQ(remedy_of_order(Cause::position_limit, CommandKind::move_absolute),
            "Give a position inside the range.");
  EXPECT_EQ(remedy_of_order(Cause::acceleration_limit, CommandKind::gear_in),
            "Give a longer --clutch, or slow the master down.");
  EXPECT_EQ(remedy_of_order(Cause::not_enabled, CommandKind::home),
            "Enable it: `jounce order NAME enable`.");
  EXPECT_EQ(remedy_of_order(Cause::no_movement, CommandKind::hold),
            "Nothing moves: no hold is needed.");
  EXPECT_EQ(remedy_of_order(Cause::no_movement, CommandKind::finish), "Start a motion first.");
  EXPECT_THAT(remedy_of_order(Cause::not_a_group, CommandKind::group_set_override),
              testing::HasSubstr("`jounce order NAME override 50%`"));
  EXPECT_EQ(remedy_of_order(Cause::not_a_group, CommandKind::group_wait),
            "Send the command to a group.");
  EXPECT_EQ(remedy_of_order(Cause::no_compensation, CommandKind::disable_compensation),
            "Nothing is compensated: no disable-compensation is needed.");
  EXPECT_THAT(remedy_of_order(Cause::no_compensation, CommandKind::enable_compensation),
              testing::HasSubstr("Add [compensation]"));
  EXPECT_EQ(remedy_of_order(Cause::compensation_active, CommandKind::enable_compensation),
            "No enable-compensation is needed.");
  EXPECT_EQ(remedy_of_order(Cause::single_axis, CommandKind::set_position).find("move-linear"),
            std::string::npos);
  EXPECT_EQ(remedy_of_order(Cause::no_master_input, CommandKind::gear_in).find("table"),
            std::string::npos);
  EXPECT_THAT(remedy_of_table(Cause::no_master_input), testing::HasSubstr("as a table over time"));
  for (const CauseInfo& one : all_causes()) {
    EXPECT_EQ(remedy_of_order(one.cause, CommandKind::move_absolute).find("For a table"),
              std::string::npos)
        << one.name;
    EXPECT_FALSE(remedy_of_table(one.cause).empty()) << one.name;
  }
}

TEST(Causes, AValueBesideItsLimitShowsTheDifference) {
  EXPECT_THAT(text(Refusal{Cause::jerk_limit, 50000.04, 50000, 1.5}, "mm"),
              EndsWith(": 50000.04 mm/s^3 at 1.5 s, limit 50000 mm/s^3."));
  EXPECT_THAT(text(Refusal{Cause::velocity_limit, 300.0000000001, 300}, "mm"),
              EndsWith(": 300.0000000001 mm/s, limit 300 mm/s."));
  EXPECT_THAT(text(Refusal{Cause::position_limit, 600.0000000001, 600}, "mm"),
              EndsWith(": 600.0000000001 mm, limit 600 mm."));
  EXPECT_THAT(text(Refusal{Cause::start_position, 12.3456791, 12.345678}, "mm"),
              EndsWith("it begins at 12.3456791 mm; the axis would start it at 12.345678 mm."));
  EXPECT_THAT(text(Refusal{Cause::start_position, 20, 12.345678}, "mm"),
              EndsWith("it begins at 20 mm; the axis would start it at 12.3457 mm."));
  EXPECT_THAT(text(Refusal{Cause::velocity_limit, 400, 300}, "mm"),
              EndsWith(": 400 mm/s, limit 300 mm/s."));
}

// text() writes six digits, or more beside the limit.
TEST(Causes, TheValueIsReadFromTheTextWithItsLimit) {
  for (const CauseInfo& one : all_causes())
    for (const std::string unit : {"", "mm", "user units"})
      for (const double value : {900.0, -1234.5678, 1e300, 3.5e-300, 500.0000001})
        for (const double where : {1.25, std::numeric_limits<double>::quiet_NaN()}) {
          const std::string all = text(Refusal{one.cause, value, 500, where}, unit);
          const auto read = refused_value(all);
          EXPECT_EQ(read.has_value(),
                    all.find(", limit ") != std::string::npos && one.cause != Cause::no_reserve)
              << all;
          // Near 0, the text shows 0.
          EXPECT_NEAR(read.value_or(value), value, 5e-6 * std::abs(value) + 1e-9) << all;
        }
  EXPECT_FALSE(refused_value("the axis is moving: send 5 mm").has_value());
  EXPECT_FALSE(refused_value(", limit 5").has_value());
}

// A move to this place must be within the tolerance of the group: six digits were too few.
TEST(Causes, ThePlaceOfAnAxisOfAGroupHasItsDigits) {
  EXPECT_THAT(remedy_of_order(Cause::axis_away, CommandKind::start),
              testing::HasSubstr("order NAME move-linear"));
  const std::vector<std::string> axes{"x"};
  EXPECT_THAT(text(Refusal{Cause::axis_away, 5.87051263, 8.02011724, 1}, "mm", "", axes),
              EndsWith(" x is at 5.87051 mm instead of 8.02011724 mm."));
  EXPECT_THAT(text(Refusal{Cause::axis_away, 0, 1234.5678912, 1}, "mm", "", axes),
              EndsWith(" x is at 0 mm instead of 1234.5678912 mm."));
}

TEST(Causes, TextsHaveTheNumbersOfTheRejection) {
  EXPECT_EQ(
      text(Refusal{Cause::too_late, 5, 123456789}, "mm"),
      "too_late: The requested start tick has passed: tick 5; the axis is at tick 123456789.");
  EXPECT_EQ(text(Refusal{Cause::no_such_move, 5, 20, 0}, "mm"),
            "no_such_move: No move from the present state to that target keeps the limits and the "
            "direction: 5 mm is not in this direction from 20 mm.");
  EXPECT_EQ(text(Refusal{Cause::no_reserve, 8000, 8000, 2}, "mm"),
            "no_reserve: The present motion leaves no reserve for a superimposed move: "
            "acceleration or deceleration 8000 mm/s^2, limit 8000 mm/s^2.");
  EXPECT_THAT(text(Refusal{Cause::no_reserve, 2000, 2000, 5}, "mm"),
              EndsWith(": deceleration 2000 mm/s^2, limit 2000 mm/s^2, which is the default."));
  EXPECT_THAT(text(Refusal{Cause::no_reserve, 2000, 1500, 4}, "mm"),
              EndsWith(": acceleration 2000 mm/s^2, limit 1500 mm/s^2."));
  EXPECT_THAT(remedy_of_order(Cause::no_reserve, CommandKind::move_superimposed),
              ::testing::HasSubstr("--deceleration"));
  EXPECT_EQ(text(Refusal{Cause::no_such_move, 5}, "mm"),
            "no_such_move: No move from the present state to that target keeps the limits and the "
            "direction.");
}

}  // namespace
}  // namespace jounce::causes_test
