// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/gate.hpp"

#include <random>

namespace jounce::web {
namespace {

bool is_here(std::string_view host, std::uint16_t port) {
  const std::string at = ":" + std::to_string(port);
  return host == "127.0.0.1" + at || host == "localhost" + at;
}

bool is_from_here(std::string_view origin, std::uint16_t port) {
  constexpr std::string_view scheme = "http://";
  return origin.substr(0, scheme.size()) == scheme && is_here(origin.substr(scheme.size()), port);
}

}  // namespace

std::string objection(const Origin& origin, std::uint16_t port) {
  if (!is_here(origin.host, port))
    return "Host must be 127.0.0.1:" + std::to_string(port) +
           " or localhost:" + std::to_string(port);
  if (!origin.origin.empty() && !is_from_here(origin.origin, port))
    return "the request comes from a page of another origin";
  if (!origin.site.empty() && origin.site != "same-origin" && origin.site != "none")
    return "the request comes from another site";
  return {};
}

std::string new_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 32; ++i) token += "0123456789abcdef"[device() % 16];
  return token;
}

bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

}  // namespace jounce::web
