#include "jounce/io/hash.hpp"

#include <bit>
#include <cstring>

#include <sodium.h>

namespace jounce {
namespace {

static_assert(std::endian::native == std::endian::little,
              "columns are hashed as they lie in memory");

void append(std::string& bytes, const std::vector<double>& column) {
  const std::size_t at = bytes.size();
  bytes.resize(at + column.size() * sizeof(double));
  if (!column.empty())
    std::memcpy(bytes.data() + at, column.data(), column.size() * sizeof(double));
}

}  // namespace

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
  std::string bytes = "jounce table 1\n";
  for (const std::string& line :
       {std::string(name(table.axis())), std::string(name(table.rule())),
        std::string(name(table.outside())), units.x, units.position, std::to_string(table.size())})
    bytes += line + '\n';
  const auto& [x, p, v, a] = table.columns();
  for (const auto* column : {&x, &p, &v, &a}) append(bytes, *column);
  return sha256(bytes);
}

}  // namespace jounce
