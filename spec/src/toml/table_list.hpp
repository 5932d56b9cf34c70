// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Changes of a list of tables in the text of a TOML document: [[knot]], or knot = [{...}, ...].
/// `key`: the key of the list, such as "segment[2].points". Everything else in the text stays. The
/// functions throw InputError if the text has no such list.
namespace jounce::spec_detail {

/// Inserts a table with the index `at`, from 0 to the number of tables. `entries`: "time = 2".
std::string with_table(const std::string& text, const std::string& key, std::size_t at,
                       const std::vector<std::string>& entries);

/// Removes the table with the index `at`; the list needs another one. Comments above it stay.
std::string without_table(const std::string& text, const std::string& key, std::size_t at);

/// Returns the number of tables.
std::size_t tables_in(const std::string& text, const std::string& key);

}  // namespace jounce::spec_detail
