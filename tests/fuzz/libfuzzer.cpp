// SPDX-License-Identifier: Apache-2.0
// The entry that libFuzzer calls, for the target named on the compiler's command line.
#include "fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  jounce::fuzz::JOUNCE_FUZZ_TARGET({data, size});
  return 0;
}
