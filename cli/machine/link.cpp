// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/link.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "jounce/command/causes.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/address.hpp"
#include "jounce/stream/transport/lossy_transport.hpp"
#include "jounce/stream/transport/open_transport.hpp"

namespace jounce::cli {

std::string said_of(StreamError error, const std::string& reason) {
  std::string said = std::string(name(error)) + ": " + reason;
  if (error == StreamError::no_answer) said += std::string("; ") + unheard_hint;
  return said;
}

std::string reason_of_axis(std::string reason, std::int32_t cause, const std::string& executor) {
  constexpr std::string_view who = "axis: ";
  if (reason.starts_with(who)) reason.erase(0, who.size());
  for (const CauseInfo& one : all_causes()) {
    if (cause == 0 || static_cast<std::int32_t>(one.cause) != cause) continue;
    if (!reason.starts_with(one.name)) return reason;  // the executor's own reason has its remedy
    std::string remedy = one.remedy;
    constexpr std::string_view placeholder = "NAME";
    for (auto at = remedy.find(placeholder); at != std::string::npos;
         at = remedy.find(placeholder, at)) {
      remedy.replace(at, placeholder.size(), executor);
      at += executor.size();
    }
    return reason + " " + remedy;
  }
  return reason;
}

void require_name_on_bus(const std::string& argument, const std::string& name) {
  if (!wire::is_executor_name(name)) throw InputError(argument, name, wire::executor_name_rule);
}

Nanos nanos(double seconds) {
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>(std::min(seconds, 1e9)));
}

void add_link_options(const Verb& verb, LinkOptions& options) {
  verb.option("--url", options.url,
              "Address of the bus: udpm://GROUP:PORT is LCM multicast, on this machine only unless "
              "?ttl=1 is added; unix://FOLDER needs no network")
      .shown();
  verb.option("--key", options.key,
              "File with the key that signs the commands; see jounce new key");
  verb.option("--inject-loss", options.inject_loss,
              "For tests: share of packets to lose in each direction")
      .hidden();
  verb.option("--seed", options.seed, "Of --inject-loss").hidden();
}

bool is_open(const LinkOptions& options) {
  return options.key.empty() && !is_local(options.url);
}

Link::Link(const LinkOptions& options) : link_(open_transport(options.url)) {
  if (!options.key.empty()) key_ = read_key(options.key);
  if (options.inject_loss > 0)
    lossy_ = std::make_unique<LossyTransport>(
        *link_, LossSpec{.seed = options.seed, .lost = options.inject_loss}, steady_now);
}

}  // namespace jounce::cli
