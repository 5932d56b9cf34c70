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
  std::string name;           ///< the spec's name with the axis', or the file's
  std::string axis;           ///< where there are several; otherwise ""
  TableOptions options = {};  ///< by which the table was made
  std::optional<DriveSpec> drive = {};
  std::vector<Residual> residuals = {};
  std::vector<SyncZone> zones = {};
  std::optional<Binding> binding = {};  ///< of a table of fewest knots
};

/// Everything that can be checked without integration: limits and joints of the curve, the table's
/// error, and limits that the table alone breaks.
Report check_all(const Input& input, int continuity = 1);

/// Reads a spec, a table file or another maker's (see exchange.hpp), told apart by the content; "-"
/// is standard input. One input for each axis; only the one named if `axis` is not empty.
std::vector<Input> load_axes(const std::string& path, const std::string& axis = "",
                             bool decimal_comma = false);

/// The same for verbs that take one axis. Throws InputError where there are several and none is
/// named.
Input load(const std::string& path, const std::string& axis = "", bool decimal_comma = false);

/// What is compared with an input: the only axis of the file, or that of the same name.
Input load_beside(const std::string& path, const Input& input);

}  // namespace jounce::cli
