// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plot/samples.hpp"

namespace jounce::findings_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

Labels labels() {
  return {{"pulse", "pulse"}, true, {}};
}

TEST(FindingsTable, PutsTheBrokenFirstAndMarksThem) {
  const DataTable table =
      findings_table(check(pmc600_cam(), pmc600_look().limits), labels(), "limits");
  EXPECT_EQ(table.caption, "limits");
  EXPECT_THAT(table.columns, ElementsAre("rule", "segment", "at", "value", "limit", "unit",
                                         "margin", "what to change"));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_TRUE(table.rows[0].broken);
  EXPECT_TRUE(table.rows[1].broken);
  // PMC600 manual, Fig. 6.14, segment 3: 3.392270802 is 13.1 % above 3.
  const auto& cells = table.rows[0].cells;
  EXPECT_EQ(cells[0], "limit/geo_velocity");
  EXPECT_EQ(cells[1], "3");
  EXPECT_EQ(cells[3], "−3.39227");
  EXPECT_EQ(cells[4], "−3");
  EXPECT_EQ(cells[5], "pulse/pulse");
  EXPECT_EQ(cells[6], "−13.1 %");
  EXPECT_EQ(table.rows[1].cells[5], "pulse/pulse²");
}

TEST(FindingsTable, LeavesOutEmptyColumns) {
  const DataTable table = findings_table(check(trapezoid_move(), {.velocity = 20}), {});
  EXPECT_THAT(table.columns, Not(Contains("of")));
  EXPECT_THAT(table.columns, Not(Contains("what to change")));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].cells.size(), table.columns.size());
  EXPECT_FALSE(table.rows[0].broken);
  EXPECT_TRUE(findings_table({}, {}).rows.empty());
}

TEST(FindingsVerdict, Counts) {
  EXPECT_EQ(verdict(check(pmc600_cam(), pmc600_look().limits)).text, "2 of 2 findings are broken.");
  EXPECT_FALSE(verdict(check(pmc600_cam(), {.velocity = 3})).ok);
  EXPECT_EQ(verdict(check(pmc600_cam(), {.velocity = 4})).text, "All checks hold (1).");
  EXPECT_TRUE(verdict(check(pmc600_cam(), {.velocity = 4})).ok);
  EXPECT_EQ(verdict({}).text, "Nothing was checked.");
}

}  // namespace
}  // namespace jounce::findings_test
