// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/link.hpp"

#include <filesystem>
#include <string_view>

#include <fmt/format.h>

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

namespace {

/// Prints a warning for a folder of --url that does not exist yet: the executor uses another one, or
/// starts later.
void warn_of_new_folder(const std::string& url) {
  constexpr std::string_view scheme = "unix://";
  std::error_code none;  // an error counts as a folder
  if (!url.starts_with(scheme) || url.size() == scheme.size() ||
      std::filesystem::exists(url.substr(scheme.size()), none) || none)
    return;
  const std::filesystem::path above =
      std::filesystem::path(url.substr(scheme.size())).parent_path();
  if (!above.empty() && !std::filesystem::exists(above, none)) return;  // the link reports it
  fmt::print(stderr,
             "jounce: warning: --url {}: the folder did not exist, so no executor uses it yet: "
             "check the --url of `jounce run`\n",
             url);
}

}  // namespace

KeyedLink open_link(const LinkOptions& options, bool serves) {
  if (!serves) warn_of_new_folder(options.url);
  return with_option_names({"url", "key"}, [&] { return KeyedLink(options); });
}

}  // namespace jounce::cli
