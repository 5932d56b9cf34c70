// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/figures/band_peaks.hpp"

#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

namespace jounce::optimize_detail {
namespace {

using profiles_detail::two_pi;
constexpr double samples_per_radian = 4;  ///< samples per radian of phase over the motion
constexpr int narrowings = 40;

/// One side of a band: over the frequency w at a damping, or over asin D at a frequency.
struct BandSide {
  bool over_frequency = true;
  double fixed = 0;
  double from = 0;
  double to = 0;

  [[nodiscard]] Mode mode(double q) const {
    if (over_frequency) return {q / two_pi, fixed};
    return {fixed / two_pi, std::sin(q)};
  }
  /// The phase over a motion of a given length, in radians.
  [[nodiscard]] double turn(double length) const {
    return (to - from) * length * (over_frequency ? 1 : fixed);
  }
};

std::vector<BandSide> sides_of(const ModeBand& band) {
  const double w0 = two_pi * band.low;
  const double w1 = two_pi * band.high;
  const double d0 = std::asin(band.damping_low);
  const double d1 = std::asin(band.damping_high);
  std::vector<BandSide> all{{true, band.damping_low, w0, w1}};
  if (d0 < d1) all.push_back({true, band.damping_high, w0, w1});
  if (d0 < d1) all.push_back({false, w0, d0, d1});
  if (d0 < d1 && w0 < w1) all.push_back({false, w1, d0, d1});
  return all;
}

class Peaks {
 public:
  explicit Peaks(const Trajectory& motion) : motion_(motion) {}

  void along(const BandSide& side) {
    const auto count =
        1 + static_cast<std::size_t>(std::ceil(samples_per_radian * side.turn(motion_.length()) +
                                               (side.to > side.from ? 8 : 0)));
    std::vector<double> q;
    std::vector<double> left;
    for (std::size_t i = 0; i < count; ++i) {
      q.push_back(count == 1 ? side.from
                             : side.from + (side.to - side.from) * static_cast<double>(i) /
                                               static_cast<double>(count - 1));
      left.push_back(kept(side, q.back()));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || i + 1 == count)
        found_.push_back({left[i], side.mode(q[i])});
      else if (left[i] > left[i - 1] && left[i] >= left[i + 1])
        narrow(side, q[i - 1], q[i + 1]);
    }
  }

  std::vector<WorstMode> found() && { return std::move(found_); }

 private:
  [[nodiscard]] double kept(const BandSide& side, double q) const {
    return residual_vibration(motion_, side.mode(q));
  }

  /// Golden section.
  void narrow(const BandSide& side, double a, double b) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = b - golden * (b - a), high = a + golden * (b - a);
    double at_low = kept(side, low), at_high = kept(side, high);
    for (int i = 0; i < narrowings; ++i) {
      if (at_low < at_high) {
        a = low;
        low = high;
        at_low = at_high;
        high = a + golden * (b - a);
        at_high = kept(side, high);
      } else {
        b = high;
        high = low;
        at_high = at_low;
        low = b - golden * (b - a);
        at_low = kept(side, low);
      }
    }
    found_.push_back({std::max(at_low, at_high), side.mode(at_low > at_high ? low : high)});
  }

  const Trajectory& motion_;
  std::vector<WorstMode> found_;
};

}  // namespace

std::vector<WorstMode> band_peaks(const Trajectory& motion, const ModeBand& band) {
  Peaks peaks(motion);
  for (const BandSide& side : sides_of(band)) peaks.along(side);
  return std::move(peaks).found();
}

}  // namespace jounce::optimize_detail
