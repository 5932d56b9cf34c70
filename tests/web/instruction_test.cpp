#include "jounce/web/instruction.hpp"

#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::web {
namespace {

TEST(Instruction, IsReadFromJson) {
  const Instruction stop = read_instruction(R"({"axis":"feeder","what":"stop"})");
  EXPECT_EQ(stop.axis, "feeder");
  EXPECT_EQ(stop.what, "stop");
  EXPECT_EQ(stop.value, 0);
  EXPECT_EQ(read_instruction(R"({"axis":"a","what":"override","value":0.5})").value, 0.5);
  EXPECT_EQ(read_instruction(R"({"axis":"a","what":"move","value":-12})").value, -12);
}

TEST(Instruction, IsRefusedWithTheKeyThatIsWrong) {
  const auto key_of = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(read_instruction(text));
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
}

}  // namespace
}  // namespace jounce::web
