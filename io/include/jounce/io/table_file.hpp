// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Origin of a table. Not part of its identity.
struct Provenance {
  std::string spec;         ///< name of the spec file; may be empty
  std::string spec_sha256;  ///< hash of its text; may be empty
  std::string made_by;      ///< "jounce 0.1.0"
};

/// A table with units and provenance, as in a file.
struct TableFile {
  Table table;
  Units units;
  Provenance provenance;
};

/// "jounce 0.1.0".
std::string made_by();

/// CSV: a head of `# key: value` lines (schema version, rule, knots, SHA-256, provenance), a line
/// of column names with units, one line for each knot. JSON: the same as an object. Doubles are
/// written in their shortest form that reads back the same, so both formats are bit-exact.
std::string to_csv(const TableFile& file);
std::string to_json(const TableFile& file);

/// Reads either format, recognized by the first character. Throws InputError with file, line, key,
/// value and rule: wrong schema or version, a missing or unknown head line, a wrong number of rows
/// or columns, text that is not a finite number, knots that do not ascend, an unknown unit, a hash
/// that does not match the content.
TableFile parse_table(const std::string& text, const std::string& name);
TableFile read_table(const std::string& path);

/// True if the text is a table file rather than a spec.
bool is_table(const std::string& text);

/// CSV, or JSON if the path ends in ".json". Throws InputError if a unit is missing, as in a table
/// of another maker: the file could not be read back.
std::string table_text(const std::string& path, const TableFile& file);

/// Writes CSV, or JSON if the path ends in ".json". Writes the whole file or none; "-" is standard
/// output.
void write_table(const std::string& path, const TableFile& file);

}  // namespace jounce
