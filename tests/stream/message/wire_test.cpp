// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/wire.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "jounce_lcm/ack_t.hpp"
#include "jounce_lcm/arm_t.hpp"
#include "jounce_lcm/chunk_t.hpp"
#include "jounce_lcm/claim_t.hpp"
#include "jounce_lcm/command_t.hpp"
#include "jounce_lcm/event_t.hpp"
#include "jounce_lcm/group_status_t.hpp"
#include "jounce_lcm/header_t.hpp"
#include "jounce_lcm/heartbeat_t.hpp"
#include "jounce_lcm/master_status_t.hpp"
#include "jounce_lcm/master_t.hpp"
#include "jounce_lcm/path_command_t.hpp"
#include "jounce_lcm/queue_ack_t.hpp"
#include "jounce_lcm/queue_t.hpp"
#include "jounce_lcm/reply_t.hpp"
#include "jounce_lcm/rows_t.hpp"
#include "jounce_lcm/start_t.hpp"
#include "jounce_lcm/status_t.hpp"
#include "jounce_lcm/stop_t.hpp"
#include "stream/harness.hpp"
#include "stream/message/samples.hpp"
#include "support/random.hpp"

namespace jounce::wire_test {
namespace {

using wire::Bytes;
using wire::Message;
using wire::Reject;

std::string hex(const Bytes& bytes) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += digits[std::to_integer<unsigned>(byte) >> 4U];
    text += digits[std::to_integer<unsigned>(byte) & 15U];
  }
  return text;
}

/// Makes the checksum right again, as a faulty sender would.
void seal(Bytes& bytes) {
  const std::size_t end = bytes.size() - 4;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(end));
  for (std::size_t i = 0; i < 4; ++i)
    bytes[end + i] = static_cast<std::byte>(sum >> (24U - 8U * i) & 0xFFU);
}

/// Why these bytes are refused; fails where they are not.
Reject reject(const Bytes& bytes) {
  const auto decoded = wire::decode(bytes);
  EXPECT_TRUE(std::holds_alternative<Reject>(decoded));
  const auto* const reason = std::get_if<Reject>(&decoded);
  return reason != nullptr ? *reason : Reject::too_short;
}

// lcm-gen exits with 0 on unknown types. Hash and length of each type as LCM's type specification
// gives them, computed from the .lcm files by a script that shares no code with it.
template <class Lcm>
void expect_type(std::uint64_t hash, int length) {
  EXPECT_EQ(static_cast<std::uint64_t>(Lcm::getHash()), hash) << Lcm::getTypeName();
  EXPECT_EQ(Lcm{}.getEncodedSize(), length) << Lcm::getTypeName();
}

TEST(Wire, TypesAreThoseOfVersionTwo) {
  expect_type<jounce_lcm::ack_t>(0xa889f6c49213c772, 266);
  expect_type<jounce_lcm::arm_t>(0x8a54ab50c0996d4b, 234);
  expect_type<jounce_lcm::chunk_t>(0x15e7a1ad123b3fb0, 100);
  expect_type<jounce_lcm::claim_t>(0xcfa72b3fe99a4735, 93);
  expect_type<jounce_lcm::event_t>(0xf5bb83ca4a1124a5, 122);
  expect_type<jounce_lcm::group_status_t>(0xff55d60bf6fc5218, 578);
  expect_type<jounce_lcm::header_t>(0x38846353a6819b65, 163);
  expect_type<jounce_lcm::heartbeat_t>(0x1249b7b537d13d0d, 81);
  expect_type<jounce_lcm::master_status_t>(0xb47ced7b012d6442, 173);
  expect_type<jounce_lcm::master_t>(0x8eeae70736c030f7, 129);
  expect_type<jounce_lcm::command_t>(0x14c25ba1d776c25f, 153);
  expect_type<jounce_lcm::path_command_t>(0x5f22dcae832c4de1, 281);
  expect_type<jounce_lcm::queue_ack_t>(0x2f7fa95bf3bd3320, 298);
  expect_type<jounce_lcm::queue_t>(0xf4004018570b643c, 161);
  expect_type<jounce_lcm::reply_t>(0xc3e4efeb673330c4, 254);
  expect_type<jounce_lcm::rows_t>(0xede242062e4e07bc, 12897);
  expect_type<jounce_lcm::start_t>(0x18a119ebc70b2884, 97);
  expect_type<jounce_lcm::status_t>(0x86320302676e16f5, 577);
  expect_type<jounce_lcm::stop_t>(0xb6b153946f26a3c8, 81);
}

/// True if the protocol page, from which others implement the protocol, has the same values.
template <class Lcm>
bool is_documented(const std::string& page) {
  std::ostringstream hash;
  hash << std::hex << std::setw(16) << std::setfill('0') << Lcm::getHash();
  const auto row = page.find("| `" + std::string(Lcm::getTypeName()) + "` |");
  if (row == std::string::npos) return false;
  return page.substr(row, page.find('\n', row) - row).find(hash.str()) != std::string::npos;
}

TEST(Wire, IsDocumented) {
  std::ifstream file(JOUNCE_SOURCE_DIR "/docs/stream-protocol.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  EXPECT_TRUE(is_documented<jounce_lcm::ack_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::arm_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::chunk_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::claim_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::event_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::group_status_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::header_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::heartbeat_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::master_status_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::master_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::command_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::queue_ack_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::queue_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::reply_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::rows_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::start_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::status_t>(page));
  EXPECT_TRUE(is_documented<jounce_lcm::stop_t>(page));
  std::ifstream reference(JOUNCE_SOURCE_DIR "/docs/reference/messages.md");
  const std::string messages(std::istreambuf_iterator<char>(reference), {});
  for (int i = 1; i < wire::refusals; ++i) {
    const std::string row = "| " + std::to_string(i) + " | " + name(static_cast<wire::Refusal>(i));
    EXPECT_NE(messages.find(row + " |"), std::string::npos) << row;
  }
}

TEST(Wire, BytesAreBigEndianWithTheChecksumLast) {
  // Packed field by field, checksum included, by Python's struct and zlib.
  const Message message{"feeder", 0x0102030405060708,
                        wire::Heartbeat{.command = 7, .release = true}, 0x1112131415161718};
  EXPECT_EQ(hex(wire::encode(message)),
            "1249b7b537d13d0d"                                  // type
            "4a4e4345"                                          // magic
            "00000002"                                          // version
            "666565646572000000000000000000000000000000000000"  // executor
            "0102030405060708"                                  // session
            "1112131415161718"                                  // challenge
            "00000007"                                          // command
            "01"                                                // release
            "00000000000000000000000000000000"                  // mac
            "0fc834f3");                                        // checksum
}

TEST(Wire, EveryMessageComesBackAsItWas) {
  for (const Message& message : test::samples()) {
    const Bytes bytes = wire::encode(message);
    const auto decoded = wire::decode(bytes);
    ASSERT_TRUE(std::holds_alternative<Message>(decoded)) << message.body.index();
    const auto& back = std::get<Message>(decoded);
    EXPECT_EQ(back.executor, message.executor);
    EXPECT_EQ(back.session, message.session);
    EXPECT_EQ(test::text(back), test::text(message));
    EXPECT_EQ(wire::encode(back), bytes);
  }
}

TEST(Wire, DoublesComeBackBitByBit) {
  const std::vector<double> odd{-0.0,
                                std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::max(),
                                0.1};
  const Message message{"a", 1, wire::Chunk{.knots = 3, .columns = 2, .values = odd}};
  const auto decoded = wire::decode(wire::encode(message));
  const auto& values = std::get<wire::Chunk>(std::get<Message>(decoded).body).values;
  ASSERT_EQ(values.size(), odd.size());
  EXPECT_EQ(std::memcmp(values.data(), odd.data(), odd.size() * sizeof(double)), 0);
}

TEST(Wire, AChunkHasTheLengthOfItsCount) {
  const auto chunk = [](std::uint32_t knots) {
    const std::vector<double> values(std::size_t{knots} * 4, 0.5);
    return wire::encode({"a", 1, wire::Chunk{.knots = knots, .columns = 4, .values = values}});
  };
  EXPECT_EQ(chunk(1).size(), 100U + 4 * 8);
  const Bytes longest = chunk(wire::chunk_values / 4);
  EXPECT_LE(longest.size(), 65'000U) << "one datagram";
  EXPECT_TRUE(std::holds_alternative<Message>(wire::decode(longest)));
  EXPECT_THROW(chunk(wire::chunk_values / 4 + 1), InputError);
  // For every count, 76 bytes from its beginning, no memory of that length is taken.
  for (const unsigned top : {0x00U, 0x10U, 0x7FU, 0x80U, 0xFFU}) {
    Bytes bytes = chunk(2);
    bytes[76] = static_cast<std::byte>(top);
    bytes[78] = std::byte{1};
    seal(bytes);
    EXPECT_EQ(reject(bytes), Reject::wrong_length) << top;
  }
  Bytes torn = chunk(2);
  torn.resize(99);
  EXPECT_EQ(reject(torn), Reject::wrong_length);
  Bytes other = chunk(2);
  other[71] = std::byte{3};  // three knots
  seal(other);
  EXPECT_EQ(reject(other), Reject::bad_field);
}

TEST(Wire, NamesEachWayInWhichBytesAreNoMessage) {
  const Bytes good = wire::encode(test::samples().front());
  EXPECT_EQ(reject({}), Reject::too_short);
  Bytes bytes = good;
  bytes[8] ^= std::byte{1};
  EXPECT_EQ(reject(bytes), Reject::wrong_magic);
  bytes = good;
  bytes[15] = std::byte{1};  // the one before
  seal(bytes);
  EXPECT_EQ(reject(bytes), Reject::wrong_version) << "even where the rest is sound";
  bytes = good;
  bytes[0] ^= std::byte{1};
  EXPECT_EQ(reject(bytes), Reject::unknown_type);
  bytes = good;
  bytes.push_back({});
  EXPECT_EQ(reject(bytes), Reject::wrong_length);
  bytes = good;
  bytes[50] ^= std::byte{1};
  EXPECT_EQ(reject(bytes), Reject::wrong_checksum);
}

/// The message with one of its bytes set to another value and the checksum made right.
Bytes forged(const wire::Body& body, std::size_t at, unsigned value) {
  Bytes bytes = wire::encode({"feeder", 5, body});
  bytes.at(at) = static_cast<std::byte>(value);
  seal(bytes);
  return bytes;
}

TEST(Wire, RejectsFieldsOutOfRange) {
  constexpr std::size_t fields = 56;  // behind type and envelope
  const wire::Header header{.units = {"s", "mm"}, .knots = 5, .columns = 2, .chunks = 1};
  const wire::Chunk chunk{.knots = 2, .columns = 2, .values = {1, 2, 3, 4}};
  EXPECT_EQ(reject(forged(header, 16, 0)), Reject::bad_field) << "no executor";
  EXPECT_EQ(reject(forged(header, 17, '.')), Reject::bad_field) << "a dot in its name";
  EXPECT_EQ(reject(forged(header, 30, 'x')), Reject::bad_field) << "letters behind its end";
  EXPECT_EQ(reject(forged(header, 40, 0x80)), Reject::bad_field) << "session < 0";
  EXPECT_EQ(reject(forged(header, 47, 0)), Reject::bad_field) << "session 0";
  EXPECT_EQ(reject(forged(header, fields, 0xFF)), Reject::bad_field) << "table < 0";
  EXPECT_EQ(reject(forged(header, fields + 3, 64)), Reject::bad_field) << "table 64";
  EXPECT_EQ(reject(forged(header, fields + 36, 2)), Reject::bad_field) << "axis 2";
  EXPECT_EQ(reject(forged(header, fields + 37, 0xFF)), Reject::bad_field) << "rule -1";
  EXPECT_EQ(reject(forged(header, fields + 38, 4)), Reject::bad_field) << "outside 4";
  EXPECT_EQ(reject(forged(header, fields + 40, 7)), Reject::bad_field) << "a bell in the unit";
  EXPECT_EQ(reject(forged(header, fields + 71, 0x80)), Reject::bad_field) << "knots < 0";
  EXPECT_EQ(reject(forged(chunk, fields + 15, 0)), Reject::bad_field) << "no knots";
  EXPECT_EQ(reject(forged(chunk, fields + 14, 0x04)), Reject::bad_field) << "1026 knots of 2";
  EXPECT_EQ(reject(forged(chunk, fields + 19, 5)), Reject::bad_field) << "5 columns";
  EXPECT_EQ(reject(forged(wire::Start{.command = 1}, fields + 3, 0)), Reject::bad_field);
  EXPECT_EQ(reject(forged(wire::Start{.command = 1}, fields + 11, 0xFE)), Reject::bad_field);
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 4, 3)), Reject::bad_field) << "queue 0";
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 4, 5)), Reject::bad_field);
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 69, 6)), Reject::bad_field) << "start";
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 69, 2)), Reject::bad_field)
      << "ramp_in without its limits";
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 70, 2)), Reject::bad_field) << "flag";
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 72, 0xBF)), Reject::bad_field)
      << "master_scaling -1";
  EXPECT_EQ(reject(forged(wire::Arm{.command = 1}, fields + 104, 0xBF)), Reject::bad_field)
      << "velocity_diff < 0";
  EXPECT_EQ(reject(forged(wire::Stop{.command = 1}, fields + 4, 2)), Reject::bad_field);
  EXPECT_EQ(reject(forged(wire::Heartbeat{.command = 1}, fields + 4, 2)), Reject::bad_field);
  EXPECT_EQ(reject(forged(wire::Ack{.boot = 1}, fields + 7, 0)), Reject::bad_field) << "boot 0";
}

TEST(Wire, RejectsGroupsOutOfRange) {
  constexpr std::size_t fields = 56;  // behind type and envelope
  const wire::GroupStatus seen{.boot = 1, .tick = 5, .axes = {"x", "y"}, .place = {1, 2}};
  const auto status = [&](std::size_t at, unsigned value) {
    Bytes bytes = wire::encode({"plotter", 0, seen});
    bytes.at(at) = static_cast<std::byte>(value);
    seal(bytes);
    return reject(bytes);
  };
  EXPECT_EQ(status(fields + 7, 0), Reject::bad_field) << "boot 0";
  EXPECT_EQ(status(fields + 8, 0x80), Reject::bad_field) << "tick < 0";
  EXPECT_EQ(status(fields + 19, 0), Reject::bad_field) << "no axes";
  EXPECT_EQ(status(fields + 19, 3), Reject::bad_field) << "a third axis without a name";
  EXPECT_EQ(status(fields + 19, 1), Reject::bad_field) << "a name beyond the axes";
  EXPECT_EQ(status(fields + 19, 10), Reject::bad_field) << "10 axes";
  EXPECT_EQ(status(fields + 20, '.'), Reject::bad_field) << "a dot in a name";
  EXPECT_EQ(status(fields + 236 + 2 * 8, 0), Reject::bad_field) << "a place beyond the axes";
  EXPECT_EQ(status(fields + 308, 2), Reject::bad_field) << "framed 2";
  EXPECT_EQ(status(fields + 309, 0x80), Reject::bad_field) << "line < 0";
  EXPECT_EQ(status(fields + 313, 0x80), Reject::bad_field) << "commands < 0";
  EXPECT_EQ(status(fields + 317, 2), Reject::bad_field) << "estimated 2";
  EXPECT_EQ(status(fields + 318, 0xBF), Reject::bad_field) << "position < 0";
  EXPECT_EQ(status(fields + 358 + 2 * 16, 'm'), Reject::bad_field) << "a unit beyond the axes";
  EXPECT_EQ(status(fields + 358, '\n'), Reject::bad_field) << "a control character in a unit";
  EXPECT_EQ(status(fields + 326, 0xBF), Reject::bad_field) << "length < 0";
}

TEST(Wire, RejectsMastersOutOfRange) {
  constexpr std::size_t fields = 56;  // behind type and envelope
  const wire::MasterStatus seen{1, "line", "mm", 5, false, 1, 2, 0.5, 3, 4};
  EXPECT_EQ(reject(forged(seen, fields + 7, 0)), Reject::bad_field) << "boot 0";
  EXPECT_EQ(reject(forged(seen, fields + 8, '.')), Reject::bad_field) << "a dot in its name";
  EXPECT_EQ(reject(forged(seen, fields + 48, 0x80)), Reject::bad_field) << "tick < 0";
  EXPECT_EQ(reject(forged(seen, fields + 56, 1)), Reject::bad_field) << "lost, with a position";
  EXPECT_EQ(reject(forged(seen, fields + 73, 0xBF)), Reject::bad_field) << "age < 0";
  EXPECT_EQ(reject(forged(seen, fields + 81, 0x80)), Reject::bad_field) << "taken < 0";
  const auto said = [](const wire::Master& master) {
    return wire::decode(wire::encode({"line", 0, master}));
  };
  const wire::Master good{1, 2, 3, true, 4, 5, "mm"};
  EXPECT_TRUE(std::holds_alternative<Message>(said(good)));
  for (const auto& break_it : std::vector<void (*)(wire::Master&)>{
           [](wire::Master& m) { m.seq = -1; }, [](wire::Master& m) { m.stamp_ns = -1; },
           [](wire::Master& m) { m.clock = -1; }, [](wire::Master& m) { m.position = NAN; },
           [](wire::Master& m) { m.velocity = INFINITY; },
           [](wire::Master& m) { m.unit.clear(); }}) {
    wire::Master bad = good;
    break_it(bad);
    const auto decoded = said(bad);
    ASSERT_TRUE(std::holds_alternative<Reject>(decoded));
    EXPECT_EQ(std::get<Reject>(decoded), Reject::bad_field);
  }
}

TEST(Wire, OperatorsAndFreeAxesHaveNoSession) {
  for (const wire::Body& body : {wire::Body{wire::Stop{.command = 1}}, wire::Body{wire::Status{}},
                                 wire::Body{wire::Reply{.boot = 1, .command = 1}}})
    EXPECT_TRUE(std::holds_alternative<Message>(wire::decode(wire::encode({"a", 0, body}))));
  EXPECT_EQ(reject(wire::encode({"a", 0, wire::Start{.command = 1}})), Reject::bad_field);
}

TEST(Wire, RejectsToEncodeWhatDoesNotFit) {
  const auto units = [](std::string x) { return wire::Header{.units = {std::move(x), "mm"}}; };
  EXPECT_THROW(wire::encode({"", 1, wire::Start{}}), InputError);
  EXPECT_THROW(wire::encode({"two words", 1, wire::Start{}}), InputError);
  EXPECT_THROW(wire::encode({std::string(24, 'a'), 1, wire::Start{}}), InputError);
  EXPECT_THROW(wire::encode({"a", 1, units("sixteen letters!")}), InputError);
  EXPECT_THROW(wire::encode({"a", 1, units("m\n")}), InputError);
  EXPECT_THROW(
      wire::encode({"a", 1, wire::Chunk{.values = std::vector<double>(wire::chunk_values + 1)}}),
      InputError);
  EXPECT_NO_THROW(wire::encode({std::string(23, 'a'), 1, units("fifteen letters")}));
}

TEST(Wire, ShortensAReasonBetweenCharacters) {
  const std::string reason = std::string(156, 'x') + "µmmmm";  // µ has the bytes 157 and 158
  const Message message{"a", 1, wire::Reply{.boot = 1, .command = 1, .reason = reason}};
  const auto decoded = wire::decode(wire::encode(message));
  EXPECT_EQ(std::get<wire::Reply>(std::get<Message>(decoded).body).reason,
            std::string(156, 'x') + "...");
}

TEST(Wire, SurvivesTruncationAtEveryLength) {
  for (const Message& message : test::samples()) {
    const Bytes bytes = wire::encode(message);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      // A copy of its own, so that a sanitizer sees any byte read behind the end.
      const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
      ASSERT_EQ(reject(cut), length < 20 ? Reject::too_short : Reject::wrong_length) << length;
    }
  }
}

/// An accepted message must match its bytes exactly: there is one encoding of a message.
bool refused_or_canonical(const Bytes& bytes) {
  const auto decoded = wire::decode(bytes);
  const auto* const message = std::get_if<Message>(&decoded);
  return message == nullptr || wire::encode(*message) == bytes;
}

TEST(Wire, SurvivesRandomDamage) {
  test::Random random(20240601);
  std::size_t wrong_checksum = 0;
  const auto samples = test::samples();
  for (int i = 0; i < 10'000; ++i) {
    Bytes bytes = wire::encode(samples[random.below(samples.size())]);
    bytes[random.below(bytes.size())] ^= static_cast<std::byte>(1 + random.below(255));
    const auto decoded = wire::decode(bytes);
    ASSERT_TRUE(std::holds_alternative<Reject>(decoded)) << "case " << i;
    wrong_checksum += std::get<Reject>(decoded) == Reject::wrong_checksum ? 1 : 0;
  }
  EXPECT_GT(wrong_checksum, 5000U) << "most damage is behind type, magic and version";
}

TEST(Wire, SurvivesRandomForgery) {
  test::Random random(20240602);
  std::size_t passed = 0;
  const auto samples = test::samples();
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = wire::encode(samples[random.below(samples.size())]);
    const std::size_t changes = 1 + random.below(std::size_t{4});
    // Mostly the front of the message, where the fields with meaning are.
    for (std::size_t k = 0; k < changes; ++k)
      bytes[16 + random.below(std::min<std::size_t>(bytes.size() - 20, 120))] =
          static_cast<std::byte>(random.below(256));
    seal(bytes);
    ASSERT_TRUE(refused_or_canonical(bytes)) << "case " << i << ": " << hex(bytes).substr(0, 300);
    passed += std::holds_alternative<Message>(wire::decode(bytes)) ? 1 : 0;
  }
  EXPECT_GT(passed, 100U) << "some forgeries must reach the fields and pass";
}

TEST(Wire, SurvivesNoise) {
  test::Random random(20240603);
  for (int i = 0; i < 5'000; ++i) {
    Bytes bytes(random.below(std::size_t{400}));
    for (auto& byte : bytes) byte = static_cast<std::byte>(random.below(256));
    ASSERT_TRUE(std::holds_alternative<Reject>(wire::decode(bytes))) << "case " << i;
  }
}

TEST(Wire, EachMessageHasItsChannel) {
  EXPECT_EQ(wire::channel("feeder", wire::lane(wire::Chunk{})), "JOUNCE2.feeder.table");
  EXPECT_EQ(wire::channel("feeder", wire::lane(wire::Header{})), "JOUNCE2.feeder.table");
  for (const wire::Body& body : {wire::Body{wire::Arm{}}, wire::Body{wire::Start{}},
                                 wire::Body{wire::Stop{}}, wire::Body{wire::Heartbeat{}}})
    EXPECT_EQ(wire::channel("feeder", wire::lane(body)), "JOUNCE2.feeder.command");
  EXPECT_EQ(wire::channel("feeder", wire::lane(wire::Ack{})), "JOUNCE2.feeder.reply");
  EXPECT_EQ(wire::channel("feeder", wire::lane(wire::Reply{})), "JOUNCE2.feeder.reply");
  EXPECT_EQ(wire::channel("feeder", wire::lane(wire::Status{})), "JOUNCE2.feeder.status");
  EXPECT_LE(wire::channel(std::string(23, 'a'), wire::Lane::command).size(), 63U) << "LCM's limit";
}

TEST(Wire, EveryEnumeratorHasItsOwnName) {
  std::set<std::string> names;
  for (int i = 0; i < wire::refusals; ++i) names.insert(name(static_cast<wire::Refusal>(i)));
  EXPECT_EQ(names.size(), std::size_t{wire::refusals});
  EXPECT_STREQ(name(wire::Refusal::axis), "axis");
  EXPECT_STREQ(name(wire::Refusal::hash_mismatch), "hash_mismatch");
  EXPECT_STREQ(name(Reject::bad_field), "bad_field");
  EXPECT_STREQ(name(wire::ArmMode::follow_table), "follow_table");
  EXPECT_STREQ(name(wire::ArmMode::path), "path");
  EXPECT_STREQ(name(State::error_stop), "error_stop");
  EXPECT_STREQ(name(wire::Next::waiting), "waiting");
}

TEST(Wire, CutsATableIntoFullChunksAndARest) {
  const wire::Cut pvt = wire::cut(Interpolation::cubic_hermite, 1067);
  EXPECT_EQ(pvt.columns, 3U);
  EXPECT_EQ(pvt.per_chunk, 533U);  // floor(1600 / 3)
  EXPECT_EQ(pvt.chunks, 3U);
  EXPECT_EQ(pvt.knots_of(0, 1067), 533U);
  EXPECT_EQ(pvt.knots_of(2, 1067), 1U);
  EXPECT_EQ(wire::cut(Interpolation::linear, 1600).chunks, 2U);
  EXPECT_EQ(wire::cut(Interpolation::quintic_hermite, 401).chunks, 2U);
  EXPECT_EQ(wire::cut(Interpolation::quintic_hermite, 0).chunks, 0U);
  EXPECT_EQ(wire::cut(Interpolation::quintic_hermite, 8192, 4096).chunks, 8U);
}

TEST(Wire, LongChunksHaveRoomWhereAsManyBytesHadIt) {
  EXPECT_EQ(wire::cut(Interpolation::linear, 1'000'000, 16).chunks_for(8), 8U)
      << "short ones count as one";
  EXPECT_EQ(wire::cut(Interpolation::linear, 1'000'000, 1600).chunks_for(8), 8U);
  EXPECT_EQ(wire::cut(Interpolation::linear, 1'000'000, 4096).chunks_for(8), 4U);
  EXPECT_EQ(wire::cut(Interpolation::linear, 1'000'000, 7680).chunks_for(8), 2U);
  EXPECT_EQ(wire::cut(Interpolation::linear, 1'000'000, 7680).chunks_for(1), 1U);
  // Datagrams that fill Linux's default buffer of 212 992 bytes where a frame has 1500, counted.
  EXPECT_LE(wire::cut(Interpolation::linear, 1'000'000, 4266).chunks_for(8), 3U);
  EXPECT_LE(wire::cut(Interpolation::linear, 1'000'000, 6398).chunks_for(8), 2U);
}

/// The message with this text in it replaced byte for byte, and the checksum made right.
Bytes with_text(Bytes bytes, const std::string& text, const std::string& other) {
  const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
  const auto at = std::search(bytes.begin(), bytes.end(), begin, begin + text.size());
  EXPECT_NE(at, bytes.end());
  std::transform(other.begin(), other.end(), at, [](char c) { return static_cast<std::byte>(c); });
  seal(bytes);
  return bytes;
}

// The direction of the master is part of the variable: queues without one have the bytes that they had.
TEST(Wire, TheVariableOfAQueueHasItsDirection) {
  for (const int direction : {-1, 0, 1}) {
    wire::Queue queue{.queue = 64, .axis = Domain::master, .capacity = 2};
    queue.direction = static_cast<std::int8_t>(direction);
    const Bytes bytes = wire::encode({"feeder", 1, queue});
    const auto decoded = wire::decode(bytes);
    ASSERT_TRUE(std::holds_alternative<wire::Message>(decoded)) << direction;
    EXPECT_EQ(std::get<wire::Queue>(std::get<wire::Message>(decoded).body), queue) << direction;
    EXPECT_EQ(wire::variable_number(queue), direction == 0 ? 1 : direction > 0 ? 2 : 3);
    EXPECT_EQ(contradiction(queue), "");
  }
  wire::Queue queue{.queue = 64, .capacity = 2, .direction = 1};
  EXPECT_EQ(contradiction(queue), "a direction needs a queue over master position");
  EXPECT_FALSE(wire::set_variable(4, queue));
  EXPECT_FALSE(wire::set_variable(-1, queue));
}

TEST(Wire, EveryTextIsUtf8WithoutControlCharacters) {
  const std::string mark = "wxyz";
  const Units units{mark, "mm"}, others{"mm", mark};
  const std::vector<wire::Body> bodies = {
      wire::Header{
          .hash = {1}, .units = units, .knots = 2, .columns = 2, .per_chunk = 2, .chunks = 1},
      wire::Header{
          .hash = {1}, .units = others, .knots = 2, .columns = 2, .per_chunk = 2, .chunks = 1},
      wire::Queue{.queue = 64, .units = units, .capacity = 2, .prefill = 1},
      wire::Queue{.queue = 64, .units = others, .capacity = 2, .prefill = 1},
      wire::Ack{.boot = 1, .reason = mark},
      wire::Reply{.boot = 1, .command = 1, .reason = mark},
      wire::QueueAck{.boot = 1, .reason = mark},
      wire::Status{.units = units},
      wire::Status{.units = others},
      wire::Master{.unit = mark},
      wire::MasterStatus{.boot = 1, .master = "line", .unit = mark},
      wire::MasterStatus{.boot = 1, .master = mark, .unit = "mm"},
      wire::GroupStatus{.boot = 1, .axes = {mark}, .place = {0}}};
  for (const wire::Body& body : bodies) {
    const bool none = wire::lane(body) == wire::Lane::master ||
                      wire::lane(body) == wire::Lane::masters ||
                      wire::lane(body) == wire::Lane::group;
    const Bytes good = wire::encode({"feeder", none ? 0 : 1, body});
    ASSERT_TRUE(std::holds_alternative<wire::Message>(wire::decode(good))) << body.index();
    for (const std::string bad : {"\xff\xfe\xfd", "a\x1b[J", "a\x7f", "\xc2\x9b", "\xc0\xaf",
                                  "\xed\xa0\x80", "a\nb", "wxy\xe2", "\xe2\x80\xae"})
      EXPECT_EQ(reject(with_text(good, mark, bad)), Reject::bad_field)
          << body.index() << " with " << printable(bad);
  }
}

TEST(Wire, ALongReasonEndsAfterAWord) {
  const std::string words = std::string(150, 'x') + " velocity limit";  // 159 is in the last word
  const auto decoded =
      wire::decode(wire::encode({"a", 1, wire::Reply{.boot = 1, .command = 1, .reason = words}}));
  EXPECT_EQ(std::get<wire::Reply>(std::get<wire::Message>(decoded).body).reason,
            std::string(150, 'x') + "...");
}

TEST(Wire, WhatIsSentIsReceivedWhateverTextItWasMadeFrom) {
  const wire::Message message{
      "feeder", 1,
      wire::Reply{
          .boot = 1, .command = 1, .reason = "file a\x1b[2J\xff: no\n" + std::string(300, 'x')}};
  const auto decoded = wire::decode(wire::encode(message));
  const auto* const back = std::get_if<wire::Message>(&decoded);
  ASSERT_NE(back, nullptr) << "an executor whose answer cannot be decoded does not answer";
  EXPECT_EQ(std::get<wire::Reply>(back->body).reason.substr(0, 15), "file a?[2J?: no");
}

}  // namespace
}  // namespace jounce::wire_test
