// A virtual master: an axis with a table of its own, which an order starts, and a follower in step with it.
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/executor/dispatcher.hpp"
#include "jounce/stream/client.hpp"
#include "jounce/stream/memory_transport.hpp"
#include "jounce/stream/static_queue.hpp"

#include "axis/tables.hpp"
#include "executor/virtual_pacer.hpp"

namespace jounce {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

struct Site {
  Site() {
    axes[0].axis.limits = limits(1000, 10000);
    axes[0].receiver.executor = "line";
    axes[0].units = {"", "mm"};
    axes[0].table = StoredTable{{1}, {"s", "mm"}, trapezoid_table(500, 400, 1000, 1000)};
    axes[1].axis.limits = limits(2000, 50000);
    axes[1].receiver.executor = "knife";
    axes[1].units = {"mm", "mm"};
    axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
    machine.emplace(machine_of(axes));
    dispatcher.emplace(own_link, axes, post, clock);
    cycle.emplace(*machine, pacer, post);
    network.on_wait = [this](Nanos time) { advance(time); };
  }
  void advance(Nanos time) {
    for (const Nanos end = clock() + time; clock() < end;) {
      cycle->once();
      dispatcher->turn(0ns);
    }
  }
  CallOutcome tell(const char* axis, wire::OrderKind kind) {
    Client client(link, axis, {}, clock);
    const CallOutcome outcome = client.order(kind);
    static_cast<void>(client.release());
    return outcome;
  }

  std::vector<ExecutorOptions> axes{2};
  MemoryNetwork network;
  MemoryTransport own_link{network}, link{network};
  VirtualPacer pacer;
  Clock clock = [this] { return Nanos(pacer.now()); };
  Post post{2};
  std::optional<Machine> machine;
  std::optional<Dispatcher> dispatcher;
  std::optional<Cycle> cycle;
};

TEST(VirtualMaster, IsStartedByAnOrderHeldAndFollowed) {
  Site site;
  Client knife(site.link, "knife", {}, site.clock);
  ASSERT_TRUE(knife.gear_in(1, 2).ok());
  ASSERT_TRUE(knife.release().ok());
  const CallOutcome start = site.tell("line", wire::OrderKind::start);
  ASSERT_TRUE(start.ok()) << start.reason;
  site.advance(500ms);
  EXPECT_NEAR(site.dispatcher->last(0).velocity, 400, 1e-9);
  ASSERT_TRUE(site.tell("line", wire::OrderKind::hold).ok());
  site.advance(1s);
  EXPECT_EQ(site.dispatcher->last(0).velocity, 0);
  EXPECT_EQ(site.dispatcher->last(1).velocity, 0) << "the follower rests with it";
  ASSERT_TRUE(site.tell("line", wire::OrderKind::resume).ok());
  site.advance(3s);
  EXPECT_EQ(site.dispatcher->last(0).finished, 1U);
  EXPECT_EQ(site.dispatcher->last(0).position, 500);
  EXPECT_NEAR(site.dispatcher->last(1).position, 250, 1e-9);
  EXPECT_EQ(site.dispatcher->last(1).fault, Cause::none);
}

TEST(VirtualMaster, StartsOnlyWhereItsTableBegins) {
  Site site;
  ASSERT_TRUE(site.tell("line", wire::OrderKind::start).ok());
  site.advance(100ms);
  EXPECT_THAT(site.tell("line", wire::OrderKind::start).reason, HasSubstr("in_motion"));
  site.advance(3s);
  EXPECT_THAT(site.tell("line", wire::OrderKind::start).reason, HasSubstr("start_position"));
  Client line(site.link, "line", {}, site.clock);
  ASSERT_TRUE(line.set_position(0).ok());
  ASSERT_TRUE(line.release().ok());
  EXPECT_TRUE(site.tell("line", wire::OrderKind::start).ok());
  site.advance(3s);
  EXPECT_EQ(site.dispatcher->last(0).finished, 2U);
}

// It is not what its owner had armed before that begins in its place.
TEST(VirtualMaster, OneThatIsRefusedStartsNothingElse) {
  Site site;
  Client line(site.link, "line", {}, site.clock);
  StaticQueue rows(line, {.units = {"s", "mm"}, .mode = wire::QueueMode::static_});
  ASSERT_TRUE(rows.open().ok());
  ASSERT_TRUE(
      rows.fill(0, {{.x_end = 1, .p_end = 5, .order = wire::RowOrder::cubic, .last = true}}).ok());
  ASSERT_TRUE(rows.arm().ok());
  ASSERT_TRUE(line.set_position(7).ok());
  EXPECT_THAT(line.order(wire::OrderKind::start).reason, HasSubstr("start_position"));
  site.advance(500ms);
  EXPECT_EQ(site.dispatcher->last(0).state, State::standstill);
  EXPECT_EQ(site.dispatcher->last(0).position, 7);
}

TEST(VirtualMaster, AnAxisWithoutATableOfItsOwnSaysSo) {
  Site site;
  EXPECT_THAT(site.tell("knife", wire::OrderKind::start).reason, HasSubstr("no table of its own"));
}

}  // namespace
}  // namespace jounce
