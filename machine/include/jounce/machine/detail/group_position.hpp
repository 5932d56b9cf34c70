// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// A position that was converted between the coordinates of a group and its joints
/// (SMC_GroupConvertPosition).
struct ConvertedPosition {
  struct Part {
    std::string name = {};  ///< name of a joint, or of a coordinate
    double position = 0;
    std::string unit = {};
    std::string broken = {};  ///< the limit that the position exceeds; empty: none
  };
  std::vector<Part> parts = {};  ///< all joints, or all coordinates

  /// True if no part exceeds a limit.
  [[nodiscard]] bool inside() const;
  /// One line for each part: "a1 = 90 deg".
  [[nodiscard]] std::string text() const;
  /// The parts as a JSON object.
  [[nodiscard]] std::string json() const;
};

/// Converts a position by the kinematics of a group of a machine. `file`: spec of kind "machine".
/// `group`: name of the group; "": the only one. `values`: all coordinates ("x=300mm"), or all
/// joints. The kinematics determines the side of an elbow. Opens no drive and needs no executor.
/// Throws InputError for a group without kinematics, for missing and unknown names, and for a
/// position that is out of reach or singular.
ConvertedPosition converted_position(const std::string& file, const std::string& group,
                                     const std::vector<std::string>& values);

}  // namespace jounce
