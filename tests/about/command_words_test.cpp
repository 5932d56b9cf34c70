// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/command_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "about/sample.hpp"
#include "support/errors.hpp"

namespace jounce::command_words_test {
namespace {

using testing::ElementsAre;
using Words = std::vector<const char*>;

TEST(CommandWords, DistinguishAnOptionFromANumber) {
  for (const char* const option : {"-o", "--json", "--"}) EXPECT_TRUE(looks_like_option(option));
  for (const char* const other : {"-", "-5", "-.5", "o", ""})
    EXPECT_FALSE(looks_like_option(other)) << other;
}

TEST(CommandWords, AreReadAsTheyAreMeant) {
  EXPECT_THAT(meant_words(Words{"order", "-.5", "--to=-.5", "--", "-.5", ""}),
              ElementsAre("order", "-0.5", "--to=-.5", "--", "-.5", ""));
  EXPECT_EQ(test::error_of([] {
              meant_words(Words{"run", "--log="});
            }),
            "--log: has no value after =");
  EXPECT_THAT(meant_words(Words{"order", "--to=x="}), ElementsAre("order", "--to=x="));
  EXPECT_EQ(test::error_of([] {
              meant_words(Words{"run", "--log", ""});
            }),
            "--log: is empty: write a value");
  EXPECT_EQ(test::error_of([] {
              meant_words(Words{"run", ""});
            }),
            "argument 1 of run: is empty: write a value");
}

TEST(CommandWords, ANegativeNumberNeedsNoDashes) {
  EXPECT_EQ(wrong_option(Words{"feeder", "jog", "--", "-20"}, {"--to"}, {}, "jog"),
            "`--` is not needed before a negative number: leave it out");
}

TEST(CommandWords, DashesEndTheOptions) {
  EXPECT_EQ(wrong_option(Words{"--", "-file.toml", "-o", "x.csv"}, {"-o"}, {}, "design"),
            "`--` ends the options: write -o before it");
  EXPECT_EQ(wrong_option(Words{"--", "-file.toml", "--out=x.csv"}, {"--out"}, {}, "design"),
            "`--` ends the options: write --out=x.csv before it");
}

TEST(CommandWords, NameTheNearestVerb) {
  const std::vector<std::string> verbs{"check", "design"};
  EXPECT_EQ(wrong_verb(Words{}, verbs), "the verb is missing");
  EXPECT_EQ(wrong_verb(Words{"check", "x"}, verbs), "");
  EXPECT_EQ(wrong_verb(Words{"--json"}, verbs), "");
  EXPECT_EQ(wrong_verb(Words{"chek"}, verbs), "`chek` is not a verb: did you mean check?");
  EXPECT_EQ(wrong_verb(Words{"plot"}, verbs), "`plot` is not a verb");
  EXPECT_EQ(wrong_verb(Words{"CHECK"}, verbs), "`CHECK` is not a verb: did you mean check?");
  EXPECT_EQ(wrong_verb(Words{"cam.toml"}, verbs),
            "`cam.toml` is not a verb: write the verb first, such as `jounce check cam.toml`");
  EXPECT_EQ(wrong_verb(Words{"--json", "check", "cam.toml"}, verbs),
            "`--json` stands before the verb: write `jounce check` first, then its options");
}

TEST(CommandWords, NameTheNearestOption) {
  const ProgramInfo program = about_test::sample();
  const std::vector<std::string> options{"--strict", "--json", "-n"};
  const auto wrong = [&](const Words& words, const std::string& verb = "check") {
    return wrong_option(words, options, program, verb);
  };
  EXPECT_EQ(wrong({"a.toml", "-n", "-3", "--strict=1"}), "");
  EXPECT_EQ(wrong({"--stric=1"}), "`--stric` is not an option of check: did you mean --strict?");
  EXPECT_EQ(wrong({"--versoin"}, ""),
            "`--versoin` is not an option of tool: did you mean --version?");
  EXPECT_EQ(wrong({"--jso"}), "`--jso` is not an option of check") << "--json is hidden";
  EXPECT_EQ(wrong({"-o", "a.csv"}), "`-o` is not an option of check");
  EXPECT_EQ(wrong({"-o", "a.csv"}, "chart"),
            "`-o` is not an option of chart: name the output as the second argument");
  EXPECT_EQ(wrong({"a", "--strict", "-1.5", "mm/s", "b"}),
            "`-1.5 mm/s` is one value: write it without a space");
  EXPECT_EQ(wrong({"a", "1.5", "b", "mm"}), "");
}

TEST(CommandWords, NameTheOptionThatAnotherWordMeans) {
  ProgramInfo program = about_test::sample();
  program.verbs.push_back(
      {.name = "turn",
       .options = {{.names = {"--to"}, .help = "Format, if OUT has no extension"},
                   {.names = {"--steps"}, .help = "Countless"}}});
  const auto wrong = [&](const char* word) {
    return wrong_option(Words{word}, {"--to", "--steps"}, program, "turn");
  };
  EXPECT_EQ(wrong("--format"), "`--format` is not an option of turn: did you mean --to?");
  EXPECT_EQ(wrong("--count"), "`--count` is not an option of turn, but of check");
  EXPECT_EQ(wrong("--limit=3"), "`--limit` is not an option of turn, but of check");
  EXPECT_EQ(wrong("--nowhere"), "`--nowhere` is not an option of turn");
}

TEST(CommandWords, WriteAnArgumentWithoutItsName) {
  const ProgramInfo program = about_test::sample();
  for (const auto& words :
       {Words{"chart", "--kind", "json", "a.svg"}, Words{"chart", "--kind=json", "a.svg"}})
    EXPECT_EQ(wrong_option(words, {}, program, "chart"),
              "`--kind` is not an option of chart: write KIND without --kind, `jounce chart json "
              "a.svg`");
}

TEST(CommandWords, SuggestTheHelpOnlyForAWordLikeIt) {
  ProgramInfo program = about_test::sample();
  program.verbs.push_back({.name = "turn", .options = {{.names = {"--help"}, .help = "Print"}}});
  const auto wrong = [&](const char* word) {
    return wrong_option(Words{word}, {"--help"}, program, "turn");
  };
  EXPECT_EQ(wrong("--hlp"), "`--hlp` is not an option of turn: did you mean --help?");
  EXPECT_EQ(wrong("--shelp"), "`--shelp` is not an option of turn");
}

TEST(CommandWords, OfferOnlyWhatTheOtherOptionsPermit) {
  ProgramInfo program = about_test::sample();
  program.verbs.push_back({.name = "turn",
                           .options = {{.names = {"--slave"}, .excludes = {"--output"}},
                                       {.names = {"-o", "--output"}, .excludes = {"--slave"}},
                                       {.names = {"--at"}, .needs = {"--output"}},
                                       {.names = {"--from"}, .needs = {"--output"}}}});
  const auto wrong = [&](const Words& words) {
    return wrong_option(words, {"--slave", "-o", "--output", "--at", "--from"}, program, "turn");
  };
  EXPECT_EQ(wrong({"--slave", "1"}), "");
  EXPECT_EQ(wrong({"--at=1", "-o", "x"}), "");
  EXPECT_EQ(wrong({"--slave", "1", "-o", "x"}),
            "--slave cannot be combined with --output: give one of the two");
  EXPECT_EQ(wrong({"--slave", "1", "--at", "2", "-o", "x"}),
            "--slave cannot be combined with --output: leave out --slave, or leave out --output "
            "and --at");
  EXPECT_EQ(wrong({"--at", "2"}), "--at needs --output: add it, or leave out --at");
  EXPECT_EQ(wrong({"--at", "2", "--from", "1"}),
            "--at and --from need --output: add it, or leave out --at and --from");
  EXPECT_EQ(wrong({"--slave", "1", "--at", "2"}),
            "--at needs --output, which cannot be combined with --slave: leave out --at, or "
            "replace --slave by --output");
}

TEST(CommandWords, TranslateTheSentencesOfTheParser) {
  EXPECT_EQ(parser_sentence("--a excludes --b", false),
            "--a cannot be combined with --b: give one of the two");
  EXPECT_EQ(parser_sentence("--a: At Most 1 required but received 2", false), "--a is given twice");
  EXPECT_EQ(parser_sentence("--a: 1 required value missing", false), "--a has no value after it");
  EXPECT_EQ(parser_sentence("FILE is required", false), "FILE is missing");
  const VerbInfo fit{"fit",
                     "",
                     {},
                     {{.names = {"IN"}, .required = true},
                      {.names = {"OUT"}, .required = true},
                      {.names = {"MORE"}}},
                     {{.names = {"-l", "--log"}, .required = true}, {.names = {"--json"}}}};
  const auto missing = [&](const char* first, const std::vector<const char*>& given) {
    return parser_sentence(std::string(first) + " is required", false, given, &fit);
  };
  EXPECT_EQ(missing("IN", {"fit"}), "IN, OUT and --log are missing");
  EXPECT_EQ(missing("OUT", {"fit", "a"}), "OUT and --log are missing");
  EXPECT_EQ(missing("OUT", {"fit", "a", "-l", "x"}), "OUT is missing");
  EXPECT_EQ(missing("--log", {"fit", "a", "b"}), "--log is missing");
  EXPECT_EQ(parser_sentence("force was given a disallowed flag override", false),
            "--force takes no value: write it alone, or leave it out");
  EXPECT_EQ(parser_sentence("other", false), "other");
  EXPECT_EQ(parser_sentence("The following argument was not expected: x", true),
            "`x` is one argument too many");
}

TEST(CommandWords, BreakAtSpaces) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("one two", 7), "one two");
  EXPECT_EQ(wrapped("a longerword b", 4), "a\nlongerword\nb");
  EXPECT_EQ(wrapped("longerword", 4), "longerword");
}

}  // namespace
}  // namespace jounce::command_words_test
