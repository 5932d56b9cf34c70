// SPDX-License-Identifier: Apache-2.0
#include "cam/src/fit/rests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce::cam_detail {
namespace {

using Points = std::vector<SplinePoint>;

double lower(const SplinePoint& p) {
  return p.slave - p.tolerance;
}
double upper(const SplinePoint& p) {
  return p.slave + p.tolerance;
}

/// Extends a rest that begins at a point as far as one position is within all tolerances.
std::size_t end_of_rest(const Points& points, std::size_t first) {
  double low = lower(points[first]), high = upper(points[first]);
  std::size_t last = first;
  while (last + 1 < points.size()) {
    low = std::max(low, lower(points[last + 1]));
    high = std::min(high, upper(points[last + 1]));
    if (low > high) break;
    ++last;
  }
  return last;
}

/// The position of the slave beside a rest, seen from the rest: 1 above it, -1 below.
int direction(const Points& points, const Stretch& rest, std::size_t beside) {
  const double middle = (points[rest.first].slave + points[rest.last].slave) / 2;
  return points[beside].slave > middle ? 1 : -1;
}

/// True if the slave arrives at the rest from one side and leaves it to the same side.
bool reverses(const Points& points, const Stretch& rest) {
  if (rest.first == 0 || rest.last + 1 == points.size()) return false;
  return direction(points, rest, rest.first - 1) == direction(points, rest, rest.last + 1);
}

double length(const Points& points, const Stretch& of) {
  return points[of.last].master - points[of.first].master;
}

/// All rests that cannot be extended.
std::vector<Stretch> maximal_rests(const Points& points) {
  std::vector<Stretch> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t end = end_of_rest(points, i);
    if (all.empty() || end > all.back().last) all.push_back({i, end});
  }
  return all;
}

/// The line of least squares through points; sums count from the first point.
class LineSums {
 public:
  explicit LineSums(const Points& points) : points_(points), sums_(points.size() + 1) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i].master - points[0].master;
      const double y = points[i].slave - points[0].slave;
      const Sums& s = sums_[i];
      sums_[i + 1] = {s.x + x, s.y + y, s.xx + x * x, s.xy + x * y};
    }
  }

  /// True if the line of these points is within all their tolerances.
  [[nodiscard]] bool straight(const Stretch& of) const {
    const double n = static_cast<double>(of.last - of.first + 1);
    const Sums &a = sums_[of.first], &b = sums_[of.last + 1];
    const double x = (b.x - a.x) / n, y = (b.y - a.y) / n;
    const double slope = ((b.xy - a.xy) / n - x * y) / ((b.xx - a.xx) / n - x * x);
    for (std::size_t i = of.first; i <= of.last; ++i) {
      const double dx = points_[i].master - points_[0].master - x;
      const double dy = points_[i].slave - points_[0].slave - y;
      if (!(std::abs(dy - slope * dx) <= points_[i].tolerance)) return false;
    }
    return true;
  }

 private:
  struct Sums {
    double x = 0, y = 0, xx = 0, xy = 0;
  };
  const Points& points_;
  std::vector<Sums> sums_;
};

}  // namespace

std::vector<Stretch> rests(const MeasuredCam& measured) {
  constexpr double least_length =
      0.02;  // share of the cam: a shorter rest is one only at a reversal
  constexpr std::size_t least_points = 4;
  const Points& points = measured.points;
  const double whole = points.back().master - points.front().master;
  std::vector<Stretch> all = maximal_rests(points);
  std::erase_if(all, [&](const Stretch& rest) {
    const bool end = rest.first == 0 || rest.last + 1 == points.size();
    const bool is_long = length(points, rest) >= least_length * whole * (end ? 0.5 : 1) &&
                         rest.last - rest.first + 1 >= least_points;
    return !is_long && !reverses(points, rest);
  });
  std::stable_sort(all.begin(), all.end(), [&](const Stretch& a, const Stretch& b) {
    return length(points, a) > length(points, b);
  });
  // Beside a rest, the slave moves slowly: it is not another rest, unless the slave reverses.
  const auto is_beside = [&](const Stretch& rest, const Stretch& other) {
    const double between = std::max(points[rest.first].master - points[other.last].master,
                                    points[other.first].master - points[rest.last].master);
    return between <= (reverses(points, rest) ? 0 : length(points, rest));
  };
  std::vector<Stretch> chosen;
  for (const Stretch& rest : all)
    if (std::none_of(chosen.begin(), chosen.end(),
                     [&](const Stretch& other) { return is_beside(rest, other); }))
      chosen.push_back(rest);
  std::sort(chosen.begin(), chosen.end(),
            [](const Stretch& a, const Stretch& b) { return a.first < b.first; });
  return chosen;
}

double level(const MeasuredCam& measured, const Stretch& rest) {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t i = rest.first; i <= rest.last; ++i) {
    low = std::max(low, lower(measured.points[i]));
    high = std::min(high, upper(measured.points[i]));
    sum += measured.points[i].slave;
  }
  const double mean = sum / static_cast<double>(rest.last - rest.first + 1);
  return low <= high ? std::clamp(mean, low, high) : mean;
}

std::optional<Stretch> longest_line(const MeasuredCam& measured, const Stretch& within,
                                    double least) {
  constexpr std::size_t starts = 200;  // places at which a line may begin
  constexpr std::size_t least_points = 5;
  const Points& points = measured.points;
  const LineSums sums(points);
  const std::size_t stride = std::max<std::size_t>(1, (within.last - within.first) / starts);
  Stretch best;
  for (std::size_t first = within.first; first + 2 <= within.last; first += stride) {
    std::size_t straight = first + 1, bent = within.last + 1;
    for (std::size_t reach = 2; first + reach <= within.last; reach *= 2) {
      if (!sums.straight({first, first + reach})) {
        bent = first + reach;
        break;
      }
      straight = first + reach;
    }
    while (straight + 1 < bent) {
      const std::size_t middle = (straight + bent) / 2;
      (sums.straight({first, middle}) ? straight : bent) = middle;
    }
    if (length(points, {first, straight}) > length(points, best)) best = {first, straight};
  }
  if (best.last - best.first + 1 < least_points ||
      length(points, best) < least * length(points, within))
    return std::nullopt;
  return best;
}

}  // namespace jounce::cam_detail
