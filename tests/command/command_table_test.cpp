// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/detail/command_table.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/command/command_values.hpp"

#include "support/page_table.hpp"

namespace jounce::command_table_test {
namespace {

std::string unit_of(Quantity quantity) {
  constexpr const char* units[] = {"",   " u", " u/s", " u/s²", " u/s³",
                                   " m", " s", " m/s", " m/s²", " m/s³"};
  return units[static_cast<std::size_t>(quantity)];
}

/// The commands in the order of their numbers on the wire.
std::vector<const CommandInfo*> sent() {
  return {sent_commands().begin(), sent_commands().end()};
}

std::string words_of(const FieldRange& range) {
  const std::string words = range.words;
  if (!range.not_zero || range.least >= 0) return words;
  return words.empty() ? "not 0" : words + ", not 0";
}

/// Number of fields from this one on that have the same name: coordinates.
std::size_t equal_from(const Fields& fields, std::size_t first) {
  std::size_t count = 1;
  while (first + count < fields.size() &&
         std::string(fields[first + count].name) == fields[first].name)
    ++count;
  return count;
}

TEST(CommandTable, NumbersEveryCommandOfAClientOnce) {
  EXPECT_EQ(sent().size(), std::variant_size_v<ClientCommand>);
  int last = -1;
  for (const CommandInfo* const row : sent()) {
    EXPECT_EQ(kind_of(command_of(row->kind)), row->kind) << row->name;
    EXPECT_EQ(kind_of_number(row->number), row->kind);
    EXPECT_GT(row->number, std::exchange(last, row->number)) << row->name;
  }
  EXPECT_FALSE(kind_of_number(-1));
  EXPECT_FALSE(kind_of_number(last + 1));
}

TEST(CommandTable, OperatorsChangeTheTimingAlone) {
  std::string operators;
  for (const CommandInfo* const row : sent())
    if (is_operators(row->kind)) operators += std::string(row->name) + " ";
  EXPECT_EQ(operators, "hold resume override group_set_override group_acknowledge ");
}

TEST(CommandTable, IsThatOfTheProtocolPage) {
  const std::string heading = "| kind | command | PLCopen | sent by | values |";
  std::string table = heading + "\n|---|---|---|---|---|\n";
  for (const CommandInfo* const row : sent()) {
    std::string values;
    for (std::size_t i = 0; i < row->fields.size(); ++i) {
      const Field& field = row->fields[i];
      const std::size_t alike = equal_from(row->fields, i);
      const std::string range = words_of(field.range);
      values += (values.empty() ? "" : "; ") + (alike > 1 ? std::to_string(alike) + " x " : "") +
                std::string(field.name) + unit_of(field.quantity) +
                (range.empty() ? "" : " (" + range + ")");
      i += alike - 1;
    }
    table += "| " + std::to_string(row->number) + " | " + row->name + " | " + row->plcopen + " | " +
             (row->sender == CommandSender::anyone ? "anyone" : "owner") + " | " + values + " |\n";
  }
  EXPECT_EQ(test::table_in("stream-protocol.md", heading), table);
}

}  // namespace
}  // namespace jounce::command_table_test
