// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/feasibility.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

Finding finding(const Cam& cam, const std::string& quantity, const Limits& slave,
                const MasterRange& master) {
  const MasterLimit most = greatest_master_velocity(cam, slave, master.rates);
  Finding f;
  f.rule = Rule(RuleFamily::feasible, quantity);
  f.quantity = quantity;
  f.where = most.where;
  f.value = master.velocity;
  f.limit = most.value;
  f.margin = std::isinf(most.value) ? 1 : most.value > 0 ? 1 - master.velocity / most.value : -1;
  f.broken = master.velocity > most.value * (1 + rounded_sum);
  if (!f.broken) return f;
  f.advice = most.value > 0
                 ? "slow the master down to " + six_digits_down(most.value) +
                       ", or engage over a longer distance"
                 : "no speed of the master keeps the " + quantity + " limit of the slave here";
  return f;
}

}  // namespace

Report feasibility(const Cam& cam, const Limits& slave, const MasterRange& master) {
  require_positive("velocity", master.velocity);
  require_valid(slave);
  Report report;
  for (const auto& [quantity, limit] : {std::pair{"velocity", &Limits::velocity},
                                        {"acceleration", &Limits::acceleration},
                                        {"jerk", &Limits::jerk}}) {
    if (!(slave.*limit)) continue;
    Limits one;
    one.*limit = slave.*limit;
    report.findings.push_back(finding(cam, quantity, one, master));
  }
  sort(report);
  return report;
}

}  // namespace jounce
