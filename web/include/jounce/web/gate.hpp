// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Access control of a server on the loopback address. Other computers cannot reach this address.
/// But in a browser on this computer, pages of other sites can send requests to it (cross-site
/// request forgery), or can make their own name refer to it (DNS rebinding). These functions detect
/// such requests.
///
///     const std::string token = new_token();             // shown to the operator, never served
///     const std::string no = objection({.host = "evil.example:8080"}, 8080);  // empty: none
///     if (!same(token, given)) return 403;                // before any action
namespace jounce::web {

/// The headers of a request that show its origin. "": the header is missing.
struct Origin {
  std::string host{};    ///< Host
  std::string origin{};  ///< Origin, which browsers send with every POST
  std::string site{};    ///< Sec-Fetch-Site: same-origin, none (typed in), same-site, cross-site
};

/// Returns the reason to reject a request, as a sentence; "": accepted. Host must be 127.0.0.1 or
/// localhost, with this port. Origin, if present, must be the same address. Sec-Fetch-Site, if
/// present, must be same-origin or none. Sources: Fetch Metadata Request Headers (W3C), RFC 6454
/// (Origin).
std::string objection(const Origin& origin, std::uint16_t port);

/// Returns a new random token of 32 hexadecimal digits.
std::string new_token();

/// True if two texts are equal. The duration of the comparison does not depend on the place of a
/// difference, so that the duration does not reveal the token.
bool same(std::string_view a, std::string_view b);

}  // namespace jounce::web
