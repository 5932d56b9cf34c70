// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/stream/transport/keyed_link.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

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

/// Calls is_unprotected() and KeyedLink. Throws InputError for --url and --key. If `serves` is false, prints a
/// warning for a folder of --url that does not exist yet.
bool is_open(const LinkOptions& options);
KeyedLink open_link(const LinkOptions& options, bool serves = false);

}  // namespace jounce::cli
