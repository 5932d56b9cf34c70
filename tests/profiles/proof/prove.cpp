// SPDX-License-Identifier: Apache-2.0
// prove [--count N | --total N] [--seed S] [--workload NAME ...] [--examples N] [--list]
//
// Throws random problems at the solver and checks every answer: one line a workload, exit status 1
// on any failure, 2 on bad usage. --count is for each workload, --total for all, slow ones getting
// less; a workload named gets what it would get of all. A failure prints the C++ line that asks it again.
#include <cstdio>
#include <string>

#include "profiles/proof/workloads.hpp"
#include "support/proof_program.hpp"

namespace {

using namespace jounce::proof;

using Options = jounce::test::ProofOptions;

bool report(const Workload& w, std::int64_t count, const Options& o) {
  const Tally t = run(w, count, o.seed, o.examples);
  std::printf("%-14s %10lld cases %6lld failures %7lld ties   end %.1e  excess %.1e  longer %.1e\n",
              w.name.c_str(), static_cast<long long>(t.cases), static_cast<long long>(t.failures),
              static_cast<long long>(t.ties), t.end_error, t.excess, t.longer);
  for (const std::string& text : t.examples) std::printf("  %s\n", text.c_str());
  std::fflush(stdout);
  return t.failures == 0;
}

}  // namespace

int main(int argc, char** argv) {
  return jounce::test::prove(
      argc, argv,
      "prove [--count N | --total N] [--seed S] [--workload NAME ...] [--examples N] [--list]",
      workloads(), report);
}
