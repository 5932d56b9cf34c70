// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/points.hpp"

#include <array>
#include <cmath>

#include "jounce/io/drawing.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "fuzz/memory_file.hpp"

namespace jounce::fuzz {
namespace {

/// The specs whose points may stand in a file of their own.
constexpr std::array kinds{
    R"(kind = "pt"
units = { position = "mm", time = "ms" }
)",
    R"(kind = "pt"
units = { position = "pulse", time = "ms" }
pt = { controller = "googol", increments = true }
)",
    R"(kind = "pvt"
units = { position = "mm", time = "s" }
)",
    R"(kind = "pvt"
units = { position = "deg", time = "s" }
velocities = "monotone"
)",
    R"(kind = "pvt"
units = { position = "deg", time = "s" }
table = { rule = "linear" }
)"};

void parse_drawing(const std::string& text) {
  for (const char* name : {"fuzz.dxf", "fuzz.dxf#0", "fuzz.svg#cam"}) try {
      const Outline outline = parse_outline(text, name);
      require(outline.pieces.size() > 1, "a curve has vertices");
      for (const Vertex& v : outline.pieces)
        require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.bulge),
                "a vertex is finite");
    } catch (const InputError&) {
    }
}

void parse(const std::string& text) {
  try {
    const Points points = parse_points(text, "fuzz");
    require(points.size() > 0 && !points.columns.empty(), "points without a point are refused");
    for (const PointColumn& column : points.columns) {
      require(column.values.size() + column.words.size() == points.size(), "a column is whole");
      for (const double each : column.values) require(std::isfinite(each), "a number is finite");
    }
  } catch (const InputError&) {
  }
}

}  // namespace

void points(Input input) {
  Source source(input);
  const std::string kind = kinds[source.below(kinds.size())];
  const Input content = source.take(input.size());
  parse(text_of(content));
  parse_drawing(text_of(content));
  const MemoryFile file(content);
  try {
    static_cast<void>(
        parse_spec("jounce = 1\npoints = \"" + file.path() + "\"\n" + kind, "fuzz").parts());
  } catch (const InputError& error) {
    require(error.what() != nullptr && *error.what() != '\0', "an error has words");
  }
}

}  // namespace jounce::fuzz
