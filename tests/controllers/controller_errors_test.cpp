// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/controller_errors.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/coupling_cycle.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/gear/gear_in.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce::controller_errors_test {
namespace {

Cam cam(Extrapolation outside) {
  return Cam({line(10, 0, 20)}, 0, outside);
}

/// "InputError KEY" of the thrown error, as in the table.
std::string thrown(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& error) {
    return "InputError " + error.key();
  }
  return "nothing";
}

std::string engaging(const Coupling& coupling, const Jet& master) {
  return std::string("CouplingStatus ") + name(engage(coupling, {}, master, 0).status);
}

/// A GearIn of a resting slave to a master at 1 m/s.
std::function<std::string()> gearing(const GearInSpec& spec) {
  return [spec] { return thrown([&] { gear_in(spec, {}, {0, 1, 0, 0}, 0); }); };
}

/// "GearInPosStatus NAME" of a slave that would have to reverse, with avoid_reversal.
std::function<std::string()> connecting(std::optional<double> slave_period) {
  return [slave_period] {
    // The slave is at its sync position already: it must run back to gain speed. Each of the five turns of 1e-3 is too
    // short.
    GearInPosSpec spec{.master_sync_position = 100, .master_start_distance = 100};
    spec.avoid_reversal = true;
    spec.slave_period = slave_period;
    switch (gear_in_pos(spec).status) {
      case GearInPosStatus::reversal_unavoidable:
        return std::string("GearInPosStatus reversal_unavoidable");
      case GearInPosStatus::reversal_on_linear_axis:
        return std::string("GearInPosStatus reversal_on_linear_axis");
      default:
        return std::string("nothing");
    }
  };
}

/// "GearInPosStatus NAME" of a master that moves back while the slave connects.
std::string reversing() {
  const GearInPos gear = gear_in_pos(
      {.master_sync_position = 100, .slave_sync_position = 50, .master_start_distance = 100});
  GearInPosState state;
  for (const double master : {-1.0, 20.0, 40.0}) state = step(gear, state, {master, 1, 0, 0}).state;
  const GearInPosStep back = step(gear, state, {30, -1, 0, 0});
  return back.status == GearInPosStatus::master_reversed ? "GearInPosStatus master_reversed"
                                                         : "nothing";
}

/// A provocation of each error that this module can throw, by controller and code.
std::map<std::string, std::function<std::string()>> provocations() {
  using When = Trigger::When;
  const auto spec = [](const CouplingSpec& given) {
    return [given] { return thrown([&] { Coupling(cam(Extrapolation::hold), given); }); };
  };
  const auto trigger = [](const Trigger& given, const char* prefix) {
    return [=] { return thrown([&] { require_valid(given, cam(Extrapolation::hold), prefix); }); };
  };
  const auto switches = [](const CamSwitchSpec& given) {
    return [given] { return thrown([&] { CamSwitches bits(given); }); };
  };
  return {
      {"PMC600 600", switches({.switches = {}, .tracks = {{.track = 1}}})},
      {"PMC600 601", switches({.switches = {{.track = 33, .last_on_position = 1}}, .tracks = {}})},
      {"PMC600 629",
       [] {
         // 1000 turns in one step: 2000 edges.
         CamSwitches bits({.switches = {{.first_on_position = 30, .last_on_position = 80}},
                           .tracks = {},
                           .period = 360});
         bits.step(0, 360e6, 1e-3);
         return std::string(bits.step(360e3, 360e6, 1e-3).lost > 0 ? "SwitchStep lost" : "none");
       }},
      {"PMC600 626",
       [] {
         return engaging(Coupling(cam(Extrapolation::refuse)), {11, 0, 0, 0});
       }},
      {"PMC600 627", spec({.start = StartMode::ramp_in})},
      {"PMC600 628", spec({.master_scaling = 0})},
      {"PMC600 675", gearing({.denominator = 0, .acceleration = 1})},
      {"PMC600 676", gearing({.acceleration = 0})},
      {"PMC600 677", gearing({.acceleration = 1, .deceleration = -1})},
      {"PMC600 679", gearing({.acceleration = 1, .jerk = -1})},
      {"PMC600 775", reversing},
      {"PMC600 776", connecting(1e-3)},
      {"PMC600 777", connecting({})},
      {"PMC600 678",
       [] {
         return engaging(Coupling(cam(Extrapolation::hold)), {NAN, 0, 0, 0});
       }},
      {"PMC600 751",
       [] {
         return thrown([] { Followed(cam(Extrapolation::refuse), Trajectory({line(1, 0, 11)})); });
       }},
      {"PMC600 752", [] { return thrown([] { design(CamSpec{}); }); }},
      {"PMC600 753",
       [] {
         CamSpec backwards;
         backwards.segments = {{Law::quintic, {-1, 0, {}, {}}, ""}};
         return thrown([&] { design(backwards); });
       }},
      {"PMC600 754",
       [] { return thrown([] { require_valid(Limits{.position_min = 1, .position_max = 0}); }); }},
      {"HMPL 0x1388", trigger({When::master_position, 5, 6}, "engage")},
      {"HMPL 0x1389", trigger({When::master_position, 11, 0}, "engage")},
      {"HMPL 0x138a", spec({.master_scaling = -1})},
      {"HMPL 0x138b", spec({.slave_scaling = 0})},
      {"HMPL 0x138d", trigger({When::master_position, 5, -1}, "disengage")},
      {"HMPL 0x138e", trigger({When::master_position, -1, 0}, "disengage")},
      {"HMPL 0x1392",
       [] {
         const Due missed = due({When::master_position, 5, 0.1}, cam(Extrapolation::hold), {},
                                {0, {4, 2, 0, 0}}, {1, {6, 2, 0, 0}});
         return std::string("CouplingStatus ") + name(missed.status);
       }},
  };
}

std::string key(const ControllerError& error) {
  return std::string(error.controller) + " " + code_text(error);
}

TEST(ControllerErrors, EachThatTheLibraryCanGiveIsProvoked) {
  const auto provoke = provocations();
  // Errors of a spec or an executor: tests/io and tests/executor.
  const std::set<std::string> elsewhere{"HMPL 0x1390", "HMPL 0x1391"};
  for (const ControllerError& error : controller_errors()) {
    const std::string here = error.here;
    const bool of_library = here.starts_with("InputError") || here.starts_with("CouplingStatus") ||
                            here.starts_with("GearInPosStatus") || here.starts_with("SwitchStep");
    if (!of_library || elsewhere.contains(key(error))) {
      EXPECT_FALSE(provoke.contains(key(error))) << key(error);
      continue;
    }
    ASSERT_TRUE(provoke.contains(key(error))) << key(error);
    EXPECT_EQ(provoke.at(key(error))(), here) << key(error);
  }
}

TEST(ControllerErrors, ListsEveryCodeOfTheManuals) {
  std::set<std::string> codes;
  for (const ControllerError& error : controller_errors()) codes.insert(key(error));
  EXPECT_EQ(codes.size(), controller_errors().size()) << "none twice";
  for (const unsigned code : {600U, 601U, 602U, 625U, 626U, 627U, 628U, 629U, 675U, 676U, 677U,
                              678U, 679U, 750U, 751U, 752U, 753U, 754U, 775U, 776U, 777U})
    EXPECT_TRUE(codes.contains(key({"PMC600", code, "", "", ""}))) << code;
  for (unsigned code = 0x1388; code <= 0x1397; ++code)
    EXPECT_TRUE(codes.contains(key({"HMPL", code, "", "", ""}))) << code;
}

TEST(ControllerErrors, ArePrintedInTheDocs) {
  std::ifstream file(JOUNCE_SOURCE_DIR "/docs/cam/errors.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const ControllerError& error : controller_errors())
    EXPECT_NE(page.find(row(error) + "\n"), std::string::npos) << row(error);
}

TEST(CouplingStatus, HasAWordAndASentenceForEach) {
  std::set<std::string> names, sentences;
  for (int i = 0; i <= static_cast<int>(CouplingStatus::window_missed); ++i) {
    names.insert(name(static_cast<CouplingStatus>(i)));
    sentences.insert(explain(static_cast<CouplingStatus>(i)));
  }
  EXPECT_EQ(names.size(), 7U);
  EXPECT_EQ(sentences.size(), 7U);
}

}  // namespace
}  // namespace jounce::controller_errors_test
