// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

/// The key that an executor and those who may command it share. It never travels, and never stands
/// on a command line: it lies in a file of 64 hexadecimal digits that only its owner can read.
///
///     write_new_key("line.key");                      // once; then copied to both machines
///     const wire::Key key = read_key("line.key");
///     stream_tables(link, plan, {.key = key});
namespace jounce {
namespace wire {
using Key = std::array<std::uint8_t, 32>;
}  // namespace wire

/// Throws InputError for a file that cannot be read, holds anything else than 64 hexadecimal digits
/// and white space around them, or that others than its owner can read or write.
wire::Key read_key(const std::filesystem::path& path);

/// Draws a key and writes it into a new file of mode 0600. Throws InputError where the file exists:
/// a key is not overwritten by accident; std::system_error where it cannot be written.
void write_new_key(const std::filesystem::path& path);

}  // namespace jounce
