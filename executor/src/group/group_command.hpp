// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "jounce/command/commands.hpp"
#include "jounce/path/frame.hpp"

namespace jounce {

/// True for a command that ends the present motion.
[[nodiscard]] bool aborts(const ClientCommand& command);
/// True for a move in which each axis takes its own shortest time.
[[nodiscard]] bool is_fast(const ClientCommand& command);
/// True for a move that joins the one before it without a rest.
[[nodiscard]] bool blends(const ClientCommand& command);
/// A line to the target of an absolute command of `axes` coordinates. nullopt: the target depends on
/// the place where the command begins, or the command has none.
[[nodiscard]] std::optional<command::MoveLinearAbsolute> line_to_target(
    const ClientCommand& command, std::size_t axes, const Frame& frame);

}  // namespace jounce
