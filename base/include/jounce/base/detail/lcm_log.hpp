// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "jounce/profiles/error.hpp"

namespace jounce::base_detail {

/// An event of an LCM log file (LCM's eventlog.c). All numbers are big-endian. Order of the fields:
///
///     u32 0xEDA1DA01, i64 number, i64 time stamp in us, i32 channel's length, i32 data's length,
///     channel, data
struct LcmEvent {
  std::int64_t number = 0;
  std::int64_t microseconds = 0;
  std::string channel = {};
  std::string data = {};
};

/// Appends the bytes of an event.
void append(std::string& bytes, std::int64_t number, std::int64_t microseconds,
            std::string_view channel, std::string_view data);

/// Reads one event after another, with at most one in memory.
class LcmLogReader {
 public:
  /// `in` must outlive the reader. `name`: name of the file for errors.
  LcmLogReader(std::istream& in, std::string name);

  /// Returns the next event; nullopt at the end. If the file ends within an event, returns nullopt,
  /// and cut() is true. Throws InputError if no event begins at this place, or if its lengths are
  /// impossible.
  std::optional<LcmEvent> next();

  /// True if the file ends within an event.
  [[nodiscard]] bool cut() const { return cut_; }
  [[nodiscard]] std::int64_t events() const { return events_; }  ///< number of events read so far
  [[nodiscard]] std::int64_t offset() const {
    return offset_;
  }  ///< offset of the next one, in bytes

 private:
  [[nodiscard]] bool take(std::string& bytes, std::size_t count);

  std::istream& in_;
  std::string name_;
  bool cut_ = false;
  std::int64_t events_ = 0;
  std::int64_t offset_ = 0;
};

}  // namespace jounce::base_detail
