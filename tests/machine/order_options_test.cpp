// SPDX-License-Identifier: Apache-2.0
#include "machine/src/operate/order_options.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/page_table.hpp"

namespace jounce::order_options_test {
namespace {

TEST(OrderOptions, EachEntryIsOfAField) {
  std::set<const FieldOption*> used;
  for (const CommandInfo* const row : sent_commands())
    if (*row->word != 0)
      for (const Field& field : row->fields) used.insert(&field_option(*row, field));
  EXPECT_EQ(used.size(), field_options().size()) << "an entry of no field, or a second one";
}

TEST(OrderOptions, ARangeOfWordsIsInsideTheRangeOfItsField) {
  for (const CommandInfo* const row : sent_commands()) {
    if (*row->word == 0) continue;
    for (const Field& field : row->fields) {
      const auto& range = field_option(*row, field).range;
      if (!range) continue;
      EXPECT_GE(range->least, field.range.least) << row->name << ": " << field.name;
      EXPECT_LE(range->most, field.range.most) << row->name << ": " << field.name;
      EXPECT_EQ(range->whole, field.range.whole) << row->name << ": " << field.name;
      if (field.range.not_zero) {
        EXPECT_TRUE(range->not_zero) << row->name << ": " << field.name;
      }
    }
  }
}

TEST(OrderOptions, AreThoseOfThePageOfJounceOrder) {
  const std::string heading = "| `jounce order AXIS ...` | options | command | PLCopen |";
  std::string table = heading + "\n|---|---|---|---|\n";
  for (const CommandInfo* const row : sent_commands()) {
    if (*row->word == 0) continue;
    std::string options;
    std::string before;
    for (const Field& field : row->fields) {
      const std::string name = field_option(*row, field).option;
      if (name == before) continue;  // a ratio, or coordinates
      before = name;
      options += (options.empty() ? "" : " ") + (name == "VALUE" ? name : "`--" + name + "`");
    }
    table += std::string("| ") + row->word + " | " + options + " | " + row->name + " | " +
             row->plcopen + " |\n";
  }
  EXPECT_EQ(test::table_in("executor/orders.md", heading), table);
}

}  // namespace
}  // namespace jounce::order_options_test
