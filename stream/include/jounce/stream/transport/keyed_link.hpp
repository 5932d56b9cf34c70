// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Address of the bus of executors and streamers, with the key that they share.
struct LinkOptions {
  std::string url = "udpm://239.255.76.67:7667";  ///< see open_transport()
  std::string key = {};                           ///< key file, see read_key(); "": no key
  double lost = 0;         ///< share of packets to lose in each direction, for tests
  std::uint64_t seed = 1;  ///< seed of these losses
};

/// True if every machine of a network can command the axes of this bus: its packets leave this
/// machine, and there is no key. Throws InputError (key "url") for an invalid address, like
/// open_transport().
bool is_unprotected(const LinkOptions& options);

/// Danger of an unprotected link, and its remedy.
inline constexpr const char* unprotected_warning =
    "this --url reaches other machines and there is no --key, so every machine of that network can "
    "move and stop these axes. Make a key with `jounce new key -o line.key`";

/// A link to a bus, with its key:
///
///     KeyedLink link({.url = "udpm://239.255.76.67:7667?ttl=1", .key = "line.key"});
///     stop_axis(link.transport(), "feeder", wire::StopMode::stop, nanos(10), link.key());
class KeyedLink {
 public:
  /// Throws InputError (key "url" or "key") like open_transport() and read_key(), and
  /// TransportError if the network is missing.
  explicit KeyedLink(const LinkOptions& options);
  [[nodiscard]] Transport& transport() { return lossy_ ? *lossy_ : *link_; }
  [[nodiscard]] const std::optional<wire::Key>& key() const { return key_; }

 private:
  std::unique_ptr<Transport> link_;
  std::unique_ptr<Transport> lossy_;  ///< loses packets of `link_`
  std::optional<wire::Key> key_;
};

}  // namespace jounce
