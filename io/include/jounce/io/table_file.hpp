// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Origin of a table. It is not part of the table's identity (content_hash()).
struct Provenance {
  std::string spec;         ///< name of the spec file; may be empty
  std::string spec_sha256;  ///< SHA-256 of the spec's text, hexadecimal; may be empty
  std::string made_by;      ///< program and version: "jounce 0.1.0"
};

/// A table with its units and its origin, as in a file.
struct TableFile {
  Table table;            ///< the table
  Units units;            ///< units of its columns
  Provenance provenance;  ///< its origin
};

/// Returns the name and version of this program: "jounce 0.1.0".
std::string made_by();

/// Returns the table as CSV: a head of `# key: value` lines (version of the format, rule, knots,
/// SHA-256, origin), a line of column names with units, and one line for each knot. Numbers have
/// the shortest form that reads back exactly.
std::string to_csv(const TableFile& file);
/// Returns the same content as JSON.
std::string to_json(const TableFile& file);

/// Reads a table as CSV or JSON; the first character determines the format. `name` is the name of
/// the file for errors. Throws InputError with file, line, key, value and rule for a wrong schema
/// or version, a missing or unknown head line, a wrong number of rows or columns, text that is not
/// a finite number, knots that do not ascend, an unknown unit, and a hash that does not match the
/// content.
TableFile parse_table(const std::string& text, const std::string& name);
/// Reads a table file.
TableFile read_table(const std::string& path);

/// True if the text begins like a table file: with `# jounce table`, or with a brace, unless a
/// letter follows it (a pragma of Structured Text). False for a spec.
bool is_table(const std::string& text);

/// Returns the text of a table file: JSON if the path ends in ".json", otherwise CSV. Throws
/// InputError if a unit is missing (as in a table from another maker's tool), because such a file
/// could not be read again.
std::string table_text(const std::string& path, const TableFile& file);

/// Writes table_text() to the path: the whole file or nothing. "-" is standard output.
void write_table(const std::string& path, const TableFile& file);

}  // namespace jounce
