// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/points.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/proof/played.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {

void recording(Input input) {
  const std::string text = text_of(input);
  try {
    static_cast<void>(begins_as_points(text));
    const Points points = parse_points(text, "fuzz");
    for (const char* name : {"time", "command", "position"})
      if (points.find(name) != nullptr)
        require(points.in_unit(name, "s").size() == points.size(), "a column is whole");
  } catch (const InputError&) {
  }
  try {
    require(!read_played(text, "fuzz").empty(), "a log without a motion is refused");
  } catch (const InputError&) {
  }
}

}  // namespace jounce::fuzz
