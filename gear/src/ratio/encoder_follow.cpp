// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/encoder_follow.hpp"

#include <string>

#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/wide.hpp"

namespace jounce {
namespace {

const EncoderFollowSpec& valid(const EncoderFollowSpec& spec) {
  const auto require = [](const char* key, std::int64_t value, std::int64_t most,
                          const char* code) {
    if (value < 1 || value > most)
      throw InputError(key, std::to_string(value),
                       "must be between 1 and " + std::to_string(most) + code);
  };
  require("numerator", spec.numerator, 10000, "");
  require("denominator", spec.denominator, 10000, " (PMC600 error 5000)");
  require("filter", spec.filter, EncoderFollow::max_filter, " (PMC600 error 5002)");
  return spec;
}

}  // namespace

// Each increment is in the window for `filter` cycles. The ratio is divided by this number, so each
// increment counts once.
EncoderFollow::EncoderFollow(const EncoderFollowSpec& spec)
    : gear_(Gear::ratio(valid(spec).numerator, spec.denominator * spec.filter)),
      filter_(spec.filter) {}

std::int64_t EncoderFollow::step(State& state, std::int64_t encoder_increment) const {
  std::int64_t& oldest = state.window[static_cast<std::size_t>(state.next)];
  state.sum += encoder_increment - oldest;
  oldest = encoder_increment;
  state.next = (state.next + 1) % filter_;
  std::int64_t pulses = gear_.advance(state.gear, state.sum);
  if (state.cycles > 0) {
    const auto [share, part] =
        gear_detail::floor_divide(gear_detail::Wide{state.part} + state.pulses, state.over);
    state.part = part;
    state.additive -= gear_detail::narrow(share);
    --state.cycles;
    pulses += gear_detail::narrow(share);
  }
  return pulses;
}

void EncoderFollow::add(State& state, std::int64_t pulses, std::int64_t cycles) {
  if (cycles < 1) throw InputError("cycles", std::to_string(cycles), "must be at least 1");
  state.additive += pulses;
  state.cycles = state.over = cycles;
  state.pulses = state.additive;
  state.part = 0;
}

}  // namespace jounce
