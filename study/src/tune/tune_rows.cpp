// SPDX-License-Identifier: Apache-2.0
#include "study/src/tune/tune_rows.hpp"

#include <algorithm>
#include <map>

namespace jounce::study_detail {
namespace {

constexpr double most = 1e6;        ///< greatest margin that matters
constexpr double least = 1e-9;      ///< least violation of a broken limit
constexpr std::size_t places = 32;  ///< more segments share constraints with their neighbors

struct RuleMargin {
  double margin = most;
  bool broken = false;
};

/// The smallest margin of each rule. `check` decides what is broken, not the sign.
std::map<std::string, RuleMargin> rules_of(const Report& report) {
  std::map<std::string, RuleMargin> all;
  for (const Finding& f : report.findings) {
    if (!states_limit(f)) continue;
    RuleMargin& rule = all[rule_of(f)];
    rule.margin = std::min(rule.margin, f.margin);
    rule.broken = rule.broken || f.broken;
  }
  return all;
}

std::vector<const LimitMargin*> margins_of(const Assessment& at, const std::string& rule) {
  std::vector<const LimitMargin*> all;
  for (const LimitMargin& room : at.margins)
    if (room.rule == rule) all.push_back(&room);
  return all;
}

/// The smallest margin of each of `count` places, which contain equal numbers of segments except for rounding.
std::vector<double> by_place(const std::vector<double>& segments, std::size_t count) {
  std::vector<double> margins(count, most);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    double& margin = margins[i * count / segments.size()];
    margin = std::min(margin, segments[i]);
  }
  return margins;
}

double constraint(double margin, bool broken) {
  return broken ? -std::clamp(margin, -most, most) : -std::clamp(margin, 0.0, most);
}

/// A broken rule breaks at least one constraint, regardless of rounding.
void mark_broken(std::vector<double>& all, std::size_t from) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from);
  const auto worst = std::max_element(begin, all.end());
  if (worst != all.end()) *worst = std::max(*worst, least);
}

}  // namespace

void TuneRows::settle(const Assessment& at) {
  for (const auto& [rule, margin] : rules_of(at.report)) {
    const auto margins = margins_of(at, rule);
    for (std::size_t b = 0; b < margins.size(); ++b)
      groups_.push_back({rule, b, std::min(places, margins[b]->segments.size()), true});
    if (margins.empty()) groups_.push_back({rule});
  }
  for (const Group& group : groups_) rules_.insert(rules_.end(), group.places, group.rule);
  rules_.emplace_back();
}

std::vector<double> TuneRows::of(const Assessment& at) {
  if (rules_.empty()) settle(at);
  std::map<std::string, RuleMargin> left = rules_of(at.report);
  std::vector<double> all;
  std::size_t first = 0;  // constraint of a rule
  for (const Group& group : groups_) {
    if (group.bound == 0) first = all.size();
    const auto it = left.find(group.rule);
    const RuleMargin rule = it == left.end() ? RuleMargin{1, false} : it->second;
    const auto margins = margins_of(at, group.rule);
    const bool known = group.by_segment && group.bound < margins.size();
    for (const double margin : known ? by_place(margins[group.bound]->segments, group.places)
                                     : std::vector<double>(group.places, rule.margin))
      all.push_back(constraint(margin, rule.broken));
    const bool last = &group == &groups_.back() || (&group + 1)->rule != group.rule;
    if (last && rule.broken) mark_broken(all, first);
    if (last && it != left.end()) left.erase(it);
  }
  double others = 1;
  for (const auto& [name, rule] : left)
    others = std::min(others, rule.broken ? std::min(rule.margin, -least) : rule.margin);
  all.push_back(-others);
  return all;
}

}  // namespace jounce::study_detail
