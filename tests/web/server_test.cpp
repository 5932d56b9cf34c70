#include "jounce/web/server.hpp"

#include <atomic>
#include <deque>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include "jounce/profiles/error.hpp"
#include "jounce/web/page.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

const std::string token = "0123456789abcdef";

Site site() {
  return {page("Jounce <1>"), std::string(script()), style(),
          [](std::int64_t& seen) { return std::to_string(++seen); },
          [](const std::string& body) {
            return Answer{200, "\"" + body + "\""};
          }};
}

struct Served {
  Server server{0, token, site()};
  httplib::Client client{"127.0.0.1", server.port()};
};

TEST(Server, ServesThePageAndWhatItNeeds) {
  Served served;
  const auto index = served.client.Get("/");
  ASSERT_TRUE(index);
  EXPECT_EQ(index->status, 200);
  EXPECT_THAT(index->body, HasSubstr("<title>Jounce &lt;1&gt;</title>"));
  EXPECT_THAT(index->body, Not(HasSubstr(token)));
  EXPECT_THAT(index->get_header_value("Content-Security-Policy"), HasSubstr("default-src 'none'"));
  EXPECT_EQ(index->get_header_value("X-Frame-Options"), "DENY");
  for (const char* path : {"/panel.js", "/panel.css"}) {
    const auto file = served.client.Get(path);
    ASSERT_TRUE(file) << path;
    EXPECT_EQ(file->status, 200) << path;
    EXPECT_FALSE(file->body.empty()) << path;
  }
  EXPECT_EQ(served.client.Get("/panelxjs")->status, 404);
  EXPECT_EQ(served.client.Get("/../etc/passwd")->status, 404);
  EXPECT_EQ(served.client.Get("/order")->status, 404);
}

TEST(Server, LoadsNothingFromElsewhere) {
  for (const std::string& text : {page("x"), std::string(script()), style()}) {
    EXPECT_THAT(text, Not(HasSubstr("http:")));
    EXPECT_THAT(text, Not(HasSubstr("https:")));
    EXPECT_THAT(text, Not(HasSubstr("innerHTML")));
  }
}

TEST(Server, AnswersNobodyThatComesByAnotherName) {
  Served served;
  for (const char* path : {"/", "/panel.js", "/events"}) {
    EXPECT_EQ(served.client.Get(path, {{"Host", "evil.example"}})->status, 403) << path;
    EXPECT_EQ(served.client.Get(path, {{"Origin", "http://evil.example"}})->status, 403) << path;
    EXPECT_EQ(served.client.Get(path, {{"Sec-Fetch-Site", "cross-site"}})->status, 403) << path;
  }
}

TEST(Server, TakesOrdersWithTheTokenOnly) {
  Served served;
  const auto post = [&](const httplib::Headers& headers) {
    return served.client.Post("/order", headers, "stop", "application/json");
  };
  EXPECT_EQ(post({})->status, 403);
  EXPECT_EQ(post({{"X-Jounce-Token", ""}})->status, 403);
  EXPECT_EQ(post({{"X-Jounce-Token", "0123456789abcdee"}})->status, 403);
  EXPECT_EQ(post({{"X-Jounce-Token", token}, {"Origin", "http://evil.example"}})->status, 403);
  const auto good = post({{"X-Jounce-Token", token}});
  EXPECT_EQ(good->status, 200);
  EXPECT_EQ(good->body, "\"stop\"");
}

TEST(Server, TakesNoLongOrder) {
  Served served;
  const auto answer = served.client.Post("/order", {{"X-Jounce-Token", token}},
                                         std::string(100'000, 'x'), "application/json");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 413);
}

/// Reads events until `enough` says so.
template <class Enough>
void read_events(std::uint16_t port, Enough enough) {
  httplib::Client client("127.0.0.1", port);
  client.Get("/events",
             [&](const char* data, std::size_t size) { return !enough(std::string(data, size)); });
}

TEST(Server, StreamsEventsToEachReaderFromItsBeginning) {
  Served served;
  for (int reader = 0; reader < 2; ++reader) {
    std::string all;
    read_events(served.server.port(), [&](const std::string& data) {
      all += data;
      return all.find("data: 3\n\n") != std::string::npos;
    });
    EXPECT_EQ(all.substr(0, 27), "data: 1\n\ndata: 2\n\ndata: 3\n\n");
  }
}

TEST(Server, EndsWithReadersAndHasRoomForEight) {
  auto served = std::make_unique<Served>();
  const std::uint16_t port = served->server.port();
  std::atomic<int> reading{0};
  std::deque<std::thread> readers;
  for (int i = 0; i < Server::most_readers; ++i)
    readers.emplace_back([&] {
      bool first = true;
      read_events(port, [&](const std::string&) {
        if (std::exchange(first, false)) ++reading;
        return false;
      });
    });
  while (reading < Server::most_readers) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(served->client.Get("/events")->status, 503);
  EXPECT_EQ(served->client.Get("/")->status, 200);  // there is a thread left for what is short
  served.reset();
  for (auto& reader : readers) reader.join();
}

TEST(Server, RefusesAPortThatIsTaken) {
  const Served served;
  EXPECT_THROW(Server(served.server.port(), token, site()), InputError);
}

}  // namespace
}  // namespace jounce::web
