// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/keyed_link.hpp"

#include "jounce/stream/transport/open_transport.hpp"

#include "stream/src/transport/address.hpp"
#include "stream/src/transport/lossy_transport.hpp"

namespace jounce {

bool is_unprotected(const LinkOptions& options) {
  return options.key.empty() && !is_local(options.url);
}

KeyedLink::KeyedLink(const LinkOptions& options) : link_(open_transport(options.url)) {
  if (!options.key.empty()) key_ = read_key(options.key);
  if (options.lost > 0)
    lossy_ = std::make_unique<LossyTransport>(
        *link_, LossSpec{.seed = options.seed, .lost = options.lost}, steady_now);
}

}  // namespace jounce
