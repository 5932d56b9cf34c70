// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/gate.hpp"

#include <gtest/gtest.h>

namespace jounce::web {
namespace {

TEST(Gate, LetsTheLoopbackNamesIn) {
  EXPECT_EQ(objection({.host = "127.0.0.1:8080"}, 8080), "");
  EXPECT_EQ(objection({.host = "localhost:8080"}, 8080), "");
  EXPECT_EQ(objection({.host = "127.0.0.1:8080", .origin = "http://127.0.0.1:8080"}, 8080), "");
  EXPECT_EQ(objection({.host = "localhost:8080", .site = "same-origin"}, 8080), "");
  EXPECT_EQ(objection({.host = "localhost:8080", .site = "none"}, 8080), "");
}

TEST(Gate, RejectsNamesThatWereReboundToLoopback) {
  for (const char* host : {"", "evil.example:8080", "127.0.0.1", "127.0.0.1:8081", "localhost",
                           "127.0.0.1:8080.evil.example", "localhost:80800", "x127.0.0.1:8080"})
    EXPECT_NE(objection({.host = host}, 8080), "") << host;
}

TEST(Gate, RejectsPagesOfOtherOrigins) {
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8080",
                             "http://127.0.0.1:8081", "http://127.0.0.1:8080.evil.example"})
    EXPECT_NE(objection({.host = "127.0.0.1:8080", .origin = origin}, 8080), "") << origin;
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_NE(objection({.host = "127.0.0.1:8080", .site = site}, 8080), "") << site;
}

TEST(Gate, DrawsATokenAnewAndComparesAllOfIt) {
  const std::string token = new_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, new_token());
  EXPECT_TRUE(same(token, std::string(token)));
  EXPECT_FALSE(same(token, token.substr(1)));
  EXPECT_FALSE(same(token, ""));
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string other = token;
    other[i] = other[i] == '0' ? '1' : '0';
    EXPECT_FALSE(same(token, other)) << i;
  }
}

}  // namespace
}  // namespace jounce::web
