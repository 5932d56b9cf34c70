// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/sweep_figure.hpp"

#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plot/markup.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::sweep_figure_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Sweeps of a move from rest to rest, whose duration follows from its three limits.
class SweepOverAParameter : public test::WithFolder {
 protected:
  Figure figure(const std::string& parameters) {
    std::ofstream(folder_ / "move.toml")
        << "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
           "profile = \"s_curve\"\nto = 100\nvelocity = \"100 mm/s\"\nacceleration = 1000\n"
           "jerk = 50000\n";
    const std::string path = (folder_ / "sweep.toml").string();
    const SweepSpec spec = parse_sweep(
        "jounce = 1\nkind = \"sweep\"\nspec = \"move.toml\"\nfigures = [\"duration\"]\n" +
            parameters,
        path);
    const SweepResult result = run_sweep(spec);
    return sweep_figure(spec, result, summary_of(spec, result));
  }

  static std::string values(const std::string& key, const std::string& list) {
    return "[[parameter]]\nkey = \"move." + key + "\"\nvalues = [" + list + "]\n";
  }

  /// The labels of the lines of the first panel that have points.
  static std::vector<std::string> labels(const Figure& figure) {
    std::vector<std::string> all;
    for (const Series& series : figure.panels.front().series)
      if (series.y.front() == series.y.front()) all.push_back(series.label);
    return all;
  }
};

/// Duration of 100 mm with velocity v, acceleration a and jerk j, if all three are reached.
double duration(double v, double a, double j) {
  return 100 / v + v / a + a / j;
}

TEST_F(SweepOverAParameter, HasALineForEachValueOfTheSecond) {
  const Figure picture =
      figure(values("velocity", "100, 60, 80") + values("acceleration", "1000, 500"));
  EXPECT_THAT(labels(picture), ElementsAre("move.acceleration = 1000", "move.acceleration = 500"));
  EXPECT_EQ(picture.x_label, "move.velocity [mm/s]");
  EXPECT_EQ(picture.x_note, "");
  const Series& second = picture.panels.front().series.back();
  EXPECT_THAT(second.x, ElementsAre(60, 80, 100)) << "in ascending order";
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(second.y[i], duration(second.x[i], 500, 50000), 1e-9) << second.x[i];
  const Markup markup(svg(picture));
  EXPECT_EQ(markup.with("path", "l1").size(), 2U) << "in the legend and in the panel";
  EXPECT_EQ(markup.with("path", "l2").size(), 2U);
  std::vector<std::string> texts;
  for (const Element& e : markup.with("text")) texts.push_back(e.text);
  EXPECT_THAT(texts, Contains("move.acceleration = 500"));
}

TEST_F(SweepOverAParameter, HasNoLegendIfItIsTheOnlyOne) {
  const Figure picture = figure(values("velocity", "60, 80, 100"));
  EXPECT_THAT(labels(picture), ElementsAre(""));
  EXPECT_THAT(Markup(svg(picture)).with("path", "l2"), IsEmpty());
}

TEST_F(SweepOverAParameter, ShowsFourOfManyValuesAndStatesIt) {
  const Figure picture = figure(values("velocity", "60, 80") +
                                values("acceleration", "400, 500, 600, 700, 800, 900, 1000"));
  EXPECT_THAT(labels(picture), ElementsAre("move.acceleration = 400", "move.acceleration = 600",
                                           "move.acceleration = 800", "move.acceleration = 1000"));
  EXPECT_EQ(picture.x_note, "move.acceleration: 4 of 7 values drawn");
}

TEST_F(SweepOverAParameter, ShowsAThirdParameterAsGivenAndStatesIt) {
  const Figure picture = figure(values("velocity", "60, 80") + values("acceleration", "500, 1000") +
                                values("jerk", "20000, 45000, 90000"));
  EXPECT_THAT(labels(picture), ElementsAre("move.acceleration = 500", "move.acceleration = 1000"));
  EXPECT_EQ(picture.x_note, "move.jerk = 45000 (1 of 3 values)");
  const Series& last = picture.panels.front().series.back();
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(last.y[i], duration(last.x[i], 1000, 45000), 1e-9) << last.x[i];
}

TEST_F(SweepOverAParameter, ShowsFewCombinationsOfThreeParametersCompletely) {
  const Figure picture = figure(values("velocity", "60, 80") + values("acceleration", "500, 1000") +
                                values("jerk", "20000, 45000"));
  EXPECT_EQ(labels(picture).size(), 4U);
  EXPECT_THAT(labels(picture), Contains("move.acceleration = 500, move.jerk = 45000"));
  EXPECT_EQ(picture.x_note, "");
}

TEST_F(SweepOverAParameter, StatesTheValueThatAllLinesHave) {
  const Figure picture = figure(values("velocity", "60, 80") + values("jerk", "20000"));
  EXPECT_THAT(labels(picture), ElementsAre(""));
  EXPECT_EQ(picture.x_note, "move.jerk = 20000");
}

}  // namespace
}  // namespace jounce::sweep_figure_test
