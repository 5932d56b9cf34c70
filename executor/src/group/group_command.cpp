// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_command.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace jounce {

bool aborts(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.path.buffer; })
          return what.path.buffer == PathBuffer::aborting;
        return what.kind == CommandKind::group_jog;
      },
      command);
}

bool is_fast(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.fast; }) return what.fast;
        return false;
      },
      command);
}

bool blends(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.path.buffer; })
          return what.path.buffer >= PathBuffer::blending_low;
        return false;
      },
      command);
}

std::optional<command::MoveLinearAbsolute> line_to_target(const ClientCommand& command,
                                                          std::size_t axes, const Frame& frame) {
  const auto line = [&](const auto& what) -> std::optional<command::MoveLinearAbsolute> {
    if constexpr (requires {
                    what.to;
                    what.path;
                  }) {
      const auto end =
          what.to.begin() + static_cast<std::ptrdiff_t>(std::min(axes, what.to.size()));
      const auto missing =
          std::count_if(what.to.begin(), end, [](double x) { return std::isnan(x); });
      const bool none = missing == end - what.to.begin();
      if (!what.relative && !none && (missing == 0 || frame.shifts()))
        return command::MoveLinearAbsolute{.to = what.to};
    }
    return std::nullopt;
  };
  return std::visit(line, command);
}

}  // namespace jounce
