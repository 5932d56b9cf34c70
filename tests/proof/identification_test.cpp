// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/identification.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace jounce::identification_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Recording recording() {
  return {.time = {0, 1, 2, 3},
          .command = {0, 1, 2, 3},
          .position = {0.5, 1, 2, 3},
          .torque = {1, 2, 3, 4}};
}

Identification inertia() {
  Identification found;
  found.status = Identification::Status::converged;
  found.reason = "done";
  found.numbers = {{"motor.inertia", "kg m^2", 1, 2, 1.9, 2.1}};
  found.explained = {{.quantity = "position", .before = 1, .after = 0.25, .model = {0, 1, 2, 3.5}},
                     {.quantity = "torque", .before = 4, .after = 1, .model = {1, 2, 3, 3}}};
  return found;
}

TEST(Identification, HasIntervalsAndResidualsWithTheirUnits) {
  const std::string text = identification_text(inertia(), "mm");
  EXPECT_THAT(text, StartsWith("converged: done\n"));
  EXPECT_THAT(text, HasSubstr("+-5 %   1.9 to 2.1 kg m^2\n"));
  EXPECT_THAT(text, HasSubstr("mm rms\n"));
  EXPECT_THAT(text, HasSubstr("N m rms\n"));
  EXPECT_THAT(text, HasSubstr("  next: fit another run from these numbers"));
  EXPECT_THAT(text, testing::Not(HasSubstr("feed-forward inertia")));
  const auto document = nlohmann::json::parse(identification_json(inertia()));
  EXPECT_EQ(document["numbers"][0]["value"], 2);
  EXPECT_EQ(document["explained"][1]["rms_after"], 1);
}

TEST(Identification, HasTheInertiaOfTheFeedForward) {
  Identification found = inertia();
  found.status = Identification::Status::misfit;
  found.feed_forward = {"feed-forward inertia", "kg m^2", 3, 4, 3.8, 4.2};
  const std::string text = identification_text(found, "mm");
  EXPECT_THAT(text, HasSubstr("feed-forward inertia                    3            4"));
  EXPECT_THAT(text, testing::Not(HasSubstr("next:")));
  const auto document = nlohmann::json::parse(identification_json(found));
  EXPECT_EQ(document["feed_forward"]["high"], 4.2);
}

TEST(Identification, FigureShowsPositionsAsTheirDistanceFromTheCommand) {
  const Figure figure = identification_figure(inertia(), recording(), "run", "mm");
  ASSERT_EQ(figure.panels.size(), 4U);
  EXPECT_EQ(figure.panels[0].y_label, "position - command [mm]");
  EXPECT_THAT(figure.panels[0].series[0].y, testing::ElementsAre(0.5, 0, 0, 0));
  EXPECT_THAT(figure.panels[1].series[0].y, testing::ElementsAre(0.5, 0, 0, -0.5))
      << "recorded - model";
  EXPECT_EQ(figure.panels[2].y_label, "torque [N m]");
  EXPECT_THAT(figure.panels[3].series[0].y, testing::ElementsAre(0, 0, 0, 1));
}

TEST(Identification, ChangesOnlyTheFittedNumbersOfTheSpec) {
  const std::string given =
      "# my drive\njounce = 1\nkind = \"drive\"\nunits = { position = \"deg\" }\n[drive]\n"
      "position_per_rev = 9\n[drive.motor]\ninertia = \"4 kg cm^2\"  # data sheet\n"
      "torque_limit = 3.8\n"
      "[[drive.mass]]\ninertia = 0.003\nstiffness = 15\n"
      "[drive.controller]\nposition_gain = 60\nvelocity_gain = 2\n";
  const Spec spec = parse_spec(given, "drive.toml");
  Identification found = inertia();
  found.drive = spec.drive->drive;
  found.numbers = {{"motor.inertia", "kg m^2", 4e-4, 5e-4, 4.9e-4, 5.1e-4},
                   {"mass[1].damping", "N m s/rad", 0.01, 0.015, 0.014, 0.016}};
  std::string wanted = given;
  wanted.replace(wanted.find("4 kg cm^2"), 9, "5 kg cm^2");
  std::string text = fitted_spec_text(found, spec, "run.csv");
  const std::string head =
      "# Fitted to run.csv by `jounce identify`, with 95 % intervals:\n"
      "#   drive.motor.inertia: 0.00049 to 0.00051 kg m^2, was 0.0004\n"
      "#   drive.mass[1].damping: 0.014 to 0.016 N m s/rad, was 0.01\n# my drive\n";
  EXPECT_THAT(text, StartsWith(head));
  const std::size_t added = text.find("damping = 0.015\n");
  ASSERT_NE(added, std::string::npos);
  text.erase(added, 16);
  EXPECT_EQ(text.substr(head.size()), wanted.substr(11));
}

}  // namespace
}  // namespace jounce::identification_test
