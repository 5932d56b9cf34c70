// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/polish.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::proof {
namespace {

using Flat = Functional::Flat;

/// Without the instants that carry nothing, stretches of one kind joined.
Functional compact(const Functional& f) {
  Functional g = f;
  g.at.clear();
  for (std::size_t i = 0; i < f.at.size(); ++i) {
    const bool last = i + 1 == f.at.size();
    if (last || f.at[i].velocity != 0 || f.at[i].acceleration != 0 ||
        f.at[i].before != f.at[i + 1].before)
      g.at.push_back(f.at[i]);
  }
  return g;
}

/// Goes back in time along (2) and moves the end of each flat stretch to where q vanishes: to press it
/// down to zero costs more.
void snap(Functional& f) {
  Real q = f.a;
  Real slope = f.v;
  for (std::size_t i = f.at.size(); i-- > 0;) {
    Functional::Instant& now = f.at[i];
    slope -= now.velocity;
    q -= now.acceleration;
    if (now.before == Flat::velocity) slope = 0;
    if (now.before != Flat::none) q = 0;
    const Real begin = i > 0 ? f.at[i - 1].t : 0;
    if (now.before == Flat::none && i > 0 && f.at[i - 1].before != Flat::none) {
      const Real d = slope * slope - 2 * f.p * q;
      if (d >= 0 && f.p != 0) {
        const Real before = i > 1 ? f.at[i - 2].t : 0;
        Real best = begin;
        Real least = now.t;
        for (const Real root : {(-slope + std::sqrt(d)) / f.p, (-slope - std::sqrt(d)) / f.p})
          if (const Real t = now.t - root; t > before && t < now.t && std::abs(t - begin) < least) {
            best = t;
            least = std::abs(t - begin);
          }
        f.at[i - 1].t = best;
      }
    }
    const Real h = now.t - (i > 0 ? f.at[i - 1].t : 0);
    if (now.before == Flat::none) q += h * (slope + h * f.p / 2);
    if (now.before != Flat::velocity) slope += f.p * h;
  }
}

/// The numbers that may be moved, and by how much at first.
struct Dial {
  Real Functional::*weight = nullptr;
  Real Functional::Instant::*pressure = nullptr;
  std::size_t at = 0;
  Real step = 0;

  Real& in(Functional& f) const { return weight ? f.*weight : f.at[at].*pressure; }
};

std::vector<Dial> dials(const Functional& f) {
  using Instant = Functional::Instant;
  const Real T = f.at.back().t;
  std::vector<Dial> all;
  if (f.p != 0) all.push_back({&Functional::v, nullptr, 0, std::abs(f.p) * T / 16});
  all.push_back({&Functional::a, nullptr, 0, std::abs(f.p) * T * T / 64 + std::abs(f.v) * T / 16});
  for (std::size_t i = 0; i + 1 < f.at.size(); ++i) {
    const Real room = std::min(f.at[i].t - (i > 0 ? f.at[i - 1].t : 0), f.at[i + 1].t - f.at[i].t);
    all.push_back({nullptr, &Instant::t, i, room / 4});
    const bool entry = f.at[i + 1].before == Flat::velocity;  // start of a cruise
    if (const Real m = f.at[i].velocity; m != 0 || entry)
      all.push_back({nullptr, &Instant::velocity, i,
                     std::max(std::abs(m) / 8, entry ? std::abs(f.p) * T / 64 : 0)});
    if (const Real n = f.at[i].acceleration; n != 0)
      all.push_back({nullptr, &Instant::acceleration, i, std::abs(n) / 8});
  }
  return all;
}

bool ordered(const Functional& f) {
  Real before = 0;
  return std::all_of(f.at.begin(), f.at.end(), [&](const Functional::Instant& i) {
    const bool later = i.t > before;
    before = i.t;
    return later;
  });
}

/// A functional and what it is worth.
struct Trial {
  Functional f;
  Real margin = 0;
};

Trial tried(Functional f, const Question& q) {
  if (!ordered(f)) return {std::move(f), -std::numeric_limits<Real>::infinity()};
  snap(f);
  const Real worth = margin(f, q);
  return {std::move(f), worth};
}

/// One round: each dial a step up or down, where that helps.
Trial explored(Trial best, const std::vector<Dial>& dials, Real scale, const Question& q) {
  for (const Dial& dial : dials)
    for (const Real sign : {1, -1}) {
      Functional f = best.f;
      dial.in(f) += sign * scale * dial.step;
      if (Trial t = tried(std::move(f), q); t.margin > best.margin) {
        best = std::move(t);
        break;
      }
    }
  return best;
}

/// One more step in the direction of the last round.
Functional onward(const Functional& from, const Functional& to, const std::vector<Dial>& dials) {
  Functional f = to;
  Functional old = from;
  for (const Dial& dial : dials) dial.in(f) += dial.in(f)-dial.in(old);
  return f;
}

}  // namespace

Functional polished(Functional f, const Question& q) {
  const Real before = margin(f, q);
  Trial best = tried(compact(f), q);
  const std::vector<Dial> all = dials(best.f);
  Real scale = 1;
  for (int round = 0; round < 60 && scale > 1e-4L; ++round) {
    Trial next = explored(best, all, scale, q);
    if (next.margin <= best.margin) {
      scale /= 2;
      continue;
    }
    Trial pattern = tried(onward(best.f, next.f, all), q);
    best = pattern.margin > next.margin ? std::move(pattern) : std::move(next);
  }
  return best.margin > before ? best.f : f;
}

}  // namespace jounce::proof
