// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/lcm_log.hpp"

#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce::base_detail {
namespace {

constexpr std::uint32_t sync_word = 0xEDA1DA01;
constexpr std::size_t head = 28;           // bytes before the channel
constexpr std::int64_t most_channel = 63;  // LCM_MAX_CHANNEL_NAME_LENGTH
constexpr std::int64_t most_data = 1 << 24;

void put(std::string& bytes, std::uint64_t value, int size) {
  for (int i = size - 1; i >= 0; --i)
    bytes.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
}

std::uint64_t get(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::int64_t length(const std::string& bytes, std::size_t at) {
  return static_cast<std::int32_t>(get(bytes, at, 4));
}

}  // namespace

void append(std::string& bytes, std::int64_t number, std::int64_t microseconds,
            std::string_view channel, std::string_view data) {
  put(bytes, sync_word, 4);
  put(bytes, static_cast<std::uint64_t>(number), 8);
  put(bytes, static_cast<std::uint64_t>(microseconds), 8);
  put(bytes, channel.size(), 4);
  put(bytes, data.size(), 4);
  bytes += channel;
  bytes += data;
}

LcmLogReader::LcmLogReader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

/// Returns false at the end of the file; cut() if the end is within the bytes.
bool LcmLogReader::take(std::string& bytes, std::size_t count) {
  bytes.resize(count);
  in_.read(bytes.data(), static_cast<std::streamsize>(count));
  const auto got = static_cast<std::size_t>(in_.gcount());
  cut_ = cut_ || (got > 0 && got < count);
  return got == count;
}

std::optional<LcmEvent> LcmLogReader::next() {
  if (cut_) return std::nullopt;
  std::string bytes;
  if (!take(bytes, head)) return std::nullopt;
  const auto fail = [&](const char* key, const std::string& value, const char* rule) {
    const std::string where =
        "event " + std::to_string(events_ + 1) + " at byte " + std::to_string(offset_) + ": ";
    throw InputError(where + key, value, rule).at(name_);
  };
  if (get(bytes, 0, 4) != sync_word && events_ == 0)
    throw InputError("", "", "is not a record of `jounce run --record`").at(name_);
  if (get(bytes, 0, 4) != sync_word)
    fail("sync word", "", "is missing: the record is damaged here");
  const std::int64_t channel = length(bytes, 20);
  const std::int64_t data = length(bytes, 24);
  if (channel < 1 || channel > most_channel)
    fail("channel", std::to_string(channel), "must be 1 to 63 bytes long: the log is damaged here");
  if (data < 0 || data > most_data)
    fail("data", std::to_string(data), "must be at most 16 MB: the log is damaged here");
  LcmEvent event{.number = static_cast<std::int64_t>(get(bytes, 4, 8)),
                 .microseconds = static_cast<std::int64_t>(get(bytes, 12, 8))};
  if (!take(event.channel, static_cast<std::size_t>(channel)) ||
      !take(event.data, static_cast<std::size_t>(data))) {
    cut_ = true;
    return std::nullopt;
  }
  ++events_;
  offset_ += static_cast<std::int64_t>(head) + channel + data;
  return event;
}

}  // namespace jounce::base_detail
