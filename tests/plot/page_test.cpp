// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/plot/findings.hpp"

#include "plot/markup.hpp"
#include "plot/samples.hpp"

namespace jounce::page_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Page sample() {
  Page page{.title = "Feeder", .subtitle = "cams/feeder.toml"};
  const Report report = check(pmc600_cam(), pmc600_look().limits);
  page.verdict = verdict(report);
  page.sections = {
      {"Summary", {Prose{"First.\n\nSecond."}, Facts{{{"slope [mm/deg^2]", "3 mm"}}}}},
      {"Curve", {Chart{curve_figure(pmc600_cam(), pmc600_look()), "Extrema are exact."}}},
      {"Findings", {findings_table(report, {}, "All limits")}},
  };
  page.footer = "Jounce 0.1.0";
  return page;
}

std::vector<std::string> texts(const std::vector<Element>& elements) {
  std::vector<std::string> out;
  for (const Element& e : elements) out.push_back(e.text);
  return out;
}

TEST(Html, IsWellFormedAndComplete) {
  const Markup markup(html(sample()), true);
  EXPECT_EQ(markup.with("h1").at(0).text, "Feeder");
  EXPECT_THAT(texts(markup.with("h2")), ElementsAre("Summary", "Curve", "Findings"));
  EXPECT_EQ(markup.with("p", "sub").at(0).text, "cams/feeder.toml");
  EXPECT_EQ(markup.with("p", "no").size(), 1U);
  EXPECT_EQ(markup.with("dt").at(0).text, "slope [mm/deg²]");
  EXPECT_EQ(markup.with("dd").at(0).text, "3 mm");
  EXPECT_EQ(markup.with("caption").at(0).text, "All limits");
  EXPECT_EQ(markup.with("figcaption").at(0).text, "Extrema are exact.");
  EXPECT_EQ(markup.with("footer").at(0).text, "Jounce 0.1.0");
}

TEST(Html, DrawsEachFigureForWideAndNarrowWindows) {
  const auto figures = Markup(html(sample()), true).with("svg");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_TRUE(figures[0].has_class("wide"));
  EXPECT_TRUE(figures[1].has_class("narrow"));
  for (const Element& e : figures) {
    EXPECT_EQ(e.attributes.count("viewBox"), 1U);
    EXPECT_EQ(e.attributes.count("width"), 0U);  // the style sheet makes it fit
  }
}

TEST(Html, RejectsScriptsAndRequests) {
  const std::string text = html(sample());
  const Markup markup(text, true);
  const auto metas = markup.with("meta");
  const auto policy = std::find_if(metas.begin(), metas.end(), [](const Element& e) {
    const auto it = e.attributes.find("http-equiv");
    return it != e.attributes.end() && it->second == "Content-Security-Policy";
  });
  ASSERT_NE(policy, metas.end());
  EXPECT_THAT(policy->attributes.at("content"),
              testing::StartsWith("default-src 'none'; style-src 'unsafe-inline'; img-src data:"));
  for (const Element& e : markup.elements()) {
    EXPECT_THAT(e.name, Not(testing::AnyOf("script", "img", "iframe", "object", "embed", "base")));
    for (const auto& [key, value] : e.attributes) {
      EXPECT_NE(key, "src");
      EXPECT_THAT(key, Not(testing::StartsWith("on")));
      EXPECT_TRUE(key != "href" || value == "data:,");
      EXPECT_TRUE(key == "xmlns" || value.find("://") == std::string::npos);
    }
  }
  for (const std::string& style : texts(markup.with("style"))) {
    EXPECT_THAT(style, Not(HasSubstr("url(")));
    EXPECT_THAT(style, Not(HasSubstr("@import")));
  }
}

TEST(Html, EscapesEveryText) {
  const std::string evil = "<script>alert('1')</script><img src=x onerror=\"x\">&\x02";
  Page page{.title = evil, .subtitle = evil};
  page.verdict = Headline{true, evil};
  CurveLook look = pmc600_look();
  look.title = look.label = look.axis = look.unit = look.axis_unit = evil;
  look.shades[0].label = evil;
  page.sections = {{evil,
                    {Prose{evil}, Facts{{{evil, evil}}}, DataTable{evil, {evil}, {{{evil}, true}}},
                     Chart{curve_figure(pmc600_cam(), look), evil}}}};
  page.footer = evil;
  const std::string text = html(page);
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_THAT(text, Not(HasSubstr("<img")));
  const Markup markup(text, true);
  EXPECT_THAT(markup.with("h1").at(0).text, HasSubstr("&lt;script&gt;"));
}

TEST(Html, AdaptsToReaderAndPaper) {
  const std::string style = Markup(html(sample()), true).with("style").at(0).text;
  EXPECT_THAT(style, HasSubstr("@media screen and (prefers-color-scheme:dark){:root{--paper:"));
  EXPECT_THAT(style, HasSubstr("@media print"));
  EXPECT_THAT(style, HasSubstr(".jf .l1{stroke:var(--one)}"));
}

/// Relative luminance of "#rrggbb" (WCAG 2.1).
double luminance(const std::string& color) {
  double sum = 0;
  for (const auto& [at, weight] : {std::pair{1U, 0.2126}, {3U, 0.7152}, {5U, 0.0722}}) {
    const double c = std::stoi(color.substr(at, 2), nullptr, 16) / 255.0;
    sum += weight * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

/// The value of a variable in the palette that begins at `palette` of the style.
std::string color_of(const std::string& style, std::size_t palette, const std::string& name) {
  return style.substr(style.find("--" + name + ":", palette) + name.size() + 3, 7);
}

TEST(Html, HasTheContrastOfLevelAa) {
  const std::string style = page_style();
  for (const std::size_t palette : {style.find(":root{"), style.find("dark){:root{")}) {
    const double paper = luminance(color_of(style, palette, "paper"));
    const auto contrast = [&](const std::string& name) {
      const double other = luminance(color_of(style, palette, name));
      return (std::max(paper, other) + 0.05) / (std::min(paper, other) + 0.05);
    };
    for (const char* text : {"ink", "soft", "limit", "three"})
      EXPECT_GE(contrast(text), 4.5) << text;
    for (const char* line : {"one", "two", "three", "four", "frame", "limit"})
      EXPECT_GE(contrast(line), 3) << line;
  }
}

TEST(Html, MarksBrokenRowsByASignToo) {
  const DataTable table{"", {"rule", "value"}, {{{"a", "1"}, true}, {{"b", "2"}, false}}};
  const Markup markup(html({.title = "t", .sections = {{"", {table}}}}), true);
  EXPECT_EQ(markup.with("tr", "broken").size(), 1U);
  EXPECT_THAT(texts(markup.with("td", "m")), ElementsAre("", "✗"));
}

TEST(Html, SetsNumbersToTheRight) {
  const DataTable table{
      "",
      {"name", "value [mm/s^2]", "margin"},
      {{{"a", "−1.5", "< −1000 %"}, false}, {{"7 b", "", "3 %"}, false}, {{"c"}, false}}};
  const Markup markup(html({.title = "t", .sections = {{"", {table}}}}), true);
  EXPECT_THAT(texts(markup.with("th", "n")), ElementsAre("value [mm/s²]", "margin"));
  EXPECT_EQ(markup.with("td").size(), 9U);  // the short row is filled
}

TEST(Html, ShowsAListingWithItsRemarks) {
  std::string text;
  for (int line = 1; line <= 2000; ++line) text += "line " + std::to_string(line) + " <b>\n";
  Listing listing{.caption = "a.toml", .text = text};
  listing.remarks.push_back({1000, "too fast & too far", true, DataTable::Place{3, 3}});
  const std::string page = html({.title = "t", .sections = {{"Spec", {listing}}}});
  EXPECT_THAT(page, HasSubstr("line 1000 &lt;b&gt;"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"remark\" data-from=\"3\" data-to=\"3\">"));
  EXPECT_THAT(page, HasSubstr("too fast &amp; too far"));
  EXPECT_THAT(page, HasSubstr("line 1003 "));
  EXPECT_THAT(page, Not(HasSubstr("line 1004 "))) << "only the surroundings of a long text";
  listing.text = "one\ntwo";
  EXPECT_THAT(html({.title = "t", .sections = {{"Spec", {listing}}}}), HasSubstr("<td>two</td>"));
}

TEST(Html, ShowsAPhoneADrawingOfItsWidth) {
  const Image image{.svg = "wide", .title = "plate", .narrow = "narrow"};
  const std::string page = html({.title = "t", .sections = {{"Disc", {image}}}});
  EXPECT_THAT(page, HasSubstr("<source media=\"screen and (max-width:600px)\" "
                              "srcset=\"data:image/svg+xml;base64,bmFycm93\"><img "));
  EXPECT_THAT(page, HasSubstr("src=\"data:image/svg+xml;base64,d2lkZQ==\"></picture>"));
  const Image wide{.svg = "wide", .title = "plate"};
  EXPECT_THAT(html({.title = "t", .sections = {{"Disc", {wide}}}}), Not(HasSubstr("<source")));
}

TEST(Html, ShowsADrawingAsAnImage) {
  const Image image{"<svg xmlns=\"x\"/>", "A \"plate\"", "caption"};
  const std::string page = html({.title = "t", .sections = {{"Disc", {image}}}});
  // printf '<svg xmlns="x"/>' | base64
  EXPECT_THAT(page, HasSubstr("src=\"data:image/svg+xml;base64,PHN2ZyB4bWxucz0ieCIvPg==\""));
  EXPECT_THAT(page, HasSubstr("alt=\"A &quot;plate&quot;\""));
  EXPECT_THAT(page, HasSubstr("img-src data:"));
}

TEST(Html, SplitsProseIntoParagraphs) {
  const Markup markup(
      html({.title = "t", .sections = {{"", {Prose{"\n\none\ntwo\n\n\n\nthree\n\n"}}}}}), true);
  EXPECT_THAT(texts(markup.with("p")), ElementsAre("one\ntwo", "three"));
}

TEST(Html, IsDeterministicAndLean) {
  EXPECT_EQ(html(sample()), html(sample()));
  EXPECT_LT(html(sample()).size(), 30'000U);
}

TEST(Html, HoldsAnEmptyPage) {
  EXPECT_NO_THROW(Markup(html({}), true));
}

}  // namespace
}  // namespace jounce::page_test
