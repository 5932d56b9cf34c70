// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/spec.hpp"

#include "jounce/profiles/error.hpp"
#include "jounce/spec/machine_spec.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {

void spec(Input input) {
  try {
    static_cast<void>(parse_machine(text_of(input), "fuzz"));
  } catch (const InputError& error) {
    require(error.what() != nullptr && *error.what() != '\0', "an error has words");
  }
  try {
    const Spec read = parse_spec(text_of(input), "fuzz");
    static_cast<void>(read.parts());
    static_cast<void>(read.master_period());
  } catch (const InputError& error) {
    require(error.what() != nullptr && *error.what() != '\0', "an error has words");
  }
}

}  // namespace jounce::fuzz
