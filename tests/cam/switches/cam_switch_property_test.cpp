// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/profiles/error.hpp"

#include "support/random.hpp"
#include "switch_oracle.hpp"

namespace jounce::cam_switch_property_test {
namespace {

using test::ClosedForm;
using test::Grid;
using test::Random;
using test::Real;
using test::SwitchOracle;

using Edges = std::map<int, std::vector<SwitchEdge>>;

/// A master of 2 s that travels a few hundred units, reverses, and (with noise) trembles.
ClosedForm random_master(Random& random, bool noise) {
  ClosedForm m{.length = 2, .c = {}, .waves = {}};
  m.c = {random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(-200, 200),
         random.uniform(-60, 60)};
  const int waves = random.below(3);
  for (int i = 0; i < waves; ++i)
    m.waves.push_back({random.uniform(5, 60), random.uniform(2, 15), random.uniform(-3, 3)});
  if (noise) m.waves.push_back({random.uniform(0.02, 0.2), random.uniform(150, 400), 0});
  return m;
}

Trajectory curve(const ClosedForm& m) {
  Segment f;
  f.length = static_cast<double>(m.length);
  f.degree = static_cast<int>(m.c.size()) - 1;
  Real power = 1;
  for (std::size_t k = 0; k < m.c.size(); ++k, power *= m.length)
    f.c[k] = static_cast<double>(m.c[k] * power);
  for (const auto& [a, w, p] : m.waves)
    f.sine[static_cast<std::size_t>(f.sines++)] = {
        static_cast<double>(a), static_cast<double>(w * m.length), static_cast<double>(p)};
  return Trajectory({f});
}

CamSwitchSpec random_switches(Random& random, bool trembling) {
  CamSwitchSpec spec;
  if (random.below(2) == 0) spec.period = random.uniform(100, 400);
  const int tracks = 1 + random.below(3);
  for (int t = 1; t <= tracks; ++t) {
    SwitchTrack track{.track = t};
    if (random.below(2) == 0) track.on_compensation = random.uniform(-0.04, 0.04);
    if (random.below(2) == 0) track.off_compensation = random.uniform(-0.04, 0.04);
    if (trembling || random.below(2) == 0) track.hysteresis = random.uniform(0.5, 4);
    track.inverted = random.below(4) == 0;
    track.initial = random.below(4) == 0;
    track.enabled = random.below(10) != 0;
    spec.tracks.push_back(track);
    const int count = 1 + random.below(3);
    for (int i = 0; i < count; ++i) {
      CamSwitch s{.track = t, .first_on_position = random.uniform(-300, 300)};
      s.axis_direction = static_cast<AxisDirection>(random.below(3));
      s.mode = static_cast<CamSwitchMode>(random.below(3) == 0);
      if (s.mode == CamSwitchMode::time)
        s.duration = random.uniform(0.09, 0.5);
      else
        s.last_on_position = s.first_on_position + random.uniform(5, 90);
      spec.switches.push_back(s);
    }
  }
  return spec;
}

std::string text(const CamSwitchSpec& spec, const ClosedForm& m) {
  std::ostringstream out;
  out.precision(17);
  out << "master";
  for (const Real c : m.c) out << ' ' << c;
  for (const auto& [a, w, p] : m.waves) out << " + " << a << " sin(" << w << " t + " << p << ')';
  if (spec.period) out << "\nperiod " << *spec.period;
  for (const auto& t : spec.tracks)
    out << "\ntrack " << t.track << " on " << t.on_compensation << " off " << t.off_compensation
        << " hysteresis " << t.hysteresis << " inverted " << t.inverted << " initial " << t.initial;
  for (const auto& s : spec.switches)
    out << "\nswitch " << s.track << ' ' << s.first_on_position << " to "
        << s.last_on_position.value_or(0) << ' ' << name(s.axis_direction) << " duration "
        << s.duration.value_or(0);
  return out.str();
}

Edges by_track(const CamSwitchSpec& spec, const std::vector<SwitchEdge>& edges) {
  Edges all;
  for (const CamSwitch& s : spec.switches) all[s.track];
  for (const SwitchEdge& edge : edges) all[edge.track].push_back(edge);
  return all;
}

std::vector<SwitchEdge> stepped(const CamSwitchSpec& spec, const Trajectory& motion) {
  CamSwitches bits(spec);
  std::vector<SwitchEdge> edges;
  const double cycle = 1e-3;
  for (int k = 0; k <= 2000; ++k) {
    const Jet now = motion.jet(std::min(k * cycle, 2.0));
    for (SwitchEdge edge : bits.step(now[0], now[1], cycle).edges()) {
      edge.time += (k - 1) * cycle;
      edges.push_back(edge);
    }
  }
  return edges;
}

/// The greatest difference in time; nothing where the edges are not the same ones.
std::optional<double> difference(const Edges& a, const Edges& b) {
  double worst = 0;
  if (a.size() != b.size()) return std::nullopt;
  for (const auto& [track, edges] : a) {
    const auto& others = b.at(track);
    if (edges.size() != others.size()) return std::nullopt;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].on != others[i].on) return std::nullopt;
      worst = std::max(worst, std::abs(edges[i].time - others[i].time));
    }
  }
  return worst;
}

/// A case is clear cut if its edges stay the same ones, and move little, when every position, or
/// the first ones alone, move by 0.002 u, and the compensations by 20 us: nothing is grazed.
bool is_clear(const CamSwitchSpec& spec, const ClosedForm& m, const Grid& grid,
              const Edges& edges) {
  for (const double d : {-0.002, 0.002})
    for (const int what : {0, 1, 2, 3}) {
      CamSwitchSpec moved = spec;
      for (CamSwitch& s : moved.switches) {
        if (what <= 1) s.first_on_position += d;
        if (what == 0 && s.last_on_position) *s.last_on_position += d;
        if (what == 3 && s.duration) *s.duration += 0.01 * d;
      }
      for (SwitchTrack& t : moved.tracks) {
        if (what == 2) t.on_compensation += 0.01 * d;
        if (what == 3 && t.hysteresis > 0) t.hysteresis += d;
      }
      const auto apart = difference(SwitchOracle(moved, m, grid).edges(), edges);
      if (!apart || *apart > 1e-3) return false;
    }
  return true;
}

struct Outcome {
  int compared = 0;
  int unclear = 0;
  std::size_t edges = 0;
};

/// Compares one face with the oracle over random cases.
template <class Face>
Outcome compare(std::uint64_t seed, int cases, bool noise, double tolerance, const Face& face) {
  Random random(seed);
  Outcome outcome;
  for (int i = 0; i < cases; ++i) {
    const ClosedForm m = random_master(random, noise);
    const CamSwitchSpec spec = random_switches(random, noise);
    require_valid(spec);
    const Grid grid(m, 1e-4L);
    const Edges expected = SwitchOracle(spec, m, grid).edges();
    if (!is_clear(spec, m, Grid(m, 4e-4L), expected)) {
      ++outcome.unclear;
      continue;
    }
    ++outcome.compared;
    for (const auto& [track, list] : expected) outcome.edges += list.size();
    const auto worst = difference(by_track(spec, face(spec, curve(m))), expected);
    EXPECT_TRUE(worst && *worst <= tolerance)
        << "case " << i << (worst ? ": apart by " + number(*worst) : ": other edges") << "\n"
        << text(spec, m);
  }
  return outcome;
}

TEST(CamSwitchProperty, TheExactFaceAgreesWithBruteForce) {
  const auto face = [](const CamSwitchSpec& spec, const Trajectory& motion) {
    return switch_times(spec, motion).edges;
  };
  for (const bool noise : {false, true}) {
    const Outcome outcome = compare(11 + noise, 50, noise, 1e-8, face);
    EXPECT_GT(outcome.compared, 4 * outcome.unclear);
    EXPECT_GT(outcome.edges, 200U);
  }
}

TEST(CamSwitchProperty, TheTickedFaceAgreesWithBruteForceToAMicrosecond) {
  const Outcome outcome = compare(23, 50, false, 1e-6, stepped);
  EXPECT_GT(outcome.compared, 4 * outcome.unclear);
  EXPECT_GT(outcome.edges, 200U);
}

}  // namespace
}  // namespace jounce::cam_switch_property_test
