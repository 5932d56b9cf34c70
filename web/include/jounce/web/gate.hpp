// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Access control of a server on the loopback address. Listening there keeps other machines out, not
/// the pages of other sites in the browser of this one: they may send requests here (cross-site
/// request forgery), or give their own name this address (DNS rebinding).
///
///     const std::string token = new_token();             // shown to the operator, never served
///     const std::string no = objection({.host = "evil.example:8080"}, 8080);  // in words; empty: none
///     if (!same(token, given)) return 403;                // before anything is done
namespace jounce::web {

/// Origin of a request by its headers; empty: not given.
struct Origin {
  std::string host{};    ///< Host
  std::string origin{};  ///< Origin: browsers send it with every POST
  std::string site{};    ///< Sec-Fetch-Site: same-origin, none (typed in), same-site, cross-site
};

/// Why a request is not answered at all, as a sentence; empty: it is. Host must be 127.0.0.1 or
/// localhost with this port; Origin, where there is one, the same; Sec-Fetch-Site same-origin or
/// none. (Fetch Metadata Request Headers, W3C; RFC 6454 for Origin.)
std::string objection(const Origin& origin, std::uint16_t port);

/// 32 random hexadecimal digits.
std::string new_token();

/// True if two texts are equal, in a time that does not depend on their difference.
bool same(std::string_view a, std::string_view b);

}  // namespace jounce::web
