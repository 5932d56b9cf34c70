// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/sobol.hpp"

#include <array>
#include <cassert>

namespace jounce {
namespace {

constexpr int bits = 32;

/// A primitive polynomial over two elements, x^degree + ... + 1, its inner coefficients as the bits of `inner`, and the
/// first direction numbers.
struct Polynomial {
  int degree;
  unsigned inner;
  std::array<std::uint32_t, 7> m;
};

constexpr std::array<Polynomial, sobol_dimensions - 1> polynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

using Directions = std::array<std::uint32_t, bits>;

/// v_i = m_i / 2^i as 32 bits. Beyond the degree s: v_i = a_1 v_(i-1) ^ ... ^ a_(s-1) v_(i-s+1) ^ v_(i-s) ^
/// v_(i-s) >> s.
constexpr Directions directions_of(const Polynomial& p) {
  Directions v{};
  for (int i = 0; i < bits; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i < p.degree) {
      v[at] = p.m[at] << (bits - 1 - i);
      continue;
    }
    const std::uint32_t oldest = v[static_cast<std::size_t>(i - p.degree)];
    v[at] = oldest ^ (oldest >> p.degree);
    for (int k = 1; k < p.degree; ++k)
      if ((p.inner >> (p.degree - 1 - k) & 1U) != 0) v[at] ^= v[static_cast<std::size_t>(i - k)];
  }
  return v;
}

constexpr std::array<Directions, sobol_dimensions> all_directions() {
  std::array<Directions, sobol_dimensions> all{};
  for (int i = 0; i < bits; ++i) all[0][static_cast<std::size_t>(i)] = 1U << (bits - 1 - i);
  for (std::size_t d = 1; d < sobol_dimensions; ++d) all[d] = directions_of(polynomials[d - 1]);
  return all;
}

constexpr auto directions = all_directions();

}  // namespace

std::uint32_t sobol(std::uint32_t number, std::size_t dimension) {
  assert(dimension < sobol_dimensions);
  std::uint32_t x = 0;
  for (std::size_t i = 0; number != 0; ++i, number >>= 1U)
    if ((number & 1U) != 0) x ^= directions[dimension][i];
  return x;
}

}  // namespace jounce
