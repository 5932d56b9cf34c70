// SPDX-License-Identifier: Apache-2.0
#include "web/src/word_order.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"

namespace jounce::web::word_order_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json command(const std::string& word) {
  for (const json& one : json::parse(word_orders_json()))
    if (one["word"] == word) return one;
  return nullptr;
}

std::vector<std::string> names(const json& command) {
  std::vector<std::string> all;
  for (const json& option : command["options"]) all.push_back(option["name"]);
  return all;
}

TEST(WordOrders, AllWordsOfTheCommandTableAreThere) {
  const json all = json::parse(word_orders_json());
  ASSERT_EQ(all.size(), command_words().size());
  EXPECT_THAT(names(command("move")),
              testing::IsSupersetOf({"to", "by", "velocity", "jerk", "blend", "buffered"}));
  EXPECT_EQ(command("move")["group"], false);
  EXPECT_EQ(command("move-linear")["group"], true);
  EXPECT_THAT(names(command("move-circular")),
              testing::IsSupersetOf({"to", "via", "center", "clockwise"}));
  EXPECT_THAT(names(command("jog")), testing::Not(testing::Contains("hold-to-run")));
  EXPECT_EQ(command("enable")["options"], json::array());
}

TEST(WordOrders, AnOptionHasItsKindAndQuantity) {
  const json move = command("move");
  const auto option = [&](const char* name) {
    return *std::find_if(move["options"].begin(), move["options"].end(),
                         [&](const json& one) { return one["name"] == name; });
  };
  EXPECT_EQ(option("velocity")["quantity"], "velocity");
  EXPECT_EQ(option("velocity")["kind"], "text");
  EXPECT_EQ(option("direction")["kind"], (json{"shortest", "positive", "negative"}));
  EXPECT_EQ(option("buffered")["kind"], "flag");
}

TEST(WordOrders, AnOrderBecomesItsCommand) {
  const WordOrder order = read_word_order(
      R"({"axis":"plotter","what":"move-linear","options":{"to":"1cm,5","velocity":"80mm/s"}})");
  EXPECT_EQ(order.axis, "plotter");
  const auto made = std::get<command::MoveLinearAbsolute>(command_of(order.words, {"mm", "mm"}));
  EXPECT_EQ(made.to[0], 10);
  EXPECT_EQ(made.to[1], 5);
  EXPECT_EQ(made.path.along.velocity, 80);
}

std::string rejection_of(const std::string& text) {
  try {
    static_cast<void>(read_word_order(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WordOrders, WhatACommandDoesNotHaveIsRejected) {
  EXPECT_THAT(rejection_of("7"), HasSubstr("must be a JSON object"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"fly"})"), HasSubstr("is not a command"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"enable","value":"3"})"),
              HasSubstr("does not apply"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"jog","value":"3","flags":["hold-to-run"]})"),
              HasSubstr("needs heartbeats"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"move","speed":"3"})"),
              HasSubstr("is not a member"));
  EXPECT_THAT(rejection_of(R"({"axis":5,"what":"move"})"), HasSubstr("must be a string"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"move","flags":null})"),
              HasSubstr("flags = null: must be a list of names"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"override","value":"1","options":{"at":"5"}})"),
              HasSubstr("at = 5: does not apply to a page"));
  EXPECT_THAT(rejection_of(R"({"axis":"a","what":"move-direct","value":"y=5"})"),
              HasSubstr("has the name of an axis: give --to y=5"));
}

}  // namespace
}  // namespace jounce::web::word_order_test
