// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Access control of a server on the loopback address. This address excludes other machines, but
/// not the pages of other sites in a browser of this machine: they may send requests here
/// (cross-site request forgery), or assign this address to their own name (DNS rebinding).
///
///     const std::string token = new_token();             // shown to the operator, never served
///     const std::string no = objection({.host = "evil.example:8080"}, 8080);  // empty: none
///     if (!same(token, given)) return 403;                // before any action
namespace jounce::web {

/// Origin of a request by its headers; empty: missing.
struct Origin {
  std::string host{};    ///< Host
  std::string origin{};  ///< Origin: browsers send it with every POST
  std::string site{};    ///< Sec-Fetch-Site: same-origin, none (typed in), same-site, cross-site
};

/// Reason to reject a request completely, as a sentence; empty: none. Host must be 127.0.0.1 or
/// localhost with this port; Origin, if present, the same; Sec-Fetch-Site same-origin or none.
/// (Fetch Metadata Request Headers, W3C; RFC 6454 for Origin.)
std::string objection(const Origin& origin, std::uint16_t port);

/// 32 random hexadecimal digits.
std::string new_token();

/// True if two texts are equal; takes the same time for any difference.
bool same(std::string_view a, std::string_view b);

}  // namespace jounce::web
