// SPDX-License-Identifier: Apache-2.0
// A slave behind a master at a constant velocity follows the cam itself, scaled in time: between two breaks it
// is one segment of the cam, or a part of it, forwards or backwards.

#include <cmath>
#include <vector>

#include "jounce/validate/signal_view.hpp"

namespace jounce::validate_detail {
namespace {

bool straight(const Segment& f) {
  for (int k = 2; k <= f.degree; ++k)
    if (f.c[static_cast<std::size_t>(k)] != 0) return false;
  return f.sines == 0;
}

/// The segment of the cam that contains x, and the number of advances and periods between.
struct Place {
  const Segment* segment;
  double begin;  ///< position in the segment, on the cam's own axis
  double x;      ///< the same place there
};

Place place(const Cam& cam, double x) {
  const double period = cam.length();
  const bool wraps =
      cam.outside() == Extrapolation::wrap || cam.outside() == Extrapolation::advance;
  if (wraps) x -= std::floor((x - cam.start()) / period) * period;
  const auto breaks = cam.breaks();
  std::size_t i = 0;
  while (i + 2 < breaks.size() && breaks[i + 1] <= x) ++i;
  return {&cam.segments()[i], breaks[i], x};
}

/// The interval of the cam from x0 to x1, passed within `time`, moved to begin where the slave does.
Segment cam_part(const Cam& cam, double x0, double x1, double time, double value) {
  const Place middle = place(cam, (x0 + x1) / 2);
  const Segment& f = *middle.segment;
  const double half = std::abs(x1 - x0) / 2;
  const auto share = [&](double x) {
    return std::fmin(1, std::fmax(0, (x - middle.begin) / f.length));
  };
  Segment piece = part(f, share(middle.x - half), share(middle.x + half));
  if (x1 < x0) piece = reversed(piece);
  piece.length = time;
  return scaled(piece, 1, value - jounce::value(piece, 0));
}

}  // namespace

std::optional<Trajectory> steady(const Followed& slave) {
  for (const Segment& f : slave.master().segments())
    if (!straight(f)) return std::nullopt;
  const Cam& cam = slave.cam();
  std::vector<Segment> segments;
  const auto breaks = slave.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double time = breaks[i + 1] - breaks[i];
    const double x0 = slave.master().jet(breaks[i], Side::right)[0];
    const double x1 = slave.master().jet(breaks[i + 1], Side::left)[0];
    const double value = slave.jet(breaks[i], Side::right)[0];
    const double middle = (x0 + x1) / 2;
    const bool within = middle >= cam.start() && middle <= cam.end();
    if (x0 == x1 || (!within && cam.outside() == Extrapolation::hold))
      segments.push_back(line(time, value, value));
    else
      segments.push_back(cam_part(cam, x0, x1, time, value));
  }
  return Trajectory(segments, slave.start(), Extrapolation::hold);
}

}  // namespace jounce::validate_detail
