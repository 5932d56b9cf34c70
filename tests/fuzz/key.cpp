// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/security/key.hpp"

#include <algorithm>
#include <cctype>

#include "jounce/profiles/error.hpp"

#include "fuzz/memory_file.hpp"
#include "fuzz/packets.hpp"

namespace jounce::fuzz {
namespace {

/// A key file: a key of which each digit stands there, or an InputError.
void read(Input input) {
  const MemoryFile file(input);
  try {
    const wire::Key key = read_key(file.path());
    std::string digits;
    for (const char c : text_of(input))
      if (std::isspace(static_cast<unsigned char>(c)) == 0)
        digits += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    require(digits.size() == 64, "a key has 64 digits");
    for (std::size_t i = 0; i < key.size(); ++i)
      require(std::stoi(digits.substr(2 * i, 2), nullptr, 16) == key[i], "a key is what was read");
  } catch (const InputError&) {
  }
}

/// A key admits only packets of its holders: no raw bytes, no good packets with another key's MAC
/// or none, and no changed signed ones.
void listen(Input input) {
  wire::Key key{}, other{};
  std::fill(key.begin(), key.end(), std::uint8_t{7});
  Source source(input);
  for (auto& byte : other) byte = source.byte();
  other[0] = 8;
  const auto heard = [&](std::span<const std::byte> bytes) {
    return std::holds_alternative<wire::Message>(wire::decode(bytes, key));
  };
  require(!heard(std::as_bytes(input)), "random bytes are dropped");
  Source again = source;
  const wire::Bytes plain = packet(source);
  require(!heard(plain), "packets without a MAC are dropped");

  const auto decoded = wire::decode(plain);
  const auto* const message = std::get_if<wire::Message>(&decoded);
  if (message == nullptr) return;
  require(!heard(wire::encode(*message, other)), "another key is not this one");
  wire::Bytes good = wire::encode(*message, key);
  require(heard(good), "packets of a key holder are accepted");
  const std::size_t at = (again.byte() * std::size_t{256} + again.byte()) % (good.size() - 4);
  const auto turned = static_cast<std::byte>(1 + again.below(255));
  good[at] ^= turned;
  set_checksum(good);
  require(!heard(good), "packets changed on the way are dropped");
}

}  // namespace

void key(Input input) {
  read(input);
  listen(input);
}

}  // namespace jounce::fuzz
