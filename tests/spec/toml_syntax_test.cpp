// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::toml_syntax_test {
namespace {

/// The error of a spec whose third line is this.
std::string error_of(const std::string& line) {
  return test::error_of(
      [&] { (void)parse_spec("jounce = 1\nkind = \"move\"\n" + line + "\n[limits]\n", "a.toml"); });
}

/// The same, without line and column.
std::string unplaced(const std::string& line) {
  const auto error = test::refusal_of(
      [&] { (void)parse_spec("jounce = 1\nkind = \"move\"\n" + line + "\n[limits]\n", "a.toml"); });
  return error ? error->key() + " = " + error->value() + ": " + error->rule() : "";
}

TEST(TomlSyntax, TextNeedsQuotes) {
  EXPECT_EQ(error_of("name = rise"), "a.toml:3:8: name = rise: text needs quotes: name = \"rise\"");
  EXPECT_EQ(unplaced("law = trapezoid"), "law = trapezoid: text needs quotes: law = \"trapezoid\"");
  EXPECT_EQ(unplaced("end = { law = indexer, slave = 5 }"),
            "law = indexer: text needs quotes: law = \"indexer\"");
}

TEST(TomlSyntax, AQuantityNeedsQuotesAndADecimalPoint) {
  EXPECT_EQ(error_of("velocity = 400 mm/s"),
            "a.toml:3:16: velocity = 400 mm/s: a number with a unit needs quotes: velocity = \"400 "
            "mm/s\"");
  EXPECT_EQ(error_of("velocity = 400,5"),
            "a.toml:3:15: velocity = 400,5: a number has a decimal point: velocity = 400.5");
  EXPECT_EQ(error_of("periodic = True"),
            "a.toml:3:12: periodic = True: must be true or false, in lower case");
}

TEST(TomlSyntax, ACommaInANumberCanMeanThousands) {
  EXPECT_EQ(unplaced("velocity = 1,000"),
            "velocity = 1,000: a number has no comma: write velocity = 1000, or velocity = 1.000");
  EXPECT_EQ(unplaced("velocity = 0,125"),
            "velocity = 0,125: a number has a decimal point: velocity = 0.125");
  EXPECT_EQ(unplaced("velocity = 50,"), "velocity = 50,: remove the comma after the number");
  EXPECT_EQ(unplaced("velocity = 5O"),
            "velocity = 5O: is a letter here a digit? The letters O and l look like 0 and 1");
}

TEST(TomlSyntax, AKeyFileIsNamedAndNotShown) {
  const std::string key(64, 'a');
  const auto error = [](const std::string& text, const std::string& name) {
    return test::error_of([&] { (void)parse_spec(text, name); });
  };
  EXPECT_EQ(error(key + "\n", "key.toml"),
            "key.toml:1:65: looks like a key file (`jounce new key`), not a spec");
  for (const std::string& line : {"key = " + key, "key = \"" + key + "\"", "kind = \"" + key + '"',
                                  key + " = 1", "[" + key, key + " " + key, "\"" + key}) {
    const std::string text = error("jounce = 1\n" + line + "\n", "a.toml");
    EXPECT_THAT(text, testing::Not(testing::HasSubstr(key.substr(0, 16)))) << line;
    EXPECT_THAT(text, testing::StartsWith("a.toml")) << line;
  }
}

TEST(TomlSyntax, NamesTheMistakesOfTheParserInPlainWords) {
  EXPECT_EQ(error_of("[ ]"), "a.toml:3:3: the name of the section is missing between its brackets");
  EXPECT_EQ(error_of("= 50"), "a.toml:3:1: the name of the key is missing before the =");
  EXPECT_EQ(unplaced("velocity = .5"),
            "velocity = .5: needs a digit before its decimal point: 0.5");
  EXPECT_EQ(unplaced("end = ( 1 )"),
            "end = : needs braces or brackets, not parentheses: { ... } or [ ... ]");
  EXPECT_EQ(error_of("[move   # a comment"),
            "a.toml:3:9: [move: needs a closing ] at the end of the section header");
}

TEST(TomlSyntax, NamesWhatIsMissing) {
  EXPECT_EQ(error_of("velocity = "), "a.toml:3:12: velocity: has no value: write velocity = VALUE");
  EXPECT_EQ(error_of("velocity 400"),
            "a.toml:3:10: velocity: needs a = between the key and its value");
  EXPECT_EQ(error_of("name = \"rise"), "a.toml:3:13: name = \"rise: the closing quote is missing");
  EXPECT_EQ(error_of("[move"),
            "a.toml:3:6: [move: needs a closing ] at the end of the section header");
  EXPECT_EQ(error_of("end = { master = 1"),
            "a.toml:3:19: end: needs its closing } on the same line");
  EXPECT_EQ(error_of("end = { master = 1 slave = 2 }"),
            "a.toml:3:20: master: needs a comma or the closing } after its value");
}

TEST(TomlSyntax, NamesWhatIsThereTwice) {
  EXPECT_EQ(error_of("name = \"a\"\nname = \"b\""),
            "a.toml:4:8: name = \"b\": is given twice: remove one of the two");
  EXPECT_EQ(error_of("[limits]"),
            "a.toml:4:1: [limits]: is given twice: keep one section, with the keys of both");
}

/// The first error of a spec of this kind.
std::string error_in(const std::string& kind, const std::string& text) {
  return test::error_of([&] {
    const std::string master = kind == "cam" || kind == "gear" ? ", master = \"deg\"" : "";
    (void)parse_spec(
        "jounce = 1\nkind = \"" + kind + "\"\nunits = { position = \"mm\"" + master + " }\n" + text,
        "a.toml");
  });
}

TEST(TomlSyntax, ASectionThatCanOccurSeveralTimesNeedsDoubleBrackets) {
  const std::string rule = ": needs double brackets: write [[";
  for (const char* text : {"[segment]\n", "[segment]\n[[segment]]\n", "[segment]\n[segment]\n"})
    EXPECT_EQ(error_in("cam", std::string("start = { master = 0, slave = 0 }\n") + text),
              "a.toml:5:1: [segment]" + rule + "segment]], because there can be several");
  EXPECT_EQ(error_in("queue", "[[command]]\n[command]\n"),
            "a.toml:5:1: [command]" + rule + "command]], because there can be several");
  EXPECT_EQ(error_in("gear",
                     "[gear]\nengage = \"distance\"\nnumerator = 1\nmaster_end = 9\n"
                     "distance = 1\n[gear.change]\nat = 1\n"),
            "a.toml:9:1: [gear.change]" + rule + "gear.change]], because there can be several");
  EXPECT_EQ(error_in("path", "[[axis]]\nname = \"x\"\n[axis]\n"),
            "a.toml:6:1: [axis]" + rule + "axis]], because there can be several");
}

TEST(TomlSyntax, NamesTheSectionThatIsUnknown) {
  EXPECT_EQ(error_in("path", "[[axis]]\nname = \"x\"\n[paths]\n"),
            "a.toml:6:2: [paths]: is not a section here: did you mean [path]?");
}

TEST(TomlSyntax, DistinguishesAForeignFileFromASpec) {
  const auto error = [](const std::string& text, const char* name) {
    return test::error_of([&] { (void)parse_spec(text, name); });
  };
  const std::string foreign =
      ": is not a spec, a table, a G-code program or a controller file that Jounce reads; a spec "
      "begins with jounce = 1";
  EXPECT_EQ(error("# Title\n\nSome SMC_CAMXYVA text.\n", "README.md"), "README.md:1" + foreign);
  EXPECT_EQ(error("a b\n", "a.toml"), "a.toml:1:3: a: needs a = between the key and its value");
  EXPECT_EQ(error("jounce = 1\na b\n", "-"), "-:2:3: a: needs a = between the key and its value");
  EXPECT_EQ(error(std::string("kind = 1\n\0", 10), "a.toml"),
            "a.toml:2: is not a text file: it has a zero byte here");
  EXPECT_EQ(error("a = 1\rb = 2\r", "a.toml").find("line ends LF or CRLF") == std::string::npos,
            false);
  EXPECT_EQ(
      error("a = \"h\xf6he\"\n", "a.toml").find("save the file in UTF-8") == std::string::npos,
      false);
  EXPECT_EQ(error("# jounce table 1\n# axis: time\n", "t.csv"),
            "t.csv:1: is a table, not a spec: give a spec");
}

TEST(TomlSyntax, ChecksANumberByItsDigits) {
  EXPECT_EQ(unplaced("velocity = 1e400"),
            "velocity = 1e400: must be less than 1.8e308 in magnitude");
  EXPECT_EQ(unplaced("end = { master = 1 # here\n}"),
            "end = : needs its closing } on the same line");
}

TEST(TomlSyntax, ASectionThatOccursOnceNeedsSingleBrackets) {
  const std::string rule = ": needs single brackets: write ";
  EXPECT_EQ(error_in("move", "[[limits]]\nvelocity = 1\n"),
            "a.toml:4:1: [[limits]]" + rule + "[limits], because there is only one");
  EXPECT_EQ(error_in("axis", "[axis]\n[[axis]]\n"),
            "a.toml:5:1: [[axis]]" + rule + "[axis], because there is only one");
}

}  // namespace
}  // namespace jounce::toml_syntax_test
