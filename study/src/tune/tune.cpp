// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/tune.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/study/spec_numbers.hpp"

#include "study/src/tune/tune_rows.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
using Numbers = std::vector<double>;

std::string parameter_key(std::size_t i, const char* field) {
  return "optimize.parameter[" + std::to_string(i + 1) + "]." + field;
}

/// The spec as a function of its numbers.
class Tuned {
 public:
  explicit Tuned(const Spec& spec)
      : spec_(spec), wanted_(*spec.parameters), numbers_(spec.document) {
    for (std::size_t i = 0; i < wanted_.parameters.size(); ++i) add(i);
    names_ = {wanted_.figure};
    for (const FigureBound& bound : wanted_.require)
      if (std::find(names_.begin(), names_.end(), bound.figure) == names_.end())
        names_.push_back(bound.figure);
    if (std::find(names_.begin(), names_.end(), "margin") == names_.end())
      names_.emplace_back("margin");
  }

  [[nodiscard]] const std::vector<SearchVariable>& variables() const { return variables_; }

  [[nodiscard]] const std::string& unit(std::size_t i) const { return units_[i]; }

  [[nodiscard]] std::string text(const Numbers& x) const {
    std::vector<SpecNumbers::Change> changes;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] != variables_[i].start) changes.push_back({variables_[i].name, x[i]});
    return numbers_.text(changes);
  }

  [[nodiscard]] Assessment assessed(const Numbers& x) const {
    return assess_by_segment(parse_spec(text(x), spec_.document.name), names_);
  }

  /// Number of different designs that were made.
  [[nodiscard]] int made() const { return static_cast<int>(made_.size()); }
  /// True if no further design may be made.
  [[nodiscard]] bool is_used_up() const { return made() >= most_designs(); }
  [[nodiscard]] int most_designs() const {
    return wanted_.options.budget.evaluations.value_or(5000);
  }

  SearchAnswer operator()(const Numbers& x) {
    made_.insert(x);
    try {
      const SearchAnswer answer = answer_of(assessed(x));
      least_ = std::min(least_, answer.objective);
      most_ = std::max(most_, answer.objective);
      return answer;
    } catch (const InputError& error) {
      if (error.key() == "figure") throw named(error);
      if (error.key().starts_with("optimize.")) throw;
      return {
          0,
          {},
          false,
          error.key() + (error.value().empty() ? "" : " = " + error.value()) + ": " + error.rule()};
    }
  }

  /// True if the figure was the same for all designs, except for rounding.
  [[nodiscard]] bool is_constant() const {
    return std::isfinite(most_) && most_ - least_ <= rounded_sum * std::abs(most_);
  }

  /// The error for a figure that depends on no parameter.
  [[nodiscard]] InputError constant_figure(const TunedFigure& figure) const {
    const std::string unit = figure.unit.empty() ? "" : " " + figure.unit;
    return spec_.document.located(InputError(
        std::string("optimize.") + (wanted_.maximize ? "maximize" : "minimize"),
        '"' + wanted_.figure + '"',
        "depends on no parameter: it is " + rounded(figure.reached) + unit +
            " in all "
            "designs that were tried. Add a parameter that changes it, or choose another figure"));
  }

  /// The rule of each constraint. The required figures follow, each with its lower and then its upper bound.
  [[nodiscard]] const std::vector<std::string>& rules() const { return rows_.rules(); }

  [[nodiscard]] std::vector<TunedFigure> figures(const Assessment& at) const {
    std::vector<TunedFigure> all;
    const auto add = [&](const std::string& name) -> TunedFigure& {
      const auto f = std::find_if(at.figures.begin(), at.figures.end(),
                                  [&](const KeyFigure& each) { return each.name == name; });
      return all.emplace_back(TunedFigure{name, f->unit, {}, f->value});
    };
    add(wanted_.figure);
    for (std::size_t i = 0; i < wanted_.require.size(); ++i) {
      TunedFigure& figure = add(wanted_.require[i].figure);
      figure.at_least = bound(i, "at_least", wanted_.require[i].at_least, figure.unit);
      figure.at_most = bound(i, "at_most", wanted_.require[i].at_most, figure.unit);
    }
    return all;
  }

 private:
  /// A variable has the unit of the file, so the number that is written is the number of the search.
  void add(std::size_t i) {
    const SpecParameter& p = wanted_.parameters[i];
    const std::string written = numbers_.unit(p.key);
    const double own = written.empty() ? 1 : conversion(written, p.unit);
    const double start = numbers_.value(p.key);
    const std::string unit = p.unit.empty() || p.unit == "1" ? "" : " " + p.unit;
    if (start * own < p.lower || start * own > p.upper)
      throw spec_.document.located(
          InputError(parameter_key(i, "range"), number(p.lower) + " to " + number(p.upper) + unit,
                     "must contain " + number(start * own) + unit +
                         ", the present value in the spec, because the search starts there"));
    units_.push_back(written.empty() ? p.unit : written);
    variables_.push_back(
        {p.key, std::min(p.lower / own, start), std::max(p.upper / own, start), start});
  }

  [[nodiscard]] InputError named(const InputError& error) const {
    std::string key = std::string("optimize.") + (wanted_.maximize ? "maximize" : "minimize");
    for (std::size_t i = 0; i < wanted_.require.size(); ++i)
      if (error.value() == '"' + wanted_.require[i].figure + '"' &&
          wanted_.require[i].figure != wanted_.figure)
        key = "optimize.require[" + std::to_string(i + 1) + "].figure";
    return spec_.document.located(InputError(key, error.value(), error.rule()));
  }

  [[nodiscard]] std::optional<double> bound(std::size_t i, const char* field,
                                            const std::optional<std::string>& text,
                                            const std::string& unit) const {
    if (!text) return std::nullopt;
    try {
      return quantity(*text, unit.empty() ? "1" : unit);
    } catch (const InputError& error) {
      throw spec_.document.located(
          InputError("optimize.require[" + std::to_string(i + 1) + "]." + field, '"' + *text + '"',
                     error.rule()));
    }
  }

  /// An excess as a share of its bound, like the margin of a limit.
  static double share(double excess, double bound) {
    return bound == 0 ? excess : excess / std::abs(bound);
  }

  SearchAnswer answer_of(const Assessment& at) {
    SearchAnswer answer;
    answer.constraints = rows_.of(at);
    for (const TunedFigure& f : figures(at)) {
      if (f.at_least) answer.constraints.push_back(share(*f.at_least - f.reached, *f.at_least));
      if (f.at_most) answer.constraints.push_back(share(f.reached - *f.at_most, *f.at_most));
    }
    const double value = at.figures.front().value;
    answer.objective = wanted_.maximize ? -value : value;
    return answer;
  }

  const Spec& spec_;
  const ParametersSpec& wanted_;
  SpecNumbers numbers_;
  std::vector<SearchVariable> variables_;
  std::vector<std::string> units_;
  std::vector<std::string> names_;
  study_detail::TuneRows rows_;
  std::set<Numbers> made_;
  double least_ = std::numeric_limits<double>::infinity();  ///< least objective of all designs
  double most_ = -std::numeric_limits<double>::infinity();
};

bool meets(const SearchAnswer& answer) {
  return answer.possible && std::isfinite(answer.objective) &&
         std::all_of(answer.constraints.begin(), answer.constraints.end(),
                     [](double constraint) { return constraint <= 0; });
}

/// Rounds x to a number of digits, each entry up or down according to the bits of `how`.
Numbers rounded_to(const std::vector<SearchVariable>& variables, const Numbers& x, int digits,
                   unsigned how) {
  Numbers y = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == variables[i].start) continue;  // the file has its digits
    const double range = variables[i].upper - variables[i].lower;
    const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(range)));
    const double per_unit = std::pow(10.0, std::abs(decimals));
    const double scaled = decimals >= 0 ? x[i] * per_unit : x[i] / per_unit;
    const double whole =
        (how >> std::min<std::size_t>(i, 2) & 1U) != 0U ? std::ceil(scaled) : std::floor(scaled);
    y[i] = std::clamp(decimals >= 0 ? whole / per_unit : whole * per_unit, variables[i].lower,
                      variables[i].upper);
  }
  return y;
}

/// The greatest objective that a simpler choice may have: it costs half the tolerance.
double most_of(const SearchOutcome& best, const OptimizeOptions& options) {
  return best.answer.objective + 0.5 * options.tolerance * std::abs(best.answer.objective);
}

/// Gives a number its given value again if its change gains nothing within `most`; all numbers first, then each.
void keep_given(Tuned& tuned, double most, SearchOutcome& best) {
  const std::vector<SearchVariable>& variables = tuned.variables();
  const auto keep = [&](std::size_t from, std::size_t to) {
    Numbers x = best.best;
    for (std::size_t i = from; i < to; ++i) x[i] = variables[i].start;
    if (x == best.best || tuned.is_used_up()) return;
    const SearchAnswer answer = tuned(x);
    if (!meets(answer) || answer.objective > most) return;
    best.best = x;
    best.answer = answer;
    std::erase_if(best.at_bound, [&](std::size_t i) { return from <= i && i < to; });
  };
  keep(0, variables.size());
  for (std::size_t i = 0; i < variables.size(); ++i) keep(i, i + 1);
}

/// Rounds the best to the fewest digits that keep the objective within `most`: from three digits of the
/// range to nine.
void round_off(Tuned& tuned, double most, SearchOutcome& best) {
  const auto combinations = std::min<std::size_t>(best.best.size(), 3);
  for (int digits = 3; digits < 10; ++digits)
    for (unsigned how = 0; how < 1U << combinations; ++how) {
      if (tuned.is_used_up()) return;
      const Numbers x = rounded_to(tuned.variables(), best.best, digits, how);
      const SearchAnswer answer = tuned(x);
      if (!meets(answer)) continue;
      if (answer.objective > most) continue;
      best.best = x;
      best.answer = answer;
      return;
    }
}

/// The worst finding of a rule, as a sentence.
std::string worst_of(const Report& report, const std::string& rule, const Labels& labels) {
  const Finding* worst = nullptr;
  for (const Finding& f : report.findings)
    if (states_limit(f) && rule_of(f) == rule && (worst == nullptr || f.margin < worst->margin))
      worst = &f;
  return worst == nullptr ? rule : sentence(*worst, labels);
}

std::vector<std::string> active_of(const Tuned& tuned, const TuneOutcome& outcome,
                                   const Labels& labels) {
  std::vector<std::string> all;
  std::vector<std::string> required;
  for (const TunedFigure& f : outcome.figures) {
    if (f.at_least)
      required.push_back(f.name + " is at its minimum, " + number(*f.at_least) + " " + f.unit);
    if (f.at_most)
      required.push_back(f.name + " is at its maximum, " + number(*f.at_most) + " " + f.unit);
  }
  const std::size_t rules = tuned.rules().size();
  for (const std::size_t i : outcome.search.met) {
    if (i >= rules) all.push_back(required.at(i - rules));
    if (i >= rules || tuned.rules()[i].empty()) continue;
    std::string worst = worst_of(outcome.report, tuned.rules()[i], labels);
    if (std::find(all.begin(), all.end(), worst) == all.end()) all.push_back(std::move(worst));
  }
  for (const TunedNumber& n : outcome.numbers)
    if (n.at_bound)
      all.push_back(n.key + " is at the end of its range, " + number(n.reached) +
                    (n.unit == "1" ? "" : " " + n.unit));
  if (!outcome.search.beyond.empty())
    all.push_back("a step beyond is rejected: " + outcome.search.beyond);
  return all;
}

void add_numbers(const Tuned& tuned, TuneOutcome& outcome) {
  const auto& bounds = outcome.search.at_bound;
  for (std::size_t i = 0; i < tuned.variables().size(); ++i) {
    const SearchVariable& v = tuned.variables()[i];
    outcome.numbers.push_back({v.name, tuned.unit(i), v.start, outcome.search.best[i], v.lower,
                               v.upper,
                               std::find(bounds.begin(), bounds.end(), i) != bounds.end()});
  }
}

/// The required figures that are not met, as sentences.
std::vector<std::string> missed_of(const std::vector<TunedFigure>& figures) {
  std::vector<std::string> all;
  const auto add = [&](const TunedFigure& f, const char* bound, double limit) {
    all.push_back(f.name + " comes to " + number(f.reached) + " " + f.unit + ": " + bound + " " +
                  number(limit) + " is required");
  };
  for (const TunedFigure& f : figures) {
    if (f.at_least && f.reached < *f.at_least) add(f, "at least", *f.at_least);
    if (f.at_most && f.reached > *f.at_most) add(f, "at most", *f.at_most);
  }
  return all;
}

/// The figures of the given spec; none if it cannot be made.
std::vector<TunedFigure> given_figures(Tuned& tuned) {
  Numbers start;
  for (const SearchVariable& v : tuned.variables()) start.push_back(v.start);
  if (!tuned(start).possible) return {};
  return tuned.figures(tuned.assessed(start));
}

bool is_same(const SearchAnswer& a, const SearchAnswer& b) {
  const auto close = [](double x, double y) {
    return x == y || std::abs(x - y) <= rounded_sum * std::max(std::abs(x), std::abs(y));
  };
  return a.possible && b.possible && close(a.objective, b.objective) &&
         std::equal(a.constraints.begin(), a.constraints.end(), b.constraints.begin(),
                    b.constraints.end(), close);
}

/// The variables on which no answer depends, at the present values of the others.
std::vector<std::size_t> idle_variables(Tuned& tuned) {
  const std::vector<SearchVariable>& variables = tuned.variables();
  Numbers start;
  for (const SearchVariable& v : variables) start.push_back(v.start);
  const SearchAnswer present = tuned(start);
  std::vector<std::size_t> idle;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    constexpr std::array shares{0.0, 1.0, 0.5, 0.2};
    const SearchVariable& v = variables[i];
    if (std::all_of(shares.begin(), shares.end(), [&](double share) {
          Numbers x = start;
          x[i] = v.lower + share * (v.upper - v.lower);
          return is_same(tuned(x), present);
        }))
      idle.push_back(i);
  }
  return idle;
}

/// The greatest number of designs of idle_variables().
int most_idle_designs(const Tuned& tuned) {
  return 1 + 4 * static_cast<int>(tuned.variables().size());
}

/// The options of a search that leaves some of the designs to round_off() and to keep_given().
OptimizeOptions options_of_search(const Tuned& tuned, OptimizeOptions options) {
  const std::size_t n = tuned.variables().size();
  const int rounding = static_cast<int>(n + 1 + (std::size_t{7} << std::min<std::size_t>(n, 3)));
  const int rest = tuned.most_designs() - tuned.made() + 1;  // its start is made already
  options.budget.evaluations = std::max(1, rest - std::min(rest / 8, rounding));
  return options;
}

double worst_of(const SearchAnswer& answer) {
  return *std::max_element(answer.constraints.begin(), answer.constraints.end());
}

/// Searches for the design whose greatest excess, as a share of its limit, is least. It is a variable t
/// of this search: the least t so that no excess is greater.
void reduce_excess(Tuned& tuned, const OptimizeOptions& given, const KeepGoing& keep_going,
                   SearchOutcome& best) {
  if (!best.answer.possible || tuned.is_used_up()) return;
  std::vector<SearchVariable> variables = tuned.variables();
  for (std::size_t i = 0; i < variables.size(); ++i) variables[i].start = best.best[i];
  const double worst = worst_of(best.answer);
  variables.push_back({"excess", 0, worst, worst});
  SearchAnswer answer;
  Numbers made;
  const auto excess = [&](const Numbers& all) {
    const Numbers x(all.begin(), all.end() - 1);
    if (x != made) answer = tuned(x);
    made = x;
    SearchAnswer shifted = answer;
    shifted.objective = all.back();
    for (double& constraint : shifted.constraints) constraint -= all.back();
    return shifted;
  };
  OptimizeOptions options = given;
  options.budget.evaluations = tuned.most_designs() - tuned.made();
  const SearchOutcome least = search(variables, excess, options, keep_going);
  const Numbers x(least.best.begin(), least.best.end() - 1);
  const SearchAnswer at = tuned(x);
  if (!at.possible || worst_of(at) >= worst) return;
  best.best = x;
  best.answer = at;
  std::erase_if(best.at_bound, [&](std::size_t i) {
    return x[i] != variables[i].lower && x[i] != variables[i].upper;
  });
}

}  // namespace

std::vector<std::size_t> idle_parameters(const Spec& spec) {
  if (!spec.parameters) throw nothing_free(spec);
  Tuned tuned(spec);
  return idle_variables(tuned);
}

TuneOutcome tune(const Spec& spec, const KeepGoing& keep_going) {
  if (!spec.parameters) throw nothing_free(spec);
  Tuned tuned(spec);
  const std::vector<TunedFigure> given = given_figures(tuned);
  if (!given.empty() && most_idle_designs(tuned) < tuned.most_designs() / 8 &&
      idle_variables(tuned).size() == tuned.variables().size())
    throw tuned.constant_figure(given.front());
  TuneOutcome outcome;
  const OptimizeOptions options = options_of_search(tuned, spec.parameters->options);
  outcome.search = search(tuned.variables(), std::ref(tuned), options, keep_going);
  if (outcome.search.evaluations > *options.budget.evaluations)
    outcome.search.reason =
        "the limit of " + counted(tuned.most_designs(), "evaluation") + " is reached";
  if (outcome.search.status == OptimizeStatus::converged && tuned.is_constant() &&
      outcome.search.evaluations > 1)
    throw tuned.constant_figure(tuned.figures(tuned.assessed(outcome.search.best)).front());
  const bool cancelled = outcome.search.status == OptimizeStatus::cancelled;
  if (outcome.search.status == OptimizeStatus::infeasible)
    reduce_excess(tuned, spec.parameters->options, keep_going, outcome.search);
  if (outcome.usable() && !cancelled) {
    const double most = most_of(outcome.search, spec.parameters->options);
    keep_given(tuned, most, outcome.search);
    round_off(tuned, most, outcome.search);
  }
  outcome.search.evaluations = tuned.made();
  add_numbers(tuned, outcome);
  outcome.text = tuned.text(outcome.search.best);
  if (!outcome.search.answer.possible) return outcome;
  const Assessment best = tuned.assessed(outcome.search.best);
  outcome.report = best.report;
  outcome.figures = tuned.figures(best);
  for (std::size_t i = 0; i < given.size(); ++i) outcome.figures[i].given = given[i].reached;
  if (!outcome.usable()) {
    if (outcome.search.status == OptimizeStatus::infeasible)
      outcome.search.reason = "none of the designs that were tried keeps all limits";
    outcome.active = missed_of(outcome.figures);
    return outcome;
  }
  outcome.active = active_of(tuned, outcome, {spec.units, spec.over_master(), {}});
  return outcome;
}

}  // namespace jounce
