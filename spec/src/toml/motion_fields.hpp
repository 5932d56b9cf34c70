// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// Reads the numbers of one table of the document whose keys are positions and their rates. Each
/// number goes into a field of the table's struct; the order of its derivative (0: position)
/// determines its unit.
class MotionFields {
 public:
  MotionFields(TomlReader& reader, const Units& units) : reader_(&reader), units_(&units) {}

  void need(const char* key, int order, double& value);
  /// The same for a number that must be greater than 0.
  void need_positive(const char* key, int order, double& value);
  void may(const char* key, int order, double& value);
  void may_positive(const char* key, int order, double& value);
  std::optional<double> optional(const char* key, int order);
  /// Reads a time, in the unit of time of the spec or of the controller.
  std::optional<double> optional_time(const char* key);
  void may_in(const char* key, const char* unit, double& value);

  /// Reads from, from_velocity, from_acceleration (or to, ...); default: 0.
  MotionState state(const std::string& prefix);
  /// Reads velocity, acceleration, jerk (magnitudes); each with ..._down for another value in the
  /// negative direction; position_min, position_max. An omitted key is no limit.
  Bounds bounds();

  [[nodiscard]] TomlReader& reader() { return *reader_; }
  [[nodiscard]] const Units& units() const { return *units_; }
  [[nodiscard]] std::string unit(int order) const;

 private:
  void bound(const std::string& key, int order, double& least, double& greatest);

  TomlReader* reader_;
  const Units* units_;
};

}  // namespace jounce::spec_detail
