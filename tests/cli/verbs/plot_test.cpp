// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::plot_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using cli_test::via;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using PlotVerb = cli_test::Program;

TEST_F(PlotVerb, DrawsTheLoopOfADriveAlone) {
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  EXPECT_THAT(run("plot drive.toml --drive bode").out, HasSubstr("phase margin"));
  EXPECT_THAT(run("plot drive.toml --drive nyquist -o n.png").err, ::testing::IsEmpty());
  EXPECT_EQ(slurp(folder / "n.png").substr(1, 3), "PNG");
  ASSERT_EQ(run("new gear -o gear.toml").status, 0);
  EXPECT_THAT(run("plot gear.toml --drive bode").err,
              HasSubstr("drive: is missing: this picture needs a spec with [drive]"));
}

TEST_F(PlotVerb, ADriveCannotBeCombinedWithAnotherPicture) {
  for (const char* other : {"--over time", "--before x.toml"}) {
    const Result both = run("plot " + cam + " --drive response " + other + " -o x.svg");
    EXPECT_EQ(both.status, 2) << other;
    EXPECT_THAT(both.err, HasSubstr("cannot be combined with")) << other;
  }
}

TEST_F(PlotVerb, ShowsACamOverTheTimeOfItsMaster) {
  const Result plot = run("plot " + examples + "rotary-knife/knife.toml --over time");
  EXPECT_EQ(plot.status, 0) << plot.err;
  EXPECT_THAT(plot.out, HasSubstr("time [s]"));
  EXPECT_THAT(plot.out, HasSubstr("velocity [rev/min]")) << "as the limit is given";
  EXPECT_EQ(run("plot " + examples + "googol-move/move.toml --over time").status, 2);
}

TEST_F(PlotVerb, PlotAndReportWriteTheirFiles) {
  EXPECT_EQ(run("plot " + cam + " -o cam.svg").status, 0);
  EXPECT_EQ(run("plot " + cam + " -o cam.png").status, 0);
  EXPECT_EQ(run("report " + cam + " -o cam.html").status, 1)
      << "this cam breaks its limits, and the page reports it";
  EXPECT_EQ(files(), (std::vector<std::string>{"cam.html", "cam.png", "cam.svg"}));
  EXPECT_THAT(slurp(folder / "cam.svg"), HasSubstr("3.39227"));
  EXPECT_THAT(slurp(folder / "cam.png"), StartsWith("\x89PNG"));
  const std::string page = slurp(folder / "cam.html");
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy"));
  EXPECT_THAT(page,
              HasSubstr("<script type=\"application/json\">"));  // its own: report_security.py
}

TEST_F(PlotVerb, AMissingRendererIsStatus3WithItsPackage) {
  const Result result =
      run("laws > /dev/null; PATH=/nowhere " JOUNCE_EXE " plot " + cam + " -o cam.png");
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(
      result.err,
      StartsWith(
          "jounce: needs rsvg-convert (Debian: librsvg2-bin); write .svg instead, or install it"));
  EXPECT_TRUE(files().empty());
}

TEST_F(PlotVerb, DrawsAllAxesOfOneUnit) {
  const Result all = run("plot " + via);
  EXPECT_EQ(all.status, 0);
  EXPECT_THAT(all.out, HasSubstr(">x</text>"));
  EXPECT_THAT(all.out, HasSubstr(">y</text>"));
  std::string spec = slurp(via);
  spec.replace(spec.find("name = \"y\""), 10, "name = \"y\"\nunit = \"deg\"");
  write("mixed.toml", spec);
  EXPECT_EQ(run("plot mixed.toml").err,
            "jounce: --axis: is missing: x and y have different units, so one picture cannot show "
            "both. Choose one\n");
  EXPECT_THAT(run("plot mixed.toml --axis y").out, HasSubstr("deg"));
}

}  // namespace
}  // namespace jounce::plot_verb_test
