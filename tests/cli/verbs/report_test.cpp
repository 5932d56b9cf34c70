// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::report_verb_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using ReportVerb = cli_test::Program;

TEST_F(ReportVerb, WritesAPageAndPrintsTheVerdict) {
  const Result page = run("report " + cam + " -o page.html");
  EXPECT_EQ(page.status, 1);
  EXPECT_THAT(page.out, HasSubstr("PMC600 Fig. 6.14: 2 findings; the worst: geo_velocity"));
  const Result pdf = run("report " + cam + " -o page.pdf");
  EXPECT_EQ(pdf.status, 2);
  EXPECT_EQ(pdf.err, "jounce: --output = page.pdf: must end in .html or .htm\n");
  std::filesystem::create_directory(folder / "folder");
  EXPECT_EQ(run("report folder -o other.html").err, "jounce: folder: is a folder: name a file\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "page.pdf"));
}

// The closest of no limits was an error of 1e-13 of the witness.
TEST_F(ReportVerb, StatesThatNoLimitsAreGiven) {
  write("f.toml",
        "jounce = 1\nkind = \"cam\"\nunits = { master = \"pulse\", position = \"pulse\" }\n"
        "start = { master = 0, slave = 0 }\n"
        "segment = [{ law = \"345\", end = { master = 10000, slave = 20000 } }]\n");
  const Result report = run("report f.toml -o f.html");
  EXPECT_EQ(report.status, 0);
  EXPECT_THAT(report.out, StartsWith("f.toml: no limits are given; the curve is continuous"));
}

}  // namespace
}  // namespace jounce::report_verb_test
