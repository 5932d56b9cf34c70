// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <set>
#include <string>
#include <vector>

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

/// Number of the `total` cases of all workloads that one of them gets, by its weight.
template <class Workload>
std::int64_t share(const std::vector<Workload>& all, const Workload& workload, double total) {
  double sum = 0;
  for (const Workload& w : all) sum += w.weight;
  return static_cast<std::int64_t>(total * workload.weight / sum);
}

/// The whole program. Calls report(workload, count of its cases, options), which returns whether all cases hold, for
/// each chosen workload. `numbered`: --first applies. Returns the exit status: 1 on any failure, 2 on bad usage.
template <class Workload, class Report>
int prove(int argc, char** argv, const char* usage, const std::vector<Workload>& workloads,
          Report report, bool numbered = false) try {
  const ProofOptions o = proof_options(argc, argv);
  bool ok = true;
  std::size_t found = 0;
  for (const Workload& w : workloads) {
    if (o.list) std::printf("%-14s %s\n", w.name.c_str(), w.what.c_str());
    if (o.list || !(o.names.empty() || o.names.count(w.name) > 0)) continue;
    ++found;
    ok = report(w, o.total > 0 ? share(workloads, w, o.total) : o.count, o) && ok;
  }
  if (!o.ok || (!numbered && o.first != 0) || (!o.list && found < o.names.size())) {
    std::fprintf(stderr, "usage: %s\n", usage);
    return 2;
  }
  return ok ? 0 : 1;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 3;
}

}  // namespace jounce::test
