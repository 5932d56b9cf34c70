// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "jounce/profiles/error.hpp"

/// Keys that authenticate messages. An executor and its authorized senders share a key. A key is
/// never transmitted and never on a command line. It is stored in a file of 64 hexadecimal digits
/// that only the owner of the file can read.
///
///     write_new_key("line.key");                      // once; then copied to both machines
///     const wire::Key key = read_key("line.key");
///     stream_tables(link, plan, {.key = key});
namespace jounce {
namespace wire {
/// A secret key of 256 bits.
using Key = std::array<std::uint8_t, 32>;
}  // namespace wire

/// Reads a key file. Throws InputError if the file cannot be read, if other users can read or write
/// it, or if it contains anything but 64 hexadecimal digits with white space around them.
wire::Key read_key(const std::filesystem::path& path);

/// Writes a new random key into a new file of mode 0600. Throws InputError if the file exists, to
/// protect an existing key, and std::system_error if the file cannot be written.
void write_new_key(const std::filesystem::path& path);

}  // namespace jounce
