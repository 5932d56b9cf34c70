#include "jounce/cam/design.hpp"

#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string key_of(std::size_t knot, const char* field) {
  return knot == 0 ? std::string("start.") + field
                   : "segment[" + std::to_string(knot) + "].end." + field;
}

const CamKnot& knot_of(const CamSpec& spec, std::size_t i) {
  return i == 0 ? spec.start : spec.segments[i - 1].end;
}

double slope(const CamKnot& from, const CamKnot& to) {
  return (to.slave - from.slave) / (to.master - from.master);
}

void require_knot(const CamSpec& spec, std::size_t i) {
  const CamKnot& knot = knot_of(spec, i);
  require_finite(key_of(i, "master").c_str(), knot.master);
  require_finite(key_of(i, "slave").c_str(), knot.slave);
  if (knot.geo_velocity) require_finite(key_of(i, "geo_velocity").c_str(), *knot.geo_velocity);
  if (knot.geo_acceleration)
    require_finite(key_of(i, "geo_acceleration").c_str(), *knot.geo_acceleration);
  if (i > 0 && !(knot.master > knot_of(spec, i - 1).master))
    throw InputError(
        key_of(i, "master"), knot.master,
        "must be greater than " + number(knot_of(spec, i - 1).master) + ", the knot before");
}

/// The law on one side of a knot demands a derivative there: take it, or check what was given.
void demand(std::optional<double>& given, double demanded, const std::string& key, Law law,
            double scale) {
  if (!given) given = demanded;
  if (std::abs(*given - demanded) > 1e-9 * scale)
    throw InputError(
        key, *given,
        "must be " + number(demanded) + ", which the law `" + name(law) + "` beside it has there");
}

void demand_of_segment(const CamSpec& spec, std::size_t segment, std::vector<CamKnot>& knots) {
  const Law law = spec.segments[segment].law;
  if (law == Law::quintic) return;
  const double chord = slope(knots[segment], knots[segment + 1]);
  if (law == Law::dwell && chord != 0)
    throw InputError(key_of(segment + 1, "slave"), knots[segment + 1].slave,
                     "a dwell must stay at " + number(knots[segment].slave));
  const double velocity = law == Law::line ? chord : 0;
  for (std::size_t i = segment; i <= segment + 1; ++i) {
    demand(knots[i].geo_velocity, velocity, key_of(i, "geo_velocity"), law, std::abs(chord));
    demand(knots[i].geo_acceleration, 0, key_of(i, "geo_acceleration"), law, 0);
  }
}

/// A normalised law moved to its place.
Segment placed(Segment f, double length, double from, double to) {
  f = scaled(f, to - from, from);
  f.length *= length;
  return f;
}

}  // namespace

std::vector<CamKnot> resolved_knots(const CamSpec& spec) {
  if (spec.segments.empty())
    throw InputError("segment", "none", "a cam needs at least one segment");
  std::vector<CamKnot> knots;
  for (std::size_t i = 0; i <= spec.segments.size(); ++i) {
    require_knot(spec, i);
    knots.push_back(knot_of(spec, i));
  }
  for (std::size_t i = 0; i < spec.segments.size(); ++i) demand_of_segment(spec, i, knots);
  for (CamKnot& knot : knots) {
    knot.geo_velocity = knot.geo_velocity.value_or(0);
    knot.geo_acceleration = knot.geo_acceleration.value_or(0);
  }
  return knots;
}

CamDesign design(const CamSpec& spec) {
  const auto knots = resolved_knots(spec);
  std::vector<Segment> segments;
  std::vector<std::size_t> origin;
  for (std::size_t i = 0; i < spec.segments.size(); ++i) {
    const CamKnot& a = knots[i];
    const CamKnot& b = knots[i + 1];
    const double length = b.master - a.master;
    const Law law = spec.segments[i].law;
    if (law == Law::quintic) {
      segments.push_back(quintic(length, a.slave, *a.geo_velocity, *a.geo_acceleration, b.slave,
                                 *b.geo_velocity, *b.geo_acceleration));
    } else if (law == Law::dwell || law == Law::line) {
      segments.push_back(line(length, a.slave, b.slave));
    } else {
      for (const Segment& piece : normalised(law))
        segments.push_back(placed(piece, length, a.slave, b.slave));
    }
    origin.resize(segments.size(), i);
  }
  return {
      Cam(std::move(segments), spec.start.master, spec.periodic ? Outside::wrap : Outside::hold),
      std::move(origin)};
}

}  // namespace jounce
