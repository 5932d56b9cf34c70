// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/edit.hpp"

#include <gtest/gtest.h>

namespace jounce::edit_test {
namespace {

constexpr const char* text = R"(jounce = 1   # the format
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

[[segment]]  # é: two bytes, one column
law = "quintic"
end = { master = "0.25 rev", slave = 50, geo_velocity = 1 } # keep me
[[segment]]
law = "quintic"
[segment.end]
master = 360
slave = 0
)";

TEST(WithKnots, ChangesNumbersAndNothingElse) {
  const Spec spec = parse_spec(text, "a.toml");
  CamSpec cam = std::get<CamSpec>(spec.subject);
  cam.segments[0].end = {100.5, 50, 1.25, -0.01};
  cam.segments[1].end.geo_velocity = 0.5;
  const std::string edited = with_knots(spec, cam);
  EXPECT_EQ(edited, R"(jounce = 1   # the format
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

[[segment]]  # é: two bytes, one column
law = "quintic"
end = { master = 100.5, slave = 50, geo_velocity = 1.25, geo_acceleration = -0.01 } # keep me
[[segment]]
law = "quintic"
[segment.end]
master = 360
geo_velocity = 0.5
slave = 0
)");
  const auto again = std::get<CamSpec>(parse_spec(edited, "b.toml").subject);
  EXPECT_EQ(again.segments[0].end.geo_acceleration, -0.01);
  EXPECT_EQ(again.segments[1].end.geo_velocity, 0.5);
}

TEST(WithKnots, WorksWithDottedKeys) {
  const Spec spec = parse_spec(R"(jounce = 1
kind = "cam"
units.master = "deg"
units.position = "mm"
start.master = 0
start.slave = 0
[[segment]]
law = "quintic"
end.master = 360
end.slave = 1
)",
                               "a.toml");
  CamSpec cam = std::get<CamSpec>(spec.subject);
  cam.start.geo_velocity = 0.25;
  cam.segments[0].end.geo_velocity = 0.5;
  const std::string edited = with_knots(spec, cam);
  EXPECT_NE(edited.find("start.master = 0\nstart.geo_velocity = 0.25\nstart.slave = 0\n"),
            std::string::npos)
      << edited;
  const auto again = std::get<CamSpec>(parse_spec(edited, "b.toml").subject);
  EXPECT_EQ(again.start.geo_velocity, 0.25);
  EXPECT_EQ(again.segments[0].end.geo_velocity, 0.5);
}

TEST(WithKnots, OfAnUnchangedCamIsTheSameText) {
  const Spec spec = parse_spec(text, "a.toml");
  EXPECT_EQ(with_knots(spec, std::get<CamSpec>(spec.subject)), text);
}

}  // namespace
}  // namespace jounce::edit_test
