// SPDX-License-Identifier: Apache-2.0
// prove_paths [--count N | --total N] [--seed S] [--first K] [--workload NAME ...] [--examples N] [--list]
//
// Plans random programs and judges every motion: one line a workload, exit status 1 on any failure, 2 on bad usage.
// --count is for each workload, --total for all; --first is the number of the first case, so that --first K --count 1
// repeats one. A failure prints its number and the spec that repeats it. A long run shows its progress on stderr.
#include <chrono>
#include <cstdio>
#include <exception>
#include <vector>

#include "path/proof/workloads.hpp"
#include "support/proof_program.hpp"

namespace {

using namespace jounce::path_proof;
using Options = jounce::test::ProofOptions;
using Clock = std::chrono::steady_clock;

constexpr auto between_reports = std::chrono::seconds(30);

struct Failure {
  std::int64_t number = 0;
  Outcome outcome;
};

Outcome attempt(const Workload& w, std::uint64_t seed, std::int64_t number, Worst& worst) try {
  return run(w, seed, number, worst);
} catch (const std::exception& error) {
  return {std::string("throws: ") + error.what(), ""};
}

bool report(const Workload& w, std::int64_t count, const Options& o) {
  std::int64_t failures = 0;
  std::vector<Failure> kept;
  Worst worst;
  auto next = Clock::now() + between_reports;
  for (std::int64_t i = 0; i < count; ++i) {
    const Outcome found = attempt(w, o.seed, o.first + i, worst);
    if (!found.why.empty()) ++failures;
    if (!found.why.empty() && kept.size() < o.examples) kept.push_back({o.first + i, found});
    if (Clock::now() < next) continue;
    next += between_reports;
    std::fprintf(stderr, "%s: %lld of %lld, %lld failures\n", w.name.c_str(),
                 static_cast<long long>(i + 1), static_cast<long long>(count),
                 static_cast<long long>(failures));
  }
  std::printf("%-14s %10lld programs %6lld failures   excess %8.1e  end %.1e  deviation %.6f\n",
              w.name.c_str(), static_cast<long long>(count), static_cast<long long>(failures),
              worst.excess, worst.end, worst.wide);
  for (const Failure& f : kept)
    std::printf("# %s, seed %llu, case %lld: %s\n%s", w.name.c_str(),
                static_cast<unsigned long long>(o.seed), static_cast<long long>(f.number),
                f.outcome.why.c_str(), f.outcome.spec.c_str());
  std::fflush(stdout);
  return failures == 0;
}

}  // namespace

int main(int argc, char** argv) {
  return jounce::test::prove(
      argc, argv,
      "prove_paths [--count N | --total N] [--seed S] [--first K] [--workload NAME ...] "
      "[--examples N] [--list]",
      workloads(), report, true);
}
