// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/play_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::play_plan_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

/// Over time in ms: 0, 10, 4 mm.
Input three_points() {
  Columns columns{.x = {0, 1000, 2000}, .p = {5, 15, 9}, .v = {}, .a = {}};
  const Table table(Domain::time, Interpolation::linear, Extrapolation::hold, std::move(columns));
  return input_of({table, {"ms", "mm"}, {}}, "three.csv");
}

TEST(StreamPlan, ATableOverTimeIsInSeconds) {
  StreamPlan plan = stream_plan("feeder", three_points(), {});
  ASSERT_EQ(plan.tables.size(), 1U);
  EXPECT_EQ(plan.executor, "feeder");
  EXPECT_EQ(plan.tables[0].table.end(), 2);
  EXPECT_EQ(plan.tables[0].units.x, "s");
  EXPECT_EQ(plan.mode, wire::ArmMode::play);
  add_swap(plan, three_points(), {});
  ASSERT_EQ(plan.swaps.size(), 1U);
  EXPECT_EQ(plan.swaps[0].slave, 1U) << "behind the first table";
}

TEST(StreamPlan, ACamBringsItsMasterOrFollowsALiveOne) {
  const Input cam = read_inputs(examples + "pmc600-cam/cam.toml").front();
  const StreamPlan own = stream_plan("feeder", cam, {});
  EXPECT_EQ(own.mode, wire::ArmMode::follow_table);
  ASSERT_EQ(own.tables.size(), 2U);
  EXPECT_EQ(own.tables[1].table.axis(), Domain::time);
  const StreamPlan live = stream_plan("feeder", cam, {.live = true, .keep_velocity = true});
  EXPECT_EQ(live.mode, wire::ArmMode::follow_input);
  EXPECT_EQ(live.tables.size(), 1U);
  EXPECT_EQ(live.end, CamEnd::keep_velocity);
  EXPECT_EQ(stream_plan("feeder", cam, {.live = true}).end, CamEnd::brake);
}

// Two blades: the cam advances by half a turn in each cut, and all cuts are equal.
TEST(StreamPlan, ACamOfARotatingKnifeMayBeginAtAnyCut) {
  const auto made = [](Extrapolation outside, const char* unit, const PlayOptions& options) {
    Columns columns{.x = {0, 170}, .p = {0, 180}, .v = {}, .a = {}};
    const Table table(Domain::master, Interpolation::linear, outside, std::move(columns));
    return stream_plan("knife", input_of({table, {"mm", unit}, {}}, "knife.csv"), options)
        .coupling.slave_period;
  };
  const PlayOptions at_master{.live = true, .at_master = true};
  EXPECT_EQ(made(Extrapolation::advance, "deg", at_master), 180);
  EXPECT_EQ(made(Extrapolation::advance, "deg", {.live = true}), std::nullopt);
  EXPECT_EQ(made(Extrapolation::advance, "mm", at_master), std::nullopt)
      << "a position on a line is absolute";
  EXPECT_EQ(made(Extrapolation::hold, "deg", at_master), std::nullopt);
}

TEST(StreamPlan, AtTheNextCutTheOffsetOfTheMasterHasNoEffect) {
  Input cam = read_inputs(examples + "pmc600-cam/cam.toml").front();
  Spec spec = *cam.spec;
  spec.coupling = CouplingSpec{.master_offset = 40};
  cam.spec = spec;
  const StreamPlan next = stream_plan("feeder", cam, {.live = true, .at_next_cut = true});
  EXPECT_EQ(next.coupling.master_offset, next.tables.front().table.start());
  EXPECT_THAT(next.remark, ::testing::StartsWith("master_offset = 40 " + next.tables[0].units.x +
                                                 " of [coupling] has no effect"));
  const StreamPlan own = stream_plan("feeder", cam, {.live = true});
  EXPECT_EQ(own.coupling.master_offset, 40);
  EXPECT_EQ(own.remark, "");
}

/// The three points, and a rest at the last one.
TableFile to_rest() {
  TableFile table = bank_of(three_points());
  Columns columns = table.table.columns();
  columns.x.push_back(3);
  columns.p.push_back(9);
  table.table = Table(Domain::time, Interpolation::linear, Extrapolation::hold, std::move(columns));
  return table;
}

TEST(RowPlan, NeedsATableThatEndsAtRest) {
  EXPECT_EQ(test::error_of([] { (void)row_plan("feeder", bank_of(three_points()), 64, false); }),
            "velocity = -6 mm/s: at the end of the table is not 0, but an axis plays rows to rest: "
            "add a ramp to rest at the end");
  const auto ending_at = [](double velocity) {
    Columns columns{.x = {0, 1, 2}, .p = {0, 50, 100}, .v = {0, 60, velocity}, .a = {}};
    const Table table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                      std::move(columns));
    return test::error_of([&] { (void)row_plan("feeder", {table, {"s", "mm"}, {}}, 64, false); });
  };
  EXPECT_THAT(ending_at(0.001), ::testing::StartsWith("velocity = 0.001 mm/s: at the end"));
  EXPECT_EQ(ending_at(1e-9), test::error_of([] {})) << "rounding";
}

TEST(RowPlan, StatesItsRangeFromTheFirstKnot) {
  const RowPlan plan = row_plan("feeder", to_rest(), 64, false);
  EXPECT_EQ(plan.queue.origin, 5);
  EXPECT_EQ(plan.queue.lowest, 0);
  EXPECT_EQ(plan.queue.highest, 10);
  EXPECT_EQ(plan.queue.prefill, 64U);
  EXPECT_EQ(row_plan("feeder", to_rest(), 64, true).queue.origin, 0);
}

// The table rises by 10, and ends 4 above its start: pass k begins at 4 k.
TEST(BankPlan, TheSecondBankAddsItsTravelInEachPass) {
  const TableFile table = bank_of(three_points());
  const BankPlan plan = bank_plan(table, table, 3, false);
  EXPECT_EQ(plan.queue.loops, 3);
  EXPECT_EQ(plan.queue.highest, 3 * 4 + 10);
  EXPECT_EQ(plan.queue.lowest, 0);
  EXPECT_EQ(plan.first.size(), plan.second.size());
  EXPECT_EQ(queue_conflict(table, table, "a.csv"), "");
  TableFile inches = table;
  inches.units.position = "in";
  const std::string rule = queue_conflict(table, inches, "a.csv");
  EXPECT_TRUE(rule.starts_with("is over a master in ") || rule.starts_with("is over time in "))
      << rule;
  EXPECT_THAT(rule, testing::HasSubstr("with positions in in, but a.csv is over "));
}

TEST(FollowBankPlan, HoldsTheEventOfTheSpec) {
  const Input follow = read_inputs(examples + "googol-follow/7-6.toml").front();
  ASSERT_TRUE(is_follow(follow));
  const BankPlan plan = follow_bank_plan(follow, true);
  EXPECT_EQ(plan.queue.axis, Domain::master);
  EXPECT_TRUE(plan.queue.relative);
  EXPECT_FALSE(plan.first.empty());
  EXPECT_EQ(pass_position(follow).has_value(), plan.queue.event == wire::QueueEvent::pass);
  EXPECT_FALSE(is_follow(three_points()));
  EXPECT_FALSE(pass_position(three_points()));
}

// In a pass that begins at a ratio, a master that turns back stops the slave at once.
TEST(FollowBankPlan, NotesARatioAtTheBeginningOfAPass) {
  const auto remark = [](const std::string& direction, const std::string& zone) {
    const Spec spec = parse_spec(
        "jounce = 1\nkind = \"follow\"\nunits = { position = \"mm\", master = \"mm\" }\n[follow]\n"
        "periodic = true\ndirection = " +
            direction + "\n[[point]]\nmaster = 400\nslave = 255\n" + zone,
        "f.toml");
    return follow_bank_plan(inputs_of(spec, "f.toml").front(), false).remark;
  };
  const std::string engaged =
      "[[zone]]\nfrom = 0\nto = 60\nratio = 1.5\n[[zone]]\nfrom = 340\nto = 400\nratio = 1.5\n";
  EXPECT_EQ(remark("0", engaged),
            "the ratio at the beginning of a pass is 1.5: if the master moves back beyond this "
            "place, the axis stops with the fault jump");
  EXPECT_EQ(remark("1", engaged), "");
  EXPECT_EQ(remark("0", ""), "") << "from rest to rest";
}

TEST(InputsFor, AreChosenByNameThenByPlace) {
  Input x = three_points(), y = three_points();
  x.axis = "x", y.axis = "y";
  const auto names = [](const std::vector<Input>& inputs) {
    std::vector<std::string> all;
    for (const Input& input : inputs) all.push_back(input.axis);
    return all;
  };
  EXPECT_THAT(names(inputs_for({"y", "x"}, {x, y}, "f")), testing::ElementsAre("y", "x"));
  EXPECT_THAT(names(inputs_for({"a", "b"}, {x, y}, "f")), testing::ElementsAre("x", "y"));
  EXPECT_THAT(names(inputs_for({"a", "b"}, {x}, "f")), testing::ElementsAre("x", "x"));
  EXPECT_EQ(test::rule_of([&] {
              inputs_for({"a", "b", "c"}, {x, y}, "f");
            }),
            "names 3 axes, but f has 2: name one executor for each axis");
}

}  // namespace
}  // namespace jounce::play_plan_test
