// SPDX-License-Identifier: Apache-2.0
#include "edit/src/jobs/optimum_job.hpp"

#include <utility>

#include "jounce/study/optimum.hpp"

namespace jounce::edit_detail {
namespace {

Job::Outcome optimum_outcome(const Spec& given, Job& job) {
  SpecOptimum best = optimum_of(
      given, [&](double done, const std::string& step) { return job.report(done, step); });
  Job::Outcome outcome{.text = std::move(best.text), .spec = std::move(best.spec)};
  if (!outcome.spec) return outcome;
  const Spec optimized = parse_spec(*outcome.spec, given.document.name);
  outcome.text += improvement_text(given, optimized);
  outcome.broken = broken_checks(optimized);
  return outcome;
}

}  // namespace

std::unique_ptr<Job> optimum_job(const std::string& path, const std::string& text) {
  Spec spec = parse_spec(text, path);
  prepare_optimum(spec);
  return std::make_unique<Job>(
      text, [given = std::move(spec)](Job& job) { return optimum_outcome(given, job); });
}

}  // namespace jounce::edit_detail
