// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <fstream>
#include <vector>

#include <nlohmann/json.hpp>

#include "jounce/cam/laws/spline.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce::test {

/// tests/oracle/splines.json, made by splines.py there without any of our code.
inline const nlohmann::json& spline_oracle(const char* name) {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/splines.json"));
  return all.at(name);
}

/// Rows of master, slave and, if there is one, tolerance.
inline std::vector<SplinePoint> points_of(const nlohmann::json& rows) {
  std::vector<SplinePoint> points;
  for (const auto& row : rows)
    points.push_back({row[0], row[1], row.size() > 2 ? row[2] : nlohmann::json(0)});
  return points;
}

/// x, but not outside the cam: its end is the sum of its lengths, with their rounding.
inline double within(const Cam& cam, double x) {
  return std::clamp(x, cam.start(), cam.end());
}

}  // namespace jounce::test
