// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/counter_random.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace jounce {
namespace {

std::uint32_t low(std::uint64_t x) {
  return static_cast<std::uint32_t>(x);
}

std::uint32_t high(std::uint64_t x) {
  return static_cast<std::uint32_t>(x >> 32U);
}

/// Two numbers in (0, 1) with 52 bits: the middles of 2^52 equal intervals.
std::pair<double, double> two(const Draw& draw) {
  const auto r = philox({low(draw.sample), high(draw.sample), low(draw.stream), high(draw.stream)},
                        {low(draw.seed), high(draw.seed)});
  const auto real = [](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t bits = ((static_cast<std::uint64_t>(a) << 32U) | b) >> 12U;
    return (static_cast<double>(bits) + 0.5) * 0x1p-52;
  };
  return {real(r[0], r[1]), real(r[2], r[3])};
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53U} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57U} * counter[2];
    counter = {high(b) ^ counter[1] ^ key[0], low(b), high(a) ^ counter[3] ^ key[1], low(a)};
    key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
  }
  return counter;
}

std::uint64_t stream_of(std::string_view name) {  // FNV-1a
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

double uniform(const Draw& draw) {
  return two(draw).first;
}

double normal(const Draw& draw) {
  const auto [u, v] = two(draw);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

}  // namespace jounce
