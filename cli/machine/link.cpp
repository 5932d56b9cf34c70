// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/link.hpp"

#include "jounce/machine/watch.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/address.hpp"
#include "jounce/stream/transport/lossy_transport.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "cli/common/option_names.hpp"

namespace jounce::cli {

void require_name_on_bus(const std::string& argument, const std::string& name) {
  if (!wire::is_executor_name(name)) throw InputError(argument, name, wire::executor_name_rule);
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
  return options.key.empty() && !with_option_names({"url"}, [&] { return is_local(options.url); });
}

Link::Link(const LinkOptions& options)
    : link_(with_option_names({"url"}, [&] { return open_transport(options.url); })) {
  if (!options.key.empty())
    key_ = with_option_names({"key"}, [&] { return read_key(options.key); });
  if (options.inject_loss > 0)
    lossy_ = std::make_unique<LossyTransport>(
        *link_, LossSpec{.seed = options.seed, .lost = options.inject_loss}, steady_now);
}

void throw_missing(Link& link, const std::string& executor) {
  throw TransportError("no message from " + executor + ": " +
                       dashboard::senders_hint(link.transport(), link.key()));
}

}  // namespace jounce::cli
