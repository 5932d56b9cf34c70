// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/registration.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/rest_to_rest.hpp"

// Let e_n be the errors, s_n the steps, o_n the outstanding and a_n the applied corrections. Then
//
//   (1)  s_n = clamp(o_n + e_n, -most, most)
//   (2)  o_(n+1) = o_n + e_n - s_n,   a_(n+1) = a_n + s_n
//
// So a + o grows by exactly e_n. If |o + e| <= most, (2) leaves exactly 0 outstanding.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr double correction_resolution = 1e-10;  ///< share of the greatest correction

void require_valid(const Registration& registration, double period) {
  require_not_negative("window_from", registration.window_from);
  require_positive("window_length", registration.window_length);
  require_positive("most", registration.most);
  gear_detail::require_rest_to_rest("law", registration.law, registration.form);
  // The rounding of the sum is no way out of the period.
  if (registration.window_from + registration.window_length > period * (1 + rounded_sum))
    throw InputError("window_length", registration.window_length,
                     "must be at most " + six_digits_down(period - registration.window_from) +
                         ": the window ends within the period, which is " + number(period));
}

void require_repeats(const Cam& cam) {
  if (!repeats(cam.outside()))
    throw InputError("cam", "", "must wrap or advance: each product is one of its periods");
}

/// One product of the cam, shifted by the advance of the previous products.
Cam product(const Cam& cam, std::size_t n) {
  const double at = static_cast<double>(n);
  if (n == 0) return with(cam, Extrapolation::refuse);
  return with(shifted(cam, at * cam.length(), at * cam.advance()), Extrapolation::refuse);
}

/// The correction c over all products, added to the master. A product is a period of the phase x +
/// c(x), and takes less of the master by its step s. The window does so as well. It therefore moves
/// back by all applied corrections, and stays at the same place in the phase:
///
///   (3)  master of product n: L - s_n, window from w and l - s_n long, phases w to w + l
Cam phase_correction(const Cam& cam, const Registration& registration,
                     std::span<const double> errors, RegistrationState state) {
  std::vector<Segment> all;
  const double start = cam.start() - state.applied;
  for (const double error : errors) {
    const Registered now = corrected(registration, state, error);
    Registration window = registration;
    window.window_length -= now.step;
    for (const Segment& piece :
         correction(window, cam.length() - now.step, state.applied, now.step))
      all.push_back(piece);
    state = now.state;
  }
  return Cam(std::move(all), start);
}

void require_valid(const Cam& cam, const Registration& registration,
                   std::span<const double> errors) {
  require_repeats(cam);
  require_valid(registration, cam.length());
  if (errors.empty()) throw InputError("errors", "", "are missing: give one for each product");
}

}  // namespace

Registered corrected(const Registration& registration, const RegistrationState& state,
                     double error) {
  require_positive("most", registration.most);
  require_finite("error", error);
  const double wanted = state.outstanding + error;
  const double step = std::clamp(wanted, -registration.most, registration.most);  // (1)
  return {step, {state.applied + step, wanted - step}};                           // (2)
}

std::vector<Segment> correction(const Registration& registration, double period, double from,
                                double step) {
  require_valid(registration, period);
  if (step == 0) return {line(period, from, from)};
  const double begin = gear_detail::on_grid(registration.window_from, period);
  const double end =
      std::min(period, gear_detail::on_grid(begin + registration.window_length, period));
  std::vector<Segment> all;
  if (begin > 0) all.push_back(line(begin, from, from));
  for (const Segment& piece : gear_detail::moved(registration.law, registration.form, begin,
                                                 end - begin, period, from, from + step))
    all.push_back(piece);
  if (end < period) all.push_back(line(period - end, from + step, from + step));
  return all;
}

Cam registered(const Cam& cam, const Registration& registration, std::span<const double> errors,
               RegistrationState state) {
  require_valid(cam, registration, errors);
  std::vector<Segment> all;
  for (std::size_t n = 0; n < errors.size(); ++n) {
    const Registered now = corrected(registration, state, errors[n]);
    Cam one = product(cam, n);
    if (now.step != 0 || state.applied != 0)
      one = sum(one,
                Cam(correction(registration, cam.length(), state.applied, now.step), one.start()));
    all.insert(all.end(), one.segments().begin(), one.segments().end());
    state = now.state;
  }
  return Cam(std::move(all), cam.start());
}

Fitted<OverMaster> registered_phase(const Cam& cam, const Registration& registration,
                                    std::span<const double> errors, double tolerance,
                                    RegistrationState state) {
  require_valid(cam, registration, errors);
  if (!(registration.most < registration.window_length))
    throw InputError("most", registration.most,
                     "must be less than window_length, " + number(registration.window_length) +
                         ": the phase must not reverse");
  const Cam correct = phase_correction(cam, registration, errors, state);
  const Cam straight({line(correct.length(), correct.start(), correct.end())}, correct.start());
  return composed_within(cam, sum(straight, correct), tolerance);
}

double greatest_correction(const Cam& cam, const Registration& registration, const Limits& slave,
                           double line_speed) {
  require_positive("line_speed", line_speed);
  require_repeats(cam);
  require_valid(registration, cam.length());
  const Cam alone = with(cam, Extrapolation::refuse);
  const auto fits = [&](double step) {
    const Cam moved = sum(alone, Cam(correction(registration, cam.length(), 0, step), cam.start()));
    return greatest_master_velocity(moved, slave).value >= line_speed * (1 - rounded_sum);
  };
  const auto both = [&](double step) { return fits(step) && fits(-step); };
  if (!fits(0)) return 0;
  if (both(registration.most)) return registration.most;
  // |f + s g| <= limit is convex in s, so it holds from 0 up to one bound.
  double lo = 0;
  double hi = registration.most;
  while (hi - lo > correction_resolution * registration.most) {
    const double mid = (lo + hi) / 2;
    (both(mid) ? lo : hi) = mid;
  }
  return lo;
}

}  // namespace jounce
