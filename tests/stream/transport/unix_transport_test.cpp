// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/unix_transport.hpp"

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "stream/harness.hpp"
#include "stream/message/samples.hpp"
#include "stream/src/transport/datagram.hpp"
#include "stream/src/transport/unix_socket.hpp"
#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::unix_transport_test {
namespace {

using namespace std::chrono_literals;
using test::why;
using ::testing::HasSubstr;

class UnixTransportTest : public test::WithFolder {};

void send_byte(Transport& link, const std::string& channel, int value = 1) {
  const auto byte = static_cast<std::byte>(value);
  link.send(channel, {&byte, 1});
}

TEST_F(UnixTransportTest, CarriesEveryMessageToTheOthersAndToItself) {
  UnixTransport here(folder());
  UnixTransport there(folder());
  for (UnixTransport* link : {&here, &there}) {
    for (const auto lane :
         {wire::Lane::table, wire::Lane::command, wire::Lane::reply, wire::Lane::status,
          wire::Lane::masters, wire::Lane::claim, wire::Lane::group})
      link->subscribe(wire::channel("feeder_2-B", lane), 10);
    link->subscribe(wire::channel("feeder_2-B", wire::Lane::event), 10);
    link->subscribe(wire::channel("line", wire::Lane::master), 10);
  }
  for (const wire::Message& message : test::samples()) {
    send_message(here, message);
    for (UnixTransport* link : {&here, &there}) {
      Rejects rejects;
      const auto back = next_message(*link, 10s, rejects);
      ASSERT_TRUE(back.has_value()) << message.body.index();
      EXPECT_EQ(test::text(*back), test::text(message));
    }
  }
  EXPECT_FALSE(there.receive(Nanos{}).has_value());
}

TEST_F(UnixTransportTest, TakesTheLargestChunk) {
  UnixTransport link(folder());
  link.subscribe("a", 1);
  const std::vector<std::byte> bytes(65000, std::byte{7});
  link.send("a", bytes);
  const auto packet = link.receive(10s);
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->bytes, bytes);
}

TEST(Datagram, AStarStandsForTextWithoutADot) {
  EXPECT_TRUE(stream_detail::matches("J.*.status", "J.a_-b.status"));
  EXPECT_TRUE(stream_detail::matches("J.*.status", "J..status"));
  EXPECT_TRUE(stream_detail::matches("J.*", "J.status"));
  EXPECT_TRUE(stream_detail::matches("*a*b", "xaab"));
  EXPECT_FALSE(stream_detail::matches("J.*.status", "J.a.b.status"));
  EXPECT_FALSE(stream_detail::matches("J.*.status", "J.a.statuses"));
  EXPECT_FALSE(stream_detail::matches("J.*.status", "J.a.reply"));
  EXPECT_FALSE(stream_detail::matches("J.a", "Jxa"));
  EXPECT_FALSE(stream_detail::matches("J.a", "J.a*"));
  EXPECT_FALSE(stream_detail::matches("", "a"));
}

TEST(Datagram, TakesNothingWithoutAName) {
  const auto packet = [](std::string text) {
    return stream_detail::packet_of(std::as_bytes(std::span(text.data(), text.size())));
  };
  using namespace std::string_literals;
  EXPECT_FALSE(packet("").has_value());
  EXPECT_FALSE(packet("\0bytes"s).has_value());
  EXPECT_FALSE(packet("no end of the name").has_value());
  EXPECT_FALSE(packet(std::string(64, 'a') + "\0bytes"s).has_value());
  EXPECT_TRUE(packet(std::string(63, 'a') + "\0bytes"s).has_value());
  const auto empty = packet("name\0"s);
  ASSERT_TRUE(empty.has_value());
  EXPECT_EQ(empty->channel, "name");
  EXPECT_TRUE(empty->bytes.empty());
}

TEST_F(UnixTransportTest, KeepsAsManyAsAskedForOfEachChannel) {
  UnixTransport link(folder());
  link.subscribe("few", 2);
  link.subscribe("few", 2);
  link.subscribe("many.*", 100);
  // Nine datagrams fit into the socket, so none is lost even if the reading thread is late.
  for (int i = 0; i < 3; ++i) {
    send_byte(link, "few", i);
    send_byte(link, "many.a", i);
    send_byte(link, "other", i);
  }
  std::this_thread::sleep_for(500ms);  // all are read before the first one is taken
  std::map<std::string, std::vector<int>> got;
  for (auto packet = link.receive(10s); packet; packet = link.receive(200ms))
    got[packet->channel].push_back(std::to_integer<int>(packet->bytes.at(0)));
  EXPECT_EQ(got["few"], (std::vector{0, 1})) << "the oldest, as LCM keeps them";
  EXPECT_EQ(got["many.a"], (std::vector{0, 1, 2}));
  EXPECT_EQ(got.size(), 2U);
  send_byte(link, "few", 9);
  EXPECT_TRUE(link.receive(10s).has_value()) << "a received message frees its place";
}

TEST_F(UnixTransportTest, LeavesNothingBehindAndRemovesWhatTheKilledLeft) {
  { const UnixTransport link(folder()); }
  EXPECT_EQ(files(), 0U);
  const pid_t child = fork();
  if (child == 0) {
    const UnixTransport link(folder());
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(files(), 1U);
  std::ofstream(folder_ / "notes.txt") << "not ours";
  std::ofstream(folder_ / "jounce-0123456789abcdef") << "a file, though it is called like a socket";
  UnixTransport link(folder());
  EXPECT_EQ(files(), 3U) << "its own, and the two files that are no sockets";
  link.subscribe("a", 1);
  send_byte(link, "a");
  EXPECT_TRUE(link.receive(10s).has_value());
}

/// A program that never takes what is sent to it.
class Sleeper {
 public:
  explicit Sleeper(const std::string& folder) : socket_(stream_detail::datagram_socket()) {
    const auto address =
        stream_detail::address_of(folder + "/" + stream_detail::unique_socket_name());
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw std::runtime_error("bind");
  }
  ~Sleeper() { close(socket_); }
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

 private:
  int socket_;
};

TEST_F(UnixTransportTest, AProgramThatHangsHindersNoOther) {
  // Some of these fill the socket's limit of messages under way.
  const std::vector<std::byte> chunk(60000);
  const Sleeper sleeper(folder());
  UnixTransport here(folder());
  UnixTransport there(folder());
  there.subscribe("a", 1000);
  int got = 0;
  for (int sent = 0; sent < 10'000 && got < 100; ++sent) {
    here.send("a", chunk);
    while (there.receive(1ms)) ++got;
  }
  EXPECT_GE(got, 100);
}

TEST_F(UnixTransportTest, IgnoresForeignDatagrams) {
  UnixTransport link(folder());
  link.subscribe("a", 100);
  const int stranger = stream_detail::datagram_socket();
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const auto address = stream_detail::address_of(entry.path().string());
    ASSERT_EQ(connect(stranger, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  const std::vector<char> large(100'000, 'a');
  const int size = 1 << 20;
  setsockopt(stranger, SOL_SOCKET, SO_SNDBUF, &size, sizeof size);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, std::size_t{65536}, large.size()})
    EXPECT_EQ(send(stranger, large.data(), length, 0), static_cast<ssize_t>(length));
  close(stranger);
  send_byte(link, "a", 5);
  const auto packet = link.receive(10s);
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->bytes, std::vector{std::byte{5}});
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST_F(UnixTransportTest, ReportsThatItsFolderIsGone) {
  UnixTransport link(folder());
  std::filesystem::remove_all(folder_);
  EXPECT_THAT(why([&] { send_byte(link, "a"); }), HasSubstr("socket has been removed"));
}

TEST_F(UnixTransportTest, MakesAFolderForItsOwnerAlone) {
  const std::string made = folder() + "/bus";
  const UnixTransport link(made);
  struct stat about {};
  ASSERT_EQ(stat(made.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0700U);
}

TEST_F(UnixTransportTest, RejectsAFolderThatAllMayWriteAndNamesThatDoNotFit) {
  chmod(folder().c_str(), 0777);
  EXPECT_THAT(why([&] { UnixTransport link(folder()); }), HasSubstr("chmod o-w"));
  EXPECT_EQ(files(), 0U);
  EXPECT_THAT(why([&] { UnixTransport link(""); }), HasSubstr("must name a folder"));
  EXPECT_THAT(why([&] { UnixTransport link("/" + std::string(75, 'a')); }), HasSubstr("75 bytes"));
  EXPECT_THAT(why([&] { UnixTransport link("/nowhere/at/all"); }), HasSubstr("No such file"));
  EXPECT_THAT(why([&] { UnixTransport link("/dev/null"); }),
              HasSubstr("url = unix:///dev/null: is a file: name a folder"));
}

TEST_F(UnixTransportTest, TakesTheLongestNameThatItAllows) {
  const std::string longest = folder() + "/" + std::string(74 - folder().size(), 'a');
  ASSERT_EQ(longest.size(), 75U);
  UnixTransport link(longest);
  link.subscribe("a", 1);
  send_byte(link, "a");
  EXPECT_TRUE(link.receive(10s).has_value());
}

TEST_F(UnixTransportTest, SixtyFourProgramsAndNoMore) {
  std::vector<std::unique_ptr<UnixTransport>> links;
  for (int i = 0; i < 64; ++i) links.push_back(std::make_unique<UnixTransport>(folder()));
  EXPECT_THAT(why([&] { UnixTransport link(folder()); }), HasSubstr("64 programs"));
  for (auto& link : links) link->subscribe("a", 1);
  send_byte(*links.front(), "a");
  for (auto& link : links) EXPECT_TRUE(link->receive(10s).has_value());
  links.pop_back();
  EXPECT_EQ(why([&] { UnixTransport link(folder()); }), "");
}

TEST_F(UnixTransportTest, AnAddressChoosesIt) {
  const auto here = open_transport("unix://" + folder());
  UnixTransport there(folder());
  there.subscribe("a", 1);
  send_byte(*here, "a");
  EXPECT_TRUE(there.receive(10s).has_value());
  EXPECT_NE(dynamic_cast<UnixTransport*>(here.get()), nullptr);
}

TEST(OpenTransport, RejectsWhatNamesNoLink) {
  for (const char* url : {"", "tcpq://", "unix:/tmp", "/tmp", "UNIX://a"})
    EXPECT_THAT(why([&] { (void)open_transport(url); }),
                HasSubstr("must begin with udpm://, unix:// or memq://"));
  EXPECT_EQ(why([&] { (void)open_transport("memq://"); }), "");
}

}  // namespace
}  // namespace jounce::unix_transport_test
