#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/io/make.hpp"
#include "jounce/io/report_text.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce::cli {

/// Whatever a verb was given to look at: a spec, which is made first, or a finished table.
struct Input {
  std::optional<Spec> spec;
  std::variant<Cam, Trajectory> curve;
  TableFile table;
  std::optional<SampleError>
      error;      ///< of the table against the curve; none where it is all there is
  Limits limits;  ///< of the spec; none for a table
  Labels labels;
  std::string name;  ///< the spec's name, or the file's
};

/// Everything that can be checked without integration: limits and joints of the curve, the table's
/// error, and limits that the table alone breaks.
Report check_all(const Input& input, int continuity = 1);

/// Reads a spec or a table file, told apart by the content; "-" is standard input.
Input load(const std::string& path);

}  // namespace jounce::cli
