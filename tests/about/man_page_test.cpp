// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/man_page.hpp"

#include <gmock/gmock.h>

#include "about/sample.hpp"

namespace jounce::man_page_test {
namespace {

using testing::HasSubstr;

const BuildInfo build{.version = "1.2.3", .date = "2026-11-26"};

std::string check_page() {
  const ProgramInfo program = about_test::sample();
  return man_page(program, program.verbs.front(), build);
}

TEST(ManPage, OfAVerbHasItsNameArgumentsOptionsAndExamples) {
  EXPECT_EQ(
      check_page(),
      ".\\\" Made from the options of the program.\n"
      ".TH TOOL\\-CHECK 1 \"2026-11-26\" \"jounce 1.2.3\" \"User Commands\"\n"
      ".SH NAME\ntool\\-check \\- Check limits\n"
      ".SH SYNOPSIS\n\\fBtool check\\fR [\\fIOPTIONS\\fR] \\fIFILE\\fR...\n"
      ".SH ARGUMENTS\n.TP\n\\fIFILE\\fR\nSpecs.\n"
      ".SH OPTIONS\n"
      ".TP\n\\fB\\-\\-format\\fR \\fIvalue\\fR\nFormat. Default: text.\n"
      ".TP\n\\fB\\-\\-limit\\fR \\fIvalue\\fR\nLimit.\n"
      ".TP\n\\fB\\-n\\fR, \\fB\\-\\-count\\fR \\fInumber\\fR\n\\(aqCount\\(aq of runs. Required.\n"
      ".TP\n\\fB\\-\\-strict\\fR\nStrict.\n"
      ".SH EXIT STATUS\n.TP\n\\fB0\\fR\nsuccess\n.TP\n\\fB1\\fR\na finding\n"
      ".SH EXAMPLES\n.nf\ntool check a.toml\n\\&.b \\e \\(aqc\n.fi\n"
      ".SH SEE ALSO\n\\fBtool\\fR(1)\n");
}

TEST(ManPage, OfTheProgramListsTheVerbs) {
  const std::string page = man_page(about_test::sample(), build);
  EXPECT_THAT(page, HasSubstr(".SH VERBS\n.TP\n\\fBtool\\-check\\fR(1)\nCheck limits\n"
                              ".TP\n\\fBtool\\-chart\\fR(1)\nDraw\n"));
  EXPECT_THAT(page, HasSubstr(".SH OPTIONS\n.TP\n\\fB\\-\\-version\\fR\nPrint the version.\n"));
  EXPECT_THAT(page, HasSubstr("Name files as arguments.\n"));
}

TEST(ManPage, OfAnOptionalArgumentHasBrackets) {
  const ProgramInfo program = about_test::sample();
  EXPECT_THAT(man_page(program, program.verbs.back(), build),
              HasSubstr("[\\fIOPTIONS\\fR] [\\fIKIND\\fR] [\\fIOUT\\fR]\n"));
}

TEST(ManPage, OfEachVerbHasAFileName) {
  const ProgramInfo program = about_test::sample();
  const auto pages = man_pages(program, build);
  ASSERT_EQ(pages.size(), 3U);
  EXPECT_EQ(pages.at("tool.1"), man_page(program, build));
  EXPECT_EQ(pages.at("tool-chart.1"), man_page(program, program.verbs.back(), build));
}

}  // namespace
}  // namespace jounce::man_page_test
