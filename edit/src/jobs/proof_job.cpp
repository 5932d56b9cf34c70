// SPDX-License-Identifier: Apache-2.0
#include "edit/src/jobs/proof_job.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "jounce/design/input.hpp"
#include "jounce/proof/proof.hpp"
#include "jounce/validate/integration_watch.hpp"

namespace jounce::edit_detail {
namespace {

constexpr std::size_t steps_of_a_report = 500;

/// Proves all axes. A stopped job ends within a step of an integration, or a case of the tolerances.
Job::Outcome proof_outcome(const std::vector<Input>& axes, Job& job) {
  Job::Outcome outcome{.ok = true};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Input& input = axes[i];
    const std::string axis = axes.size() > 1 ? input.name + ": " : "";
    const auto show = [&](double share, const std::string& step) {
      const double done = (static_cast<double>(i) + share) / static_cast<double>(axes.size());
      if (!job.report(done, axis + step)) throw std::runtime_error("stopped: nothing is proven");
    };
    std::size_t steps = 0;
    const IntegrationWatch watch([&] {
      if (++steps % steps_of_a_report == 0 || job.is_stopped())
        show(0, fmt::format("{} steps of the integration", steps));
    });
    show(0, "integration");
    const Proof proof =
        prove(input, {.progress = [&](double share) { show(share, "tolerances"); }});
    outcome.ok = outcome.ok && proof.report.ok();
    outcome.text += proof_answer(proof, input);
  }
  return outcome;
}

}  // namespace

std::unique_ptr<Job> proof_job(const std::string& path, const std::string& text) {
  std::vector<Input> axes = inputs_of(parse_spec(text, path), path);
  return std::make_unique<Job>(
      text, [given = std::move(axes)](Job& job) { return proof_outcome(given, job); });
}

}  // namespace jounce::edit_detail
