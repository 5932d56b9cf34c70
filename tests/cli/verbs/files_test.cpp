// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/base/detail/printable.hpp"

#include "program.hpp"

namespace jounce::files_of_verbs_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using cli_test::slurp;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using Files = cli_test::Program;

// None of the inputs is there: so it is the folder that was looked at first, before any work.
TEST_F(Files, AMissingFolderIsRejectedBeforeTheWork) {
  const std::string identify = "identify no.toml --log no.csv --fit mass[1].inertia";
  for (const auto& [verb, option] :
       std::vector<std::pair<std::string, std::string>>{{"optimize no.toml", "--output"},
                                                        {"optimize no.toml", "--table"},
                                                        {"optimize no.toml", "--plot"},
                                                        {"sweep no.toml", "--output"},
                                                        {"sweep no.toml", "--npy"},
                                                        {"sweep no.toml", "--plot"},
                                                        {identify, "--output"},
                                                        {identify, "--plot"},
                                                        {"report no.toml", "--output"}}) {
    const Result missing = run(verb + " " + option + " nowhere/x.svg");
    EXPECT_EQ(missing.status, 2) << verb;
    EXPECT_EQ(missing.err, "jounce: " + option +
                               " = nowhere/x.svg: cannot be written, because the folder nowhere "
                               "does not exist: make it first\n");
    EXPECT_THAT(run(verb + " " + option + " .").err, HasSubstr(option + " = .: is a folder"));
  }
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Files, AnOutputHasTheExtensionOfItsFormat) {
  for (const auto& [verb, name, endings] :
       {std::tuple{"design " + cam + " -o ", "o.xls", ".csv or .json"},
        {"optimize " + cam + " -o ", "o.csv", ".toml"},
        {"events " + cam + " -o ", "o.txt", ".csv or .json"},
        {"map " + cam + " -o ", "o.pdf", ".csv, .svg or .png"},
        {"plot " + cam + " -o ", "o.gif", ".svg or .png"},
        {std::string("new cam -o "), "o.csv", ".toml"}}) {
    const Result wrong = run(verb + name);
    EXPECT_EQ(wrong.status, 2) << verb;
    EXPECT_EQ(wrong.err,
              std::string("jounce: --output = ") + name + ": must end in " + endings + "\n");
  }
  EXPECT_EQ(
      run("report " + cam + " -o no/o.html").err,
      "jounce: --output = no/o.html: cannot be written, because the folder no does not exist: "
      "make it first\n");
  EXPECT_EQ(run("design " + cam + " -o table").status, 1);
}

TEST_F(Files, BadInputLeavesNothingBehind) {
  const std::string text = slurp(cam);
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string changed = text;
    changed.replace(changed.find(what), what.size(), by);
    return changed;
  };
  const std::vector<std::string> bad{"",
                                     with("jounce = 1", "jounce = 9"),
                                     with("master = 75", "master = nan"),
                                     with("master = 75", "master = inf"),
                                     with("master = 200", "master = 75"),
                                     with("master = 200", "master = 60"),
                                     with("slave = 225", "slave = \"225 mm\""),
                                     with("periodic", "periodc"),
                                     text.substr(0, text.find("\"in step\"") + 4)};
  for (const std::string& spec : bad) {
    write("bad.toml", spec);
    for (const char* verb :
         {"design bad.toml -o out.csv --curve out.json", "plot bad.toml -o out.svg",
          "plot bad.toml -o out.png", "report bad.toml -o out.html",
          "optimize bad.toml -o out.toml --table out.csv"}) {
      const Result result = run(verb);
      EXPECT_EQ(result.status, 2) << verb << "\n" << spec.substr(0, 80);
      EXPECT_THAT(result.err, StartsWith("jounce: bad.toml")) << verb;
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
          << "one message: " << result.err;
      EXPECT_EQ(files(), std::vector<std::string>{"bad.toml"}) << verb;
    }
  }
}

TEST_F(Files, AFolderThatRejectsFilesIsStatus3) {
  const Result result =
      run("design " + cam + " -o /proc/t.csv");  // no program can make files there
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot write /proc/t.csv"));
}

TEST_F(Files, AMissingFolderIsStatus2) {
  const Result result = run("design " + cam + " -o /nonexistent/folder/t.csv");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("the folder /nonexistent/folder does not exist"));
}

// A full disk behind `> file` was exit status 0, with half of the text or none.
TEST_F(Files, AFullDiskIsStatus3) {
  for (const char* verb : {"check ", "check --json ", "validate ", "diff "}) {
    const std::string file = verb == std::string("diff ") ? cam + " " + cam : cam;
    const Result full = run(verb + file + " > /dev/full");
    EXPECT_EQ(full.status, 3) << verb;
    EXPECT_THAT(full.err, HasSubstr("No space left on device")) << verb;
  }
}

TEST_F(Files, AClosedStandardOutputIsIgnored) {
  EXPECT_EQ(run("design " + cam + " -o table.csv >&-").status, 1);
  const std::string table = slurp(folder / "table.csv");
  EXPECT_THAT(table, StartsWith("# jounce table 1\n"));
  EXPECT_THAT(table, Not(HasSubstr("certified")));
}

TEST_F(Files, NoFileThatASpecNamesIsReplaced) {
  const std::string points = "time [s],position [mm],velocity [mm/s]\n0,0,0\n1,10,0\n2,0,0\n";
  write("p.csv", points);
  write("p.toml",
        "points = \"p.csv\"\njounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\n");
  for (const char* verb :
       {"design p.toml -o p.csv", "convert p.toml p.csv --rule linear --allow-loss"}) {
    const Result result = run(verb);
    EXPECT_EQ(result.status, 2) << verb;
    EXPECT_THAT(result.err, HasSubstr("p.csv: is also an input")) << verb;
    EXPECT_EQ(slurp(folder / "p.csv"), points) << verb;
  }
  EXPECT_EQ(run("design p.toml -o table.csv").status, 0);
  write("p.html", points);
  write("page.toml",
        "points = \"p.html\"\njounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\n");
  EXPECT_THAT(run("report page.toml -o p.html").err, HasSubstr("p.html: is also an input"));
  EXPECT_EQ(slurp(folder / "p.html"), points);
}

TEST_F(Files, NoFileThatAnInputNamesIsReplaced) {
  const std::string points = "time [s],position [mm],velocity [mm/s]\n0,0,0\n1,10,0\n2,0,0\n";
  const std::string spec = "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\n";
  write("p.csv", points);
  write("p.png", points);
  write("p.toml", spec + "points = \"p.csv\"\n");
  write("picture.toml", spec + "points = \"p.png\"\n");
  write("cam.csv", slurp(cam));  // the content determines what it is
  write("from.toml", "jounce = 1\nkind = \"cam\"\nfrom = \"cam.csv\"\n");
  for (const auto& [verb, file] : {std::pair{"design - -o p.csv < p.toml", "p.csv"},
                                   {"plot picture.toml -o p.png", "p.png"},
                                   {"plot p.toml --before picture.toml -o p.png", "p.png"},
                                   {"diff picture.toml p.toml -o p.png", "p.png"},
                                   {"convert from.toml cam.csv --allow-loss", "cam.csv"}}) {
    const std::string before = slurp(folder / file);
    const Result result = run(verb);
    EXPECT_EQ(result.status, 2) << verb;
    EXPECT_THAT(result.err, HasSubstr(std::string(file) + ": is also an input")) << verb;
    EXPECT_EQ(slurp(folder / file), before) << verb;
  }
}

TEST_F(Files, TheKeyInAFileWithAWrongNameIsNeverShown) {
  std::string digits;
  for (int i = 0; i < 8; ++i) digits += "5ff94de8";
  for (const std::string name : {"key.toml", "key.csv", "key.ngc", "key.txt", "key.json", "key"}) {
    write(name, digits + "\n");
    for (const std::string verb :
         {"check ", "design ", "report ", "stream --to feeder --url memq:// ", "explain ",
          "convert --to csv x.csv "}) {
      const Result result = run(verb + name);
      EXPECT_EQ(result.status, 2) << verb << name;
      EXPECT_THAT(result.out + result.err, Not(HasSubstr("5ff94de8"))) << verb << name;
    }
  }
}

// A terminal obeys an escape sequence wherever it comes from.
TEST_F(Files, NoControlCharacterOfAFileOrItsNameReachesATerminal) {
  const auto expect_harmless = [&](const std::string& words) {
    const Result result = run(words);
    for (const std::string& text : {result.out, result.err})
      EXPECT_EQ(printable_lines(text), text) << words;
  };
  const std::string file = "a\x1b[2J\xff.toml";
  const std::string named = "'" + file + "'";
  EXPECT_EQ(run("new cam -o good.toml").status, 0);
  std::filesystem::copy_file(folder / "good.toml", folder / file);
  const std::string table = "'t\x1b]0;x\x07.csv'";
  for (const std::string& words :
       {"check " + named, "design " + named + " -o " + table, "validate " + named,
        "diff " + named + " " + named, "convert " + named + " " + table,
        "plot " + named + " -o '\x1b.svg'", "run " + named, "replay " + named,
        "contour " + named + " -o '\x1b.svg'", std::string("check '\x1b[2J'"),
        std::string("monitor '\x1b[2J'"), std::string("'\x1b[2J'"),
        std::string("check --'\x1b[2J'")})
    expect_harmless(words);
  write("name.toml",
        "jounce = 1\nkind = \"axis\"\nname = \"\\u001b[2J\"\nunits = { position = \"mm\" }\n");
  write("key.toml", "jounce = 1\nkind = \"axis\"\n\"\\u001b[2J\" = 1\n");
  write("raw.toml", "jounce = 1\nkind = \"\x1b[2J\"\n");
  write("unit.csv", "# jounce table 1\n# axis: \x1b[2J\n# rule: \x1b\n");
  for (const char* name : {"name.toml", "key.toml", "raw.toml", "unit.csv"})
    for (const char* verb : {"check ", "run ", "plot "}) expect_harmless(std::string(verb) + name);
}

}  // namespace
}  // namespace jounce::files_of_verbs_test
