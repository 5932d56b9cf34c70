// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

/// The shared key of an executor and its authorized senders. It is never transmitted and never on a
/// command line: it is in a file of 64 hexadecimal digits that only its owner can read.
///
///     write_new_key("line.key");                      // once; then copied to both machines
///     const wire::Key key = read_key("line.key");
///     stream_tables(link, plan, {.key = key});
namespace jounce {
namespace wire {
using Key = std::array<std::uint8_t, 32>;
}  // namespace wire

/// Throws InputError if the file cannot be read, contains anything but 64 hexadecimal digits and
/// surrounding white space, or if other users can read or write it.
wire::Key read_key(const std::filesystem::path& path);

/// Draws a key and writes it into a new file of mode 0600. Throws InputError if the file exists: a
/// key is never overwritten by accident; std::system_error if it cannot be written.
void write_new_key(const std::filesystem::path& path);

}  // namespace jounce
