// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/spec_numbers.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::spec_numbers_test {
namespace {

using test::error_of;

constexpr const char* text = R"(jounce = 1   # the format
kind = "cam"
name = "5 s"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

[[segment]]  # é: two bytes, one column
law = "quintic"
shares = [0.25, 0.5, 0.25]
end = { master = "0.25 rev", slave = -50.5, geo_velocity = 1 } # keep me
[[segment]]
law = "quintic"
[segment.end]
master = '360'
slave = 0
)";

SpecNumbers numbers() {
  return SpecNumbers({"a.toml", text, {}, {}});
}

TEST(SpecNumbers, AreFoundByTheirPlace) {
  EXPECT_EQ(numbers().value("segment[1].end.master"), 0.25);
  EXPECT_EQ(numbers().unit("segment[1].end.master"), "rev");
  EXPECT_EQ(numbers().value("segment[1].end.slave"), -50.5);
  EXPECT_EQ(numbers().unit("segment[1].end.slave"), "");
  EXPECT_EQ(numbers().value("segment[1].shares[2]"), 0.5);
  EXPECT_EQ(numbers().value("segment[2].end.master"), 360);
  EXPECT_TRUE(numbers().is_whole("segment[2].end.slave"));
  EXPECT_FALSE(numbers().is_whole("segment[2].end.master"));
}

TEST(SpecNumbers, ChangeInTheTextAndNothingElseDoes) {
  const std::vector<SpecNumbers::Change> changes{{"segment[2].end.master", 359.5},
                                                 {"segment[1].end.slave", 1e-9},
                                                 {"segment[1].shares[3]", 2},
                                                 {"segment[1].end.master", 1.0 / 3}};
  std::string wanted = text;
  const auto swap = [&](const std::string& from, const std::string& to) {
    wanted.replace(wanted.find(from), from.size(), to);
  };
  swap("'360'", "\"359.5\"");
  swap("-50.5", "1e-09");
  swap("0.25]", "2]");
  swap("0.25 rev", "0.3333333333333333 rev");
  EXPECT_EQ(numbers().text(changes), wanted);
  EXPECT_EQ(SpecNumbers({"b.toml", wanted, {}, {}}).value("segment[1].end.master"), 1.0 / 3);
}

TEST(SpecNumbers, OfAnUnchangedFileGiveItBack) {
  EXPECT_EQ(numbers().text({}), text);
}

TEST(SpecNumbers, MakeASpec) {
  const std::vector<SpecNumbers::Change> changes{{"units.master", 1}};
  EXPECT_THROW((void)numbers().spec(changes), InputError);
  SpecNumbers cam({"c.toml",
                   R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [{ law = "quintic", end = { master = "0.5 rev", slave = 20 } }]
)",
                   {},
                   {}});
  const std::vector<SpecNumbers::Change> half{{"segment[1].end.master", 0.25}};
  EXPECT_EQ(std::get<CamSpec>(cam.spec(half).subject).segments[0].end.master, 90);
}

TEST(SpecNumbers, RejectsAnInvalidNumber) {
  const auto refused = [](const char* key, double value = 1) {
    const std::vector<SpecNumbers::Change> changes{{key, value}};
    return error_of([&] { (void)numbers().text(changes); });
  };
  EXPECT_EQ(refused("segment[1].law"), "a.toml:8: segment[1].law: is not a number");
  EXPECT_EQ(refused("segment[2].end"), "a.toml:13: segment[2].end: is not a number");
  EXPECT_EQ(refused("segment[2].end.slaves"),
            "a.toml: segment[2].end.slaves: names no number in this file: did you mean "
            "segment[2].end.slave?");
  EXPECT_EQ(refused("master.velocity"),
            "a.toml: master.velocity: names no number in this file; if the file omits the key, add "
            "it there first");
  EXPECT_EQ(refused("start.slave", std::nan("")),
            "a.toml: start.slave = nan: must be a finite number");
  const std::vector<SpecNumbers::Change> twice{{"start.slave", 1}, {"start.slave", 1}};
  EXPECT_EQ(error_of([&] { (void)numbers().text(twice); }),
            "a.toml: start.slave = 1: is given twice");
}

TEST(SpecNumbers, RejectWhatIsNoToml) {
  EXPECT_THROW(SpecNumbers({"a.toml", "jounce = = 1", {}, {}}), InputError);
  EXPECT_THROW((void)SpecNumbers({"a.toml", "", {}, {}}).value("jounce"), InputError);
}

}  // namespace
}  // namespace jounce::spec_numbers_test
