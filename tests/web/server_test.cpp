// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/server.hpp"

#include <atomic>
#include <cerrno>
#include <deque>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "web/src/page.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

const std::string token = "0123456789abcdef";

Site site() {
  return {.files = files_of(page("Jounce <1>")),
          .commands = {"POST /order"},
          .event = [](std::int64_t& seen) { return std::to_string(++seen); },
          .obey =
              [](const Request& request) {
                if (request.body == "slow") std::this_thread::sleep_for(300ms);
                return Answer{200, "\"" + request.body + "\""};
              },
          .urgent = [](const Request& request) { return request.body == "stop"; },
          .freshness = 300ms};
}

struct Served {
  Server server{Listening(0), token, site()};
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

TEST(Server, RejectsAnotherHostName) {
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

/// A connection of its own, for requests that no client makes.
class Raw {
 public:
  explicit Raw(std::uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const timeval limit{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    host_ = "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
  }
  ~Raw() { close(socket_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;

  bool send(const std::string& text) const {
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }
  /// Everything received until the server closes or resets the connection; ends with "still open"
  /// if it does neither in 20 s.
  [[nodiscard]] std::string rest() const {
    std::string all;
    char bytes[4096];
    ssize_t n = 0;
    while ((n = recv(socket_, bytes, sizeof bytes, 0)) > 0)
      all.append(bytes, static_cast<std::size_t>(n));
    return n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? all + "still open" : all;
  }
  /// The first bytes received.
  [[nodiscard]] std::string first() const {
    char bytes[64];
    const ssize_t n = recv(socket_, bytes, sizeof bytes, 0);
    return {bytes, static_cast<std::size_t>(n > 0 ? n : 0)};
  }
  [[nodiscard]] const std::string& host() const { return host_; }

 private:
  int socket_;
  std::string host_;
};

TEST(Server, AnswersAnOrderWithoutTheTokenBeforeItsBody) {
  const Served served;
  for (const char* length : {"Transfer-Encoding: chunked\r\n", "Content-Length: 1000\r\n"}) {
    const Raw raw(served.server.port());
    ASSERT_TRUE(raw.send("POST /order HTTP/1.1\r\n" + raw.host() + length + "\r\n"));
    EXPECT_THAT(raw.rest(), AllOf(HasSubstr(" 403 "), Not(HasSubstr("still open"))))
        << "it waits for a body";
  }
}

TEST(Server, TakesNoBodyWhoseLengthIsNotGiven) {
  const Served served;
  const Raw raw(served.server.port());
  ASSERT_TRUE(raw.send("POST /order HTTP/1.1\r\n" + raw.host() + "X-Jounce-Token: " + token +
                       "\r\nTransfer-Encoding: chunked\r\n\r\n4\r\nstop\r\n0\r\n\r\n"));
  EXPECT_THAT(raw.rest(), HasSubstr(" 411 "));
}

TEST(Server, BoundsTheHeadOfARequest) {
  const Served served;
  const Raw raw(served.server.port());
  static_cast<void>(
      raw.send("GET / HTTP/1.1\r\n" + raw.host() + "X: " + std::string(100'000, 'x') + "\r\n\r\n"));
  EXPECT_THAT(raw.rest(), Not(HasSubstr(" 200 ")));
}

TEST(Server, EndsARequestWhoseBytesComeOneByOne) {
  const Served served;
  const Raw raw(served.server.port());
  ASSERT_TRUE(raw.send("GET / HTTP/1.1\r\n" + raw.host()));
  std::atomic<bool> ended{false};
  std::thread drip([&] {
    while (!ended && raw.send("X: y\r\n")) std::this_thread::sleep_for(100ms);
  });
  EXPECT_EQ(raw.rest(), "");  // returns: the server has closed the connection
  ended = true;
  drip.join();
}

TEST(Server, AStopFindsAConnectionAmongAnyNumberOfSlowOnes) {
  Served served;
  std::deque<Raw> slow;
  for (int i = 0; i < 3 * Server::most_guests; ++i) {
    slow.emplace_back(served.server.port());
    ASSERT_TRUE(slow.back().send("POST /order HTTP/1.1\r\n"));
  }
  const auto stop =
      served.client.Post("/order", {{"X-Jounce-Token", token}}, "stop", "application/json");
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->status, 200);
}

TEST(Server, AStopWaitsForNoOtherOrder) {
  Served served;
  std::deque<std::thread> others;
  std::atomic<int> answered{0};
  std::atomic<int> late{0};
  for (int i = 0; i < Server::most_commands; ++i)
    others.emplace_back([&] {
      httplib::Client client("127.0.0.1", served.server.port());
      client.set_read_timeout(30s);
      const auto answer =
          client.Post("/order", {{"X-Jounce-Token", token}}, "slow", "application/json");
      if (answer && answer->status == 200) ++answered;
      if (answer && answer->status == 503) ++late;
    });
  const auto stop =
      served.client.Post("/order", {{"X-Jounce-Token", token}}, "stop", "application/json");
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->status, 200);
  for (auto& other : others) other.join();
  EXPECT_EQ(answered + late, Server::most_commands);
}

// Its sender may be gone: a late order would move an axis without an observer.
TEST(Server, AnOrderThatWaitedForOthersIsNotCarriedOut) {
  std::atomic<int> begun{0};
  std::atomic<int> quick{0};
  Site slow = site();
  slow.obey = [&](const Request& request) {
    if (request.body == "quick") ++quick;
    if (request.body != "quick") {
      ++begun;
      std::this_thread::sleep_for(2s);
    }
    return Answer{200, "1"};
  };
  Server server(Listening(0), token, slow);
  const auto post = [&](const char* body) {
    httplib::Client client("127.0.0.1", server.port());
    client.set_read_timeout(30s);
    const auto answer =
        client.Post("/order", {{"X-Jounce-Token", token}}, body, "application/json");
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(post("quick"), 200);
  std::deque<std::thread> others;
  for (int i = 0; i < 4; ++i) others.emplace_back([&] { EXPECT_EQ(post("slow"), 200); });
  while (begun < 4) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(post("quick"), 503);
  for (auto& other : others) other.join();
  EXPECT_EQ(quick, 1);
}

/// Reads events until `enough` returns true.
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

TEST(Server, AReaderWithTheTokenTakesThePlaceOfOneWithout) {
  Served served;
  std::deque<Raw> strangers;
  for (int i = 0; i < Server::most_readers; ++i) {
    strangers.emplace_back(served.server.port());
    ASSERT_TRUE(
        strangers.back().send("GET /events HTTP/1.1\r\n" + strangers.back().host() + "\r\n"));
  }
  const auto answer = [&](const std::string& more) {
    const Raw raw(served.server.port());
    EXPECT_TRUE(raw.send("GET /events HTTP/1.1\r\n" + raw.host() + more + "\r\n"));
    return raw.first();
  };
  for (const Raw& stranger : strangers) EXPECT_THAT(stranger.first(), HasSubstr(" 200 "));
  EXPECT_THAT(answer(""), HasSubstr(" 503 "));
  EXPECT_THAT(answer("X-Jounce-Token: " + token + "\r\n"), HasSubstr(" 200 "));
}

TEST(Server, RejectsAPortThatIsTaken) {
  const Served served;
  EXPECT_THROW(Listening(served.server.port()), InputError);
}

}  // namespace
}  // namespace jounce::web
