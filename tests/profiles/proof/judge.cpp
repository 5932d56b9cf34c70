// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/judge.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "support/draw_until.hpp"

namespace jounce::proof {

void Tally::fail(const std::string& why, const std::string& asked) {
  ++failures;
  if (examples.size() < kept) examples.push_back(why + "\n    " + asked);
}

void Tally::fail(const std::string& why, const Case& c) {
  fail(why, reproducer(c));
}

void Tally::note(const Verdict& verdict, const Case& c) {
  end_error = std::max(end_error, verdict.end_error);
  excess = std::max(excess, verdict.excess);
  if (!verdict.ok()) fail(verdict.fault, c);
}

std::string text(Real x) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17Lg", x);
  return buffer.data();
}

Solved solve(const Case& c, Tally& tally) {
  Solved s;
  s.move =
      c.duration ? move_to(c.from, c.to, c.bounds, *c.duration) : move_to(c.from, c.to, c.bounds);
  ++tally.cases;
  if (!s.move) {
    tally.fail(std::string("refused: ") + explain(s.move.status), c);
    return s;
  }
  s.verdict = check(s.move.profile, c);
  tally.note(s.verdict, c);
  return s;
}

std::vector<Span> reachable(const Case& c, const Verdict& move, Real share) {
  return reachable(c.from, c.to, c.bounds, slack_of(move, share));
}

Slack slack_of(const Verdict& move, Real share) {
  const auto of = [share](Real scale, Real floor) {
    return std::copysign(std::max(std::abs(share) * scale, std::abs(share) / rounding * floor),
                         share);
  };
  return {of(move.scale.position, move.floor.position),
          of(move.scale.velocity, move.floor.velocity),
          of(move.scale.acceleration, move.floor.acceleration)};
}

Real minimum(const std::vector<Span>& spans) {
  return spans.empty() ? std::numeric_limits<Real>::infinity() : spans.front().from;
}

void compare(Real is, const Reference& reference, const Asked& asked, Tally& tally) {
  const Real exact = reference(last_bit);
  if (std::abs(is - exact) <= same * exact) {
    if (exact > 0) tally.longer = std::max(tally.longer, static_cast<double>((is - exact) / exact));
    return;
  }
  if (is >= reference(rounding) * (1 - same) && is <= reference(-rounding) * (1 + same)) {
    ++tally.ties;
    return;
  }
  tally.fail("lasts " + text(is) + ", the reference " + text(exact) +
                 (is > exact ? " (too long)" : " (too short)"),
             asked());
}

void compare(Real is, const Reference& reference, const Case& c, Tally& tally) {
  if (c.from == c.to && is > 0 && !c.duration)
    return tally.fail("moves for " + text(is) + " though it is there", c);
  compare(
      is, reference, [&c] { return reproducer(c); }, tally);
}

Case any(Random& r) {
  const auto one = [&r] {
    return draws()[static_cast<std::size_t>(r.below(static_cast<int>(draws().size())))];
  };
  return test::draw_until(one, [](const Draw& d) { return !d.alone; }).draw(r);
}

Case far_apart(Random& r) {
  const char* const kinds[] = {"unequal", "leaving", "leaving-unequal", "ratios", "extremes"};
  return draw(kinds[r.below(5)], r);
}

}  // namespace jounce::proof
