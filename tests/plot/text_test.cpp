// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/text.hpp"

#include <gtest/gtest.h>

namespace jounce::text_test {
namespace {

TEST(Escaped, MakesMarkupPlain) {
  EXPECT_EQ(escaped("<script>alert('a' & \"b\")</script>"),
            "&lt;script&gt;alert(&#39;a&#39; &amp; &quot;b&quot;)&lt;/script&gt;");
}

TEST(Escaped, KeepsGoodCharacters) {
  for (const char* text : {"", "a\n\tb", "mm/deg²", "軸", "😀", "−10⁻⁹"})
    EXPECT_EQ(escaped(text), text);
}

TEST(Escaped, ReplacesWhatXmlCannotHold) {
  using namespace std::string_literals;
  EXPECT_EQ(escaped("a\0b"s), "a\uFFFDb");
  EXPECT_EQ(escaped("\x01\x1b\r\x7f"), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escaped("\xEF\xBF\xBF"), "\uFFFD");
}

TEST(Escaped, ReplacesBrokenUtf8) {
  EXPECT_EQ(escaped("a\xC3"), "a\uFFFD");                              // cut off
  EXPECT_EQ(escaped("\xE9t\xE9"), "\uFFFDt\uFFFD");                    // Latin-1
  EXPECT_EQ(escaped("\xC0\xBC"), "\uFFFD\uFFFD");                      // overlong <
  EXPECT_EQ(escaped("\xE0\x80\xBC"), "\uFFFD\uFFFD\uFFFD");            // the same in three bytes
  EXPECT_EQ(escaped("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");            // surrogate
  EXPECT_EQ(escaped("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");  // above U+10FFFF
  EXPECT_EQ(escaped("\xC3<"), "\uFFFD&lt;");                           // hides no markup
}

TEST(Fitted, CutsWithAnEllipsis) {
  EXPECT_EQ(fitted("short", 12, 100), "short");
  const std::string cut = fitted("a rather long name of an axis", 12, 100);
  EXPECT_TRUE(cut.ends_with("…"));
  EXPECT_LE(text_width(cut, 12), 100);
  EXPECT_GT(text_width(cut, 12), 80);
}

TEST(Fitted, CutsBetweenCharacters) {
  const std::string cut = fitted("²²²²²²²²²²", 10, 40);
  EXPECT_EQ(escaped(cut), cut);
}

}  // namespace
}  // namespace jounce::text_test
