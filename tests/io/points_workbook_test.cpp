// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/io/points.hpp"

#include "support/errors.hpp"

// The workbooks are those of tests/io/workbooks/make.py, which writes them with openpyxl and XlsxWriter.
namespace jounce::points_workbook_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string folder = JOUNCE_SOURCE_DIR "/tests/io/workbooks/";

TEST(Workbook, OfAColleagueIsReadAtTheFirstTry) {
  Points p = read_points(folder + "colleague.xlsx");
  const std::vector<std::string> wanted{"master", "slave", "tolerance"};
  p.name_columns(wanted);
  EXPECT_THAT(p.in_unit("master", "deg"), ElementsAre(0, 90, 180.5, 270, 360));
  EXPECT_THAT(p.in_unit("slave", "um"), ElementsAre(0, 12500.25, 25000, 12500.25, 0));
  EXPECT_EQ(p.find("tolerance")->unit, "um");
  EXPECT_THAT(p.lines, ElementsAre(4, 5, 7, 8, 9)) << "the rows of the sheet";
  EXPECT_EQ(p.columns.size(), 3U) << "a remark at the side is not a column";
}

TEST(Workbook, HasUnitsInARowAndResultsOfFormulas) {
  for (const char* sheet : {"", "#Data"}) {
    const Points p = read_points(folder + "measured.xlsx" + sheet);
    EXPECT_THAT(p.in_unit("time", "s"), ElementsAre(0, 0.01, 0.02, 0.03, 0.04));
    EXPECT_EQ(p.find("velocity")->unit, "mm/s");
    EXPECT_THAT(p.lines, ElementsAre(3, 4, 5, 6, 7));
  }
}

std::string complaint(const std::string& sheet) {
  const std::string error =
      test::error_of([&] { (void)read_points(folder + "mistakes.xlsx#" + sheet); });
  return error.starts_with(folder) ? error.substr(folder.size()) : error;
}

TEST(Workbook, NamesTheSheetAndTheCellOfAMistake) {
  EXPECT_EQ(complaint("good"), "");
  EXPECT_EQ(complaint("date"),
            "mistakes.xlsx:3: date!A3 (time) = 0.5: is a date or a time of day: give the column "
            "the format of a number");
  EXPECT_EQ(complaint("error"),
            "mistakes.xlsx:3: error!B3 (position) = #DIV/0!: is an error of a formula: correct the "
            "formula, or clear the row");
  EXPECT_EQ(complaint("text"),
            "mistakes.xlsx:3: text!B3 (position) = about 3: is text: must be a finite number");
  EXPECT_EQ(complaint("empty"),
            "mistakes.xlsx:3: empty!B3 (position): is empty: every point needs a number");
  EXPECT_THAT(complaint("formula"),
              HasSubstr("formula!B3 (position): has a formula without a stored value"));
  EXPECT_EQ(complaint("twice"),
            "mistakes.xlsx:1: twice!B1 = time: is the name of two columns: remove one");
  EXPECT_EQ(complaint("unit"),
            "mistakes.xlsx:1: unit!B1 = furlong: is not a known unit: write one such as mm, deg, s "
            "or mm/s");
  EXPECT_THAT(complaint("mixed"),
              HasSubstr("mixed!B3 (position) = 1.5: is text with a decimal point, but other texts "
                        "of the sheet have a decimal comma"));
  EXPECT_THAT(
      complaint("headless"),
      HasSubstr("mistakes.xlsx:1: headless!A1 = 0: is a value, but the sheet has no header"));
  EXPECT_THAT(complaint("Gut"), HasSubstr("mistakes.xlsx: sheet = Gut: is not in the workbook, "
                                          "whose sheets are good, date, error"));
}

TEST(Workbook, EveryTruncationIsRejected) {
  const std::string bytes = read_file(folder + "measured.xlsx", Archive::returned);
  for (std::size_t n = 4; n < bytes.size(); ++n) {
    const std::string error =
        test::error_of([&] { (void)parse_points(bytes.substr(0, n), "m.xlsx"); });
    EXPECT_THAT(error, HasSubstr("m.xlsx: is not a complete zip archive")) << n;
  }
}

TEST(Workbook, AChangedByteIsRejectedOrWithoutEffect) {
  const std::string bytes = read_file(folder + "measured.xlsx", Archive::returned);
  const std::vector<double> times{0, 0.01, 0.02, 0.03, 0.04};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const char flip : {'\x01', '\x80'}) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ flip);
      try {
        EXPECT_EQ(parse_points(changed, "m.xlsx").in_unit("time", "s"), times) << i;
      } catch (const InputError&) {
      }
    }
}

TEST(Workbook, OfAnotherFormatIsNamed) {
  EXPECT_THAT(test::error_of([] { (void)parse_points("PK\x03\x04 and so on", "a.zip"); }),
              HasSubstr("a.zip: is not a complete zip archive"));
}

}  // namespace
}  // namespace jounce::points_workbook_test
