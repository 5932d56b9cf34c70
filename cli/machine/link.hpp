// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// Bus address of executors and streamers.
struct LinkOptions {
  std::string url = "udpm://239.255.76.67:7667";
  std::string key;         ///< file; empty: none
  double inject_loss = 0;  ///< share of packets to lose, for tests
  std::uint64_t seed = 1;
};

/// Hint for a missing answer of an executor.
inline constexpr const char* unheard_hint =
    "check that it is running, with the same --url and the same --key";

/// Throws InputError, of this argument, where no executor, axis or master can be called so.
void require_name_on_bus(const std::string& argument, const std::string& name);

/// Counts the time of --seconds; 0: without an end.
class Duration {
 public:
  explicit Duration(double seconds) : seconds_(seconds) {}
  [[nodiscard]] bool goes_on() const {
    return seconds_ == 0 || steady_now() - begun_ < nanos(seconds_);
  }

 private:
  double seconds_;
  Nanos begun_ = steady_now();
};

/// Adds --url and --key, and the hidden --inject-loss and --seed.
void add_link_options(const Verb& verb, LinkOptions& options);

/// True if every machine of a network can command the axes of this address: the address leaves this
/// machine, and there is no key.
bool is_open(const LinkOptions& options);

/// Why that is dangerous, and what to do.
inline constexpr const char* open_warning =
    "this --url reaches other machines and there is no --key, so every machine of that network can "
    "move and stop these axes. Make a key with `jounce new key -o line.key`";

/// A link made from the options, and made worse if they ask for it. Throws TransportError with
/// advice where the network is missing.
class Link {
 public:
  explicit Link(const LinkOptions& options);
  [[nodiscard]] Transport& transport() { return lossy_ ? *lossy_ : *link_; }
  [[nodiscard]] const std::optional<wire::Key>& key() const { return key_; }

 private:
  std::unique_ptr<Transport> link_;
  std::unique_ptr<Transport> lossy_;
  std::optional<wire::Key> key_;
};

/// Throws TransportError: no message arrives from this executor. Listens for a second to name those
/// that send.
[[noreturn]] void throw_missing(Link& link, const std::string& executor);

}  // namespace jounce::cli
