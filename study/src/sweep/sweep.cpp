// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/study/tune.hpp"

#include "study/src/sweep/journal.hpp"

namespace jounce {
namespace {

std::vector<std::string> names_of(const SweepSpec& spec) {
  std::vector<std::string> names;
  for (const KeyFigure& f : spec.given) names.push_back(f.name);
  names.resize(names.size() - spec.chosen);
  return names;
}

/// The spec of a case, or its optimum. `chosen`: the numbers that the optimization chose.
Spec spec_of(const SweepSpec& spec, std::size_t number, std::vector<double>& chosen) {
  Spec given = spec.base.spec(spec.numbers(number));
  if (!spec.optima) return given;
  const TuneOutcome best = tune(given);
  if (!best.usable())
    throw InputError("optimize", "",
                     std::string(name(best.search.status)) + ": " + best.search.reason);
  for (const TunedNumber& n : best.numbers) chosen.push_back(n.reached);
  return parse_spec(best.text, given.document.name);
}

SweepRow impossible(const SweepSpec& spec, std::size_t number, const std::string& why) {
  return {number, std::vector<double>(spec.given.size(), std::numeric_limits<double>::quiet_NaN()),
          Verdict::impossible, printable(why)};
}

/// The worst limit that is broken, or "".
std::string broken_limit(const SweepSpec& spec, const Assessment& all) {
  if (!all.report.ok()) {
    const Finding& worst = all.report.findings.front();  // in the order of sort()
    return worst.rule.text() + (worst.axis.empty() ? "" : " (" + worst.axis + ")");
  }
  for (const SweepLimit& limit : spec.limits)
    if (!(all.value(limit.figure) <= limit.at_most))
      return limit.figure + " above " + number(limit.at_most);
  return "";
}

std::vector<std::size_t> missing(const std::vector<std::optional<SweepRow>>& rows) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!rows[i]) numbers.push_back(i);
  return numbers;
}

/// Cuts the next word off the front.
std::string_view next_word(std::string_view& rest) {
  const std::size_t end = std::min(rest.find(' '), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

template <class Number>
bool read(std::string_view word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

}  // namespace

SweepRow evaluated(const SweepSpec& spec, std::size_t number) {
  try {
    std::vector<double> chosen;
    const Assessment all = assess(spec_of(spec, number, chosen), names_of(spec));
    SweepRow row{number, {}, Verdict::within, broken_limit(spec, all)};
    if (!row.why.empty()) row.verdict = Verdict::broken;
    for (const KeyFigure& f : all.figures)
      row.figures.push_back(std::isnan(f.value) ? std::numeric_limits<double>::quiet_NaN()
                                                : f.value);
    row.figures.insert(row.figures.end(), chosen.begin(), chosen.end());
    return row;
  } catch (const InputError& error) {
    // Without the place in the text, whose numbers differ from those in the file.
    return impossible(
        spec, number,
        error.key() + (error.value().empty() ? "" : " = " + error.value()) + ": " + error.rule());
  }
}

std::string line_of(const SweepRow& row) {
  std::string line =
      std::to_string(row.number) + ' ' + std::to_string(static_cast<int>(row.verdict)) + ' ';
  for (const double value : row.figures) line += number(value) + ' ';
  return line + row.why;
}

std::optional<SweepRow> row_of(const std::string& line, const SweepSpec& spec) {
  std::string_view rest = line;
  SweepRow row;
  int verdict = 0;
  if (!read(next_word(rest), row.number) || row.number >= spec.cases() ||
      !read(next_word(rest), verdict) || verdict < 0 || verdict > 2)
    return std::nullopt;
  row.verdict = static_cast<Verdict>(verdict);
  row.figures.resize(spec.given.size());
  for (double& value : row.figures)
    if (!read(next_word(rest), value)) return std::nullopt;
  row.why = rest;
  return row;
}

Farm on_threads(unsigned jobs) {
  if (jobs == 0) jobs = std::max(1U, std::thread::hardware_concurrency());
  return
      [jobs](const std::vector<std::size_t>& numbers, const MakeLine& make, const TakeLine& take) {
        std::atomic<std::size_t> next{0};
        std::mutex taking;
        std::exception_ptr trouble;
        const auto work = [&] {
          try {
            for (std::size_t i = next++; i < numbers.size(); i = next++) {
              const std::string line = make(numbers[i]);
              const std::lock_guard lock(taking);
              if (trouble || !take(numbers[i], line)) next = numbers.size();
            }
          } catch (...) {
            const std::lock_guard lock(taking);
            if (!trouble) trouble = std::current_exception();
            next = numbers.size();
          }
        };
        {
          std::vector<std::jthread> threads;
          const std::size_t wanted = std::min<std::size_t>(jobs, numbers.size());
          for (std::size_t i = 1; i < wanted; ++i) threads.emplace_back(work);
          work();
        }
        if (trouble) std::rethrow_exception(trouble);
      };
}

SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options) {
  SweepResult result;
  std::vector<std::optional<SweepRow>> rows(spec.cases());
  std::optional<Journal> journal;
  if (!options.journal.empty()) journal.emplace(options.journal, hex(spec.identity()));
  if (journal)
    for (const std::string& line : journal->lines())
      if (auto row = row_of(line, spec); row && !rows[row->number]) {
        ++result.resumed;
        rows[row->number] = std::move(*row);
      }
  options.farm(
      missing(rows), [&](std::size_t number) { return line_of(evaluated(spec, number)); },
      [&](std::size_t number, const std::string& line) {
        if (journal) journal->append(line);
        rows[number] = row_of(line, spec).value();
        ++result.evaluated;
        return !options.keep_going ||
               options.keep_going(result.resumed + result.evaluated, rows.size());
      });
  result.complete = result.resumed + result.evaluated == rows.size();
  for (auto& row : rows)
    if (row) result.rows.push_back(std::move(*row));
  return result;
}

}  // namespace jounce
