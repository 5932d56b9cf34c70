// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Origin of a table. It is not part of the table's identity (content_hash()).
struct Provenance {
  std::string spec = {};         ///< name of the spec file; may be empty
  std::string spec_sha256 = {};  ///< SHA-256 of the spec's text, hexadecimal; may be empty
  std::string made_by = {};      ///< program and version: "jounce 0.1.0"
};

/// A table with its units and its origin, as in a file.
struct TableFile {
  Table table;                 ///< the table
  Units units = {};            ///< units of its columns
  Provenance provenance = {};  ///< its origin
};

/// Returns the name and version of this program: "jounce 0.1.0".
std::string made_by();

/// Returns the table as CSV: a head of `# key: value` lines (version of the format, rule, knots,
/// SHA-256, origin), a line of column names with units, and one line for each knot. Numbers have
/// the shortest form that reads back exactly.
std::string to_csv(const TableFile& file);
/// Returns the same content as JSON.
std::string to_json(const TableFile& file);
/// Returns the same content as an LCM event log: one event on the channel JOUNCE.table_file, whose
/// type is in io/lcm/table_file_t.lcm.
std::string to_lcm_log(const TableFile& file);
/// Returns the same content as an MCAP file: on the channel /jounce/table, one message in JSON for
/// each knot. The time of a message is the time from the first knot to its knot; for a cam,
/// successive messages are 1 ms apart.
std::string to_mcap(const TableFile& file);

/// A format of Jounce for its tables.
struct OwnForm {
  const char* name;    ///< "csv", "json", "npy", "lcm-log", "mcap"
  const char* ending;  ///< ending of its files: ".csv"
  std::string (*write)(const TableFile& file);
  bool readable;  ///< true if parse_table() reads it
};
/// Returns all formats of Jounce for its tables.
std::span<const OwnForm> own_forms();
/// Returns the format of a path by its ending; null if no format has the ending.
const OwnForm* own_form_of_path(const std::string& path);

/// Reads a table as CSV, JSON, LCM log or MCAP; the first characters determine the format. `name`
/// is the name of the file for errors. Throws InputError with file, line, key, value and rule for a
/// wrong schema or version, a missing or unknown head line, a wrong number of rows or columns, text
/// that is not a finite number, knots that do not ascend, an unknown unit, and a hash that does not
/// match the content.
TableFile parse_table(const std::string& text, const std::string& name);
/// Reads a table file.
TableFile read_table(const std::string& path);

/// True if the text begins like a table file: with `# jounce table`; with a brace, unless a letter
/// follows it (a pragma of Structured Text); or like the LCM log or the MCAP file of a table. False
/// for a spec.
bool is_table(const std::string& text);

/// Returns the content of a table file, in the readable format that the ending of the path selects;
/// CSV for any other ending. Throws InputError if a unit is missing (as in a table from another
/// maker's tool), because such a file could not be read again.
std::string table_text(const std::string& path, const TableFile& file);

/// Writes table_text() to the path: the whole file or nothing. "-" is standard output.
void write_table(const std::string& path, const TableFile& file);

}  // namespace jounce
