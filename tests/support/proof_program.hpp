// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>

namespace jounce::test {

/// Options of the programs that check random problems: tests/profiles/proof/prove and tests/path/proof/prove_paths.
struct ProofOptions {
  std::int64_t count = 100000;  ///< for each workload
  double total = 0;             ///< for all workloads, instead of count, if > 0
  std::uint64_t seed = 1;
  std::size_t examples = 5;          ///< failures to print
  std::set<std::string> names = {};  ///< workloads; empty: all
  std::int64_t first = 0;            ///< number of the first case, where a program counts them
  bool list = false;
  bool ok = true;
};

inline ProofOptions proof_options(int argc, char** argv) {
  ProofOptions o;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--list") {
      o.list = true;
      continue;
    }
    if (i + 1 == argc) {
      o.ok = false;
      break;
    }
    const char* value = argv[++i];
    if (key == "--count")
      o.count = static_cast<std::int64_t>(std::strtod(value, nullptr));
    else if (key == "--total")
      o.total = std::strtod(value, nullptr);
    else if (key == "--seed")
      o.seed = std::strtoull(value, nullptr, 10);
    else if (key == "--first")
      o.first = std::strtoll(value, nullptr, 10);
    else if (key == "--examples")
      o.examples = std::strtoull(value, nullptr, 10);
    else if (key == "--workload")
      o.names.insert(value);
    else
      o.ok = false;
  }
  return o;
}

}  // namespace jounce::test
