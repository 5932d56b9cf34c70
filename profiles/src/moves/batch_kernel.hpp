// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "profiles/src/solver/span.hpp"

namespace jounce::profiles_detail {

/// A block of moves in columns, with the results.
struct Block {
  static constexpr std::size_t size = 64;

  alignas(64) double distance[size], entry[size], exit[size], velocity[size],
      acceleration[size], jerk[size];
  alignas(64) double duration[size], peak[size];
  alignas(64) double settled[size];  ///< > 0 where the result is final
};

/// The kernels for one width of vectors: the templates below, compiled in a separate file with the
/// flags for this width. That file contains no other code, because a linker could use it for older
/// machines, too.
struct Kernels {
  void (*ways)(Block&) noexcept;   ///< for any velocities at the ends
  void (*rests)(Block&) noexcept;  ///< from rest to rest; ignores entry and exit
};
extern const Kernels kernels_anywhere, kernels_avx2, kernels_avx512;

/// True if the input is valid and the result is a number: no NaN passes a comparison.
template <class Real>
JOUNCE_INLINE Mask<Real> answered(const Rates<Real>& r, Real distance, Real velocity, Real ends,
                                  Real duration) {
  return is_magnitude(r.a) & is_limit(r.j) & is_limit(velocity) & (ends <= velocity) &
         is_way(distance) & is_moderate(ends) & (duration < __builtin_inf());
}

/// Computes every case for every move, and selects the right one.
template <class Real>
JOUNCE_INLINE void solve_ways(Block& b, std::size_t i) {
  const Rates<Real> rates(load<Real>(b.acceleration + i), load<Real>(b.jerk + i));
  const Real velocity = load<Real>(b.velocity + i);
  const Real entry = load<Real>(b.entry + i);
  const Real exit = load<Real>(b.exit + i);
  const Real distance = load<Real>(b.distance + i);
  const Span<Real> s(distance, entry, exit, rates);
  const Cruise<Real> cruise = cruise_way(s, velocity);
  const Real z = s.both();
  const Mask<Real> none = s.none();
  const Start<Real> with = s.one_start();
  const Start<Real> without = s.none_start();
  const Quartic<Real> f{none ? without.f.c4 : with.f.c4, none ? without.f.c3 : with.f.c3,
                        none ? without.f.c2 : with.f.c2, none ? without.f.c1 : with.f.c1,
                        none ? without.f.c0 : with.f.c0};
  Real before = none ? without.x : with.x;
  for (int k = 1; k < usual_steps; ++k) before = f.next(before);
  const Real x = f.next(before);

  const Way<Real> one = one_way(s, x);
  const Way<Real> neither = none_way(s, x);
  const Way<Real> both = both_way(s, z);
  const Mask<Real> reach = z >= rates.tau;
  const Mask<Real> cruises = cruise.duration >= 0;
  const Real duration = reach ? both.duration : (none ? neither.duration : one.duration);
  const Real peak = reach ? both.peak : (none ? neither.peak : one.peak);
  const Real top = s.is_direct ? s.h : (cruises ? cruise.way.peak : peak);
  const Real total = s.is_direct ? s.direct : (cruises ? cruise.way.duration : duration);
  store(b.duration + i, total);
  store(b.peak + i, s.mirrored ? -top : top);
  const Mask<Real> arrived = s.is_direct | cruises | reach | settled(before, x);
  const Mask<Real> good =
      answered(rates, distance, velocity, greatest(magnitude(entry), magnitude(exit)), total);
  store(b.settled + i, (arrived & good) ? every<Real>(1) : every<Real>(0));
}

/// A move from rest to rest, over a distance that is not zero.
template <class Real>
JOUNCE_INLINE void solve_rests(Block& b, std::size_t i) {
  const Rates<Real> r(load<Real>(b.acceleration + i), load<Real>(b.jerk + i));
  const Real distance = load<Real>(b.distance + i);
  const Real velocity = load<Real>(b.velocity + i);
  const Real D = magnitude(distance);
  const Way<Real> way = rest_way(r, D, velocity);
  store(b.duration + i, way.duration);
  store(b.peak + i, distance < 0 ? -way.peak : way.peak);
  const Mask<Real> good = (D > 0) & answered(r, distance, velocity, every<Real>(0), way.duration);
  store(b.settled + i, good ? every<Real>(1) : every<Real>(0));
}

template <class Real>
void each_way(Block& block) noexcept {
  for (std::size_t i = 0; i < Block::size; i += lanes<Real>) solve_ways<Real>(block, i);
}
template <class Real>
void each_rest(Block& block) noexcept {
  for (std::size_t i = 0; i < Block::size; i += lanes<Real>) solve_rests<Real>(block, i);
}

}  // namespace jounce::profiles_detail
