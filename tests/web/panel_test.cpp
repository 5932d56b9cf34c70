// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/panel.hpp"

#include <atomic>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;

/// A link on which an axis sends its status, one tick after another, and answers each stop.
class OneAxis : public Transport {
 public:
  void subscribe(const std::string& channel, int /*capacity*/) override {
    hears_ |= channel == wire::channel("feeder", wire::Lane::status);
  }
  void send(const std::string& /*channel*/, std::span<const std::byte> bytes) override {
    const auto message = std::get<wire::Message>(wire::decode(bytes, {}));
    if (const auto* stop = std::get_if<wire::Stop>(&message.body))
      answer_ = wire::Message{
          "feeder", message.session,
          wire::Reply{.boot = 1, .command = stop->command, .outcome = wire::Outcome::accepted}};
  }
  std::optional<Packet> receive(Nanos timeout) override {
    if (answer_) return packet(*std::exchange(answer_, std::nullopt));
    std::this_thread::sleep_for(std::min<Nanos>(timeout, 5ms));
    if (!hears_) return std::nullopt;
    return packet({"feeder", 0, wire::Status{.tick = ++tick_, .slave_position = 12.5}});
  }

 private:
  static Packet packet(const wire::Message& message) {
    return {wire::channel(message.executor, wire::lane(message.body)), wire::encode(message)};
  }

  bool hears_ = false;
  std::int64_t tick_ = 0;
  std::optional<wire::Message> answer_;
};

/// A panel of one axis, and a browser that was given its address.
struct Shown {
  Panel panel{{.axes = {"feeder"}, .title = "Line 3", .token = "0123456789abcdef"},
              Listening(0),
              [] { return std::make_unique<OneAxis>(); }};
  std::string address = panel.address();
  std::string token = address.substr(address.find('#') + 1);
  httplib::Client client{address.substr(0, address.find("/#"))};

  httplib::Result order(const std::string& body) {
    return client.Post("/order", {{"X-Jounce-Token", token}}, body, "application/json");
  }
};

TEST(Panel, ShowsTheReceivedStatus) {
  Shown shown;
  std::string all;
  shown.client.Get("/events", [&](const char* data, std::size_t size) {
    all.append(data, size);
    return all.find("12.5") == std::string::npos;
  });
  const std::size_t begin = all.rfind("data: ") + 6;
  const auto event = nlohmann::json::parse(all.substr(begin));
  EXPECT_EQ(event["axes"][0]["name"], "feeder");
  EXPECT_EQ(event["axes"][0]["position"], 12.5);
}

TEST(Panel, HandsOrdersOnAndTheAxisAnswerBack) {
  Shown shown;
  const auto stop = shown.order(R"({"axis":"feeder","what":"stop"})");
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->status, 200);
  EXPECT_EQ(stop->body, R"({"ok":true,"reason":""})");
}

TEST(Panel, TracesAreReadWithoutATokenButCommandsNeedIt) {
  Shown shown;
  nlohmann::json trace;
  for (int turn = 0; turn < 200 && trace["newest"].is_null(); ++turn) {
    const auto answer = shown.client.Get("/trace?axis=feeder&span=1&buckets=0");
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->status, 200) << answer->body;
    trace = nlohmann::json::parse(answer->body);
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(trace["source"], "status");
  EXPECT_EQ(trace["low"]["position"].back(), 12.5);
  EXPECT_EQ(shown.client.Get("/trace?axis=knife")->status, 400);
  EXPECT_EQ(shown.client.Get("/trace?axis=feeder&span=-1")->status, 400);
  EXPECT_EQ(shown.client.Get("/tables")->status, 200);
  EXPECT_EQ(shown.client.Get("/commands")->status, 200);
  EXPECT_EQ(shown.client.Get("/trace?axis=feeder", {{"Origin", "http://evil.example"}})->status,
            403);
  EXPECT_EQ(
      shown.client.Post("/command", R"({"axis":"feeder","what":"enable"})", "application/json")
          ->status,
      403);
  EXPECT_EQ(shown.client.Post("/trace", "", "text/plain")->status, 404);
}

TEST(Panel, CommandsInWordsAreReadLikeThoseOfJounceOrder) {
  Shown shown;
  for (const char* body :
       {"", R"({"axis":"feeder","what":"fly"})", R"({"axis":"knife","what":"enable"})",
        R"({"axis":"feeder","what":"move","options":{"to":"3 apples"}})"}) {
    const auto answer =
        shown.client.Post("/command", {{"X-Jounce-Token", shown.token}}, body, "application/json");
    ASSERT_TRUE(answer) << body;
    EXPECT_TRUE(answer->status == 400 || answer->status == 504) << body << answer->body;
  }
}

TEST(Panel, OrdersNothingOfWhatItDoesNotUnderstand) {
  Shown shown;
  for (const char* body : {"", "{", R"({"axis":"feeder","what":"jump"})",
                           R"({"axis":"knife","what":"stop"})", "\xff{}"}) {
    const auto answer = shown.order(body);
    ASSERT_TRUE(answer) << body;
    EXPECT_EQ(answer->status, 400) << body;
    EXPECT_EQ(nlohmann::json::parse(answer->body)["ok"], false) << body;
  }
}

}  // namespace
}  // namespace jounce::web
