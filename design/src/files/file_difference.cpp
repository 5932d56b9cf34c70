// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/files/file_difference.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "jounce/design/detail/path_text.hpp"
#include "jounce/design/detail/version.hpp"
#include "jounce/path/path_length.hpp"

namespace jounce {
namespace {

bool has_two_paths(const FileDifference& difference) {
  const auto& [before, after] = difference.axes.front();
  return before.plan && after.plan;
}

/// "cam.toml has kind = \"cam\", name = \"feeder\"; ...": for two specs of different kinds or names;
/// otherwise "".
std::string identities(const FileDifference& difference) {
  const auto& [before, after] = difference.axes.front();
  if (!before.spec || !after.spec) return "";
  const auto identity = [](const Spec& spec) {
    return "has kind = \"" + spec_kind(spec.document.text) + "\", name = \"" + spec.name + '"';
  };
  const std::string old = identity(*before.spec);
  const std::string now = identity(*after.spec);
  const Comparison& files = difference.comparisons.front();
  return old == now ? "" : files.before + " " + old + "; " + files.after + " " + now + "\n";
}

}  // namespace

bool FileDifference::equal() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& each) { return each.equal(); });
}

std::vector<std::string> FileDifference::files() const {
  const auto& [before, after] = axes.front();
  std::vector<std::string> all = before.files;
  all.insert(all.end(), after.files.begin(), after.files.end());
  return all;
}

FileDifference file_difference(std::vector<Input> before, std::vector<Input> after,
                               const std::string& before_path, const std::string& after_path,
                               const std::function<Tolerance(const Labels&)>& tolerance,
                               const std::string& axis) {
  FileDifference all;
  all.axes = paired_axes(std::move(before), std::move(after), before_path, after_path, axis);
  for (const auto& [old, now] : all.axes)
    all.comparisons.push_back(
        compare(version_of(old, before_path), version_of(now, after_path), tolerance(now.labels)));
  const auto& [first, last] = all.axes.front();
  if (first.spec && last.spec)
    all.keys = take_key_changes(*first.spec, *last.spec, all.comparisons);
  return all;
}

std::string to_text(const FileDifference& difference) {
  std::string text = identities(difference);
  if (has_two_paths(difference)) {
    const auto& [before, after] = difference.axes.front();
    text += path_difference(*after.spec, *before.plan, *after.plan) + "\n";
  }
  for (std::size_t i = 0; i < difference.comparisons.size(); ++i)
    text +=
        (i == 0 ? "" : "\n") + to_text(difference.comparisons[i], 10, headline_of(difference.keys));
  return difference.keys.empty() ? text : text + "  ~ " + to_text(difference.keys) + "\n";
}

std::string to_json(const FileDifference& difference) {
  std::vector<std::pair<std::string, std::string>> documents;
  for (std::size_t i = 0; i < difference.axes.size(); ++i)
    documents.emplace_back(difference.axes[i].second.axis, to_json(difference.comparisons[i]));
  auto document = nlohmann::ordered_json::parse(axes_json(documents));
  document["equal"] = difference.equal();
  auto keys = nlohmann::ordered_json::array();
  for (const KeyChange& change : difference.keys)
    keys.push_back({{"key", change.key}, {"before", change.before}, {"after", change.after}});
  document["keys"] = std::move(keys);
  if (has_two_paths(difference)) {
    const auto& [before, after] = difference.axes.front();
    document["path"] = {
        {"durations", {before.plan->duration(), after.plan->duration()}},
        {"lengths", nlohmann::ordered_json::array(
                        {PathLength(*before.plan).whole(), PathLength(*after.plan).whole()})}};
  }
  return document.dump();
}

}  // namespace jounce
