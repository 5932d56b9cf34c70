// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/gear/follow.hpp"

/// The tables of the Googol manual's follow examples, as its code accumulates them.
namespace jounce::test {

/// Increments of master and slave, all normal but the first.
inline std::vector<PtPoint> accumulated(std::initializer_list<PtPoint> increments) {
  std::vector<PtPoint> points;
  double master = 0;
  double slave = 0;
  for (const auto& [dm, ds, type] : increments) points.push_back({master += dm, slave += ds, type});
  return points;
}

/// Example 7-6, region 2: the shear's cycle, from ratio 1 to ratio 1.
inline FollowTable shear_cycle() {
  return {
      {{1000, 1000, PtType::continued}, {4000, 3400}, {6000, 4600}, {9000, 7000}, {10000, 8000}},
      0};
}

/// Example 7-7: without end.
inline FollowTable example_7_7() {
  return {{{20000, 10000}, {40000, 30000}, {60000, 40000}}, 0};
}

/// Example 7-8: 802 segments.
inline FollowTable example_7_8(int middle = 800) {
  FollowTable table{{{20000, 10000}}};
  double master = 20000;
  double slave = 10000;
  for (int i = 0; i < middle; ++i)
    table.segments.push_back({master += 100, slave += 100, PtType::even});
  table.segments.push_back({master + 20000, slave + 10000, PtType::stop});
  return table;
}

/// Example 7-9: old table, bridge, new table.
inline FollowTable old_7_9() {
  return {accumulated({{20000, 10000}, {20000, 20000}, {20000, 10000}})};
}
inline FollowTable bridge_7_9(double third_master = 20000) {
  return {accumulated({{20000, 10000}, {20000, 20000}, {third_master, 16000}})};
}
inline FollowTable new_7_9() {
  return {accumulated({{20000, 16000, PtType::continued}, {20000, 20000}, {20000, 16000}})};
}

}  // namespace jounce::test
