// SPDX-License-Identifier: Apache-2.0
// Rolling streams and single orders over every kind of bad link: what is played are the rows that were
// sent, each in its place, or fewer of them; an order is given once, or not; and all of it ends, done
// or with a named error.
#include <gtest/gtest.h>

#include "jounce/stream/sender/client.hpp"

#include "stream/faults.hpp"
#include "stream/sender/rows.hpp"

namespace jounce::row_fault_test {
namespace {

using namespace std::chrono_literals;
using test::faults;
using test::text;
using test::World;

class BadLink : public ::testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const test::Fault& fault() const { return faults()[GetParam()]; }
  [[nodiscard]] LossSpec spec(std::uint64_t seed) const {
    LossSpec spec = fault().spec;
    spec.seed = seed;
    return spec;
  }
};

INSTANTIATE_TEST_SUITE_P(Faults, BadLink, ::testing::Range<std::size_t>(0, faults().size()),
                         [](const auto& each) { return faults()[each.param].label; });

/// The rows that the executor was handed, those it played before all others, are those of the
/// source in its order.
void expect_only_what_was_sent(const std::vector<wire::Row>& rows, std::size_t count) {
  ASSERT_LE(rows.size(), count);
  for (std::size_t i = 0; i < rows.size(); ++i)
    ASSERT_EQ(rows[i], test::row(i, i + 1 == count)) << "row " << i;
}

TEST_P(BadLink, ARollingStreamPlaysItsRowsOrFewer) {
  constexpr std::size_t count = 3000;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const bool resume : {false, true}) {
      SCOPED_TRACE(text(spec(seed)) + (resume ? ", resumes" : ""));
      World world;
      const test::Player player(world, 1ms);
      LossyTransport bad(world.link, spec(seed), world.clock);
      const RowOutcome outcome = stream_rows(bad,
                                             {.executor = "feeder",
                                              .queue = test::queue_of(500, 800),
                                              .rows = test::source_of(count),
                                              .resume = resume},
                                             {}, world.clock, 1);
      expect_only_what_was_sent(world.executor->rows, count);
      EXPECT_LE(player.played, world.executor->rows.size());
      if (outcome.ok()) {
        EXPECT_TRUE(outcome.progress.finished);
        EXPECT_EQ(player.played, count);
      } else {
        EXPECT_FALSE(outcome.reason.empty()) << name(outcome.error);
      }
      if (fault().completes && fault().spec.partitions.empty()) {
        EXPECT_TRUE(outcome.ok()) << outcome.reason;
      }
      EXPECT_LT(world.now, 60s);
      world.pass(3s);
      EXPECT_EQ(world.executor->pump.receiver().session(), 0) << "the axis is free";
    }
  }
}

TEST_P(BadLink, AnOrderIsGivenOnceOrNot) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(text(spec(seed)));
    World world;
    LossyTransport bad(world.link, spec(seed), world.clock);
    Client client(bad, "feeder", {}, world.clock);
    std::size_t given = 0;
    for (int i = 0; i < 20; ++i) {
      const std::size_t before = world.executor->log.size();
      const CallOutcome outcome = client.command(command::MoveRelative{.distance = 1});
      std::size_t now = 0;
      for (std::size_t k = before; k < world.executor->log.size(); ++k)
        now += world.executor->log[k].starts_with("move_relative") ? 1 : 0;
      // An unanswered order may have been obeyed, also later, but no order twice.
      if (outcome.ok()) {
        EXPECT_EQ(now, 1U) << "order " << i;
      } else {
        EXPECT_FALSE(outcome.reason.empty());
      }
      given += now;
      ASSERT_LE(given, static_cast<std::size_t>(i) + 1);
      if (fault().completes) {
        EXPECT_TRUE(outcome.ok()) << "order " << i << ": " << outcome.reason;
      }
    }
  }
}

}  // namespace
}  // namespace jounce::row_fault_test
