// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// The saved user table of a HIWIN HIMC controller (HMPL manual, chapter 11): numbers under the
/// indices of the controller. It also contains the correction tables.
///
///     UserTable table;
///     table.set(1, {-2, 0, 2, 6, 4});                      // SetUserTable
///     std::vector<double> some = table.get(3, 3, "mm");    // GetUserTable: 2, 6, 4
///     write_file("user.csv", table.text());                // SaveUserTable
///     table = read_user_table("user.csv");                 // LoadUserTable
///
/// In a file, the table is a CSV file with the columns `index` and `value`. The header may give the
/// unit of the values. An index that is not in the file has no value.
class UserTable {
 public:
  static constexpr std::int64_t size = 512'000;  ///< number of entries of a controller

  /// `unit`: unit of the values; "": the unit that the reader expects.
  explicit UserTable(std::string unit = "") : unit_(std::move(unit)) {}

  /// Sets entries from the index `start` on. Throws InputError("start", ...) outside 0 to size - 1,
  /// and InputError("value", ...) for a number that is not finite.
  void set(std::int64_t start, const std::vector<double>& values);
  /// Returns `count` entries from the index `start` on, in `unit`. Throws InputError("start", ...)
  /// if one of them has no value, and InputError("value", ...) if the unit does not convert.
  [[nodiscard]] std::vector<double> get(std::int64_t start, std::size_t count,
                                        const std::string& unit) const;
  /// The table as CSV, with all entries.
  [[nodiscard]] std::string text() const;

 private:
  std::string unit_;
  std::map<std::int64_t, double> entries_;
};

/// Reads a table from a file. Throws InputError with file and line: like read_points(), for an
/// index that is not a whole number from 0 to UserTable::size - 1, and for an index that occurs
/// twice.
UserTable read_user_table(const std::string& path);

}  // namespace jounce
