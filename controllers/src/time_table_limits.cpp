// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/detail/time_table_limits.hpp"

#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string key(const char* of, std::size_t i) {
  return std::string(of) + "[" + std::to_string(i + 1) + "].time";
}

}  // namespace

void googol::require_pt(std::span<const PtPoint> points, std::size_t loops) {
  double before = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double whole = std::trunc(points[i].x);
    if (whole > largest_long)
      throw InputError(key("point", i), points[i].x,
                       "must be at most 2147483647 ms: GT_PtData takes a long of 32 bits");
    if (whole != points[i].x) {
      std::string rule =
          "must be a whole number of ms: GT_PtData would take " + number(whole) + " ms";
      if (!(whole > before)) rule += ", and the table would never advance";
      throw InputError(key("point", i), points[i].x, rule);
    }
    before = whole;
  }
  if (loops != 1 && points.size() > pt_fifo)
    throw InputError(
        "loops", std::to_string(loops),
        "must be 1: only a table in one FIFO can repeat, and the FIFO holds 1024 segments, not " +
            std::to_string(points.size()));
}

std::string googol::broken_follow_rule(double master) {
  if (std::trunc(master) != master)
    return "must be a whole number of pulses: GT_FollowData takes a long";
  if (std::abs(master) > largest_long)
    return "must be at most 2147483647 pulses: GT_FollowData takes a long of 32 bits";
  return "";
}

const char* himc::pvt_limit_error(const std::string& quantity) {
  if (quantity == "velocity") return "0x83aa08a2";
  return quantity == "acceleration" ? "0x83aa08ac" : "";
}

void himc::require_pvt(std::span<const double> x) {
  if (x.size() > pvt_points)
    throw InputError("knot", std::to_string(x.size()) + " knots",
                     "must be at most 50, the greatest number for MovePVT of HIMC");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i == 0 ? x[i] == 0 : x[i] > x[i - 1]) continue;
    throw InputError(key("knot", i), x[i],
                     (i == 0 ? std::string("must be 0")
                             : "must be greater than " + number(x[i - 1]) + ", the previous knot") +
                         " (HIMC error 0x83aa08b6, PVT time sequence)");
  }
}

}  // namespace jounce
