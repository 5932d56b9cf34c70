// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/command_values.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::command_values_test {
namespace {

/// A value of the range that is no default.
double some(const FieldRange& range, double number) {
  for (const double value :
       {-number / 4, number / 4, -number, number, 1 / number, 4.0, 3.0, 2.0, -1.0, 1.0})
    if (broken_rule(range, value).empty()) return value;
  ADD_FAILURE() << "no value is " << range.words;
  return 0;
}

/// True if the words have the number.
bool have(const std::string& words, double number) {
  return words.find(std::to_string(static_cast<std::int64_t>(number))) != std::string::npos;
}

TEST(CommandValues, TheWordsOfARangeHaveItsBounds) {
  for (const CommandInfo& about : all_commands())
    for (const auto& [name, quantity, range] : about.fields) {
      if (!std::isinf(range.least)) {
        EXPECT_TRUE(have(range.words, range.least)) << about.name << ": " << name;
        EXPECT_EQ(broken_rule(range, range.least - 1), "must be " + std::string(range.words));
        EXPECT_EQ(broken_rule(range, range.least).empty(), !range.not_zero || range.least < 0);
      }
      if (!std::isinf(range.most)) {
        EXPECT_TRUE(have(range.words, range.most)) << about.name << ": " << name;
        EXPECT_EQ(broken_rule(range, range.most + 1), "must be " + std::string(range.words));
        EXPECT_EQ(broken_rule(range, range.most), "");
      }
      EXPECT_EQ(broken_rule(range, NAN).empty(), range.may_be_nan) << about.name << ": " << name;
      EXPECT_EQ(broken_rule(range, HUGE_VAL), "must be finite");
      EXPECT_EQ(broken_rule(range, 1), "") << about.name << ": " << name;
    }
}

TEST(CommandValues, EveryFieldHasAPlaceOfItsOwn) {
  for (const CommandInfo& about : all_commands()) {
    if (about.number < 0) continue;
    CommandValues values{};
    for (std::size_t i = 0; i < about.fields.size(); ++i)
      values[i] = some(about.fields[i].range, static_cast<double>(3 + i));
    const bool takes_one = about.kind == CommandKind::cut;
    ASSERT_EQ(contradiction(about.kind, values).empty(), !takes_one) << about.name;
    const ClientCommand command = command_of(about.kind, values);
    EXPECT_EQ(kind_of(command), about.kind);
    EXPECT_EQ(values_of(command), values) << about.name;
  }
}

TEST(CommandValues, DefaultsAreAsConfiguredAndContradictNothing) {
  const CommandValues home = values_of(command::Home{});
  EXPECT_TRUE(std::isnan(home[0]));
  EXPECT_EQ(home[1], 0);
  for (std::size_t i = 2; i < 7; ++i) EXPECT_TRUE(std::isnan(home[i])) << i;
  EXPECT_EQ(home[7], 0);
  for (const CommandInfo& about : all_commands()) {
    if (about.number < 0) continue;
    const bool has_ratio = about.kind == CommandKind::gear_in ||
                           about.kind == CommandKind::gear_in_pos ||
                           about.kind == CommandKind::combine_axes;
    EXPECT_EQ(contradiction(command_of(about.kind)), has_ratio ? "denominator must not be 0" : "")
        << about.name;
  }
}

TEST(CommandValues, AreReadByTheirNames) {
  const ClientCommand command =
      command_of(CommandKind::move_absolute, {120, 200, 1000, 2000, 3e4, -1, 5});
  const auto& move = std::get<command::MoveAbsolute>(command);
  EXPECT_EQ(move.position, 120);
  EXPECT_EQ(move.dynamics.velocity, 200);
  EXPECT_EQ(move.dynamics.acceleration, 1000);
  EXPECT_EQ(move.dynamics.deceleration, 2000);
  EXPECT_EQ(move.dynamics.jerk, 3e4);
  EXPECT_EQ(move.direction, Direction::negative);
  EXPECT_EQ(move.buffer, BufferMode::blending_high);
  EXPECT_TRUE(holds_to_run(command_of(CommandKind::move_velocity, {10, 1, 1, 1, 0, 1})));
  EXPECT_FALSE(holds_to_run(command_of(CommandKind::move_velocity, {10, 1, 1, 1, 0, 0})));
}

// The sentences are those of the refusal bad_order: clients show them.
TEST(CommandValues, OutOfRangeAreNamed) {
  struct Wrong {
    CommandKind kind;
    CommandValues values;
    const char* sentence;
  };
  const double inf = HUGE_VAL;
  const Wrong all[] = {
      {CommandKind::enable, {1}, "enable takes 0 values at most"},
      {CommandKind::halt, {1, 1, -1}, "halt takes 2 values at most"},
      {CommandKind::start_table, {0, 0, 0, 0, 0, 0, 0, 1}, "start_table takes 0 values at most"},
      {CommandKind::set_position, {NAN}, "position must be finite"},
      {CommandKind::set_position, {1, 0.5}, "relative must be 0 or 1"},
      {CommandKind::home, {inf}, "offset must be finite"},
      {CommandKind::home, {NAN, 2.5}, "method must be a whole number from 0 to 2147483647"},
      {CommandKind::home, {NAN, -1}, "method must be a whole number from 0 to 2147483647"},
      {CommandKind::home,
       {NAN, 24, 0},
       "search velocity must be greater than 0; leave it out to use the limit of the axis"},
      {CommandKind::override_, {2.1}, "factor must be 0 to 2"},
      {CommandKind::override_, {-0.1}, "factor must be 0 to 2"},
      {CommandKind::override_, {NAN}, "factor must be finite"},
      {CommandKind::move_absolute, {1, 1, 1, 1, inf}, "jerk must be finite"},
      {CommandKind::move_absolute, {1, 1, 1, 1, 1, 2}, "direction must be -1, 0 or 1"},
      {CommandKind::move_absolute, {1, 1, 1, 1, 1, 0.5}, "direction must be -1, 0 or 1"},
      {CommandKind::move_absolute, {1, 1, 1, 1, 1, 0, 6}, "buffer mode must be 0 to 5"},
      {CommandKind::move_relative, {1, 1, 1, 1, 1, 1.5}, "buffer mode must be 0 to 5"},
      {CommandKind::move_superimposed,
       {1, -1},
       "velocity difference must be greater than 0; leave it out to use the limit of the axis"},
      {CommandKind::move_velocity, {NAN}, "velocity must be finite"},
      {CommandKind::move_velocity, {1, 1, 1, 1, 0, 2}, "hold to run must be 0 or 1"},
      {CommandKind::gear_in,
       {1.5, 1},
       "numerator must be a whole number from -2147483647 to 2147483647"},
      {CommandKind::gear_in, {1, 0}, "denominator must not be 0"},
      {CommandKind::gear_in,
       {1, 2147483648.0},
       "denominator must be a whole number from -2147483647 to 2147483647"},
      {CommandKind::gear_in_pos, {1, 1, 5, 5, 0}, "master start distance must not be 0"},
      {CommandKind::gear_in_pos, {1, 1, 1, 1, 1, 3}, "avoid reversal must be 0 or 1"},
      {CommandKind::gear_in, {1, 1, NAN, NAN, NAN, -1}, "clutch must be 0 or more"},
      {CommandKind::combine_axes, {1, 1, 1, 0}, "denominator of the second master must not be 0"},
      {CommandKind::phasing_absolute, {NAN}, "phase shift must be finite"},
      {CommandKind::move_repetitive, {1, 1, 1, 1, 1, -0.1}, "wait must be 0 or more"},
      {CommandKind::queue_clear, {64, 2}, "bank must be 0 or 1"},
      {CommandKind::queue_end, {-1}, "queue must be a whole number from 0 to 2147483647"},
  };
  for (const auto& [kind, values, sentence] : all) EXPECT_EQ(contradiction(kind, values), sentence);
}

TEST(CommandValues, FieldsOfOneCommandSuitEachOther) {
  EXPECT_EQ(contradiction(command::Cut{.length = 900, .waste = 80}),
            "waste cannot be combined with length: give at most one of length, position, waste");
  EXPECT_EQ(contradiction(command::Cut{.position = 0, .waste = 0}),
            "waste cannot be combined with position: give at most one of length, position, waste");
  EXPECT_EQ(contradiction(command::Cut{.waste = 80}), "");
  EXPECT_EQ(contradiction(command::ChangeVelocity{.velocity = 5, .direction = Direction::negative}),
            "direction has no effect without position: give the position");
  EXPECT_EQ(contradiction(command::ChangeVelocity{
                .velocity = 5, .position = 0, .direction = Direction::negative}),
            "");
}

TEST(CommandValues, AConflictHasTheNamesOfTheCaller) {
  const auto name = [](const Field& field) { return "<" + std::string(field.name) + ">"; };
  const auto cut = field_conflict(CommandKind::cut, 0b011, name);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->field, 1U);
  EXPECT_EQ(cut->rule,
            "cannot be combined with <length>: give at most one of <length>, <position>, <waste>");
  EXPECT_FALSE(cut->missing);
  const auto change = field_conflict(CommandKind::change_velocity, 0b101, name);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->field, 2U);
  EXPECT_EQ(change->rule, "has no effect without <position>");
  EXPECT_EQ(change->missing, 1U);
  EXPECT_FALSE(field_conflict(CommandKind::change_velocity, 0b111, name));
}

TEST(CommandValues, KindsOfTheExecutorAreNoCommandsOfAClient) {
  EXPECT_THROW(static_cast<void>(command_of(CommandKind::arm)), InputError);
  EXPECT_THROW(static_cast<void>(command_of(CommandKind::none)), InputError);
}

}  // namespace
}  // namespace jounce::command_values_test
