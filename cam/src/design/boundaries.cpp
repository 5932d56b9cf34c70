// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/boundaries.hpp"

#include "cam/src/design/least_energy.hpp"

// A quintic segment is fixed by position, velocity and acceleration at both ends, and the free
// derivatives do not affect the other segments. The integral of geo_jerk^2 over the quintics is
// therefore a quadratic function of the free derivatives. least_energy.cpp finds its
// minimum, run by run: a run is the interval between two knots next to any other law.

namespace jounce {
namespace {

using Derivative = std::optional<double> CamKnot::*;

CamKnot& knot_of(CamSpec& spec, std::size_t i) {
  return i == 0 ? spec.start : spec.segments[i - 1].end;
}

/// True if only quintics meet at the knot.
bool among_quintics(const CamSpec& spec, std::size_t knot) {
  const std::size_t last = spec.segments.size();
  const auto quintic = [&](std::size_t segment) {
    return spec.segments[segment].law == Law::quintic;
  };
  const bool before = knot > 0 ? quintic(knot - 1) : !spec.periodic || quintic(last - 1);
  const bool after = knot < last ? quintic(knot) : !spec.periodic || quintic(0);
  return before && after;
}

/// True if an adjacent law defines an acceleration of its own, so that the acceleration may step
/// there.
bool bends_itself(const CamSpec& spec, std::size_t knot) {
  const auto own = [&](std::size_t segment) {
    const Ends ends = info(spec.segments[segment].law).ends;
    return ends == Ends::moving_free || reverses(ends);
  };
  return (knot > 0 && own(knot - 1)) || (knot < spec.segments.size() && own(knot));
}

/// The first and the last knot of a periodic cam are one knot: a value that is given at one of
/// them, or that an adjacent law requires, holds for both.
void close(CamSpec& spec, const std::vector<CamKnot>& resolved) {
  if (!spec.periodic) return;
  const std::size_t last = spec.segments.size();
  const auto demanded = [&](std::size_t knot, Derivative d) -> std::optional<double> {
    const CamKnot& given = knot == 0 ? spec.start : spec.segments.back().end;
    const Law law = spec.segments[knot == 0 ? 0 : last - 1].law;
    return given.*d || law == Law::quintic ? given.*d : resolved[knot].*d;
  };
  for (const Derivative d : {&CamKnot::geo_velocity, &CamKnot::geo_acceleration}) {
    const auto at_start = demanded(0, d);
    const auto at_end = demanded(last, d);
    CamKnot& end = spec.segments.back().end;
    if (!(spec.start.*d) && spec.segments.front().law == Law::quintic) spec.start.*d = at_end;
    if (!(end.*d) && spec.segments.back().law == Law::quintic) end.*d = at_start;
  }
}

std::vector<FreeDerivatives> free_in(const CamSpec& closed) {
  std::vector<FreeDerivatives> free;
  for (std::size_t i = 0; i <= closed.segments.size(); ++i) {
    const CamKnot& knot = i == 0 ? closed.start : closed.segments[i - 1].end;
    const bool may = among_quintics(closed, i);
    free.push_back({may && !knot.geo_velocity, may && !knot.geo_acceleration});
  }
  return free;
}

std::vector<cam_detail::EnergyKnot> energy_knots(const std::vector<CamKnot>& knots,
                                                 const std::vector<FreeDerivatives>& free) {
  std::vector<cam_detail::EnergyKnot> out;
  for (std::size_t i = 0; i < knots.size(); ++i)
    out.push_back({knots[i].master,
                   {knots[i].slave, *knots[i].geo_velocity, *knots[i].geo_acceleration},
                   {true, !free[i].geo_velocity, !free[i].geo_acceleration}});
  return out;
}

}  // namespace

const char* name(Fill fill) {
  return fill == Fill::rest ? "rest" : "minimum_jerk";
}

std::vector<FreeDerivatives> free_derivatives(const CamSpec& spec) {
  CamSpec closed = spec;
  close(closed, resolved_knots(spec));
  return free_in(closed);
}

CamSpec filled(CamSpec spec, Fill how) {
  auto resolved = resolved_knots(spec);
  if (how == Fill::minimum_jerk) {
    close(spec, resolved);
    resolved = resolved_knots(spec);
    auto knots = energy_knots(resolved, free_in(spec));
    cam_detail::minimize(knots, cam_detail::Energy::jerk, spec.periodic);
    for (std::size_t i = 0; i < knots.size(); ++i) {
      resolved[i].geo_velocity = knots[i].state[1];
      resolved[i].geo_acceleration = knots[i].state[2];
    }
  }
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    CamKnot& knot = knot_of(spec, i);
    knot.geo_velocity = resolved[i].geo_velocity;
    if (!bends_itself(spec, i)) knot.geo_acceleration = resolved[i].geo_acceleration;
  }
  return spec;
}

}  // namespace jounce
