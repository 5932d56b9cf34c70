#include "jounce/io/hash.hpp"

#include <bit>

#include <sodium.h>

namespace jounce {
static_assert(std::endian::native == std::endian::little,
              "columns are hashed as they lie in memory");

Sha256 sha256(std::string_view bytes) {
  Sha256 hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                     bytes.size());
  return hash;
}

std::string hex(const Sha256& hash) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const auto byte : hash) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

Sha256 content_hash(const Table& table, const Units& units) {
  std::string head = "jounce table 1\n";
  for (const std::string& line :
       {std::string(name(table.axis())), std::string(name(table.rule())),
        std::string(name(table.outside())), units.x, units.position, std::to_string(table.size())})
    head += line + '\n';
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  const auto add = [&](const void* bytes, std::size_t size) {
    crypto_hash_sha256_update(&state, static_cast<const unsigned char*>(bytes), size);
  };
  add(head.data(), head.size());
  const auto& [x, p, v, a] = table.columns();
  for (const auto* column : {&x, &p, &v, &a}) add(column->data(), column->size() * sizeof(double));
  Sha256 hash{};
  crypto_hash_sha256_final(&state, hash.data());
  return hash;
}

}  // namespace jounce
