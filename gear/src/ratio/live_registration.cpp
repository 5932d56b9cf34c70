// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/live_registration.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

// The equations (1) to (3) are in the header.

namespace jounce {
namespace {

void require_at_most(const char* key, double value, double most, const std::string& why) {
  if (!(value <= most))
    throw InputError(key, value, "must be at most " + six_digits_down(most) + ": " + why);
}

LiveRegistrationSpec checked(LiveRegistrationSpec spec) {
  require_positive("period", spec.period);
  require_finite("mark", spec.mark);
  require_positive("window", spec.window);
  if (spec.search == 0) spec.search = spec.window;
  require_at_most("search", spec.search, spec.period / 2,
                  "half the period, so that a mark belongs to one product");
  require_at_most("window", spec.window, spec.search,
                  "the search, and half the period, so that a mark belongs to one product");
  Registration& window = spec.correction;
  require_finite("correct_from", window.window_from);
  require_positive("correct_length", window.window_length);
  require_at_most("correct_length", window.window_length, spec.period,
                  "the windows of two products must not overlap");
  require_positive("most", window.most);
  if (spec.add_to == CorrectionOf::master)
    require_at_most("most", window.most, window.window_length / 2,
                    "half of correct_length, so that the phase does not reverse");
  require_finite("ratio", spec.ratio);
  if (spec.ratio == 0) throw InputError("ratio", "0", "must not be 0");
  require_positive("gain", spec.gain);
  require_at_most("gain", spec.gain, 1, "it is the share of the error that one product corrects");
  if (spec.misses < 1)
    throw InputError("misses", std::to_string(spec.misses), "must be at least 1");
  return spec;
}

/// The law from 0 to 1 over a length of 1.
Cam unit_law(const Registration& window) {
  return Cam(correction(Registration{0, 1, 1, window.law, window.form}, 1, 0, 1), 0);
}

}  // namespace

LiveRegistration::LiveRegistration(const LiveRegistrationSpec& spec)
    : spec_(checked(spec)),
      law_(unit_law(spec.correction)),
      of_master_(spec.add_to == CorrectionOf::master) {}

void LiveRegistration::begin(double master) noexcept {
  shift_ = needed_ = applied_ = step_ = 0;
  found_ = moving_ = fresh_ = false;
  misses_ = 0;
  last_ = master;
  // The windows of these products have ended, or have begun, at this position.
  product_ = std::ceil((master - spec_.mark - spec_.search) / spec_.period) - 1;
  first_ = std::floor((master - spec_.mark + spec_.search) / spec_.period) + 1;
  correction_ = {};
  now_ = {};
}

void LiveRegistration::step(const Jet& master, double reported,
                            std::span<const double> marks) noexcept {
  const double x = master[0] - shift_;
  if (!std::isfinite(x)) return;
  for (const double mark : marks) take(mark - shift_);
  miss(reported - shift_);
  plan(x);
  Jet moved = master;
  moved[0] = x;
  correction_ = chained(at(x), moved);
  now_.correction = correction_[0];
  last_ = x;
}

void LiveRegistration::take(double mark) noexcept {
  const double expected = spec_.mark + (found_ ? now_.deviation : 0);
  const double product = std::round((mark - expected) / spec_.period);
  const double off = mark - expected - product * spec_.period;
  if (!(std::abs(off) <= reach()) || product <= product_) {
    ++now_.strays;
    return;
  }
  product_ = product;
  now_.deviation = mark - spec_.mark - product * spec_.period;  // (1)
  needed_ = -(of_master_ ? 1 : spec_.ratio) * now_.deviation;
  found_ = fresh_ = true;
  now_.lost = false;
  misses_ = 0;
  ++now_.marks;
}

/// Counts the products whose windows ended before `reported`.
void LiveRegistration::miss(double reported) noexcept {
  const double expected = spec_.mark + (found_ ? now_.deviation : 0);
  const double passed = std::ceil((reported - expected - reach()) / spec_.period) - 1;
  if (!(passed > product_)) return;
  constexpr double most = 1e9;  // after a jump of the master
  const double seen = std::clamp(passed - std::max(product_, first_ - 1), 0.0, most);
  product_ = passed;
  now_.missed += static_cast<std::int64_t>(seen);
  misses_ = static_cast<int>(std::min(misses_ + seen, most));
  if (misses_ < spec_.misses) return;
  now_.lost = true;
  found_ = false;
}

/// Ends the window of a correction, and begins the next one at its exact place.
void LiveRegistration::plan(double x) noexcept {
  if (moving_ && x >= from_ + length_) {
    applied_ += step_;
    moving_ = false;
  }
  if (moving_) return;
  const Registration& window = spec_.correction;
  const double phase = of_master_ ? applied_ : 0;
  const double product = std::floor((x + phase - window.window_from) / spec_.period);
  const double start = product * spec_.period + window.window_from - phase;
  if (!(last_ < start && start <= x) || !std::exchange(fresh_, false)) return;
  const double wanted = spec_.gain * (needed_ - applied_);
  step_ = corrected(window, {applied_, 0}, wanted).step;  // (2)
  if (step_ == 0) return;
  from_ = start;
  length_ = window.window_length - (of_master_ ? step_ : 0);
  moving_ = true;
}

/// The correction at this position of the master, and its derivatives with respect to it: (3).
Jet LiveRegistration::at(double x) const noexcept {
  if (!moving_) return {applied_, 0, 0, 0};
  Jet c = law_.jet(std::clamp((x - from_) / length_, 0.0, 1.0));
  double scale = step_;
  for (double& derivative : c) {
    derivative *= scale;
    scale /= length_;
  }
  if (x <= from_) c = {};
  c[0] += applied_;
  return c;
}

}  // namespace jounce
