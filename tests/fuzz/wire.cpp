// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fuzz/packets.hpp"

namespace jounce::fuzz {
namespace {

/// A decoded message represents its bytes: encoded again, it is decoded as the same.
void check(std::span<const std::byte> bytes) {
  const auto decoded = wire::decode(bytes);
  const auto* const message = std::get_if<wire::Message>(&decoded);
  if (message == nullptr) return;
  const wire::Bytes again = wire::encode(*message);
  require(again.size() == bytes.size(), "a type has one length");
  const auto back = wire::decode(again);
  const auto* const same = std::get_if<wire::Message>(&back);
  require(same != nullptr, "what is encoded can be decoded");
  require(wire::encode(*same) == again, "encoding and decoding agree");
}

}  // namespace

void wire(Input input) {
  check(std::as_bytes(input));
  Source source(input);
  check(packet(source));
}

}  // namespace jounce::fuzz
