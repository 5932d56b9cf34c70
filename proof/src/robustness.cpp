// SPDX-License-Identifier: Apache-2.0
#include "proof/src/robustness.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/parallel.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

std::string in_words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::string numbers_text(const ToleranceCase& worst) {
  std::string text;
  for (const auto& [key, value] : worst.numbers)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, rounded(value));
  return text;
}

}  // namespace

ToleranceResult robustness(const SignalView& reference, const DriveSpec& drive,
                           const ProofProgress& progress) {
  const auto farm = [&](std::size_t count, const std::function<void(std::size_t)>& body) {
    on_all_cores(count, body, progress);
  };
  return over_tolerances(reference, drive.drive, drive.options(), *drive.tolerances, farm);
}

std::string robustness_text(const ToleranceResult& result, const std::string& unit) {
  std::string text = fmt::format(
      "  {:<12} {}: {} cases{}{}\n", "tolerances", result.report.ok() ? "ok" : "BROKEN",
      result.cases, result.all_corners ? ", every corner" : "",
      result.saturated > 0 ? fmt::format(", {} of them at the torque limit", result.saturated)
                           : "");
  for (const ToleranceSpread& f : result.figures) {
    const std::string& u = f.unit == "u" ? unit : f.unit;
    text += fmt::format(
        "  {:<12} {}: {} {} with the given numbers, {} in the worst case ({:.0f} % of cases within "
        "{})\n",
        "", in_words(f.figure), rounded(f.nominal), u, rounded(f.worst.value), 99.0,
        rounded(f.most_of_all));
    text += fmt::format("  {:<12}   worst at {}\n", "", numbers_text(f.worst));
  }
  return text;
}

nlohmann::ordered_json robustness_json(const ToleranceResult& result) {
  Json figures = Json::array();
  for (const ToleranceSpread& f : result.figures) {
    Json worst = Json::object();
    for (const auto& [key, value] : f.worst.numbers) worst[key] = value;
    figures.push_back({{"figure", f.figure},
                       {"nominal", f.nominal},
                       {"least", f.least},
                       {"mean", f.mean},
                       {"deviation", f.deviation},
                       {"of_99_percent", f.most_of_all},
                       {"worst", f.worst.value},
                       {"worst_at", worst},
                       {"beyond_limit", f.beyond}});
  }
  return {{"cases", result.cases},         {"all_corners", result.all_corners},
          {"saturated", result.saturated}, {"failed", result.failed},
          {"unstable", result.unstable},   {"figures", figures}};
}

}  // namespace jounce
