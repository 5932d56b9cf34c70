// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/address.hpp"

#include <charconv>
#include <string_view>

#include <arpa/inet.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::string_view multicast = "udpm://";

[[noreturn]] void refuse(const std::string& url, const std::string& rule) {
  throw InputError("url", url, rule);
}

int whole(const std::string& url, std::string_view name, std::string_view text, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high)
    refuse(url, std::string(name) + " must be a whole number from " + std::to_string(low) + " to " +
                    std::to_string(high));
  return value;
}

void read_option(const std::string& url, std::string_view option, MulticastAddress& address) {
  const auto equals = option.find('=');
  const auto name = option.substr(0, equals);
  const auto value = equals == option.npos ? std::string_view() : option.substr(equals + 1);
  if (name == "ttl")
    address.ttl = whole(url, name, value, 0, 255);
  else if (name == "recv_buf_size")
    address.receive_buffer = whole(url, name, value, 2048, 1 << 30);
  else if (name == "interface" && !value.empty())
    address.interface = value;
  else
    refuse(url,
           "has an unknown option; the options are ttl=N, interface=NAME and recv_buf_size=BYTES");
}

/// Removes the text up to the next `end`, and the mark itself, from `rest`, and returns the text.
std::string_view taken(std::string_view& rest, char end) {
  const auto at = rest.find(end);
  const std::string_view head = rest.substr(0, at);
  rest = at == rest.npos ? std::string_view() : rest.substr(at + 1);
  return head;
}

}  // namespace

MulticastAddress multicast_address(const std::string& url) {
  std::string_view rest = url;
  if (!rest.starts_with(multicast)) refuse(url, "must begin with udpm:// or unix://");
  rest.remove_prefix(multicast.size());
  std::string_view place = taken(rest, '?');
  MulticastAddress address;
  address.group = taken(place, ':');
  if (!place.empty())
    address.port = static_cast<std::uint16_t>(whole(url, "the port", place, 1, 65535));
  in_addr group{};
  if (inet_pton(AF_INET, address.group.c_str(), &group) != 1 || !IN_MULTICAST(ntohl(group.s_addr)))
    refuse(
        url,
        "needs a multicast group, 224.0.0.0 to 239.255.255.255, as in udpm://239.255.76.67:7667");
  while (!rest.empty()) read_option(url, taken(rest, '&'), address);
  if (address.is_local() && !address.interface.empty())
    refuse(url, "needs ttl=1 beside interface: without it, packets stay on this machine");
  return address;
}

bool is_local(const std::string& url) {
  return url.starts_with("unix://") || url == "memq://" || multicast_address(url).is_local();
}

}  // namespace jounce
