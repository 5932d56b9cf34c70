// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/datagram.hpp"

#include <algorithm>
#include <cstring>

namespace jounce::stream_detail {
namespace {

constexpr std::size_t longest_channel = 63;

}  // namespace

std::vector<std::byte> datagram_of(const std::string& channel, std::span<const std::byte> bytes) {
  std::vector<std::byte> datagram(channel.size() + 1 + bytes.size());
  std::memcpy(datagram.data(), channel.c_str(), channel.size() + 1);
  std::copy(bytes.begin(), bytes.end(),
            datagram.begin() + static_cast<std::ptrdiff_t>(channel.size() + 1));
  return datagram;
}

std::optional<Packet> packet_of(std::span<const std::byte> datagram) {
  if (datagram.size() > longest_datagram) return std::nullopt;
  const auto end = std::find(datagram.begin(), datagram.end(), std::byte{0});
  const auto length = static_cast<std::size_t>(end - datagram.begin());
  if (end == datagram.end() || length == 0 || length > longest_channel) return std::nullopt;
  return Packet{{reinterpret_cast<const char*>(datagram.data()), length},
                {end + 1, datagram.end()}};
}

bool matches(const std::string& pattern, const std::string& channel) {
  std::size_t p = 0;
  std::size_t c = 0;
  std::size_t star = std::string::npos;  // the last *, and the text it has matched so far
  std::size_t taken = 0;
  while (c < channel.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = c;
    } else if (p < pattern.size() && pattern[p] == channel[c]) {
      ++p;
      ++c;
    } else if (star != std::string::npos && channel[taken] != '.') {
      p = star + 1;
      c = ++taken;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace jounce::stream_detail
