// SPDX-License-Identifier: Apache-2.0
#include "proof/src/text/loop_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<LoopMargin>& margin) {
  if (!margin) return nullptr;
  return {{"value", margin->value}, {"frequency", margin->frequency}};
}

}  // namespace

std::optional<LoopStability> loop_of(const Drive& drive) {
  try {
    return loop_stability(drive);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string gain_text(const LoopStability& loop) {
  if (!loop.gain) return "";
  const bool falls = loop.stable && loop.gain->value < 0;
  return fmt::format("gain margin {:.3g} dB{} at {:.4g} Hz",
                     falls ? -loop.gain->value : loop.gain->value, falls ? " downwards" : "",
                     loop.gain->frequency);
}

std::string phase_text(const LoopStability& loop) {
  if (!loop.phase) return "";
  return fmt::format("phase margin {:.3g} deg at {:.4g} Hz", loop.phase->value,
                     loop.phase->frequency);
}

std::string stability_text(const LoopStability& loop) {
  return loop.stable ? "stable"
                     : fmt::format("unstable at {:.4g} Hz", loop.poles.front().frequency);
}

std::string loop_text(const LoopStability& loop) {
  std::string text = stability_text(loop);
  text += loop.gain ? ", " + gain_text(loop) : loop.stable ? " at any gain" : "";
  if (loop.phase) text += ", " + phase_text(loop);
  return text;
}

Json loop_json(const LoopStability& loop) {
  Json poles = Json::array();
  for (const LoopPole& p : loop.poles)
    poles.push_back({{"growth", p.growth}, {"frequency", p.frequency}, {"damping", p.damping}});
  return {{"stable", loop.stable},
          {"gain_margin", json_of(loop.gain)},
          {"phase_margin", json_of(loop.phase)},
          {"poles", poles}};
}

}  // namespace jounce
