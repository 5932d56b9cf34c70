// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>

#include "jounce/base/printable.hpp"

namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";
const std::string cam = examples + "pmc600-cam/cam.toml";

std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Result {
  int status;
  std::string out;
  std::string err;
};

/// Each test works in a folder of its own, which must hold only what the test expects.
class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "jounce_cli_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  Result run(const std::string& arguments) {
    const std::string err = folder.string() + ".err";
    const std::string command =
        "cd " + folder.string() + " && " JOUNCE_EXE " " + arguments + " 2> " + err;
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    const int status = WEXITSTATUS(pclose(pipe));
    const Result result{status, out, slurp(err)};
    std::filesystem::remove(err);
    return result;
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::filesystem::path folder;
};

/// The verbs that `jounce --help` lists.
std::vector<std::string> verbs_of(const std::string& help) {
  std::vector<std::string> verbs;
  std::istringstream lines(help.substr(help.find("Subcommands:\n")));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && !line.empty();)
    if (line.size() > 2 && line[2] != ' ') verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  return verbs;
}

TEST_F(Cli, EveryVerbHasHelpWithAnExample) {
  const Result program = run("--help");
  EXPECT_EQ(program.status, 0);
  const auto verbs = verbs_of(program.out);
  EXPECT_GE(verbs.size(), 24U) << program.out;
  for (const std::string& verb : verbs) {
    const Result help = run(verb + " --help");
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_THAT(help.out, HasSubstr("Example:\n  jounce " + verb)) << verb;
  }
}

TEST_F(Cli, ExplainNamesMeaningAndRemedy) {
  const Result name = run("explain following_error");
  EXPECT_EQ(name.status, 0);
  EXPECT_THAT(name.out,
              HasSubstr("6 following_error (Faults of an axis)\n  The following error exceeded "));
  EXPECT_THAT(name.out, HasSubstr("What to do: "));
  const Result number = run("explain 6");
  EXPECT_THAT(number.out, HasSubstr(name.out)) << "the same fault";
  EXPECT_THAT(number.out, HasSubstr("6 out_of_memory (Refusals of the stream)"));
  EXPECT_THAT(run("explain 0x1392").out, HasSubstr("Errors of HMPL for cams and gears"));
  const Result finding = run("explain limit/geo_jerk");  // a member of the family limit/*
  EXPECT_EQ(finding.status, 0);
  EXPECT_THAT(finding.out,
              HasSubstr("limit/* (Findings of a check)\n  The named quantity exceeds its limit."));
  EXPECT_EQ(run("explain limit/velocityy").status, 2);
  const Result wrong = run("explain folowing_error");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err,
            "jounce: CODE = folowing_error: is not the number or name of a message: did you mean "
            "following_error?\n");
}

TEST_F(Cli, BadUsageIsTwoAndSaysWhatWasMeant) {
  EXPECT_EQ(run("").status, 2);
  const Result verb = run("chek x");
  EXPECT_EQ(verb.status, 2);
  EXPECT_EQ(verb.err, "jounce: `chek` is not a verb: did you mean check? (see jounce --help)\n");
  const Result option = run("check --limt x");
  EXPECT_EQ(option.status, 2);
  EXPECT_EQ(option.err,
            "jounce: `--limt` is not an option of check: did you mean --limit? (see jounce check "
            "--help)\n");
  EXPECT_THAT(run("convert a.csv b.csv --format csv").err, HasSubstr("did you mean --to?"));
  EXPECT_THAT(run("check a.toml --force").err, HasSubstr("not an option of check, but of new"));
  EXPECT_THAT(run("order x move --speed 3").err, Not(HasSubstr("--seed"))) << "a hidden option";
  for (const char* flag : {"new cam --force=3", "check a.toml --strict=no", "--json=3"}) {
    const Result valued = run(flag);
    EXPECT_EQ(valued.status, 2) << flag;
    EXPECT_THAT(valued.err, HasSubstr("takes no value: write it alone, or leave it out")) << flag;
  }
  EXPECT_EQ(run("check nothing.toml").status, 2);
}

TEST_F(Cli, AValueThatDoesNotFitItsOptionIsToldWithItsRule) {
  const auto told = [&](const std::string& words) {
    const Result result = run(words);
    EXPECT_EQ(result.status, 2) << words;
    return result.err;
  };
  EXPECT_EQ(told("check " + cam + " --continuity 4"),
            "jounce: --continuity = 4: must be a whole number from 0 to 3\n");
  EXPECT_EQ(told("convert " + cam + " x.csv --most -3"),
            "jounce: --most = -3: must be a number of at least 0\n");
  EXPECT_EQ(told("optimize " + cam + " --seconds soon"),
            "jounce: --seconds = soon: must be a number\n");
  EXPECT_EQ(told("plot " + cam + " --over tiem"),
            "jounce: --over = tiem: must be one of master, time: did you mean time?\n");
  EXPECT_EQ(told("stop a --patience nan"),
            "jounce: --patience = nan: must be a number of seconds from 0.001 to 1e12\n");
  EXPECT_EQ(told("-x"), "jounce: `-x` is not an option of jounce (see jounce --help)\n");
  EXPECT_EQ(told("design " + cam + " -o"),
            "jounce: --output has no value after it (see jounce design --help)\n");
}

// The parser would take the next word for the value, and the spec would be lost to the log.
TEST_F(Cli, AValueThatIsLeftOutIsNotTheNextWord) {
  EXPECT_EQ(run("new axis -o a.toml").status, 0);
  EXPECT_EQ(run("run --log= a.toml a.toml --url memq:// --seconds 0.1").err,
            "jounce: --log: has no value after =\n");
  EXPECT_THAT(run("run a.toml --log a.toml --url memq:// --seconds 0.1").err,
              HasSubstr("--log = a.toml: is also the input"));
  EXPECT_THAT(slurp(folder / "a.toml"), HasSubstr("kind = \"axis\""));
}

// The run would begin, and fail when it opens the log.
TEST_F(Cli, ARunNeedsTheFoldersOfItsFiles) {
  EXPECT_EQ(run("new axis -o a.toml").status, 0);
  for (const char* option : {"--log", "--record", "--black-box"}) {
    const Result done =
        run(std::string("run a.toml --url memq:// --seconds 0.1 ") + option + " none/a.x");
    EXPECT_EQ(done.status, 2) << option;
    EXPECT_EQ(done.err, std::string("jounce: ") + option +
                            " = none/a.x: cannot be written, because the folder none does not "
                            "exist: make it first\n");
  }
}

TEST_F(Cli, NumbersAreDecimal) {
  EXPECT_EQ(run("check " + cam + " --continuity 02").status,
            run("check " + cam + " --continuity 2").status);
  EXPECT_THAT(run("check " + cam + " --continuity 010").err, HasSubstr("0 to 3"));
  EXPECT_THAT(run("order feeder jog -.5mm/s --url memq://").err, Not(HasSubstr("not expected")));
}

TEST_F(Cli, AnOrderRejectsSecondsThatItWouldIgnore) {
  const std::string far = " --url memq://";
  const Result jog = run("order feeder jog 100 --seconds 1" + far);
  EXPECT_EQ(jog.status, 2);
  EXPECT_EQ(jog.err,
            "jounce: --seconds = 1: applies to jog --hold-to-run only: add --hold-to-run\n");
  EXPECT_EQ(run("order feeder move --to 5 --seconds 1" + far).err,
            "jounce: --seconds = 1: applies to jog --hold-to-run only\n");
  EXPECT_THAT(run("order feeder jog 100 --hold-to-run --seconds 1" + far).err,
              Not(HasSubstr("--seconds")));
}

TEST_F(Cli, AnOrderNamesTheSwappedWords) {
  EXPECT_EQ(run("order enable feeder").err,
            "jounce: WHAT = feeder: is not a command: did you mean jounce order feeder enable?\n");
}

TEST_F(Cli, HelpTellsWhatTakesAValueAndWhatMustBeGiven) {
  const std::string help = run("stream --help").out;
  EXPECT_THAT(help, HasSubstr("  --to ...                        Required. Name of the axis or "
                              "group, or of several axes (x,y,z): each\n"));
  EXPECT_THAT(help, HasSubstr("  --loops [1]  "));
  EXPECT_THAT(help, HasSubstr("  --json                          Outcome"));
  EXPECT_THAT(help, Not(HasSubstr("\n\n\n")));
  std::istringstream lines(run("convert --help").out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 104U) << line;
}

TEST_F(Cli, SaysWhereAnAxisContradictsItsOwnLimits) {
  write("a.toml",
        "jounce = 1\nkind = \"axis\"\nname = \"a\"\nunits = { position = \"mm\" }\n[axis]\n"
        "stop_acceleration = 10\n[limits]\nvelocity = 1\nacceleration = 100\n");
  const Result run_it = run("run a.toml --url memq:// --seconds 1");
  EXPECT_EQ(run_it.status, 2);
  EXPECT_THAT(run_it.err,
              HasSubstr("a.toml:6:21: axis.stop_acceleration = 10 mm/s^2: must be at least"));
}

// None of the inputs is there: so it is the folder that was looked at first, before any work.
TEST_F(Cli, AMissingFolderIsRefusedBeforeTheWorkThatItWouldHold) {
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

TEST_F(Cli, EveryStartingSpecIsGood) {
  for (const char* kind : {"cam", "follow", "gear", "indexer", "knife", "shear", "move", "queue",
                           "axes", "pvt", "pt"}) {
    const std::string file = std::string(kind) + ".toml";
    EXPECT_EQ(run(std::string("new ") + kind + " -o " + file).status, 0);
    const Result check = run("check " + file);
    EXPECT_EQ(check.status, 0) << check.out << check.err;
    EXPECT_EQ(run("validate " + file).status, 0) << kind;
  }
  EXPECT_EQ(run("new axis -o axis.toml").status, 0);
  EXPECT_EQ(run("new lathe").status, 2);
}

TEST_F(Cli, IdentifyFindsTheInertiaThatWasRecorded) {
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  // A rigid machine without error of following: its torque is inertia times acceleration and friction, and noise beside
  // which the error of following is small: a sum of twelve digits of a generator by Park and Miller.
  constexpr double inertia = 3e-4, friction = 2e-4, turns = 2 * 3.141592653589793, time = 0.3;
  std::string log = "time [s],command [rev],torque [N m]\n";
  std::uint64_t seed = 1;
  for (int i = 0; i <= 300; ++i) {
    const double x = i / 300.0;
    const double v = turns / time * (1 - std::cos(turns * x));
    const double a = turns * turns / time / time * std::sin(turns * x);
    double noise = -6;
    for (int k = 0; k < 12; ++k) {
      seed = seed * 48271 % 2147483647;
      noise += static_cast<double>(seed) / 2147483647;
    }
    log += std::to_string(time * x) + "," + std::to_string(x - std::sin(turns * x) / turns) + "," +
           std::to_string(inertia * a + friction * v + 0.005 * noise) + "\n";
  }
  write("run.csv", log);
  const std::string identify = "identify drive.toml --log run.csv --fit mass[1].inertia";
  const Result found = run(identify + " -o fitted.toml --plot fit.svg --json");
  EXPECT_EQ(found.status, 0) << found.err;
  const json first = json::parse(found.out)["numbers"][0];
  EXPECT_NEAR(first["value"].get<double>(), inertia - 4e-5, 0.01 * inertia);  // less the motor's
  EXPECT_THAT(slurp(folder / "fitted.toml"), HasSubstr("kind = \"drive\""));
  EXPECT_THAT(slurp(folder / "fit.svg"), StartsWith("<svg"));
  EXPECT_EQ(run(identify + " --plot fit.png").status, 0);
  EXPECT_EQ(slurp(folder / "fit.png").substr(1, 3), "PNG");  // not SVG by another name
  EXPECT_THAT(run(identify + " -o drive.toml").err, HasSubstr("is also the input"));
  EXPECT_THAT(run(identify + " -o run.csv").err, HasSubstr("must end in .toml"));
  EXPECT_EQ(run("identify drive.toml --log run.csv --fit mass[1].inertai").status, 2);
}

/// A move through two masses whose loop has a delay, ms.
std::string delayed_drive(double delay) {
  return R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = 100
velocity = 500
acceleration = 5000
jerk = 2e5
[drive]
position_per_rev = 20
settle = 0.3
motor = { inertia = 4e-5, friction.viscous = 1e-4, torque_limit = 20, torque_constant = 0.5 }
mass = [{ stiffness = 50, damping = 5e-3, inertia = 2e-4 }]
[drive.controller]
position_gain = 40
velocity_gain = 0.05
integral_time = 0.02
delay = ")" +
         std::to_string(delay) + " ms\"\n";
}

/// A loop that is hardly unstable, and one that is much so (issue 19): findings of the loop, not of the solver.
TEST_F(Cli, AnUnstableLoopIsAFinding) {
  for (const double delay : {0.86, 1.1}) {
    write("unstable.toml", delayed_drive(delay));
    for (const char* verb : {"validate", "check"}) {
      const Result found = run(std::string(verb) + " unstable.toml");
      EXPECT_EQ(found.status, 1) << verb << found.err;
      EXPECT_THAT(
          found.out,
          HasSubstr(delay < 1 ? "the loop is unstable: an oscillation at 307.217 Hz grows"
                              : "the loop is unstable: an oscillation at 278.632 Hz grows"));
      EXPECT_THAT(found.out, HasSubstr("-> lower controller.velocity_gain from 0.05 to less than"));
      EXPECT_THAT(found.out, Not(HasSubstr("please report")));
    }
    const json validated = json::parse(run("validate --json unstable.toml").out);
    EXPECT_EQ(validated["findings"][0]["rule"], "drive/stability");
    EXPECT_EQ(validated["findings"][0]["where_unit"], "Hz");
    EXPECT_EQ(validated["drive"]["loop"]["stable"], false);
    EXPECT_EQ(run("report unstable.toml -o page.html").status, 1);
    const std::string page = slurp(folder / "page.html");
    EXPECT_EQ(page.find("drive/stability"), page.rfind("drive/stability"));  // reported once
    EXPECT_THAT(page, HasSubstr("gain margin"));
    for (const char* picture : {"spectrum", "bode", "nyquist", "response"}) {
      const Result drawn = run(std::string("plot unstable.toml --drive ") + picture);
      EXPECT_EQ(drawn.status, 0) << picture << drawn.err;
      EXPECT_THAT(drawn.out, StartsWith("<svg"));
    }
  }
  std::string periodic = delayed_drive(1.1);
  periodic.replace(periodic.find("settle = 0.3"), 12, "periodic = true");
  write("periodic.toml", periodic);  // a finding too, though it has no steady state to integrate
  for (const char* verb : {"validate", "check"}) {
    const Result found = run(std::string(verb) + " periodic.toml");
    EXPECT_EQ(found.status, 1) << verb << found.err;
    EXPECT_THAT(found.out, HasSubstr("the loop is unstable: an oscillation at 278.632 Hz grows"));
    EXPECT_THAT(found.out, HasSubstr("-> lower controller.velocity_gain from 0.05 to less than"));
  }
  EXPECT_THAT(run("validate periodic.toml").out,
              HasSubstr("loop unstable at 278.6 Hz, gain margin"));
  EXPECT_EQ(run("report periodic.toml -o page.html").status, 1);
  write("stable.toml", delayed_drive(0.1));
  const Result calm = run("validate stable.toml");
  EXPECT_EQ(calm.status, 0) << calm.out;
  EXPECT_THAT(calm.out, HasSubstr("loop stable, gain margin"));
}

TEST_F(Cli, TheLoopOfADriveAloneIsDrawn) {
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  EXPECT_THAT(run("plot drive.toml --drive bode").out, HasSubstr("phase margin"));
  EXPECT_THAT(run("plot drive.toml --drive nyquist -o n.png").err, ::testing::IsEmpty());
  EXPECT_EQ(slurp(folder / "n.png").substr(1, 3), "PNG");
  ASSERT_EQ(run("new gear -o gear.toml").status, 0);
  EXPECT_THAT(run("plot gear.toml --drive bode").err,
              HasSubstr("drive: is missing: this picture needs a spec with a [drive]"));
}

/// The signals of the model are a recording that `identify` reads.
TEST_F(Cli, ValidateWritesTheSignalsOfADrive) {
  write("move.toml", delayed_drive(0.1));
  ASSERT_EQ(run("validate move.toml --signals run.csv --samples 801").status, 0);
  const std::string text = slurp(folder / "run.csv");
  EXPECT_THAT(text, HasSubstr("\ntime [s],command [mm],feedback [mm],load [mm],velocity [mm/s],"
                              "following_error [mm],torque [N m],current [A]\n0,0,0,0,0,0,0,0\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 1 + 801);
  const Result found = run("identify move.toml --log run.csv --fit mass[1].inertia --json");
  EXPECT_EQ(found.status, 0) << found.out << found.err;
  EXPECT_NEAR(json::parse(found.out)["numbers"][0]["value"].get<double>(), 2e-4, 1e-7);
  ASSERT_EQ(run("validate move.toml --signals run.npy --samples 801").status, 0);
  EXPECT_THAT(slurp(folder / "run.npy"), HasSubstr("('feedback', '<f8'), ('load', '<f8')"));
  EXPECT_THAT(run("validate move.toml --signals run.txt").err,
              HasSubstr("must end in one of .csv, .npy"));
  EXPECT_THAT(run("validate move.toml --signals move.toml").err, HasSubstr("--signals"));
  ASSERT_EQ(run("new gear -o gear.toml").status, 0);
  EXPECT_THAT(run("validate gear.toml --signals run.csv").err, HasSubstr("[drive]"));
  const Result piped = run("validate move.toml --signals -");
  EXPECT_THAT(piped.out, StartsWith("# jounce drive signals 1\n"));
  EXPECT_THAT(piped.err, HasSubstr("proven"));
}

/// The shell waits until the program catches the signal, then sends it.
TEST_F(Cli, SigtermKeepsTheBestSoFarAsSigintDoes) {
  std::string spec = slurp(examples + "fastest-for-motor/move.toml");
  const std::string few = "max_evaluations = 600";
  const std::size_t at = spec.find(few);
  ASSERT_NE(at, std::string::npos);
  spec.replace(at, few.size(), "max_evaluations = 1000000\ntolerance = 1e-9");
  const std::string local = "search = \"local\"";
  spec.replace(spec.find(local), local.size(), "search = \"global\"");
  write("move.toml", spec);
  for (const char* signal : {"INT", "TERM"}) {
    // SigCgt, hexadecimal: bits 1 and 14 are SIGINT and SIGTERM
    const std::string script = JOUNCE_EXE
                               " optimize move.toml -o best.toml > out.txt 2>&1 & pid=$!; "
                               "for i in $(seq 3000); do kill -0 $pid || break; grep -Eq "
                               "'SigCgt:.*[4-7c-f]..[2367abef]$' /proc/$pid/status && break; "
                               "sleep 0.01; done; sleep 1; kill -" +
                               std::string(signal) + " $pid; wait $pid; echo status $?";
    std::filesystem::remove(folder / "best.toml");
    write("stop.sh", script);
    const std::string command = "cd " + folder.string() + " && bash stop.sh";
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    std::array<char, 256> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    pclose(pipe);
    EXPECT_EQ(out, "status 0\n") << signal << ": " << slurp(folder / "out.txt");
    EXPECT_THAT(slurp(folder / "out.txt"), StartsWith("cancelled")) << signal;
    EXPECT_THAT(slurp(folder / "best.toml"), HasSubstr("kind = \"move\""));
  }
}

TEST_F(Cli, OptimizeRefusesBeforeItSearches) {
  const std::string shapes = "optimize " + examples + "residual-17hz/cam.toml";
  EXPECT_EQ(run(shapes + " --plot x.pdf").err,
            "jounce: --plot = x.pdf: must end in one of .svg, .png\n");
  EXPECT_THAT(run(shapes + " --seconds nan").err, HasSubstr("--seconds = nan"));
  EXPECT_THAT(run("optimize " + cam + " --seconds 0").err, HasSubstr("must be greater than 0"));
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Cli, OptimizeDrawsParametersBeforeAndAfter) {
  const Result done = run("optimize " + examples + "shear-line-speed/shear.toml --plot both.svg");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(slurp(folder / "both.svg"), HasSubstr("optimized"));
}

TEST_F(Cli, OptimizeAgainstADriveIsToldByIntegration) {
  const std::string against = examples + "against-drive/";
  const Result done = run("optimize " + against + "cam.toml --against " + against +
                          "drive.toml --json -o better.toml");
  ASSERT_EQ(done.status, 0) << done.err;
  const json drive = json::parse(done.out).at("drive");
  EXPECT_TRUE(drive.at("real"));
  EXPECT_EQ(drive.at("figures").at(0).at("figure"), "drive rms torque");
  EXPECT_LT(drive.at("figures").at(0).at("reached"),
            0.9 * drive.at("figures").at(0).at("given").get<double>());
  EXPECT_THAT(slurp(folder / "better.toml"), HasSubstr("hermite"));
}

TEST_F(Cli, OptimizeAgainstADriveWritesNothingWhereACeilingCannotBeKept) {
  const std::string against = examples + "against-drive/";
  write("cam.toml", slurp(against + "cam.toml") +
                        "\n[[optimize.ceiling]]\nfigure = \"drive following error\"\n"
                        "at_most = 0.001\n");
  const Result done = run("optimize cam.toml --against " + against + "drive.toml -o better.toml");
  EXPECT_EQ(done.status, 1) << done.out;
  EXPECT_THAT(done.out, HasSubstr("drive following error"));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(Cli, OptimizeAgainstADriveRefusesWhatIsNoneAndWhatLacksOne) {
  const std::string spec = examples + "against-drive/cam.toml";
  const Result none = run("optimize " + spec);
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("--against drive.toml"));
  const Result cam_as_drive = run("optimize " + spec + " --against " + spec);
  EXPECT_EQ(cam_as_drive.status, 2);
  EXPECT_THAT(cam_as_drive.err, HasSubstr("drive: is missing"));
}

TEST_F(Cli, PlotOfADriveGoesWithNothingElse) {
  for (const char* other : {"--over time", "--before x.toml"}) {
    const Result both = run("plot " + cam + " --drive response " + other + " -o x.svg");
    EXPECT_EQ(both.status, 2) << other;
    EXPECT_THAT(both.err, HasSubstr("cannot be combined with")) << other;
  }
}

TEST_F(Cli, AnOutputHasTheExtensionOfItsFormat) {
  for (const auto& [verb, name, endings] :
       {std::tuple{"design " + cam + " -o ", "o.xls", "one of .csv, .json"},
        {"optimize " + cam + " -o ", "o.csv", ".toml"},
        {"events " + cam + " -o ", "o.txt", "one of .csv, .json"},
        {"map " + cam + " -o ", "o.pdf", "one of .csv, .svg, .png"},
        {"plot " + cam + " -o ", "o.gif", "one of .svg, .png"},
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

TEST_F(Cli, DesignDoesNotKeepQuietOfWhatCheckFinds) {
  const Result broken = run("design " + cam + " -o broken.csv");
  EXPECT_EQ(broken.status, 1);  // a CI that only designs sees it; the table is written
  EXPECT_THAT(broken.out, HasSubstr("jounce check: 2 findings; the worst: geo_velocity"));
  EXPECT_THAT(run("design " + cam + " -o broken.csv --json").out, HasSubstr("\"broken\":2"));
}

TEST_F(Cli, EventsSayWhenOutputsSwitch) {
  const std::string scan = examples + "position-compare/scan.toml";
  const Result events = run("events " + scan);
  EXPECT_EQ(events.status, 0) << events.err;
  EXPECT_THAT(events.out, ::testing::StartsWith("time [s],output,on,position [mm]\n"));
  EXPECT_EQ(std::count(events.out.begin(), events.out.end(), '\n'), 23);  // 11 pulses, both edges
  EXPECT_THAT(run("events " + scan + " --json").out, HasSubstr("\"output\": \"compare\""));
  EXPECT_EQ(run("events " + scan + " -o e.csv --json").err,
            "jounce: --json: cannot be combined with .csv: end the output in .json\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "e.csv"));
  EXPECT_EQ(run("events " + scan + " -o e.json").status, 0);
  EXPECT_THAT(slurp(folder / "e.json"), StartsWith("{"));
  for (const char* both : {"laws --markdown --json", "laws quintic -o q.svg --json"})
    EXPECT_EQ(run(both).status, 2) << both;
  EXPECT_EQ(run("check " + scan).status, 0);
  EXPECT_THAT(run("events " + examples + "spring-coiler/cam.toml").err,
              HasSubstr("switch: is missing"));
}

TEST_F(Cli, EventsNamePointsThatDoNotFire) {
  std::string scan = slurp(examples + "position-compare/scan.toml");
  const std::string_view count = "count = ";
  const std::size_t at = scan.find(count);
  ASSERT_NE(at, std::string::npos);
  scan.replace(at, scan.find('\n', at) - at, "count = 100000");
  std::ofstream(folder / "scan.toml") << scan;
  const Result events = run("events scan.toml");
  EXPECT_EQ(events.status, 1);
  EXPECT_THAT(events.err, HasSubstr("compare/missed: "));
  EXPECT_THAT(events.err, HasSubstr(" of 100000 points fire"));
}

TEST_F(Cli, EventsOfASlavesOwnPositionTakeAnyLaw) {
  ASSERT_EQ(run("new cam -o cam.toml").status,
            0);  // modified sine behind a master that accelerates
  std::ofstream(folder / "cam.toml", std::ios::app)
      << "[switches]\nof = \"position\"\n"
         "[[switch]]\ntrack = 1\nfirst_on_position = 25\nlast_on_position = 40\n";
  const Result events = run("events cam.toml --json");
  ASSERT_EQ(events.status, 0) << events.err;
  const json all = json::parse(events.out)["events"];
  ASSERT_EQ(all.size(), 12U);  // on and off, up and down, in three turns
  // The rise passes its middle, 25 mm, at 60 deg, when the master, which reaches 180 deg/s at 22.5 deg
  // after 0.25 s, has run on for (60 - 22.5)/180 s.
  EXPECT_NEAR(all[0]["time"].get<double>(), 0.25 + 37.5 / 180, 1e-12);
  EXPECT_NEAR(all[0]["position"].get<double>(), 25, 1e-10);
}

json finding_of(const json& report, const std::string& rule, const std::string& quantity) {
  for (const json& f : report["findings"])
    if (f["rule"] == rule && f["quantity"] == quantity) return f;
  return {};
}

// By closed forms: at X = 0.5 * 0 + 30 = 0.4 of the first segment the quintic is at 23.68, with slope 1.792.
// So the slave rests 2 * 23.68 - 7 = 40.36 from its place, which moves on at 2 * 0.5 * 1.792 * 200 = 358.4,
// and the correction turns round by 5000.
TEST_F(Cli, CheckTellsTheRampOfAScaledCoupling) {
  write("cam.toml", slurp(cam) +
                        "\n[coupling]\nstart = \"ramp_in\"\nvelocity_diff = 150\n"
                        "acceleration = 5000\nmaster_scaling = 0.5\nmaster_offset = 30\n"
                        "slave_scaling = 2\nslave_offset = -7\n");
  const json report =
      json::parse(run("check cam.toml --json --slave 0 --master 0 --master-velocity 200").out);
  const auto peak = [&](const char* quantity) {
    return std::abs(finding_of(report, "coupling/ramp", quantity)["value"].get<double>());
  };
  EXPECT_NEAR(peak("position"), 40.36 + 358.4 * 358.4 / 2 / 5000, 1e-9);
  EXPECT_NEAR(peak("velocity"), 358.4, 1e-9);
  EXPECT_NEAR(peak("acceleration"), 5000, 1e-6);
}

TEST_F(Cli, CheckNamesAnEndThatMoves) {
  const Result gear = run("check " + examples + "pmc600-gear-in-pos/gear.toml");
  EXPECT_THAT(gear.out, HasSubstr("coupling/end"));
  EXPECT_THAT(gear.out,
              HasSubstr("at the master velocity 10000 pulse/s, the slave moves at 5000 pulse/s "
                        "there; with a live master, it stays in gear after the end of its table"));
  const std::string once =
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
      "start = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"quintic\"\n"
      "end = { master = 90, slave = 40, geo_velocity = 0.5, geo_acceleration = 0 }\n"
      "[master]\nvelocity = 180\ndistance = 90\n";
  write("once.toml", once);
  const Result cam_once = run("check once.toml");
  EXPECT_EQ(cam_once.status, 0) << "the axis brakes there";
  EXPECT_THAT(cam_once.out, Not(HasSubstr("BROKEN"))) << "one finding";
  EXPECT_THAT(cam_once.out,
              HasSubstr("at the master velocity 180 deg/s, the slave moves at 90 mm/s there; "
                        "with a live master, it brakes there"));
  EXPECT_THAT(cam_once.out, HasSubstr("warn   coupling/end"));
  write("scaled.toml", once + "[coupling]\nstart = \"absolute\"\nslave_scaling = 2\n");
  EXPECT_THAT(run("check scaled.toml").out, HasSubstr("the slave moves at 180 mm/s there"));
  EXPECT_THAT(run("check scaled.toml --master-velocity 90").out,
              HasSubstr("at the master velocity 90 deg/s, the slave moves at 90 mm/s there"));
  write("open.toml",
        "jounce = 1\nkind = \"follow\"\nunits = { master = \"pulse\", position = "
        "\"pulse\" }\nsegment = [{ master = 20000, slave = 10000 }]\n"
        "[master]\nvelocity = 50000\ndistance = 20000\n");
  const Result open = run("check open.toml");
  EXPECT_EQ(open.status, 1);
  EXPECT_THAT(open.out, HasSubstr("the slave moves at 50000 pulse/s there; the controller stops"));
  EXPECT_THAT(run("check " + cam).out, Not(HasSubstr("coupling/end"))) << "it repeats";
}

TEST_F(Cli, CheckJudgesACouplingInTheStateItIsGiven) {
  const std::string line = slurp(cam) + "\n[coupling]\nstart = \"absolute\"\n";
  std::ofstream(folder / "cam.toml") << line;
  const Result rest = run("check cam.toml --json");
  const json before = json::parse(rest.out);
  const auto broken_start = [](const json& report) {
    for (const json& f : report["findings"])
      if (f["rule"] == "coupling/start" && f["quantity"] == "position") return f;
    return json();
  };
  EXPECT_FALSE(broken_start(before)["broken"].get<bool>());
  const json moved = json::parse(run("check cam.toml --json --slave 12.5 --master 0").out);
  EXPECT_TRUE(broken_start(moved)["broken"].get<bool>());
  EXPECT_NEAR(std::abs(broken_start(moved)["value"].get<double>()), 12.5, 1e-9);
  EXPECT_TRUE(broken_start(moved)["limit"].is_null());
  const Result refused = run("check " + cam + " --slave 12.5");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--slave = 12.5: needs a spec with [coupling]"));
}

TEST_F(Cli, EventsAreThoseOfACamsSwitchesToo) {
  const std::string switched = slurp(cam) +
                               "\n[[switch]]\ntrack = 2\nfirst_on_position = 90\n"
                               "last_on_position = 180\n";
  std::ofstream(folder / "cam.toml") << switched;
  const Result events = run("events cam.toml");
  EXPECT_EQ(events.status, 0) << events.err;
  EXPECT_THAT(events.out, HasSubstr(",track 2,1,"));
  EXPECT_EQ(std::count(events.out.begin(), events.out.end(), '\n'), 7);  // three periods
}

TEST_F(Cli, MapSaysHowFastTheLineMayRunForEachCut) {
  const std::string knife = examples + "rotary-knife/knife.toml";
  const Result map = run("map " + knife + " --from 2 --to 10 --steps 9 --line-speed 60");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("\ncut_length [in],line_speed [in/s],cuts [1/min],limit\n2,"));
  EXPECT_THAT(map.out, HasSubstr("# longest without a stop: 19.8967534727353"));
  EXPECT_THAT(map.out, HasSubstr("# shortest at 20 in/s: 4.5800"));
  EXPECT_EQ(run("map " + knife + " -o map.svg").status, 0);
  EXPECT_THAT(slurp(folder / "map.svg"), HasSubstr("longest without a stop 19.8968"));
  EXPECT_THAT(run("map " + knife + " --from 5 --to 4").err,
              HasSubstr("greater than --from = 5 in"));
  EXPECT_EQ(run("map " + examples + "pmc600-cam/cam.toml").status, 2);
}

TEST_F(Cli, MapShowsWhereAKnifeWithoutADwellTurnsBack) {
  std::string knife = slurp(examples + "rotary-knife/knife.toml");
  knife.erase(knife.find("dwell = true"), 12);
  write("knife.toml", knife);
  const Result map = run("map knife.toml --from 5 --to 25 --steps 3");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("# reversal: reverses: needs dwell\n"));
  EXPECT_THAT(map.out, HasSubstr("# from 19.8967534727"));
  EXPECT_THAT(map.out, HasSubstr("\n25,,,reversal\n"));
  EXPECT_EQ(run("map knife.toml -o map.svg").status, 0);
  EXPECT_THAT(slurp(folder / "map.svg"), HasSubstr("reverses: needs dwell"));
}

TEST_F(Cli, MapAndCheckOfAShearAgree) {
  const std::string shear = examples + "flying-shear/shear.toml";
  const Result map = run("map " + shear + " --line-speed 3000 --from 500 --to 9000 --steps 3");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("# shortest at 1000 mm/s: 966.4246"));
  EXPECT_THAT(map.out, HasSubstr("\n9000,1114.37"));  // beyond the spec's line
  EXPECT_THAT(map.out, HasSubstr(",stroke\n"));
  const Result check = run("check " + shear);
  EXPECT_THAT(check.out, HasSubstr("  shortest cut         966.425 mm: at 1000 mm/s, limited by "));
  EXPECT_THAT(check.out, HasSubstr("  fastest line         1019.76 mm/s"));
  EXPECT_THAT(check.out, HasSubstr("  fastest master 1000 mm/s for this table, limited by "));
}

TEST_F(Cli, CheckSaysWhenTheMastersOwnAccelerationIsTooMuch) {
  const std::string gear = R"(jounce = 1
kind = "gear"
units = { position = "mm", master = "mm" }
gear = { numerator = 5, master_period = 100 }
limits = { slave = { acceleration = 5000 } }
)";
  write("fast.toml", gear + "master = { velocity = 500, distance = 100, acceleration = 2000 }\n");
  const Result fast = run("check fast.toml");
  EXPECT_EQ(fast.status, 1);
  EXPECT_THAT(fast.out, HasSubstr("master_acceleration 2000 mm/s^2"));
  EXPECT_THAT(fast.out, HasSubstr("lower acceleration in [master] to at most 1000"));
  EXPECT_THAT(fast.out, HasSubstr("fastest acceleration of the master 1000 mm/s^2"));
  EXPECT_THAT(fast.out, Not(HasSubstr("slow the master down")));
  const auto passing = [](const std::string& velocity, const std::string& acceleration) {
    return R"(jounce = 1
kind = "follow"
units = { position = "mm", master = "mm" }
follow = {}
zone = [{ from = 100, to = 200, ratio = 5, slave = 250 }]
point = [{ master = 300, slave = 1000 }]
limits = { slave = { acceleration = 5000 } }
master = { distance = 300, velocity = )" +
           velocity + ", acceleration = " + acceleration + " }\n";
  };
  write("both.toml", passing("500", "2000"));
  EXPECT_THAT(run("check both.toml").out,
              HasSubstr("at most 500 mm/s^2, and velocity to at most 216.345 mm/s"));
  write("advised.toml", passing("216.345", "500"));
  EXPECT_THAT(run("check advised.toml").out, Not(HasSubstr("BROKEN limit/")));
  write("good.toml", gear + "master = { velocity = 500, distance = 100, acceleration = 1000 }\n");
  EXPECT_EQ(run("check good.toml").status, 0);
}

TEST_F(Cli, PlotShowsACamOverTheTimeOfItsMaster) {
  const Result plot = run("plot " + examples + "rotary-knife/knife.toml --over time");
  EXPECT_EQ(plot.status, 0) << plot.err;
  EXPECT_THAT(plot.out, HasSubstr("time [s]"));
  EXPECT_THAT(plot.out, HasSubstr("velocity [rev/min]")) << "as the limit is given";
  EXPECT_EQ(run("plot " + examples + "googol-move/move.toml --over time").status, 2);
}

TEST_F(Cli, ACamIsShownOverTimeByEveryVerbThatMakesATable) {
  const std::string pusher = examples + "press-pusher/pusher.toml";
  const Result check = run("check " + pusher + " --over time --limit jerk=1500m/s^3");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("limit/jerk"));
  const Result design = run("design " + pusher + " --over time -o -");
  EXPECT_EQ(design.status, 0) << design.err;
  EXPECT_THAT(design.out, HasSubstr("time [s]"));
  EXPECT_EQ(
      run("convert " + pusher + " pt.csv --over time --rule linear --intervals 100 --allow-loss")
          .status,
      0);
  const Result lines = run("check pt.csv --continuity 0");
  EXPECT_EQ(lines.status, 1);
  EXPECT_THAT(lines.out, HasSubstr("limit/velocity_step"));
  EXPECT_THAT(run("design " + examples + "valve-cam/valve.toml --over time").err,
              HasSubstr("master: is missing"));
  EXPECT_THAT(run("check pt.csv --over time").err, HasSubstr("jounce: --over = time: "));
  EXPECT_THAT(run("check " + pusher + " " + cam + " --over time").err,
              HasSubstr("--over = time: applies to a single file with a motion"));
}

TEST_F(Cli, InverseFindsTheMasterOfASlave) {
  const std::string pusher = examples + "cam-algebra/last-year.toml";
  EXPECT_EQ(run("inverse " + pusher + " --slave 20mm").out,
            "60 deg (segment 1 push)\n240 deg (segment 3 return)\n");
  EXPECT_EQ(run("inverse " + pusher + " --slave 41").status, 1);
  EXPECT_EQ(json::parse(run("inverse --json " + pusher).out)["branches"].size(), 2U);
  EXPECT_EQ(run("inverse " + pusher + " --at 60 --from 1 --to 39 -o inverse.csv").status, 0);
  EXPECT_EQ(run("inverse inverse.csv --slave 60").out.substr(0, 3), "20 ");
  EXPECT_THAT(run("inverse " + pusher + " -o x.csv").err, HasSubstr("jounce: --at: is missing"));
  EXPECT_THAT(run("inverse " + pusher + " --at 60 -o x.csv").err, HasSubstr("--from = 0: "));
  EXPECT_THAT(run("inverse " + pusher + " --at 60").err, HasSubstr("--output"));
}

TEST_F(Cli, CheckNamesWhereThePmc600CamBreaksItsLimits) {
  const Result check = run("check --json " + cam);
  EXPECT_EQ(check.status, 1);
  const json report = json::parse(check.out);
  EXPECT_FALSE(report["ok"].get<bool>());
  const auto& worst = report["findings"][0];
  EXPECT_EQ(worst["rule"], "limit/geo_velocity");
  EXPECT_EQ(worst["segment"], 3);
  EXPECT_NEAR(worst["value"].get<double>(), -3.392270802, 1e-9);
  EXPECT_NEAR(worst["where"].get<double>(), 241.8976648927, 1e-9);
  EXPECT_NEAR(report["segments"][0]["geo_velocity"]["max"]["value"].get<double>(), 2.107392, 1e-12);
}

TEST_F(Cli, CheckFindsTheOvershootOfTheHmplExample) {
  const Result check = run("check --json " + examples + "hmpl-pvt/pvt.toml");
  EXPECT_EQ(check.status, 1);
  const json report = json::parse(check.out);
  int outside = 0;
  for (const auto& finding : report["findings"]) outside += finding["broken"].get<bool>() ? 1 : 0;
  EXPECT_EQ(outside, 6);
  EXPECT_NEAR(report["findings"][0]["value"].get<double>(), 596.1, 0.05);
  EXPECT_THAT(run("check " + examples + "hmpl-pvt/pvt.toml").out,
              HasSubstr("position -188.701 mm at 1.2126 s (segment 1)"));
}

TEST_F(Cli, LimitsFromTheCommandLineTakeUnits) {
  EXPECT_EQ(run("check " + cam + " --limit geo_velocity=4 --limit geo_acceleration=0.2").status, 0);
  const Result wrong = run("check " + cam + " --limit geo_velocity='4 mm'");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err,
              HasSubstr("mm is not a unit of this quantity: give the value in pulse/pulse"));
  EXPECT_EQ(run("check " + cam + " --limit velocity=4 --master-velocity 1000").status, 1);
  EXPECT_EQ(run("check " + cam + " --limit velocty=4").status, 2);
  EXPECT_EQ(run("check " + cam + " --limit geo_velocity=nan").status, 2);
}

TEST_F(Cli, ATableIsComparedWithItsSpec) {
  EXPECT_EQ(run("new cam -o feeder.toml").status, 0);
  EXPECT_EQ(run("design feeder.toml -o feeder.csv").status, 0);
  EXPECT_EQ(run("convert feeder.toml feeder.st").status, 0);
  EXPECT_EQ(run("check feeder.csv feeder.st --against feeder.toml --strict").status, 0);
  const std::string spec = slurp(folder / "feeder.toml");
  write("feeder.toml", spec + "# another text\n");
  for (const char* verb : {"check", "validate"}) {
    const Result older = run(std::string(verb) + " . --strict");
    EXPECT_EQ(older.status, 1) << verb;
    EXPECT_THAT(older.out, HasSubstr("feeder.toml has changed since the table was made"));
    EXPECT_THAT(older.out, HasSubstr("`jounce design feeder.toml -o feeder.csv`"));
  }
  EXPECT_EQ(run("check feeder.csv --against feeder.toml --strict").status, 0);
  EXPECT_EQ(run("check feeder.csv --tolerance 1e-3").err,
            "jounce: --tolerance = 1e-3: needs --baseline or --against\n");
  EXPECT_EQ(run("check feeder.csv --against feeder.csv").status, 2);
}

TEST_F(Cli, DesignPipesAndReadsBack) {
  const Result csv = run("design " + cam);
  EXPECT_EQ(csv.status, 1);
  EXPECT_THAT(csv.out, StartsWith("# jounce table 1\n"));
  EXPECT_EQ(run("design " + cam + " | " JOUNCE_EXE " check - --limit geo_velocity=4").status, 0);
  EXPECT_EQ(run("design " + cam + " -o t.csv --curve c.json").status, 1);
  EXPECT_EQ(run("design " + cam + " -o t.json").status, 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"c.json", "t.csv", "t.json"}));
  EXPECT_EQ(json::parse(slurp(folder / "c.json"))["segments"].size(), 4U);
  EXPECT_EQ(run("check t.json").status, 1) << "the limits of its spec";
}

TEST_F(Cli, BadInputLeavesNothingBehind) {
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

TEST_F(Cli, AMachineThatCannotIsThree) {
  const Result result =
      run("design " + cam + " -o /proc/t.csv");  // no program can make files there
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot write /proc/t.csv"));
}

TEST_F(Cli, AMissingFolderOfAnOutputIsTwo) {
  const Result result = run("design " + cam + " -o /nonexistent/folder/t.csv");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("the folder /nonexistent/folder does not exist"));
}

TEST_F(Cli, OptimizeWritesTheSameTextWithOtherNumbers) {
  const Result result = run("optimize --json " + cam + " -o better.toml --table better.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const json outcome = json::parse(result.out);
  EXPECT_TRUE(outcome["usable"].get<bool>());
  for (const auto& objective : outcome["objectives"]) {
    EXPECT_GE(objective["reached"].get<double>(), objective["bound"].get<double>() * (1 - 1e-12))
        << objective;
    EXPECT_LE(objective["reached"].get<double>(), objective["given"].get<double>()) << objective;
  }
  EXPECT_EQ(run("check better.toml").status, 0);
  EXPECT_EQ(run("check better.csv --limit geo_velocity=3 --limit geo_acceleration=0.15").status, 0);
  // The stretch in step, 75 to 200, is as it was.
  const std::string better = slurp(folder / "better.toml");
  EXPECT_THAT(
      better,
      HasSubstr("end = { master = 75, slave = 100, geo_velocity = 1, geo_acceleration = 0 }"));
  EXPECT_THAT(
      better,
      HasSubstr("end = { master = 200, slave = 225, geo_velocity = 1, geo_acceleration = 0 }"));
  EXPECT_THAT(better, HasSubstr("# pulse/s"));
}

TEST_F(Cli, OptimizeRejectsItsInputAsAnOutputBeforeTheSearch) {
  write("own.toml", slurp(cam));
  for (const char* option : {"-o", "--table", "--plot"}) {
    const Result result = run(std::string("optimize own.toml ") + option + " own.toml");
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_EQ(result.out, "") << option;
  }
  EXPECT_THAT(run("optimize own.toml -o own.toml").err,
              HasSubstr("--output = own.toml: is also the input"));
  EXPECT_EQ(slurp(folder / "own.toml"), slurp(cam));
}

TEST_F(Cli, WhatIsNotLimitedIsNamedBesideTheLimitsThatHold) {
  const Result better = run("optimize " + cam + " -o better.toml");
  ASSERT_EQ(better.status, 0) << better.err;
  const Result checked = run("check better.toml");
  EXPECT_THAT(checked.out, HasSubstr("all limits hold; the closest: "));
  EXPECT_THAT(checked.out, HasSubstr("; not limited: geo_jerk (up to "));
  EXPECT_THAT(run("design better.toml -o better.csv").out,
              HasSubstr("\nnot limited: geo_jerk (up to "));
  const json design = json::parse(run("design --json better.toml -o better.csv").out);
  EXPECT_EQ(design["not_limited"][0]["quantity"], "geo_jerk");
  const json report = json::parse(run("check --json better.toml").out);
  std::size_t notes = 0;
  for (const json& f : report["findings"]) notes += f["rule"] == "unlimited/geo_jerk" ? 1 : 0;
  EXPECT_EQ(notes, 1U);
  EXPECT_THAT(run("check better.toml --limit geo_jerk=1").out, Not(HasSubstr("not limited")));
  ASSERT_EQ(run("report better.toml -o better.html").status, 0);
  EXPECT_THAT(slurp(folder / "better.html"), HasSubstr("not limited"));
}

TEST_F(Cli, OptimizeSaysWhatTheOptimumCosts) {
  const Result told = run("optimize " + cam + " -o better.toml");
  EXPECT_THAT(told.out, HasSubstr("peaks                           given    optimized"));
  EXPECT_THAT(told.out, HasSubstr("not limited   pulse/pulse^3"));
  const json outcome = json::parse(run("optimize --json " + cam).out);
  ASSERT_EQ(outcome["peaks"].size(), 3U);
  const json& jerk = outcome["peaks"][2];
  EXPECT_EQ(jerk["quantity"], "geo_jerk");
  EXPECT_TRUE(jerk["limit"].is_null());
  // The same numbers as `check` has of the given and of the optimized cam.
  const auto peak = [&](const std::string& file) {
    const json report = json::parse(run("check --json " + file).out);
    for (const json& f : report["findings"])
      if (f["rule"] == "unlimited/geo_jerk") return std::abs(f["value"].get<double>());
    return 0.0;
  };
  EXPECT_EQ(jerk["given"].get<double>(), peak(cam));
  EXPECT_EQ(jerk["optimized"].get<double>(), peak("better.toml"));
}

TEST_F(Cli, CheckJudgesTheTorqueOfALoad) {
  std::string text = slurp(examples + "pusher-torque/cam.toml");
  const auto load = text.find("[limits]");
  ASSERT_NE(load, std::string::npos);
  text.insert(load, "[load.limits]\ntorque = 0.5\n\n");
  write("pusher.toml", text);
  const Result result = run("check pusher.toml");
  EXPECT_EQ(result.status, 1) << result.out;
  EXPECT_THAT(result.out, HasSubstr("BROKEN limit/load_torque"));
  EXPECT_THAT(result.out, HasSubstr(" N m at "));
}

TEST_F(Cli, CheckNamesTheErrorByWhichHimcRefusesATable) {
  write("pvt.toml",
        "jounce = 1\nkind = \"pvt\"\ncontroller = \"himc\"\nunits = { position = \"mm\", time = "
        "\"s\" }\n"
        "knot = [{time = 0, position = 0, velocity = 0}, {time = 1, position = 10, velocity = 0}]\n"
        "[limits]\nvelocity = 12\nacceleration = 50\n");
  const Result result = run("check pvt.toml");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("MovePVT refuses the table: HIMC error 0x83aa08a2"));
  EXPECT_THAT(result.out, HasSubstr("MovePVT refuses the table: HIMC error 0x83aa08ac"));
}

TEST_F(Cli, OptimizeSaysWhatIsInfeasibleAndWritesNothing) {
  std::string text = slurp(cam);
  text.replace(text.find("geo_velocity = 3\n"), 17, "geo_velocity = 1\n");
  write("tight.toml", text);
  const Result result = run("optimize tight.toml -o out.toml --table out.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_THAT(result.out, HasSubstr("limit/geo_velocity"));
  EXPECT_EQ(files(), std::vector<std::string>{"tight.toml"});
}

/// A cam with one free shape between two dwells.
constexpr const char* free_cam = R"(jounce = 1
kind = "cam"
name = "lift"   # a comment
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
name = "up"
law = "4567"   # the law it was
free = { shape = 20 }
end = { master = 120, slave = 50 }
[[segment]]
law = "dwell"
end = { master = 200, slave = 50 }
[[segment]]
law = "4567"
end = { master = 320, slave = 0 }
[[segment]]
law = "dwell"
end = { master = 360, slave = 0 }
[master]
velocity = 360
distance = 360
[load]
position_per_rev = 100
inertia = "2 kg cm^2"
[limits]
geo_velocity = 0.92
[optimize]
minimize = ["peak torque"]
)";

TEST_F(Cli, OptimizeFindsAShapeThatDesignMakesAgain) {
  write("cam.toml", free_cam);
  const Result result =
      run("optimize --json cam.toml -o better.toml --table better.csv --plot better.svg");
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  const json outcome = json::parse(result.out);
  EXPECT_TRUE(outcome["usable"].get<bool>());
  const json& figure = outcome["runs"][0]["figures"][0];
  EXPECT_EQ(figure["figure"], "peak torque");
  EXPECT_EQ(figure["unit"], "N m");
  EXPECT_LT(figure["reached"].get<double>(), 0.65 * figure["given"].get<double>());
  EXPECT_EQ(files(),
            (std::vector<std::string>{"better.csv", "better.svg", "better.toml", "cam.toml"}));
  const std::string better = slurp(folder / "better.toml");
  EXPECT_THAT(better, HasSubstr("name = \"lift\"   # a comment\n"));
  EXPECT_THAT(better, HasSubstr("law = \"hermite\"   # the law it was\n"));
  // The design from it has the promised peak: J a with a of the exact curve.
  const json check = json::parse(run("check --json better.toml").out);
  EXPECT_EQ(run("check better.toml").status, 0);
  const Result again = run("optimize --json better.toml");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NEAR(json::parse(again.out)["runs"][0]["figures"][0]["given"].get<double>(),
              figure["reached"].get<double>(), 1e-9 * figure["reached"].get<double>());
  EXPECT_THAT(slurp(folder / "better.svg"), HasSubstr("torque [N m]"));
}

TEST_F(Cli, OptimizeSaysWhatLimitsAShape) {
  write("cam.toml", free_cam);
  const Result result = run("optimize cam.toml");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("peak torque"));
  EXPECT_THAT(result.out, HasSubstr("segments 1 up"));
  EXPECT_THAT(result.out, HasSubstr("peak torque is attained at "));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(Cli, OptimizeWritesNothingForAShapeThatCannotBe) {
  std::string text = free_cam;
  text.replace(text.find("0.92"), 4, "0.4 ");
  write("cam.toml", text);
  const Result result = run("optimize cam.toml -o better.toml --plot better.svg");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_THAT(result.out, HasSubstr("geo_velocity"));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(Cli, OptimizeChoosesNumbersOfAnySpec) {
  const std::string shear = examples + "shear-line-speed/shear.toml";
  const Result result = run("optimize --json " + shear + " -o faster.toml --table faster.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const json outcome = json::parse(result.out);
  EXPECT_EQ(outcome["status"], "converged");
  EXPECT_EQ(outcome["maximize"], "master velocity");
  EXPECT_NEAR(outcome["figures"][0]["reached"].get<double>(), 1019.76, 0.01);
  EXPECT_EQ(outcome["parameters"][0]["unit"], "m/min");
  EXPECT_EQ(run("check faster.toml").status, 0);
  EXPECT_EQ(run("check faster.csv").status, 0);
  const Result piped = run("optimize " + shear + " -o -");
  EXPECT_THAT(piped.out, HasSubstr("line_speed = \"61.18"));
  EXPECT_THAT(piped.err, StartsWith("converged"));
}

TEST_F(Cli, OptimizeOfNumbersWritesNothingWhereNothingHolds) {
  std::string text = slurp(examples + "shear-line-speed/shear.toml");
  write("tight.toml", text + "\n[[optimize.require]]\nfigure = \"stroke\"\nat_most = 1\n");
  const Result result = run("optimize tight.toml -o out.toml --table out.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_EQ(files(), std::vector<std::string>{"tight.toml"});
  EXPECT_THAT(run("optimize tight.toml --seconds 0").err,
              HasSubstr("--seconds = 0: must be greater than 0"));
  EXPECT_EQ(run("optimize tight.toml --seconds nan").status, 2);
}

TEST_F(Cli, ValidateProvesAndFindsALie) {
  const Result good = run("validate --json " + cam);
  EXPECT_EQ(good.status, 0);
  const json proof = json::parse(good.out);
  EXPECT_LE(proof["witness"]["curve"]["position"].get<double>(), 1e-10);
  EXPECT_GT(
      proof["drive"]["peak_torque"].get<double>() * proof["drive"]["peak_torque"].get<double>(), 0);

  std::string text = slurp(cam);
  text.replace(text.find("following_error = 1"), 19, "following_error = 0.001");
  write("tight.toml", text);
  EXPECT_EQ(run("validate tight.toml").status, 1);
}

TEST_F(Cli, PlotAndReportMakeWhatTheyName) {
  EXPECT_EQ(run("plot " + cam + " -o cam.svg").status, 0);
  EXPECT_EQ(run("plot " + cam + " -o cam.png").status, 0);
  EXPECT_EQ(run("report " + cam + " -o cam.html").status, 1)
      << "this cam breaks its limits, and the page reports it";
  EXPECT_EQ(files(), (std::vector<std::string>{"cam.html", "cam.png", "cam.svg"}));
  EXPECT_THAT(slurp(folder / "cam.svg"), HasSubstr("3.39227"));
  EXPECT_THAT(slurp(folder / "cam.png"), StartsWith("\x89PNG"));
  const std::string page = slurp(folder / "cam.html");
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy"));
  EXPECT_THAT(page,
              HasSubstr("<script type=\"application/json\">"));  // its own: report_security.py
}

// A full disk behind `> file` was exit status 0, with half of the text or none.
TEST_F(Cli, TextThatCannotBeWrittenIsAFault) {
  for (const char* verb : {"check ", "check --json ", "validate ", "diff "}) {
    const std::string file = verb == std::string("diff ") ? cam + " " + cam : cam;
    const Result full = run(verb + file + " > /dev/full");
    EXPECT_EQ(full.status, 3) << verb;
    EXPECT_THAT(full.err, HasSubstr("No space left on device")) << verb;
  }
}

TEST_F(Cli, AClosedStandardOutputDiscards) {
  EXPECT_EQ(run("design " + cam + " -o table.csv >&-").status, 1);
  const std::string table = slurp(folder / "table.csv");
  EXPECT_THAT(table, StartsWith("# jounce table 1\n"));
  EXPECT_THAT(table, Not(HasSubstr("certified")));
}

TEST_F(Cli, AMissingRendererIsAFaultOfTheMachineThatNamesIt) {
  const Result result =
      run("laws > /dev/null; PATH=/nowhere " JOUNCE_EXE " plot " + cam + " -o cam.png");
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(
      result.err,
      StartsWith(
          "jounce: needs rsvg-convert (Debian: librsvg2-bin); write .svg instead, or install it"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Cli, NoFileThatASpecNamesIsReplaced) {
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

TEST_F(Cli, NoFileThatAnInputNamesIsReplaced) {
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

TEST_F(Cli, NoFileOfAMachineIsReplaced) {
  for (const char* name : {"gantry", "cut-plan"})
    std::filesystem::copy(examples + name, folder / name);
  for (const auto& [machine, file] : {std::pair{"gantry", "y1.toml"},
                                      {"gantry", "part.toml"},
                                      {"gantry", "part.ngc"},
                                      {"cut-plan", "drum.toml"},
                                      {"cut-plan", "knife.toml"},
                                      {"cut-plan", "line.toml"}}) {
    const std::string path = std::string(machine) + "/" + file;
    const std::string before = slurp(folder / path);
    const Result result =
        run("run " + std::string(machine) + "/machine.toml --seconds 0.1 --record " + path);
    EXPECT_EQ(result.status, 2) << path;
    EXPECT_THAT(result.err, HasSubstr(path + ": is also an input")) << path;
    EXPECT_EQ(slurp(folder / path), before) << path;
  }
}

TEST_F(Cli, AReportSaysWhatItFoundAndIsAPageOfHtml) {
  const Result page = run("report " + cam + " -o page.html");
  EXPECT_EQ(page.status, 1);
  EXPECT_THAT(page.out, HasSubstr("PMC600 Fig. 6.14: 2 findings; the worst: geo_velocity"));
  const Result pdf = run("report " + cam + " -o page.pdf");
  EXPECT_EQ(pdf.status, 2);
  EXPECT_EQ(pdf.err, "jounce: --output = page.pdf: must end in one of .html, .htm\n");
  std::filesystem::create_directory(folder / "folder");
  EXPECT_EQ(run("report folder -o other.html").err,
            "jounce: folder: cannot be read: Is a directory\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "page.pdf"));
}

TEST_F(Cli, AnEmptyArgumentIsNoMissingOne) {
  const Result result = run("convert " + cam + " out.csv --tolerance \"\"");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, "jounce: --tolerance: is empty: write a value\n");
  EXPECT_TRUE(files().empty());
}

TEST_F(Cli, AToleranceBelowTheRoundingIsRefused) {
  const std::string convert = "convert " + cam + " out.csv ";
  EXPECT_EQ(run(convert + "--tolerance 1e-30").err,
            "jounce: --tolerance = 1e-30 pulse: must be at least 5.55948e-12 pulse: rounding hides "
            "smaller errors\n");
  EXPECT_THAT(run(convert + "--velocity-tolerance 1e-30").err,
              HasSubstr("--velocity-tolerance = 1e-30 pulse/pulse: must be at least "));
  EXPECT_EQ(run(convert + "--tolerance -1").err,
            "jounce: --tolerance = -1: must be greater than 0\n");
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(run(convert + "--tolerance 5.559478149432e-12").status, 0);
}

TEST_F(Cli, AUnitOfConvertIsRefusedByTheNameOfItsOption) {
  ASSERT_EQ(run("design " + cam + " -o given.csv").status, 1);
  EXPECT_EQ(run("convert given.csv out.csv --master-unit J").err,
            "jounce: --master-unit = J: cannot be converted from the unit of the table, pulse\n");
  EXPECT_EQ(
      run("convert given.csv out.csv --position-unit wibble").err,
      "jounce: --position-unit = wibble: is not a known unit: give a length (mm m um cm in), an "
      "angle (rad deg rev), a time (s ms us ns min h), or pulse, count or inc\n");
  EXPECT_EQ(run("convert given.csv given.csv").err,
            "jounce: OUT = given.csv: is also the input: choose another name\n");
}

TEST_F(Cli, AFileOfAnotherVerbIsSentThere) {
  write("a.toml", "jounce = 1\nkind = \"machine\"\n");
  EXPECT_THAT(
      run("plot a.toml -o a.svg").err,
      HasSubstr("a.toml:2:8: kind = \"machine\": is a machine: run it alone, with `jounce run`"));
  write("a.toml", "jounce = 1\nkind = \"sweep\"\n");
  EXPECT_THAT(run("plot a.toml -o a.svg").err,
              HasSubstr("a.toml:2:8: kind = \"sweep\": is a sweep: start it with `jounce sweep`"));
}

TEST_F(Cli, AnEnergyIsNoPosition) {
  ASSERT_EQ(run("new move -o move.toml").status, 0);
  std::string text = slurp(folder / "move.toml");
  const auto at = text.find("position = \"");
  text.replace(at, text.find('"', at + 12) + 1 - at, "position = \"J\"");
  write("move.toml", text);
  EXPECT_THAT(run("check move.toml").err,
              HasSubstr("units.position = \"J\": is not a unit of position"));
}

const std::string via = examples + "generators/08-via.toml";

TEST_F(Cli, DesignWritesATableForEachAxis) {
  const Result all = run("design " + via + " -o via.csv --curve via.curve.json");
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_THAT(all.out, StartsWith("via points x: "));
  EXPECT_THAT(all.out, HasSubstr("\nvia points y: "));
  EXPECT_EQ(files(), (std::vector<std::string>{"via-x.csv", "via-y.csv", "via.curve-x.json",
                                               "via.curve-y.json"}));
  EXPECT_THAT(slurp(folder / "via-x.csv"), HasSubstr("4000"));
  EXPECT_EQ(run("check via-y.csv").status, 0);
  EXPECT_EQ(run("design " + via + " -o ./no_suffix").status, 0);
  EXPECT_THAT(files(), ::testing::Contains("no_suffix-y"));

  const json summary = json::parse(run("design --json " + via + " -o via.csv").out);
  EXPECT_EQ(summary["axes"]["y"]["table"], "via-y.csv");
  EXPECT_FALSE(summary.contains("ok"));

  const Result one = run("design " + via + " --axis y");
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(one.out, slurp(folder / "via-y.csv"));
}

TEST_F(Cli, NeverShowsTheKeyOfAFileWithAWrongName) {
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

TEST_F(Cli, AnOptionThatHasNoEffectIsRejected) {
  ASSERT_EQ(run("new move -o move.toml").status, 0);
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  EXPECT_THAT(run("plot move.toml --over master -o x.svg").err,
              HasSubstr("is over time, without a master: leave out --over"));
  EXPECT_THAT(run("convert " + cam + " y.scl --rule linear").err,
              HasSubstr("--rule = linear: applies to csv, json, lcm-log and mcap only"));
  EXPECT_THAT(run("check drive.toml --limit foo=3").err,
              HasSubstr("--limit = foo=3: applies to a motion, but this file has none"));
  EXPECT_THAT(run("events " + cam).err, HasSubstr("switch: is missing: add [[switch]]"));
  EXPECT_THAT(run("events move.toml").err, HasSubstr("compare: is missing: add [compare]"));
  EXPECT_THAT(run("check " + cam + " --limit geo_acceleration=-1").err,
              HasSubstr("--limit geo_acceleration = -1"));
  EXPECT_THAT(run("design " + cam + " -o a.csv -o b.csv").err,
              HasSubstr("--output is given twice"));
}

TEST_F(Cli, SeveralAxesWithOneFileAreRefusedWithAWayOut) {
  const Result piped = run("design " + via);
  EXPECT_EQ(piped.status, 2);
  EXPECT_EQ(piped.err,
            "jounce: --output: is missing: with several axes, each needs a file. -o a.csv writes "
            "a-x.csv and so on; --axis x writes one axis only\n");
  EXPECT_EQ(piped.out, "");
  const Result other = run("design --axis z " + via);
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err, "jounce: --axis = z: must be one of x, y\n");
  EXPECT_EQ(
      run("check " + cam + " --axis x").err,
      "jounce: --axis = x: " + cam + " has only one axis, without a name: leave out --axis\n");
  const Result streamed = run("stream --to feeder --url memq:// " + via);
  EXPECT_EQ(streamed.status, 2);
  EXPECT_EQ(streamed.err,
            "jounce: --axis: is missing: " + via + " has several axes. Choose one of x, y\n");
  EXPECT_EQ(run("report " + via + " -o both.html").status, 0);
  EXPECT_EQ(run("report --axis x " + via + " -o x.html").status, 0);
  EXPECT_EQ(run("plot " + via + " --before " + via).status, 2);
  EXPECT_EQ(run("plot --axis x " + via + " --before " + via).status, 0);
  EXPECT_EQ(run("validate " + via + " --log x.csv").status, 2);
}

TEST_F(Cli, CheckAndValidateTakeEveryAxis) {
  const Result text = run("check " + via);
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, StartsWith("via points x: all limits hold"));
  EXPECT_THAT(text.out, HasSubstr("\nvia points y: all limits hold"));
  const json all = json::parse(run("check --json " + via).out);
  EXPECT_TRUE(all["ok"].get<bool>());
  EXPECT_EQ(all["axes"]["x"]["segments"].size(), 19U);
  EXPECT_TRUE(all["axes"]["y"]["ok"].get<bool>());
  const json x = json::parse(run("check --axis x --json " + via).out);
  EXPECT_EQ(x, all["axes"]["x"]);
  EXPECT_TRUE(json::parse(run("validate --json " + via).out)["axes"]["y"]["ok"].get<bool>());

  std::string spec = slurp(via);
  spec.replace(spec.rfind("limits = { velocity = 1000"), 26, "limits = { velocity = 900");
  write("tight.toml", spec);
  EXPECT_EQ(run("check tight.toml").status, 1) << "y alone is over its limit";
  EXPECT_EQ(run("check tight.toml --axis x").status, 0);
  EXPECT_FALSE(json::parse(run("check tight.toml --json").out)["ok"].get<bool>());
}

TEST_F(Cli, EachAxisHasADriveOfItsOwn) {
  const std::string spec =
      "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
      "[[axis]]\nname = \"x\"\nto = 30\nvelocity = 100\nacceleration = 1000\njerk = 20000\n"
      "[axis.drive]\nmodel = \"servo_400w\"\nposition_per_rev = 10\n"
      "[[axis]]\nname = \"y\"\nto = 30\nvelocity = 100\nacceleration = 1000\n";
  write("gantry.toml", spec);
  const json proof = json::parse(run("validate --json gantry.toml").out)["axes"];
  EXPECT_GT(proof["x"]["drive"]["peak_torque"].get<double>(), 0);
  EXPECT_FALSE(proof["y"].contains("drive"));
  write("wrong.toml", std::string(spec).replace(spec.find("rev = 10"), 8, "rev = -1"));
  EXPECT_EQ(run("validate wrong.toml").err,
            "jounce: wrong.toml:12:20: axis[1].drive.position_per_rev = -1 mm/rev: must be greater "
            "than 0\n");
}

TEST_F(Cli, PlotDrawsAllAxesOfOneUnit) {
  const Result all = run("plot " + via);
  EXPECT_EQ(all.status, 0);
  EXPECT_THAT(all.out, HasSubstr(">x</text>"));
  EXPECT_THAT(all.out, HasSubstr(">y</text>"));
  std::string spec = slurp(via);
  spec.replace(spec.find("name = \"y\""), 10, "name = \"y\"\nunit = \"deg\"");
  write("mixed.toml", spec);
  EXPECT_EQ(run("plot mixed.toml").err,
            "jounce: --axis: is missing: x and y have different units, so one picture cannot show "
            "both. Choose one\n");
  EXPECT_THAT(run("plot mixed.toml --axis y").out, HasSubstr("deg"));
}

TEST_F(Cli, DesignSaysWhatIsLeftSwinging) {
  const std::string spec = examples + "generators/21-shaper.toml";
  EXPECT_THAT(run("design " + spec + " -o t.csv").out,
              HasSubstr("; without the operators 8.84401 mm\n"));
  const json residual = json::parse(run("design --json " + spec + " -o t.csv").out)["residuals"][0];
  EXPECT_EQ(residual["frequency"], 5.5);
  EXPECT_NEAR(residual["before"].get<double>(), 8.84401, 1e-5);
  EXPECT_LT(residual["after"].get<double>(), 1e-10);
}

TEST_F(Cli, WhatOnlyRoundingOfKnotsBreaksIsNotFound) {
  // The shortest phases of this motion last 3.5 us, at 2000 mm: there the jerk of a table of doubles
  // is off by more than the limit itself, the curve's is not.
  EXPECT_EQ(run("check " + via).status, 0);
  // A limit that the table breaks by more is still found.
  write("coarse.toml",
        "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
        "profile = \"s_curve\"\nto = 300\nvelocity = 400\nacceleration = 2000\njerk = 20000\n"
        "[limits]\njerk = 20000\n[table]\nrule = \"cubic_hermite\"\nintervals = 10\n");
  const Result coarse = run("check coarse.toml");
  EXPECT_EQ(coarse.status, 1);
  EXPECT_THAT(coarse.out, HasSubstr("table"));
}

TEST_F(Cli, WithoutANetworkTheStreamSaysWhatItNeeds) {
  // memq:// reaches only this process.
  const Result result = run("stream " + cam + " --to feeder --url memq:// --patience 8");
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.err, HasSubstr("no answer from"));
  EXPECT_EQ(run("stream " + cam + " --to feeder --url ''").status, 2);
  EXPECT_EQ(run("run " + cam + " --url memq:// --seconds 0.1").status, 2) << "a cam is no axis";
}

TEST_F(Cli, DiffSaysWhatChangedAndAnswersLikeDiff) {
  EXPECT_EQ(run("diff " + cam + " " + cam).status, 0);
  std::string text = slurp(cam);
  text.replace(text.find("slave = 100, geo_velocity = 0.01739"), 11, "slave = 95 ");
  write("b.toml", text);
  const Result changed = run("diff " + cam + " b.toml -o both.svg");
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.out, HasSubstr("! position          differs by -5 pulse at 280 pulse"));
  EXPECT_THAT(changed.out,
              HasSubstr("~ knot 4 (end of 3 return) at 280 pulse, position 100 -> 95"));
  EXPECT_THAT(slurp(folder / "both.svg"), StartsWith("<svg"));
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance position=\"5 pulse\"").status, 0);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance position=4.9").status, 1);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance 1").status, 0);
  const Result documents = run("diff --json " + cam + " b.toml");
  EXPECT_EQ(documents.status, 1);
  const json report = json::parse(documents.out);
  EXPECT_FALSE(report["equal"].get<bool>());
  EXPECT_NEAR(report["changes"]["position"]["largest"]["value"].get<double>(), -5, 1e-12);
  EXPECT_EQ(report["knots"][0]["what"], "changed");
  EXPECT_EQ(run("diff " + cam + " nothing.toml").status, 2);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance speed=1").status, 2);
  EXPECT_EQ(run("diff " + cam + " b.toml -o both.gif").status, 2);
}

TEST_F(Cli, DiffOfSeveralAxesPairsThemByName) {
  EXPECT_EQ(run("new axes -o a.toml").status, 0);
  EXPECT_EQ(run("diff a.toml a.toml").status, 0);
  const json report = json::parse(run("diff --json a.toml a.toml").out);
  EXPECT_TRUE(report["equal"].get<bool>());
  EXPECT_GE(report["axes"].size(), 2U);
  EXPECT_EQ(run("diff a.toml " + cam).status, 2);
}

TEST_F(Cli, ConvertsThereAndBackWithoutLoss) {
  EXPECT_EQ(run("design " + cam + " -o a.csv").status, 1);
  EXPECT_EQ(run("convert a.csv a.xyva").status, 0);
  EXPECT_EQ(run("convert a.xyva a.st").status, 0);
  EXPECT_EQ(run("convert a.st b.csv").status, 0);
  const auto hash = [&](const char* file) {
    const std::string text = slurp(folder / file);
    return text.substr(text.find("# sha256: "), 74);
  };
  EXPECT_EQ(hash("a.csv"), hash("b.csv"));
  EXPECT_EQ(run("diff a.csv a.st").status, 0);
  EXPECT_EQ(run("plot a.xyva -o a.svg").status, 0);
}

TEST_F(Cli, ConvertStatesItsLoss) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);
  const Result pairs = run("convert a.toml a.txt --intervals 360 --json");
  EXPECT_EQ(pairs.status, 0) << pairs.err;
  const json summary = json::parse(pairs.out);
  EXPECT_FALSE(summary["lossless"].get<bool>());
  EXPECT_NEAR(summary["error"].get<double>(), 0.0024, 1e-4);  // h^2 max|f''| / 8 = 0.0191943 / 8
  const Result coarse = run("convert a.toml c.txt --intervals 6");
  EXPECT_EQ(coarse.status, 1);
  EXPECT_THAT(coarse.out, HasSubstr("nothing was written: give more --intervals"));
  EXPECT_FALSE(std::filesystem::exists(folder / "c.txt"));
  EXPECT_EQ(run("convert a.toml c.txt --intervals 6 --allow-loss").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "c.txt"));
  EXPECT_EQ(run("convert a.toml d.txt").status, 0) << "the knots follow from the tolerance";
  EXPECT_EQ(
      run("convert a.toml c.bas").err,
      "jounce: --position-resolution: is missing: the format trio has the position in counts. "
      "Give the size of one count, such as 0.001mm\n");
  const std::string both = run("convert a.toml c.dmc").err;
  EXPECT_THAT(both, HasSubstr("jounce: --resolution: is missing"));
  EXPECT_THAT(both, HasSubstr("\njounce: --position-resolution: is missing"));
  EXPECT_EQ(run("convert a.toml c.bas --position-resolution 1um").status, 0);
  EXPECT_THAT(run("convert a.toml c.csv --tolerance 1 um").err,
              HasSubstr("`1 um` is one value: write it without a space"));
  EXPECT_THAT(run("convert a.toml e.csv --most 5 --tolerance 1um").err,
              HasSubstr("--most = 5: must be at least "));
  EXPECT_EQ(run("convert a.toml b.xyva --tolerance 0.1um").status, 0);
  const Result close = run("diff a.toml b.xyva --tolerance position=0.1um");
  EXPECT_EQ(close.status, 0) << close.out;
}

TEST_F(Cli, ConvertNamesWhatStaysBehind) {
  write("c.toml", slurp(cam) +
                      "\n[coupling]\nstart = \"absolute\"\n[[switch]]\ntrack = 1\n"
                      "first_on_position = 25\nlast_on_position = 40\n");
  EXPECT_THAT(run("convert c.toml c.st").out,
              HasSubstr("laws, limits, the coupling and 1 cam switch stay in the spec"));
  EXPECT_THAT(run("convert " + cam + " c.st").out, HasSubstr("laws and limits stay in the spec"));
  write("t.st",
        "E_A : ARRAY[0..1] OF SMC_CAMXYVA := [(dX := 0), (dX := 360, dY := 40)];\n"
        "E : MC_CAM_REF := (nTappets := 3, pce := ADR(E_A));\n");
  EXPECT_THAT(run("convert t.st t.xyva").out, HasSubstr("3 tappets of E are not read"));
}

// KAS joins points of the type SPLINE by curves: the error is theirs, and CYCLIC is in the file.
TEST_F(Cli, ConvertJudgesSplinesAsSplines) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);
  const json lines = json::parse(run("convert a.toml a.txt --intervals 360 --json").out);
  const Result made = run("convert a.toml a.csv --to kollmorgen --intervals 360 --json");
  const json splines = json::parse(made.out);
  EXPECT_LT(splines["error"].get<double>(), lines["error"].get<double>() / 100);
  EXPECT_THAT(slurp(folder / "a.csv"), StartsWith("CYCLIC;YES;"));
  EXPECT_THAT(splines["losses"].dump(), HasSubstr("cubic spline"));
  EXPECT_THAT(splines["losses"].dump(), Not(HasSubstr("that the cam repeats")));
  EXPECT_THAT(lines["losses"].dump(), HasSubstr("that the cam repeats"));
  const json knots =
      json::parse(run("convert a.toml b.csv --to kollmorgen --intervals 6 --json").out);
  EXPECT_GT(knots["error"].get<double>(), 1e3 * splines["error"].get<double>());
}

TEST_F(Cli, TakesOneOfTheCamsOfADeclaration) {
  for (const char* name : {"A", "B"}) {
    EXPECT_EQ(run("design " + cam + " -o " + name + ".csv").status, 1);
    EXPECT_EQ(run(std::string("convert ") + name + ".csv " + name + ".st").status, 0);
  }
  std::string both = slurp(folder / "A.st") + slurp(folder / "B.st");
  both.replace(both.rfind("  Cam : "), 7, "  Other :");
  write("both.st", both);
  const Result asked = run("convert both.st c.xyva");
  EXPECT_EQ(asked.status, 2);
  EXPECT_EQ(asked.err,
            "jounce: --axis: is missing: both.st has several axes. Choose one of Cam, Other\n");
  write("same.st", slurp(folder / "A.st") + slurp(folder / "B.st"));
  EXPECT_EQ(run("convert same.st c.xyva --axis Cam").err,
            "jounce: --axis = Cam: is the name of 2 cams in same.st: rename one of them\n");
  EXPECT_EQ(run("convert both.st c.xyva --axis Other").status, 0);
  EXPECT_EQ(run("diff c.xyva A.csv").status, 0);
  EXPECT_EQ(run("check both.st").status, 0);
  EXPECT_EQ(run("plot both.st -o both.svg").status, 0);
}

// Input for a controller: whole ms, no step of the velocity, and the same motion when it is read
// again.
TEST_F(Cli, ConvertWritesTheSegmentsOfAController) {
  write("m.toml",
        "jounce = 1\nkind = \"move\"\nunits = { position = \"pulse\", time = \"ms\" }\n[move]\n"
        "profile = \"s_curve\"\nto = 20000\nvelocity = 50\nacceleration = 0.25\njerk = 0.002\n");
  const Result even =
      run("convert m.toml even.csv --rule linear --most 33 --resolution 1ms --json");
  const Result made = run("convert m.toml p.csv --to points --controller googol_pt --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const double error = json::parse(made.out)["error"].get<double>();
  EXPECT_LT(10 * error, json::parse(even.out)["error"].get<double>());
  const std::string points = slurp(folder / "p.csv");
  EXPECT_THAT(points, StartsWith("time [ms],position [pulse],type\n"));
  EXPECT_LE(std::count(points.begin(), points.end(), '\n'), 33);
  EXPECT_THAT(points, HasSubstr(",20000,normal\n"));
  write("p.toml",
        "jounce = 1\nkind = \"pt\"\nunits = { position = \"pulse\", time = \"ms\" }\n"
        "points = \"p.csv\"\n[pt]\ncontroller = \"googol\"\n");
  const Result played = run("check p.toml --continuity 1");
  EXPECT_EQ(played.status, 0) << played.out << played.err;
  EXPECT_THAT(played.out, Not(HasSubstr("pt/velocity_step")));
  EXPECT_EQ(run("diff p.toml m.toml --tolerance position=" + std::to_string(1.01 * error) + "pulse")
                .status,
            0);
  EXPECT_EQ(run("convert p.csv x.csv --controller googol_pt").status, 2);
  const Result refused =
      run("convert m.toml q.csv --controller googol_pt --position-resolution 1pulse");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("--position-resolution = 1 pulse: cannot be used with quadratic pieces"));
  EXPECT_THAT(run("convert m.toml q.csv --to points --rule cubic_hermite").err,
              HasSubstr("needs a constant acceleration between the knots; before knot 2"));
}

// A law that begins at rest has 1.9e-16 there: its first segment was "continue", which takes over a ratio.
TEST_F(Cli, ConvertTakesRoundingForRest) {
  write("f.toml",
        "jounce = 1\nkind = \"cam\"\nunits = { master = \"pulse\", position = \"pulse\" }\n"
        "start = { master = 0, slave = 0 }\n"
        "segment = [{ law = \"simple_sine\", end = { master = 10000, slave = 20000 } }]\n");
  ASSERT_EQ(run("convert f.toml f.csv --to points --controller googol_follow").status, 0);
  const std::string points = slurp(folder / "f.csv");
  EXPECT_THAT(points, StartsWith("master [pulse],slave [pulse],type\n"));
  EXPECT_THAT(points, Not(HasSubstr("continue")));
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 17);
}

// The closest of no limits was an error of 1e-13 of the witness.
TEST_F(Cli, AReportWithoutLimitsSaysSo) {
  write("f.toml",
        "jounce = 1\nkind = \"cam\"\nunits = { master = \"pulse\", position = \"pulse\" }\n"
        "start = { master = 0, slave = 0 }\n"
        "segment = [{ law = \"345\", end = { master = 10000, slave = 20000 } }]\n");
  const Result report = run("report f.toml -o f.html");
  EXPECT_EQ(report.status, 0);
  EXPECT_THAT(report.out, StartsWith("f.toml: no limits are given; the curve is continuous"));
}

TEST_F(Cli, ConvertSaysWhatToDoWithPulses) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);  // deg and mm
  const Result position = run("convert a.toml a.csv --most 32 --position-resolution 1pulse");
  EXPECT_EQ(position.status, 2);
  EXPECT_THAT(position.err, HasSubstr("give the size of a pulse, such as --position-resolution "
                                      "\"0.001 mm\""));
  const Result controller = run("convert a.toml a.csv --controller googol_follow");
  EXPECT_EQ(controller.status, 2);
  EXPECT_THAT(controller.err, HasSubstr("give the size of one count with --resolution"));
  EXPECT_EQ(run("convert a.toml a.csv --controller googol_follow --resolution 0.01deg").status, 0);
}

TEST_F(Cli, PointsAreToldFromSpecs) {
  write("p.csv", "time [s];position [mm]\n0;0\n1;2,5\n");
  for (const char* command : {"convert p.csv x.csv", "check p.csv"}) {
    const Result refused = run(command);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("has points only, without the header of a Jounce table"));
    EXPECT_THAT(refused.err, HasSubstr("points = \"p.csv\""));
  }
}

TEST_F(Cli, ConvertAsksForTheUnitsThatAFileDoesNotHave) {
  write("a.xyva", "0 0 0 0\n180 90 0 0\n360 0 0 0\n");
  const Result refused = run("convert a.xyva a.csv");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--master-unit"));
  EXPECT_EQ(run("design a.xyva -o a.csv").status, 2) << "what it wrote could not be read";
  EXPECT_EQ(run("convert a.xyva a.csv --master-unit deg --position-unit mm --periodic").status, 0);
  EXPECT_THAT(slurp(folder / "a.csv"), HasSubstr("# outside: wrap"));
  const std::string rotary = examples + "codesys-default/cam.xyva";
  EXPECT_EQ(
      run("convert " + rotary + " r.csv --master-unit deg --position-unit deg --periodic").status,
      0);
  EXPECT_THAT(slurp(folder / "r.csv"), HasSubstr("# outside: advance"));
  EXPECT_EQ(run("convert a.csv b.csv --position-unit m").status, 0);
  EXPECT_THAT(slurp(folder / "b.csv"), HasSubstr("180,0.09,0,0"));
  write("comma.txt", "0;0\n1;0,5\n");
  EXPECT_EQ(run("check comma.txt").status, 2);
  EXPECT_EQ(
      run("convert comma.txt c.csv --decimal-comma --master-unit deg --position-unit mm").status,
      0);
}

TEST_F(Cli, CheckTellsWhatACamIsWorthAndHowFastItsMasterMayRun) {
  const std::string text = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [{ law = "345", end = { master = 120, slave = 50 } }]
limits = { slave = { velocity = 400, acceleration = 6000 } }
)";
  write("cam.toml", text);
  const Result good = run("check cam.toml");
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_THAT(good.out, HasSubstr("rise 0 .. 120 deg    velocity Cv 1.875, acceleration Ca 5.7735, "
                                  "jerk Cj 60, torque Cm 6.6943; with this Cj, Ca can be as low as "
                                  "4.753"));
  EXPECT_THAT(good.out,
              HasSubstr("fastest master 512 deg/s, limited by the slave's velocity at 60 deg"));
  EXPECT_THAT(good.out, Not(HasSubstr("bound/"))) << "certificates are for --json";

  write("fast.toml", text + "master = { velocity = 600, distance = 120 }\n");
  const Result fast = run("check fast.toml --json");
  EXPECT_EQ(fast.status, 1);
  const json document = json::parse(fast.out);
  EXPECT_NEAR(document["cam"]["fastest_master"]["value"].get<double>(), 512, 1e-9);
  EXPECT_NEAR(document["cam"]["rises"][0]["cv"]["value"].get<double>(), 1.875, 1e-12);
  EXPECT_EQ(document["findings"][0]["rule"], "limit/acceleration") << "the worst first";
  EXPECT_TRUE(std::any_of(document["findings"].begin(), document["findings"].end(),
                          [](const json& f) { return f["rule"] == "limit/master_velocity"; }));
  bool certified = false;
  for (const json& f : document["findings"])
    certified = certified || f["rule"] == "bound/acceleration_for_jerk";
  EXPECT_TRUE(certified);
}

TEST_F(Cli, CheckWarnsOfTheDefaultCamOfCodesys) {
  write("cam.toml", R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "deg" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 120, slave = 120, geo_velocity = 1 }
[[segment]]
law = "quintic"
end = { master = 240, slave = 240, geo_velocity = 1 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 360 }
[limits]
geo_velocity = 2
)");
  const Result result = run("check cam.toml");
  EXPECT_EQ(result.status, 0) << "a warning fails nothing";
  EXPECT_THAT(result.out, HasSubstr("(2 warnings)"));
  EXPECT_THAT(result.out,
              HasSubstr("warn   warning/velocity_overshoot geo_velocity 1.512 deg/deg"));
  EXPECT_THAT(result.out, HasSubstr("use a length from 200 deg to 300 deg"));
}

// A terminal obeys an escape sequence wherever it comes from.
TEST_F(Cli, NoControlCharacterOfAFileOrItsNameReachesATerminal) {
  const auto expect_harmless = [&](const std::string& words) {
    const Result result = run(words);
    for (const std::string& text : {result.out, result.err})
      EXPECT_EQ(jounce::printable_lines(text), text) << words;
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

/// A recorded motion of so many rows, and a spec that plays it.
void write_recording(const std::filesystem::path& folder, const std::string& name, int rows) {
  std::ofstream points(folder / (name + ".csv"));
  points << "time [s],position [mm],velocity [mm/s]\n";
  for (int i = 0; i < rows; ++i) {
    const double t = 1e-3 * i;
    std::array<char, 80> row{};
    std::snprintf(row.data(), row.size(), "%.3f,%.9f,%.9f\n", t, 10 * std::sin(t),
                  10 * std::cos(t));
    points << row.data();
  }
  std::ofstream(folder / (name + ".toml"))
      << "jounce = 1\nkind = \"pvt\"\noutside = \"refuse\"\n"
         "units = { position = \"mm\", time = \"s\" }\npoints = \"" +
             name + ".csv\"\n[limits]\nvelocity = 11\n";
}

TEST_F(Cli, ChecksARecordingInLittleMemory) {
  const auto peak = [&](const std::string& file) {  // KiB, the most of all children so far
    EXPECT_EQ(run("check " + file + " > out.txt").status, 0) << slurp(folder / "out.txt");
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_maxrss);
  };
  constexpr int few = 100000, many = 500000;
  write_recording(folder, "few", few);
  write_recording(folder, "many", many);
  const double of_few = peak("few.toml");
  EXPECT_LT(1024 * (peak("many.toml") - of_few) / (many - few), 120) << "bytes a row";
}

}  // namespace
