// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/assembly.hpp"

#include <gtest/gtest.h>

#include "stream/harness.hpp"

namespace jounce::assembly_test {
namespace {

const wire::Header& header_of(const std::vector<wire::Message>& messages) {
  return std::get<wire::Header>(messages.front().body);
}

const wire::Chunk& chunk_of(const std::vector<wire::Message>& messages, std::size_t seq) {
  return std::get<wire::Chunk>(messages.at(seq + 1).body);
}

const Sha256& content_of(const std::vector<wire::Message>& messages) {
  return header_of(messages).hash;
}

class AssemblyOfRule : public testing::TestWithParam<Interpolation> {};

TEST_P(AssemblyOfRule, GivesTheTableBackWhateverTheOrder) {
  const Table table = test::sine_table(3000, GetParam());
  const auto messages = test::messages_of(table, 1);
  Assembly assembly(header_of(messages));
  const std::size_t chunks = header_of(messages).chunks;
  for (std::size_t i = chunks; i-- > 0;) {
    EXPECT_FALSE(assembly.complete());
    ASSERT_TRUE(assembly.add(chunk_of(messages, i)));
    ASSERT_TRUE(assembly.add(chunk_of(messages, i))) << "twice";
  }
  ASSERT_TRUE(assembly.complete());
  const auto result = assembly.finish(content_of(messages));
  ASSERT_TRUE(std::holds_alternative<StoredTable>(result));
  EXPECT_TRUE(test::same(*std::get<StoredTable>(result).table, table));
}

INSTANTIATE_TEST_SUITE_P(Rules, AssemblyOfRule,
                         testing::Values(Interpolation::linear, Interpolation::cubic_hermite,
                                         Interpolation::quintic_hermite),
                         [](const auto& each) { return std::string(name(each.param)); });

TEST(Assembly, ReportsWhatHasArrived) {
  const auto messages = test::messages_of(test::sine_table(80 * 533), 1);
  Assembly assembly(header_of(messages));
  for (const std::size_t seq : {0U, 1U, 3U, 5U, 67U}) assembly.add(chunk_of(messages, seq));
  EXPECT_EQ(assembly.next(), 2U);
  EXPECT_EQ(assembly.mask(), 0b101U) << "chunks 3 and 5; 67 is the 65th behind 2";
  assembly.add(chunk_of(messages, 66));
  EXPECT_EQ(assembly.mask(), std::uint64_t{1} << 63U | 0b101U);
  assembly.add(chunk_of(messages, 2));
  EXPECT_EQ(assembly.next(), 4U);
}

TEST(Assembly, RejectsAChunkThatContradictsItsHeader) {
  const auto messages = test::messages_of(test::sine_table(1000), 1);
  Assembly assembly(header_of(messages));
  const auto refuses = [&](auto change) {
    wire::Chunk chunk = chunk_of(messages, 1);
    change(chunk);
    return !assembly.add(chunk);
  };
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.seq = 2; }));
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.seq = UINT32_MAX; }));
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.first_knot += 1; }));
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.columns = 2; }));
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.knots -= 1; }));
  EXPECT_TRUE(refuses([](wire::Chunk& c) { c.values.pop_back(); }));
  EXPECT_FALSE(refuses([](wire::Chunk& /*as it is*/) {}));
}

TEST(Assembly, FindsAnotherTableThanWasAnnounced) {
  const auto messages = test::messages_of(test::sine_table(100), 1);
  wire::Chunk chunk = chunk_of(messages, 0);
  chunk.values[150] += 1e-12;
  Assembly assembly(header_of(messages));
  ASSERT_TRUE(assembly.add(chunk));
  const auto result = assembly.finish(content_of(messages));
  ASSERT_TRUE(std::holds_alternative<Refused>(result));
  EXPECT_EQ(std::get<Refused>(result).refusal, wire::Refusal::hash_mismatch);
}

TEST(Assembly, FindsOtherUnitsThanWereAnnounced) {
  const auto messages = test::messages_of(test::sine_table(100), 1);
  wire::Header header = header_of(messages);
  header.units.position = "deg";
  Assembly assembly(header);
  ASSERT_TRUE(assembly.add(chunk_of(messages, 0)));
  EXPECT_EQ(std::get<Refused>(assembly.finish(content_of(messages))).refusal,
            wire::Refusal::hash_mismatch);
}

TEST(Assembly, RejectsWhatIsNoTable) {
  const auto messages = test::messages_of(test::sine_table(100), 1);
  wire::Chunk chunk = chunk_of(messages, 0);
  chunk.values[7] = chunk.values[6];  // x does not ascend
  Assembly assembly(header_of(messages));
  ASSERT_TRUE(assembly.add(chunk));
  const auto refused = std::get<Refused>(assembly.finish(content_of(messages)));
  EXPECT_EQ(refused.refusal, wire::Refusal::bad_table);
  EXPECT_NE(refused.reason.find("0.006: must be greater than 0.006"), std::string::npos)
      << refused.reason;
}

TEST(Contradiction, NamesTheWrongFieldOfAHeader) {
  const auto messages = test::messages_of(test::sine_table(1000), 1);
  const auto says = [&](auto change) {
    wire::Header header = header_of(messages);
    change(header);
    return contradiction(header).reason;
  };
  EXPECT_EQ(says([](wire::Header& /*as it is*/) {}), "");
  EXPECT_EQ(says([](wire::Header& h) { h.knots = 1; }), "a table needs at least 2 knots");
  EXPECT_EQ(says([](wire::Header& h) { h.columns = 4; }),
            "a cubic_hermite table has 3 columns, not 4");
  EXPECT_EQ(says([](wire::Header& h) { h.chunks = 3; }), "1000 knots make 2 chunks, not 3");
  EXPECT_EQ(says([](wire::Header& h) { h.table = 64; }), "a session has at most 64 tables");
}

TEST(Misfit, JudgesAxesAndUnitsByTheMode) {
  const Table move = test::sine_table(5);
  const Table cam = test::sine_table(5, Interpolation::cubic_hermite, Domain::master);
  const Units milliseconds{"ms", "mm"}, degrees{"s", "deg"};
  const TableInUnits time{move, test::move_units}, over_master{cam, test::cam_units};
  const TableInUnits slow{move, milliseconds}, turning{move, degrees};
  const auto verdict = [](wire::ArmMode mode, TableInUnits slave, const TableInUnits* master) {
    return misfit(mode, slave, master).refusal;
  };
  using wire::ArmMode, wire::Refusal;
  EXPECT_EQ(verdict(ArmMode::play, time, nullptr), Refusal::none);
  EXPECT_EQ(verdict(ArmMode::play, over_master, nullptr), Refusal::wrong_axis);
  EXPECT_EQ(verdict(ArmMode::play, slow, nullptr), Refusal::wrong_unit);
  EXPECT_EQ(verdict(ArmMode::follow_input, over_master, nullptr), Refusal::none);
  EXPECT_EQ(verdict(ArmMode::follow_input, time, nullptr), Refusal::wrong_axis);
  EXPECT_EQ(verdict(ArmMode::follow_table, over_master, &turning), Refusal::none);
  EXPECT_EQ(verdict(ArmMode::follow_table, over_master, nullptr), Refusal::table_missing);
  EXPECT_EQ(verdict(ArmMode::follow_table, over_master, &over_master), Refusal::wrong_axis);
  EXPECT_EQ(verdict(ArmMode::follow_table, over_master, &time), Refusal::wrong_unit)
      << "the master moves in mm, the cam is over deg";
}

}  // namespace
}  // namespace jounce::assembly_test
