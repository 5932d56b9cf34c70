// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/axes.hpp"

#include <gtest/gtest.h>

#include "jounce/design/detail/version.hpp"

#include "support/errors.hpp"

namespace jounce::axes_test {
namespace {

Input named(const std::string& axis) {
  const Table table(Domain::time, Interpolation::linear, Extrapolation::hold,
                    {.x = {0, 1}, .p = {0, 1}, .v = {}, .a = {}});
  Input input = input_of({table, {"s", "mm"}, {}}, "t.csv");
  input.axis = axis;
  return input;
}

TEST(Axes, AreChosenByName) {
  const std::vector<Input> both{named("x"), named("y")};
  EXPECT_EQ(axes_named(both, "", "f").size(), 2U);
  EXPECT_EQ(axes_named(both, "y", "f").front().axis, "y");
  EXPECT_EQ(test::rule_of([&] { axes_named(both, "z", "f"); }), "must be one of x, y");
  EXPECT_EQ(test::key_of([&] { axes_named({named("x"), named("x")}, "x", "f"); }), "axis");
  EXPECT_EQ(only_axis({named("x")}, "f").axis, "x");
  EXPECT_EQ(test::rule_of([&] { only_axis(both, "-"); }),
            "is missing: standard input has several axes. Choose one of x, y");
}

TEST(Axes, OfTwoFilesArePairedByName) {
  const auto pairs = paired_axes({named("x"), named("y")}, {named("y"), named("x")}, "a", "b");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].second.axis, "x");
  EXPECT_EQ(pairs[1].second.axis, "y");
  EXPECT_EQ(paired_axes({named("x")}, {named("y")}, "a", "b").size(), 1U) << "the only ones";
  EXPECT_EQ(test::rule_of([] {
              paired_axes({named("x"), named("y")}, {named("x")}, "a", "b");
            }),
            "is missing: b has no axis y. Name the axis to compare");
  EXPECT_EQ(test::rule_of([] {
              paired_axes({named("x")}, {named("x"), named("y")}, "a", "b");
            }),
            "is missing: a has no axis y. Name the axis to compare");
  EXPECT_EQ(test::rule_of([] {
              paired_axes({named("x"), named("y")}, {named("")}, "a", "b");
            }),
            "is missing: b has only one axis, without a name; the other file has x, y. Name the "
            "axis to compare");
  const auto mixed = paired_axes({named("x"), named("y")}, {named("")}, "a", "b", "y");
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_EQ(mixed[0].first.axis, "y");
  EXPECT_EQ(mixed[0].second.axis, "");
  EXPECT_EQ(test::rule_of([] { paired_axes({named("x")}, {named("z")}, "a", "b", "q"); }),
            "a has only one axis, without a name: leave out --axis");
}

TEST(Axes, HaveAFileEach) {
  EXPECT_EQ(file_of_axis("feeder.csv", "x"), "feeder-x.csv");
  EXPECT_EQ(file_of_axis("v1.2/feeder", "x"), "v1.2/feeder-x") << "the dot of a folder";
  EXPECT_EQ(file_of_axis("out/.hidden", "x"), "out/.hidden-x");
  EXPECT_EQ(file_of_axis("--table", "feeder.csv", "x", 2), "feeder-x.csv");
  EXPECT_EQ(file_of_axis("--table", "feeder.csv", "x", 1), "feeder.csv") << "the only axis";
  EXPECT_EQ(file_of_axis("--table", "-", "x", 1), "-");
  EXPECT_EQ(test::key_of([] { file_of_axis("--table", "-", "x", 2); }), "--table");
}

}  // namespace
}  // namespace jounce::axes_test
