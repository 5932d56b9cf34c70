// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/claim.hpp"

#include <deque>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace jounce::claim_test {
namespace {

using namespace std::chrono_literals;

/// Executors that start at some instant, on a network that loses, delays and cuts.
struct World {
  struct One {
    Claim claim;
    Nanos starts;
    int net = 0;  // until `joined`, it is reached from its own network only
    bool was_up = false;
  };

  World(test::Random& its_random, double its_loss, Nanos its_delay)
      : random(its_random), loss(its_loss), delay(its_delay) {}

  void add(const std::vector<std::string>& names, std::int64_t boot, Nanos starts, int net = 0) {
    executors.push_back({Claim(names, boot), starts, net});
  }

  void run(Nanos until) {
    for (; now < until; now += 1ms) {
      deliver();
      for (One& one : executors) {
        if (now < one.starts || one.claim.lost()) continue;
        for (const auto& message : one.claim.poll(now)) send(message, one.net);
        one.was_up |= one.claim.up();
      }
    }
  }

  void send(const wire::Message& message, int net) {
    for (One& to : executors) {
      const bool reached = net == to.net || now >= joined;
      if (!reached || now < to.starts || random.uniform(0, 1) < loss) continue;
      const Nanos late(
          static_cast<std::int64_t>(random.uniform(0, 1) * static_cast<double>(delay.count())));
      on_its_way.emplace(now + late, std::pair{&to, message});
    }
  }

  void deliver() {
    while (!on_its_way.empty() && on_its_way.begin()->first <= now) {
      auto [to, message] = on_its_way.begin()->second;
      on_its_way.erase(on_its_way.begin());
      if (!to->claim.lost()) to->claim.receive(message, now);
    }
  }

  [[nodiscard]] int left() const {
    int count = 0;
    for (const One& one : executors) count += !one.claim.lost() && one.claim.up();
    return count;
  }

  test::Random& random;
  double loss;
  Nanos delay;
  Nanos joined{};
  Nanos now{};
  std::deque<One> executors{};
  std::multimap<Nanos, std::pair<One*, wire::Message>> on_its_way{};
};

constexpr std::uint64_t seed = 20261122;

TEST(Claim, IsUpAfterItHasAskedInVain) {
  Claim claim({"feeder"}, 5);
  Nanos now{};
  for (int i = 0; i < 10; ++i, now += 30ms) {
    EXPECT_EQ(claim.poll(now).size(), 1U);
    EXPECT_FALSE(claim.up());
  }
  EXPECT_EQ(claim.poll(now).size(), 1U) << "now it reports that it is up";
  EXPECT_TRUE(claim.up());
  EXPECT_TRUE(claim.poll(now + 999ms).empty());
  EXPECT_EQ(claim.poll(now + 1s).size(), 1U);
}

TEST(Claim, GivesUpOnlyWhereItsOwnBootIsNamed) {
  Claim claim({"feeder"}, 5);
  const auto say = [&](const wire::Claim& said) { claim.receive({"feeder", 0, said}, 0s); };
  say({.boot = 1, .rival = 0, .up = true});
  say({.boot = 1, .rival = 4, .up = true});
  say({.boot = 5, .rival = 5, .up = true});
  say({.boot = 6, .rival = 5, .up = false});
  EXPECT_FALSE(claim.lost()) << "recorded, its own, or of one that must give up itself";
  claim.receive({"knife", 0, wire::Claim{1, 5, true}}, 0s);
  EXPECT_FALSE(claim.lost()) << "of another name";
  say({.boot = 1, .rival = 5, .up = false});
  EXPECT_EQ(claim.lost(), "feeder");
}

TEST(Claim, AnswersOnlyTheSenderOfTheRequest) {
  Claim claim({"feeder"}, 5);
  (void)claim.poll(0s);
  claim.receive({"feeder", 0, wire::Claim{7, 5, false}}, 0s);
  EXPECT_TRUE(claim.poll(1ms).empty()) << "an answer to an answer would go on for good";
  claim.receive({"feeder", 0, wire::Claim{7, 0, false}}, 0s);
  const auto said = claim.poll(1ms);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(std::get<wire::Claim>(said[0].body).rival, 7);
  for (int i = 0; i < 10'000; ++i) claim.receive({"feeder", 0, wire::Claim{7, 0, false}}, 0s);
  EXPECT_LE(claim.poll(2ms).size(), 256U) << "bounded";
}

// Exactly one of the executors that start together continues, on every network.
TEST(Claim, OneContinuesIfSeveralStartTogether) {
  test::Random random(seed);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    World world(random, random.uniform(0, 0.5), Nanos(random.below(40) * 1'000'000));
    const int count = 2 + random.below(3);
    for (int i = 0; i < count; ++i)
      world.add({"feeder"}, 1 + random.below(1'000'000'000), Nanos(random.below(400) * 1'000'000));
    world.run(12s);
    EXPECT_EQ(world.left(), 1);
  }
}

TEST(Claim, ARunningOneStays) {
  test::Random random(seed);
  for (int round = 0; round < 100; ++round) {
    World world(random, random.uniform(0, 0.1), 5ms);
    world.add({"feeder", "knife"}, 1'000'000, 0s);
    world.add({"knife"}, 1, 500ms);  // its boot is smaller
    world.run(4s);
    EXPECT_FALSE(world.executors[0].claim.lost());
    EXPECT_EQ(world.executors[1].claim.lost(), "knife");
  }
}

// Two machines were apart, each with an executor that is up, and are joined.
TEST(Claim, OneContinuesIfTwoNetworksAreJoined) {
  test::Random random(seed);
  for (int round = 0; round < 100; ++round) {
    World world(random, random.uniform(0, 0.3), 5ms);
    world.joined = 2s;
    world.add({"feeder"}, 1 + random.below(1000), 0s, 0);
    world.add({"feeder"}, 1001 + random.below(1000), Nanos(random.below(500) * 1'000'000), 1);
    world.run(1900ms);
    EXPECT_EQ(world.left(), 2);
    world.run(12s);
    EXPECT_EQ(world.left(), 1);
    EXPECT_FALSE(world.executors[0].claim.lost()) << "the smaller boot goes on";
  }
}

}  // namespace
}  // namespace jounce::claim_test
