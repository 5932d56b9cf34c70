// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/line_follow.hpp"

#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

namespace jounce {

Trajectory line_follow(const Trajectory& master, double from, double to) {
  require_finite("from", from);
  require_finite("to", to);
  const double x0 = master.jet(master.start())[0];
  const double x1 = master.jet(master.end(), Side::left)[0];
  if (x0 == x1)
    throw InputError("master", x1, "ends at its start: the ratio of the distances is undefined");
  const double ratio = (to - from) / (x1 - x0);
  return shifted(scaled(shifted(master, 0, -x0), ratio), 0, from);
}

namespace pmc600 {

LineFollowed line_follow(const LineFollow& s) {
  for (const auto& [key, value] : {std::pair{"velocity", s.velocity},
                                   {"acceleration", s.acceleration},
                                   {"deceleration", s.deceleration},
                                   {"jerk", s.jerk}})
    require_positive(key, value);
  if (s.ipo_cycle <= 0)
    throw InputError("ipo_cycle", std::to_string(s.ipo_cycle), "must be greater than 0");
  const double end_master = s.relative ? s.start_master + s.end_master : s.end_master;
  const double end_slave = s.relative ? s.start_slave + s.end_slave : s.end_slave;
  if (end_master == s.start_master)
    throw InputError("end_master", s.end_master,
                     "is the position of the master: there is no motion to follow");
  Trajectory master = s_curve({.from = s.start_master,
                               .to = end_master,
                               .velocity = s.velocity,
                               .acceleration = s.acceleration,
                               .deceleration = s.deceleration,
                               .jerk = s.jerk})
                          .curve();
  Trajectory slave = jounce::line_follow(master, s.start_slave, end_slave);
  return {std::move(master), std::move(slave)};
}

}  // namespace pmc600
}  // namespace jounce
