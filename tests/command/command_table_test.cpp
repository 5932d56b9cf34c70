// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/command_table.hpp"

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/command/command_values.hpp"

namespace jounce::command_table_test {
namespace {

std::string unit_of(Quantity quantity) {
  constexpr const char* units[] = {"",   " u", " u/s", " u/s²", " u/s³",
                                   " m", " s", " m/s", " m/s²", " m/s³"};
  return units[static_cast<std::size_t>(quantity)];
}

std::vector<std::string> lines_of(const std::string& page) {
  std::ifstream file(std::string(JOUNCE_SOURCE_DIR) + "/docs/" + page);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The table of a page that begins with this line.
std::string table_in(const std::string& page, const std::string& heading) {
  std::string table;
  for (const std::string& line : lines_of(page))
    if (table.empty() ? line == heading : line.rfind('|', 0) == 0)
      table += line + "\n";
    else if (!table.empty())
      break;
  return table;
}

/// The commands in the order of their numbers on the wire.
std::vector<const CommandInfo*> sent() {
  return {sent_commands().begin(), sent_commands().end()};
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
      const std::string range = words(field.range);
      values += (values.empty() ? "" : "; ") + (alike > 1 ? std::to_string(alike) + " x " : "") +
                std::string(field.name) + unit_of(field.quantity) +
                (range.empty() ? "" : " (" + range + ")");
      i += alike - 1;
    }
    table += "| " + std::to_string(row->number) + " | " + row->name + " | " + row->plcopen + " | " +
             (row->sender == CommandSender::anyone ? "anyone" : "owner") + " | " + values + " |\n";
  }
  EXPECT_EQ(table_in("stream-protocol.md", heading), table);
}

TEST(CommandTable, IsThatOfThePageOfJounceOrder) {
  const std::string heading = "| `jounce order AXIS ...` | options | command | PLCopen |";
  std::string table = heading + "\n|---|---|---|---|\n";
  for (const CommandInfo* const row : sent()) {
    if (*row->word == 0) continue;
    std::string options;
    std::string before;
    for (const Field& field : row->fields) {
      const std::string name = field.option;
      if (name == before) continue;  // a ratio, or coordinates
      before = name;
      options += (options.empty() ? "" : " ") + (name == "VALUE" ? name : "`--" + name + "`");
    }
    table += std::string("| ") + row->word + " | " + options + " | " + row->name + " | " +
             row->plcopen + " |\n";
  }
  EXPECT_EQ(table_in("executor/orders.md", heading), table);
}

}  // namespace
}  // namespace jounce::command_table_test
