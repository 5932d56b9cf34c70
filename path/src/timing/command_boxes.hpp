// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/path/path.hpp"

#include "path/src/timing/stations.hpp"

namespace jounce {

/// The boxes of units within the limits of axes in commands (PathSettings::axes). These limits do not
/// change the path: the corners have their shapes before.
///
///     const CommandBoxes boxes(path, rates, program);
///     if (boxes.limited()) units = boxes.lowered(std::move(units));
class CommandBoxes {
 public:
  /// The arguments must outlive it.
  CommandBoxes(const Path& path, const Rates& rates, const Program& program);

  /// True if a command has limits of axes.
  [[nodiscard]] bool limited() const { return limited_; }
  /// Lowers the boxes of units. A unit whose start has the entry 0 begins at rest, and the last one ends
  /// at rest. An arc may get other zones.
  [[nodiscard]] std::vector<Unit> lowered(std::vector<Unit> units) const;

 private:
  [[nodiscard]] bool applies_to(const Unit& unit) const;
  [[nodiscard]] double corner_velocity(std::size_t piece) const;
  [[nodiscard]] Box line(const Unit& unit) const;

  const Path& path_;
  const Rates& rates_;
  const Program& program_;
  bool limited_;
};

}  // namespace jounce
