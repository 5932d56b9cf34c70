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
  SampleError error;  ///< of the table against the curve; zero where the table is all there is
  Limits limits;      ///< of the spec; none for a table
  Labels labels;
  std::string name;  ///< the spec's name, or the file's
};

/// Reads a spec or a table file, told apart by the content; "-" is standard input.
Input load(const std::string& path);

}  // namespace jounce::cli
