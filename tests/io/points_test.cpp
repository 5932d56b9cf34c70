// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/points.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::points_test {
namespace {

using ::testing::ElementsAre;

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)parse_points(text, "p.csv"); });
}

TEST(Points, AreColumnsWithUnits) {
  const Points p =
      parse_points("# measured\ntime [ms],Position [mm]\n0,0\n\n16, 0.25 \n32,-1e-3\n", "p");
  EXPECT_THAT(p.in_unit("time", "s"), ElementsAre(0, 0.016, 0.032));
  EXPECT_THAT(p.in_unit("position", "mm"), ElementsAre(0, 0.25, -1e-3));
  EXPECT_THAT(p.lines, ElementsAre(3, 5, 6));
}

TEST(Points, MayHaveSemicolonsAndDecimalCommas) {
  const Points p = parse_points("time [s]; position\r\n0;0\r\n0,5;1,25\r\n1;1e3", "p");
  EXPECT_THAT(p.in_unit("time", "s"), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(p.in_unit("position", "mm"), ElementsAre(0, 1.25, 1000));
}

TEST(Points, MayHaveTabsAndWords) {
  const Points p = parse_points("time\tposition\ttype\n16\t1.5\teven\n32\t2\t0\n", "p");
  EXPECT_THAT(p.find("position")->values, ElementsAre(1.5, 2));
  EXPECT_THAT(p.find("type")->words, ElementsAre("even", "0"));
}

TEST(Points, NameWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint(""),
            "p.csv: is empty: a header must name the columns, such as time [s],position [mm] or "
            "master [deg],slave [mm]");
  EXPECT_EQ(complaint(std::string("time\nposition\0", 14)),
            "p.csv:2: is not a text file: it has a zero byte here");
  EXPECT_EQ(complaint("time [s],position [mm]\n"),
            "p.csv:1: has a header but no points: add at least one row");
  EXPECT_EQ(complaint("0,1\n1,2\n"),
            "p.csv:1:1: header = 0: must be the name of a column, with or without a unit, such as "
            "position [mm]: write a header above the numbers");
  EXPECT_EQ(complaint("time [s,position\n0,1\n"),
            "p.csv:1:1: time = time [s: needs a closing bracket after its unit");
  EXPECT_EQ(complaint("time [s],position [mm]\r0,1\r1,2\r"),
            "p.csv:1: header = time [s],position [mm]: ends with a carriage return alone: save the "
            "file with "
            "line ends LF or CRLF");
  EXPECT_EQ(complaint("time [furlong]\n0\n"),
            "p.csv:1:1: time = furlong: is not a known unit: write one such as mm, deg, s or mm/s");
  EXPECT_EQ(complaint("time,time\n0,1\n"), "p.csv:1: time: is the name of two columns: remove one");
  EXPECT_EQ(complaint("time,position\n0,1\n1\n"),
            "p.csv:3: has 1 value, but the header has 2 columns");
  EXPECT_EQ(complaint("time,position\n0,1\n1,2,3\n"),
            "p.csv:3: has 3 values, but the header has 2 columns: if a value has a decimal comma, "
            "separate the columns by semicolons");
  EXPECT_EQ(complaint("time,position\n0,0\n0,5,1,25\n"),
            "p.csv:3: has 4 values, but the header has 2 columns: decimal "
            "commas need "
            "semicolons between columns");
  EXPECT_EQ(complaint("time,position\n0,1\n1,\n"),
            "p.csv:3:3: position: is empty: every point needs a number");
  for (const char* bad : {"nan", "inf", "1e999", "0x10", "1 2", "--1", "+", ".", "1e", "1.2.3",
                          "++1", "+-1", "-+1", "\"1"})
    EXPECT_EQ(complaint(std::string("time,position\n0,") + bad + "\n"),
              std::string("p.csv:2:3: position = ") + bad + ": must be a finite number")
        << bad;
}

TEST(Points, DoNotGuessWhichDecimalSignIsMeant) {
  EXPECT_EQ(complaint("time;position\n0;1.5\n1;2,5\n"),
            "p.csv:3:3: position = 2,5: has a decimal comma where other numbers have a point");
  EXPECT_EQ(complaint("time;position\n0;1,5\n1;2.5\n"),
            "p.csv:3:3: position = 2.5: has a decimal point where other numbers have a comma");
  EXPECT_EQ(complaint("time;position\n0;1.234,5\n"),
            "p.csv:2:3: position = 1.234,5: must be a finite number with one decimal comma and no "
            "thousands separator");
  EXPECT_EQ(complaint("time;position\n0;1,234,5\n"),
            "p.csv:2:3: position = 1,234,5: must be a finite number with one decimal comma and no "
            "thousands separator");
}

TEST(Points, NameTheSignThatOnlyLooksLikeAMinusSign) {
  EXPECT_EQ(complaint("time;weg\n0;\u22121,5\n"),
            "p.csv:2:3: weg = \u22121,5: begins with the typographic minus sign U+2212: write the "
            "minus sign of the keyboard, -");
  EXPECT_EQ(complaint("time,weg\n0,\u20131.5\n"),
            "p.csv:2:3: weg = \u20131.5: begins with a dash (U+2013): write the minus sign of the "
            "keyboard, -");
}

TEST(Points, NameAnUnknownUnitInALineOfUnits) {
  EXPECT_EQ(complaint("Zeit;Weg;Last\n[ms];[mm];[furlong]\n0;0;0\n"),
            "p.csv:2:11: last = [furlong]: is not a known unit: write one such as mm, deg, s or "
            "mm/s, or delete the column if the table does not need it");
}

TEST(Points, AreReadAsSpreadsheetsWriteThem) {
  for (const char* text : {"sep=;\ntime;position\n0;1,5\n1;-2,5\n",
                           "\"sep=;\"\r\n\"time\";\"position\"\r\n0;\"1,5\"\r\n\"1\";-2,5\r\n",
                           "time,position\n0,1.5\n,\n , \n1,-2.5\n,\n,,,\n",
                           "time;position\n;\n+0;+1,5\n+1;-2,5\n;;;;\n",
                           "time,position\n\"0\",\"+1.5\"\n1,\"-2.5\"\n"}) {
    const Points p = parse_points(text, "p.csv");
    EXPECT_EQ(p.in_unit("time", "s"), (std::vector{0.0, 1.0})) << text;
    EXPECT_EQ(p.in_unit("position", "mm"), (std::vector{1.5, -2.5})) << text;
  }
}

/// Columns of points as text: "time ms, position um".
std::string header_of(const std::string& text) {
  std::string all;
  for (const PointColumn& column : parse_points(text, "p.csv").columns)
    all += (all.empty() ? "" : ", ") + column.name + (column.unit.empty() ? "" : " " + column.unit);
  return all;
}

TEST(Points, HaveHeadersAsOtherProgramsWriteThem) {
  EXPECT_EQ(header_of("Zeit [ms];Weg [\u00b5m]\n0;0\n"), "zeit ms, weg um");
  EXPECT_EQ(header_of("time (s),Position (mm),vel (mm/s\u00b2)\n0,0,0\n"),
            "time s, position mm, vel mm/s^2");
  EXPECT_EQ(header_of("Winkel / \u00b0;Hub in \u03bcm\n0;0\n"), "winkel deg, hub um");
  EXPECT_EQ(header_of("Winkel [\xB0];Hub [\xB5m]\n0;0\n"), "winkel deg, hub um") << "Windows-1252";
  EXPECT_EQ(header_of("time;position\nms;mm\n0;0\n"), "time ms, position mm") << "a line of units";
  EXPECT_EQ(header_of("time;position\n[ms];(inch)\n0;0\n"), "time ms, position inch");
  EXPECT_EQ(header_of("time;position\n;mm\n0;0\n"), "time, position mm");
  EXPECT_EQ(header_of("Cam 7;;\n;;\ntime;position;\n0;0;\n"), "time, position") << "a title";
  EXPECT_EQ(header_of("\"time, measured (s)\",position (actual)\n0,0\n"),
            "time, measured s, position (actual)");
}

TEST(Points, HaveColumnsWithTheNamesOfOtherPrograms) {
  const auto named = [](const std::string& header, const std::vector<std::string>& wanted) {
    Points p = parse_points(header + "\n0;0\n", "p.csv");
    p.name_columns(wanted);
    return p.columns[0].name + " " + p.columns[1].name;
  };
  EXPECT_EQ(named("Zeit;Weg", {"time", "position"}), "time position");
  EXPECT_EQ(named("MasterPos;SlavePos", {"master", "slave"}), "master slave");
  EXPECT_EQ(named("leadingValue;following_value", {"master", "slave"}), "master slave");
  EXPECT_EQ(named("X;Y", {"master", "slave"}), "master slave");
  EXPECT_EQ(named("X;Y", {"time", "x", "y"}), "x y") << "here they are the names of axes";
  EXPECT_EQ(named("master;x", {"master", "slave"}), "master x");
  EXPECT_EQ(named("angle;winkel", {"master", "slave"}), "angle winkel") << "two candidates";
}

TEST(Points, HaveDecimalCommasInQuotes) {
  const Points p = parse_points("time,position\n\"0,5\",\"-1,25\"\n1,\"2,5\"\n", "p.csv");
  EXPECT_THAT(p.find("time")->values, ElementsAre(0.5, 1));
  EXPECT_THAT(p.find("position")->values, ElementsAre(-1.25, 2.5));
  EXPECT_EQ(complaint("time,position\n0,\"1.5\"\n1,\"2,5\"\n"),
            "p.csv:3:4: position = 2,5: has a decimal comma where other numbers have a point");
}

TEST(Points, MayEndEachLineWithASeparator) {
  const Points p = parse_points("time;position;\n0;1;\n1;2;;\n2;3\n", "p.csv");
  EXPECT_THAT(p.find("position")->values, ElementsAre(1, 2, 3));
  EXPECT_EQ(complaint("time;position;\n0;1;x\n"),
            "p.csv:2: has 3 values, but the header has 2 columns");
}

TEST(Points, AnErrorOfAUnitIsAtTheLineOfTheHeader) {
  const Points p =
      parse_points("# measured on Monday\n\ntime [s],position [deg]\n0,180\n", "p.csv");
  EXPECT_EQ(test::error_of([&] { (void)p.in_unit("position", "mm"); }),
            "p.csv:3: position = deg: cannot be converted to mm: correct the unit in the header");
  EXPECT_THAT(test::error_of([&] { (void)p.in_unit("velocity", "mm/s"); }),
              ::testing::StartsWith("p.csv:3: column \"velocity\": is missing"));
}

TEST(Points, ConvertOnlyWhatMeasuresTheSame) {
  const Points p = parse_points("time [ms],position [deg]\n0,180\n", "p.csv");
  EXPECT_NEAR(p.in_unit("position", "rad")[0], std::acos(-1), 1e-15);
  try {
    (void)p.in_unit("position", "mm");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("p.csv:1: position = deg:"));
  }
  try {
    (void)p.in_unit("velocity", "mm/s");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "p.csv:1: column \"velocity\": is missing: the columns of the file are time, position. "
        "Rename one, or add the column");
  }
}

TEST(Points, AreKnownByTheirFirstLine) {
  for (const char* text : {"time [s];position [mm]\n0;0\n", "# measured\n\nTime,Position\n", "a\tb",
                           "time s,velocity mm/s^2\n"})
    EXPECT_TRUE(begins_as_points(text)) << text;
  for (const char* text :
       {"", "time\n0\n", "0;0\n", "jounce = 1, 2\n", "[a, b]\n", "kind, = \"cam\""})
    EXPECT_FALSE(begins_as_points(text)) << text;
}

/// Every number comes back to the bit, with either decimal sign.
TEST(Points, AreReadToTheBit) {
  test::Random random(7);
  for (const char sign : {'.', ','}) {
    std::string text = "time; position\n";
    std::vector<double> values;
    for (int i = 0; i < 20000; ++i) {
      char cell[64];
      values.push_back((random.below(2) == 1 ? -1 : 1) * random.log_uniform(1e-12, 1e18));
      const auto end = std::to_chars(cell, cell + 64, values.back());
      std::replace(cell, end.ptr, '.', sign);
      text += std::to_string(i) + ";" + std::string(cell, end.ptr) + "\n";
    }
    EXPECT_EQ(parse_points(text, "p").find("position")->values, values) << sign;
  }
}

}  // namespace
}  // namespace jounce::points_test
