// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/vibration.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/vibration/vibration_band.hpp"

// Impulses. The free vibration has the pole s = w (-D + i sqrt(1 - D^2)). An impulse at t_i leaves
// A_i e^(s (t_n - t_i)) at the instant t_n of the last one, and a single impulse at t_n leaves 1:
//
//   (1)  V = | sum of A_i e^(s (t_n - t_i)) |
//
// which is eq. 3 of Singer & Seering. Its slope with respect to w is at most
//
//   (2)  |dV/dw| <= sum of |A_i| |-D (t_n - t_i) + i sqrt(1 - D^2) (t_n/2 - t_i)|
//
// (A common factor e^(i sqrt(1 - D^2) w t_n/2) does not change V, so times may be counted from the
// middle.)
//
// Motions. The load's deviation after a unit step of the command is -Re(c e^(st)) with c = 1 - i D
// / sqrt(1 - D^2), |c| = 1 / sqrt(1 - D^2). Superposed over the motion f, which ends at T,
//
//   (3)  |x - f(T)| <= |c| |I| at T,   I = integral of f'(t) e^(s (T - t)) dt
//
// On a segment of length L, with z = s L, a polynomial p(r) = L f' and a sine, r in [0, 1]:
//
//   (4)  phi_k(z) = integral of r^k e^(z (1 - r)) dr;  z phi_k = k phi_(k-1) - 1, z phi_0 = e^z - 1
//   (5)  integral of e^(i b r) e^(z (1 - r)) dr = (e^(ib) - e^z) / (ib - z)
//
// (4) is stable upwards for k <= |z| and downwards for k >= |z|.

namespace jounce {
namespace {

using Complex = std::complex<double>;
using profiles_detail::two_pi;
constexpr std::size_t moments = Segment::max_degree + 1;

Complex pole(const Mode& mode) {
  const double w = two_pi * mode.frequency;
  return {-mode.damping * w, std::sqrt((1 - mode.damping) * (1 + mode.damping)) * w};
}

/// phi_k by (4), for all k.
std::array<Complex, moments> phi(Complex z) {
  std::array<Complex, moments> result{};
  if (std::abs(z) > static_cast<double>(moments)) {
    result[0] = (std::exp(z) - 1.0) / z;
    for (std::size_t k = 1; k < moments; ++k)
      result[k] = (static_cast<double>(k) * result[k - 1] - 1.0) / z;
    return result;
  }
  // Downwards from a high k, at which phi_k is 1/(k + 1) to within 12/k; each step divides this
  // error by k/|z|.
  constexpr std::size_t far = 64;
  Complex f = 1.0 / static_cast<double>(far + 1);
  for (std::size_t k = far; k > 0; --k) {
    f = (1.0 + z * f) / static_cast<double>(k);
    if (k <= moments) result[k - 1] = f;
  }
  return result;
}

/// Equation (5).
Complex phi_sine(double b, Complex z) {
  const Complex d = Complex(0, b) - z;
  if (std::abs(d) > 1) return (std::exp(Complex(0, b)) - std::exp(z)) / d;
  return std::exp(z) * phi(d)[0];
}

/// Terms that are the same for all segments of one length, to the rounding of breaks.
struct Span {
  double length = 0;
  Complex z, decay;  ///< s L, e^(s L)
  std::array<Complex, moments> moment{};

  void become(double new_length, Complex s) {
    if (std::abs(new_length - length) <= 1e-14 * length) return;
    length = new_length;
    z = s * length;
    decay = std::exp(z);
    moment = phi(z);
  }
};

/// The integral (3) over one segment, with its end as T.
Complex excitation(const Segment& f, const Span& span) {
  const auto& [length, z, decay, moment] = span;
  Complex total = 0;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(f.degree); ++k)
    total += static_cast<double>(k) * f.c[k] * moment[k - 1];
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& [amplitude, b, phase] = f.sine[i];  // A b cos(b r + p), as exponentials
    const Complex turn = std::polar(1.0, phase);
    total += amplitude * b / 2 * (turn * phi_sine(b, z) + std::conj(turn) * phi_sine(-b, z));
  }
  return total;
}

struct Band {
  double low, high, residual_low, residual_high;
};

}  // namespace

void require_valid(const Mode& mode) {
  require_positive("frequency", mode.frequency);
  require_finite("damping", mode.damping);
  if (mode.damping < 0 || mode.damping >= 1)
    throw InputError("damping", mode.damping, "must be at least 0 and less than 1");
}

void require_valid(std::span<const Impulse> impulses) {
  if (impulses.empty()) throw InputError("impulses", "none", "a shaper needs at least one");
  double before = 0;
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    const std::string key = "impulse[" + std::to_string(i + 1) + "]";
    require_finite((key + ".amplitude").c_str(), impulses[i].amplitude);
    require_not_negative((key + ".time").c_str(), impulses[i].time);
    if (impulses[i].time < before)
      throw InputError(key + ".time", impulses[i].time, "times must not descend");
    before = impulses[i].time;
  }
}

double residual_vibration(std::span<const Impulse> impulses, const Mode& mode) {
  require_valid(mode);
  require_valid(impulses);
  const Complex s = pole(mode);
  Complex total = 0;
  for (const Impulse& impulse : impulses)
    total += impulse.amplitude * std::exp(s * (impulses.back().time - impulse.time));  // (1)
  return std::abs(total);
}

WorstResidual worst_residual(std::span<const Impulse> impulses, double damping, double low,
                             double high) {
  const auto residual = [&](double f) { return residual_vibration(impulses, {f, damping}); };
  WorstResidual worst{residual(low), low};
  require_valid(Mode{high, damping});
  if (low > high) throw InputError("low", low, "must not be greater than high = " + number(high));
  const double last = impulses.back().time;
  double slope = 0;  // (2), with respect to the frequency
  for (const auto& [time, amplitude] : impulses)
    slope += two_pi * std::abs(amplitude) *
             std::hypot(damping * (last - time),
                        std::sqrt((1 - damping) * (1 + damping)) * (last / 2 - time));

  const auto consider = [&](double f, double value) {
    if (value > worst.residual) worst = {value, f};
  };
  constexpr double tolerance = 1e-6;
  std::vector<Band> open{{low, high, worst.residual, residual(high)}};
  consider(high, open.front().residual_high);
  while (!open.empty()) {
    const Band band = open.back();
    open.pop_back();
    const double highest =
        (band.residual_low + band.residual_high + slope * (band.high - band.low)) / 2;
    const double middle = (band.low + band.high) / 2;
    if (highest <= worst.residual + tolerance || middle <= band.low || middle >= band.high)
      continue;
    const double at_middle = residual(middle);
    consider(middle, at_middle);
    open.push_back({band.low, middle, band.residual_low, at_middle});
    open.push_back({middle, band.high, at_middle, band.residual_high});
  }
  return worst;
}

std::complex<double> residual_phasor(const Trajectory& motion, const Mode& mode) {
  require_valid(mode);
  const Complex s = pole(mode);
  Complex total = 0;
  double before = value(motion.segments().front(), 0);
  Span span;
  for (const Segment& f : motion.segments()) {
    total += value(f, 0) - before;  // a step of the position, if there is one
    span.become(f.length, s);
    total = total * span.decay + excitation(f, span);
    before = value(f, 1);
  }
  return total / std::sqrt((1 - mode.damping) * (1 + mode.damping));  // (3)
}

double residual_vibration(const Trajectory& motion, const Mode& mode) {
  return std::abs(residual_phasor(motion, mode));
}

}  // namespace jounce
