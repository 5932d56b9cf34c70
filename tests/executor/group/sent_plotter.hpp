// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "executor/group/judged_plotter.hpp"

namespace jounce::test {

using At = std::array<double, 2>;

inline ProgramWord m_word(std::int32_t number, std::size_t command) {
  return {.number = number, .line = static_cast<int>(command) + 1, .command = command};
}

/// A plotter that receives whole programs of lines from its origin.
struct SentPlotter : ::testing::Test {
  /// `window`: of the plans of a long program.
  explicit SentPlotter(const PlanWindow& window = {})
      : site(true, test::limits(200, 2000, 1e5), window) {}

  /// The program of these lines, with rounded corners; the judge receives the lines.
  LimitedProgram lines(const std::vector<At>& points, const std::vector<ProgramWord>& words = {}) {
    Program program(2, {site.last(Plotter::x).position, site.last(Plotter::y).position});
    program.set({.velocity = 100, .corner = Corner::deviation, .value = corner});
    At from{site.last(Plotter::x).position, site.last(Plotter::y).position};
    for (const At& to : points) {
      site.requested.lines.push_back({from[0], from[1], to[0], to[1]});
      program.line({to[0], to[1]}, static_cast<int>(program.commands().size()) + 1);
      from = to;
    }
    site.requested.tolerance = corner + 1e-9;
    return {
        program, {.axes = std::vector<Limits>(2, test::limits(200, 2000, 1e5))}, {"x", "y"}, words};
  }
  StreamOutcome stream(const LimitedProgram& program) { return site.stream(stream_of(program)); }
  void accepts(const ClientCommand& command) {
    const CallOutcome outcome = site.order("plotter", command);
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
  }
  [[nodiscard]] std::string refused(const ClientCommand& command) {
    const CallOutcome outcome = site.order("plotter", command);
    EXPECT_FALSE(outcome.ok());
    return outcome.reason;
  }
  [[nodiscard]] Cause reason() {
    return static_cast<Cause>(site.dispatcher.server(Plotter::group).status().reason);
  }
  [[nodiscard]] At place() const {
    return {site.last(Plotter::x).position, site.last(Plotter::y).position};
  }
  /// Until the group has ended this number of motions.
  void ends(std::uint64_t motions) {
    for (int k = 0; k < 800 && site.last(Plotter::group).finished < motions; ++k)
      site.advance(std::chrono::milliseconds(10));
    ASSERT_EQ(site.last(Plotter::group).finished, motions);
    site.advance(std::chrono::milliseconds(20));
  }
  void expect_same_replay() {
    const Replay replay = site.replayed();
    EXPECT_TRUE(replay.same()) << replay.shorter
                               << (replay.difference ? replay.difference->what.field : "");
  }
  static constexpr double corner = 0.2;
  Judged site;
};

}  // namespace jounce::test
