// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace jounce {

/// Files of a recorder.
struct RecorderOptions {
  std::optional<std::filesystem::path> log = {};  ///< log of the whole run; nullopt: none
  /// Black box, written at a fault; nullopt: none.
  std::optional<std::filesystem::path> black_box = {};
  std::size_t black_box_cycles = 2000;  ///< number of cycles of each axis in the black box
  std::function<void(const std::string&)> notify = {};  ///< receives notices as text
};

}  // namespace jounce
