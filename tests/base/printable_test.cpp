// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/printable.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/utf8.hpp"

namespace jounce::printable_test {
namespace {

using test::is_utf8;

/// RFC 3629, section 3, without a look at the code under test.
std::string encoded(std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    return static_cast<char>(0x80U | (code >> shift & 0x3FU));
  };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | code >> 6U), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | code >> 12U), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | code >> 18U), tail(12), tail(6), tail(0)};
}

TEST(Printable, EveryCodePointIsOneOrIsNot) {
  std::vector<std::uint32_t> refused;
  for (std::uint32_t code = 0; code <= 0x110000; ++code) {
    const std::string text = encoded(code);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    ASSERT_EQ(is_utf8(text), !surrogate && code <= 0x10FFFF) << code;
    if (!is_printable(text) && !surrogate && code <= 0x10FFFF) refused.push_back(code);
    ASSERT_FALSE((surrogate || code > 0x10FFFF) && is_printable(text)) << code;
  }
  std::vector<std::uint32_t> expected;
  for (std::uint32_t code = 0; code < 0x20; ++code) expected.push_back(code);
  for (std::uint32_t code = 0x7F; code < 0xA0; ++code) expected.push_back(code);
  for (const std::uint32_t code : {0x061Cu, 0x200Eu, 0x200Fu, 0x2028u, 0x2029u, 0x202Au, 0x202Bu,
                                   0x202Cu, 0x202Du, 0x202Eu, 0x2066u, 0x2067u, 0x2068u, 0x2069u})
    expected.push_back(code);
  EXPECT_EQ(refused, expected);
}

TEST(Printable, WhatIsShownIsPrintableAndItselfIfItWas) {
  const std::uint64_t seed = 20260101;
  test::Random random(seed);
  // Bytes that begin, continue and break sequences are drawn more often than others.
  constexpr unsigned char often[] = {0x80, 0xBF, 0xC0, 0xC2, 0xE0, 0xED,
                                     0xEF, 0xF0, 0xF4, 0xF5, 0x1B, 'a'};
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    for (int n = random.below(9); n > 0; --n)
      text += static_cast<char>(random.below(2) == 0 ? often[random.below(12)] : random.below(256));
    const std::string shown = printable(text);
    ASSERT_TRUE(is_printable(shown)) << "seed " << seed << ", text " << i;
    ASSERT_TRUE(is_utf8(shown)) << "seed " << seed << ", text " << i;
    ASSERT_EQ(shown == text, is_printable(text)) << "seed " << seed << ", text " << i;
    ASSERT_TRUE(!is_printable(text) || is_utf8(text)) << "seed " << seed << ", text " << i;
  }
}

TEST(Printable, ABrokenByteCostsOneMark) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a?[2Jb");
  EXPECT_EQ(printable("mm\xff\xfe\xfd"), "mm???");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "?2J");
  EXPECT_EQ(printable("\xC2\xB5m"), "\xC2\xB5m");
  EXPECT_EQ(printable("\xE2\x82"), "??");
  EXPECT_EQ(printable("a\nb\tc"), "a?b?c");
  EXPECT_EQ(printable_lines("a\nb\tc\x1b\r"), "a\nb\tc??");
}

}  // namespace
}  // namespace jounce::printable_test
