// SPDX-License-Identifier: Apache-2.0
// Outputs and M words on the path of a group: their instants between two ticks. The instants are
// compared with a closed form, and with the places of the axes between the ticks.
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/path/arc.hpp"

#include "executor/group/sent_plotter.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::group_outputs_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;

constexpr double dt = 1e-3;

ProgramWord output(std::int32_t number, std::size_t command) {
  return {.kind = ProgramWord::Kind::output, .number = number, .command = command};
}

/// A change of an output, with the places of the axes at this instant: the cubics through positions
/// and velocities of both ticks.
struct Seen {
  int output;
  bool on;
  double time;  // s, from the first tick of the motion
  At place;
};

struct GroupOutputs : SentPlotter {
  GroupOutputs() {
    listener.subscribe(wire::channel("plotter", wire::Lane::event), 4096);
    site.each_tick = [this] {
      site.judge();
      see();
    };
  }
  void see() {
    const Tick& now = site.last(group);
    if (now.tick == last_group.tick) return;
    if (last_group.job == 0 && now.job != 0) begin = now.time;
    for (const SwitchEdge& edge : now.switches.edges()) {
      const double s = edge.time / dt;
      const auto between = [&](const Tick& a, const Tick& b) {
        const double way = b.position - a.position;
        const double bend = (1 - s) * (a.velocity * dt - way) - s * (b.velocity * dt - way);
        return a.position + s * way + s * (1 - s) * bend;
      };
      seen.push_back({edge.track,
                      edge.on,
                      now.time - dt + edge.time - begin,
                      {between(last_x, site.last(x)), between(last_y, site.last(y))}});
    }
    last_group = now;
    last_x = site.last(x);
    last_y = site.last(y);
  }
  /// Numbers and times of the M words that were passed since the motion began.
  std::vector<std::pair<std::uint32_t, double>> passed() {
    std::map<std::int64_t, wire::Event> events;  // a message may come twice
    Rejects rejects;
    while (const auto message = next_message(listener, 0ns, rejects))
      if (const auto* event = std::get_if<wire::Event>(&message->body))
        events[event->count] = *event;
    std::vector<std::pair<std::uint32_t, double>> words;
    for (const auto& [count, event] : events)
      if (const double at = static_cast<double>(event.tick) * dt - event.offset_s - begin;
          event.kind == wire::EventKind::m_word && at >= 0)
        words.emplace_back(event.number, at);
    return words;
  }
  void expect(const std::vector<Seen>& wanted, double tolerance) {
    ASSERT_EQ(seen.size(), wanted.size());
    for (std::size_t k = 0; k < seen.size(); ++k) {
      EXPECT_EQ(seen[k].output, wanted[k].output) << k;
      EXPECT_EQ(seen[k].on, wanted[k].on) << k;
      EXPECT_NEAR(seen[k].time, wanted[k].time, tolerance) << k;
    }
  }
  MemoryTransport listener{site.network};
  double begin = 0;
  Tick last_group, last_x, last_y;
  std::vector<Seen> seen;
};

/// A line of 100 mm at 100 mm/s: the ramp with 2000 mm/s^2 and 1e5 mm/s^3 lasts 0.07 s and takes 3.5
/// mm. So a place p between 3.5 mm and 96.5 mm is passed at 0.07 s + (p - 3.5 mm) / (100 mm/s).
double passing(double place) {
  return 0.07 + (place - 3.5) / 100;
}

TEST_F(GroupOutputs, SwitchAtTheInstantOfAClosedForm) {
  for (const double rate : {1.0, 0.5}) {
    const double from = site.last(x).position;
    seen.clear();
    accepts(command::Override{rate});
    ASSERT_TRUE(stream(lines({{from + 30.512, 0}, {from + 60.2573, 0}, {from + 100, 0}},
                             {output(2, 0), output(1, 1), m_word(8, 1), output(-1, 2),
                              output(-2, 3), m_word(9, 3)}))
                    .ok());
    ends(site.last(group).finished + 1);
    expect({{2, true, 0, {}},
            {1, true, passing(30.512) / rate, {}},
            {1, false, passing(60.2573) / rate, {}},
            {2, false, 1.07 / rate, {}}},
           1e-11);
    const auto words = passed();
    ASSERT_EQ(words.size(), 2U);
    EXPECT_EQ(words[0].first, 8U);
    EXPECT_NEAR(words[0].second, passing(30.512) / rate, 1e-11);
    EXPECT_EQ(words[1].first, 9U);
    EXPECT_NEAR(words[1].second, 1.07 / rate, 1e-11);
  }
  expect_same_replay();
}

TEST_F(GroupOutputs, SwitchAtTheirPlacesOnArcsAndWhileTheRateChanges) {
  LimitedProgram program = lines({{20, 0}}, {});
  site.requested.circles.push_back({20, 10, 10});
  site.requested.lines.push_back({20, 20, 0, 20});
  Program& path = program.program;
  const auto turn = [&](Junction junction, const Point& to) {
    path.set({.velocity = 100, .corner = Corner::stop, .junction = junction});
    path.arc(arc_about(path.position(), {20, 10}, to, Plane{0, 1}, ArcRotation::counterclockwise));
  };
  turn(Junction::buffered, {30, 10});  // the curvature steps, so the group rests
  turn(Junction::look_ahead, {20, 20});
  path.set({.velocity = 100, .corner = Corner::stop, .junction = Junction::buffered});
  path.line({7.3, 20});
  path.set({.velocity = 100, .corner = Corner::stop});
  path.line({0, 20});
  program.words = {output(1, 1), output(2, 2), output(3, 3), output(4, 4)};
  const StreamOutcome outcome = stream(program);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  for (int k = 0; site.last(group).finished < 1 && k < 400; ++k) {
    if (k % 4 == 0) accepts(command::Override{k % 8 == 0 ? 0.3 : 0.9});
    site.advance(10ms);
  }
  ASSERT_EQ(site.last(group).finished, 1U);
  const std::vector<At> places{{20, 0}, {30, 10}, {20, 20}, {7.3, 20}};
  ASSERT_EQ(seen.size(), places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_EQ(seen[k].output, static_cast<int>(k) + 1);
    EXPECT_NEAR(seen[k].place[0], places[k][0], 1e-6) << k;
    EXPECT_NEAR(seen[k].place[1], places[k][1], 1e-6) << k;
  }
  expect_same_replay();
}

TEST_F(GroupOutputs, StayOverAWaitAndEndWhenTheGroupIsDisabled) {
  ASSERT_TRUE(stream(lines({{20, 0}, {20, 10}, {0, 10}},
                           {output(3, 1), m_word(0, 1), output(32, 2), m_word(0, 3)}))
                  .ok());
  ends(1);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].place[0], 20, 1e-9) << "before the M word";
  EXPECT_EQ(site.last(group).switches.outputs, 1U << 2U);
  accepts(command::GroupAcknowledge{});
  ends(2);
  EXPECT_EQ(site.last(group).switches.outputs, 1U << 2U | 1U << 31U);
  accepts(command::Disable{});
  site.advance(10ms);
  EXPECT_EQ(site.last(group).switches.outputs, 0U);
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_FALSE(seen[2].on);
  EXPECT_FALSE(seen[3].on);
  expect_same_replay();
}

}  // namespace
}  // namespace jounce::group_outputs_test
