// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/link.hpp"

#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"

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
  verb.option("--inject-loss", options.lost,
              "For tests: share of packets to lose in each direction")
      .hidden();
  verb.option("--seed", options.seed, "Of --inject-loss").hidden();
}

bool is_open(const LinkOptions& options) {
  return with_option_names({"url"}, [&] { return is_unprotected(options); });
}

KeyedLink open_link(const LinkOptions& options) {
  return with_option_names({"url", "key"}, [&] { return KeyedLink(options); });
}

}  // namespace jounce::cli
