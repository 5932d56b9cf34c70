// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/hash.hpp"

#include <bit>
#include <future>
#include <memory>

#define OPENSSL_API_COMPAT 10101  // version 3 warns of SHA256_*, which need no providers
#include <openssl/sha.h>

namespace jounce {
static_assert(std::endian::native == std::endian::little,
              "columns are hashed as they lie in memory");
namespace {

/// OpenSSL's SHA-256. It uses the SHA instructions of the processor if there are any: a table of
/// millions of knots is hashed at both ends of every transfer. The newer EVP functions of OpenSSL
/// are not used: at the first hash they load providers and a configuration file, a quarter of the
/// instructions of a short `check`.
class Hasher {
 public:
  Hasher() { SHA256_Init(&context_); }
  void add(const void* bytes, std::size_t size) { SHA256_Update(&context_, bytes, size); }
  Sha256 result() {
    Sha256 hash{};
    SHA256_Final(hash.data(), &context_);
    return hash;
  }

 private:
  SHA256_CTX context_{};
};

}  // namespace

Sha256 sha256(std::string_view bytes) {
  Hasher hasher;
  hasher.add(bytes.data(), bytes.size());
  return hasher.result();
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

struct ContentHasher::State {
  std::array<Hasher, 4> columns;
  std::array<bool, 4> has{};
};

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) {}
ContentHasher::~ContentHasher() = default;
ContentHasher::ContentHasher(ContentHasher&&) noexcept = default;
ContentHasher& ContentHasher::operator=(ContentHasher&&) noexcept = default;

// Each column has its own state: several threads may add to different columns at once.
void ContentHasher::add(const std::array<std::span<const double>, 4>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) continue;
    state_->has[i] = true;
    state_->columns[i].add(columns[i].data(), columns[i].size_bytes());
  }
}

Sha256 ContentHasher::result(Domain axis, Interpolation rule, Extrapolation outside,
                             const Units& units, std::size_t knots) {
  std::string head = "jounce table, by columns\n";
  for (const std::string& line :
       {std::string(name(axis)), std::string(name(rule)), std::string(name(outside)), units.x,
        units.position, std::to_string(knots)})
    head += line + '\n';
  Hasher all;
  all.add(head.data(), head.size());
  for (std::size_t i = 0; i < state_->columns.size(); ++i) {
    if (!state_->has[i]) continue;
    const Sha256 column = state_->columns[i].result();
    all.add(column.data(), column.size());
  }
  return all.result();
}

/// The columns of a large table are hashed in parallel, each in a separate thread.
Sha256 content_hash(const Table& table, const Units& units) {
  constexpr std::size_t large = 100'000;
  const auto& [x, p, v, a] = table.columns();
  ContentHasher hasher;
  if (table.size() < large) {
    hasher.add({x, p, v, a});
  } else {
    // If no thread can be started, get() does the work.
    const auto alone = [&hasher](std::size_t column, std::span<const double> values) {
      return std::async(std::launch::async | std::launch::deferred, [&hasher, column, values] {
        std::array<std::span<const double>, 4> all;
        all[column] = values;
        hasher.add(all);
      });
    };
    std::array columns{alone(0, x), alone(1, p), alone(2, v), alone(3, a)};
    for (auto& column : columns) column.get();
  }
  return hasher.result(table.axis(), table.rule(), table.outside(), units, table.size());
}

}  // namespace jounce
