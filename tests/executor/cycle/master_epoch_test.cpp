// SPDX-License-Identifier: Apache-2.0
// A sender that begins with an old epoch of a master gets one notice; its samples are not just
// counted.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/executor/detail/masters.hpp"

#include "stream/src/transport/memory_transport.hpp"

namespace jounce::master_epoch_test {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A keyed executor with one master, "line".
struct Ear {
  Ear() {
    options.keyed = true;  // an epoch that is over never comes back
    options.masters.push_back(
        {"line", "mm",
         std::make_shared<ExternalMaster>(TrackerSpec{.velocity = 1, .acceleration = 1})});
    options.follows.push_back({.what = Follow::What::master, .index = 0});
    options.notify = [this](const std::string& notice) { notices.push_back(notice); };
    server.emplace(options, pump, exchange, clock);
  }
  void say(std::int32_t epoch, std::int64_t seq, const std::string& unit = "mm") {
    now += 1ms;
    send_message(theirs, {"line", 0,
                          wire::Master{.seq = seq,
                                       .stamp_ns = seq * 1'000'000,
                                       .clock = epoch,
                                       .valid = true,
                                       .position = 0,
                                       .unit = unit}});
    pump.run(0ns);
  }

  MemoryNetwork network;
  MemoryTransport own{network}, theirs{network};
  Nanos now = 5s;
  Clock clock = [this] { return now; };
  ReceiverPump pump{own, ReceiverOptions{.executor = "feeder"}, 1, clock};
  MachineExchange exchange{1, 1};
  MasterServer::Options options;
  std::vector<std::string> notices;
  std::optional<MasterServer> server;
};

TEST(MasterEpoch, ThatIsOverIsReportedWithTheCurrentOne) {
  Ear ear;
  ear.say(200'000'000, 1);
  for (std::int64_t k = 1; k <= 50; ++k) ear.say(7, k);
  ASSERT_EQ(ear.notices.size(), 1U) << "once, for any number of samples";
  EXPECT_THAT(ear.notices[0],
              AllOf(HasSubstr("master line"), HasSubstr("7 is older"), HasSubstr("200000000")));
  EXPECT_EQ(ear.server->status(0).refused, 50);
  ear.say(200'000'001, 1);
  ear.say(8, 1);
  EXPECT_EQ(ear.notices.size(), 2U) << "another epoch, another sender that needs a notice";
}

TEST(MasterEpoch, IsNotBlamedForWhatIsRepeatedOrInAnotherUnit) {
  Ear ear;
  ear.say(9, 5);
  ear.say(9, 5);
  ear.say(9, 4);
  ear.say(3, 6, "deg");
  EXPECT_EQ(ear.server->status(0).refused, 3);
  EXPECT_THAT(ear.notices, ElementsAre());
}

}  // namespace
}  // namespace jounce::master_epoch_test
