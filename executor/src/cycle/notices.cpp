// SPDX-License-Identifier: Apache-2.0
#include "executor/src/cycle/notices.hpp"

#include "jounce/command/refusal_text.hpp"

namespace jounce {

std::vector<std::string> notices_of(const Tick& before, const Tick& now, const std::string& unit) {
  std::vector<std::string> notices;
  const std::string at = " at tick " + std::to_string(now.tick);
  if (now.job != 0 && now.job != before.job) notices.push_back("started" + at);
  if (now.dropped)
    notices.push_back("the armed motion did not start" + at + ": " + text(*now.dropped, unit));
  if (now.finished > before.finished) notices.push_back("finished" + at);
  if (now.stopped > before.stopped) notices.push_back("stopped" + at);
  if (now.fault != before.fault && now.fault != Cause::none)
    notices.push_back("fault" + at + ": " + name(now.fault) + ": " + meaning(now.fault));
  if (now.registration.lost && !before.registration.lost)
    notices.push_back("registration: no mark in the last products" + at);
  return notices;
}

}  // namespace jounce
