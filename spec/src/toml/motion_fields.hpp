// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// One table of the document whose keys are positions and their rates. Each is read, by the order of its derivative (0:
/// position), into the field of its struct.
class MotionFields {
 public:
  MotionFields(TomlReader& reader, const Units& units) : reader_(&reader), units_(&units) {}

  void need(const char* key, int order, double& value);
  void may(const char* key, int order, double& value);
  std::optional<double> optional(const char* key, int order);
  /// In the unit of time of the spec, or of the controller.
  std::optional<double> optional_time(const char* key);
  void may_in(const char* key, const char* unit, double& value);

  /// from, from_velocity, from_acceleration (or to...); default: 0.
  MotionState state(const std::string& prefix);
  /// velocity, acceleration, jerk (magnitudes), each with ..._down for another value in the negative
  /// direction; position_min, position_max. A key that is left out is not limited.
  Bounds bounds();

  [[nodiscard]] TomlReader& reader() { return *reader_; }
  [[nodiscard]] const Units& units() const { return *units_; }

 private:
  [[nodiscard]] std::string unit(int order) const;
  void bound(const std::string& key, int order, double& least, double& greatest);

  TomlReader* reader_;
  const Units* units_;
};

}  // namespace jounce::spec_detail
