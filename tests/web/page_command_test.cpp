// SPDX-License-Identifier: Apache-2.0
#include "web/src/page_command.hpp"

#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::web {
namespace {

TEST(PageCommand, IsReadFromJson) {
  const PageCommand stop = read_command(R"({"axis":"feeder","what":"stop"})");
  EXPECT_EQ(stop.axis, "feeder");
  EXPECT_EQ(stop.what, "stop");
  EXPECT_EQ(stop.value, 0);
  EXPECT_EQ(read_command(R"({"axis":"a","what":"override","value":0.5})").value, 0.5);
  EXPECT_EQ(read_command(R"({"axis":"a","what":"move","value":-12})").value, -12);
  const PageCommand jog =
      read_command(R"({"axis":"a","what":"jog","value":-3,"hold":1795420044212})");
  EXPECT_EQ(jog.value, -3);
  EXPECT_EQ(jog.hold, 1795420044212);
  EXPECT_EQ(read_command(R"({"axis":"a","what":"release","hold":7})").hold, 7);
}

TEST(PageCommand, IsRejectedWithTheKeyThatIsWrong) {
  const auto key_of = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(read_command(text));
      return "nothing";
    } catch (const InputError& error) {
      return error.key();
    }
  };
  EXPECT_EQ(key_of(""), "order");
  EXPECT_EQ(key_of("[]"), "order");
  EXPECT_EQ(key_of("{"), "order");
  EXPECT_EQ(key_of(R"({"what":"stop"})"), "axis");
  EXPECT_EQ(key_of(R"({"axis":1,"what":"stop"})"), "axis");
  EXPECT_EQ(key_of(R"({"axis":"a"})"), "what");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"jump"})"), "what");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"stop","value":1})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"override"})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"override","value":"1"})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"override","value":2.5})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"override","value":null})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"move","value":1e999})"), "order");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"stop","when":1})"), "when");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"stop","hold":1})"), "hold");
  for (const char* hold : {"", R"(,"hold":0)", R"(,"hold":-1)", R"(,"hold":1.5)", R"(,"hold":"1")",
                           R"(,"hold":1e300)", R"(,"hold":18446744073709551615)"})
    EXPECT_EQ(key_of(std::string(R"({"axis":"a","what":"jog","value":1)") + hold + "}"), "hold")
        << hold;
  EXPECT_EQ(key_of(R"({"axis":"a","what":"jog","hold":1})"), "value");
  EXPECT_EQ(key_of(R"({"axis":"a","what":"release","hold":1,"value":1})"), "value");
}

}  // namespace
}  // namespace jounce::web
