// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "jounce/base/input_errors.hpp"
#include "jounce/base/units.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {
namespace {

/// The name of the element that is `step` elements after that of `key`, such as "segment[3].end.master"; "" if `key` is
/// in no list.
std::string neighbor(const std::string& key, int step) {
  const auto open = key.rfind('[');
  if (open == std::string::npos) return "";
  int index = 0;
  const auto [end, bad] = std::from_chars(key.data() + open + 1, key.data() + key.size(), index);
  if (bad != std::errc() || index + step < 1) return "";
  return key.substr(0, open + 1) + std::to_string(index + step) + end;
}

/// The name as toml::at_path() needs it: it counts elements from 0.
std::string from_zero(const std::string& key) {
  std::string name;
  for (std::size_t i = 0; i < key.size();) {
    name += key[i++];
    if (name.back() != '[') continue;
    int index = 0;
    const auto [end, bad] = std::from_chars(key.data() + i, key.data() + key.size(), index);
    if (bad != std::errc()) return "";
    name += std::to_string(index - 1);
    i = static_cast<std::size_t>(end - key.data());
  }
  return name;
}

/// The number under a full name, in `unit`; nullopt if there is none.
std::optional<double> number_at(const toml::table& root, const std::string& key,
                                const std::string& unit) {
  if (key.empty()) return std::nullopt;
  const auto node = toml::at_path(root, from_zero(key));
  if (const auto text = node.value_exact<std::string>()) {
    try {
      return quantity(*text, unit);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }
  const auto value = node.value<double>();
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

bool ErrorList::add(const InputError& error) {
  if (!found_.places.emplace(error.document(), error.line(), error.column(), error.key()).second)
    return false;
  found_.errors.push_back(error);
  if (found_.errors.size() == most) throw TooManyErrors{};
  return true;
}

void ErrorList::end_part(const InputError& error) {
  bool known = is_faulty(error.key());
  for (const std::string& table : ignored_) known = known || error.key().starts_with(table);
  uncertain_ = uncertain_ || placeholders_ > 0;
  if (known || !add(error)) {
    ++found_.unread;
    return;
  }
  faulty_.insert(error.key());
  ended_ = true;
}

bool ErrorList::again() {
  placeholders_ = 0;
  if (std::exchange(ended_, false) && ++passes_ < most_passes) {
    found_.unread = 0;
    return true;
  }
  const auto rank = [](const Result& r) { return std::pair(r.unread, r.errors.size()); };
  const bool certain = !std::exchange(uncertain_, false) && found_.unread == 0;
  if (!best_ || rank(found_) < rank(*best_)) best_ = std::move(found_);
  found_ = {};
  faulty_.clear();
  ignored_.clear();
  return !certain && ++guess_ < guesses_ && ++passes_ < most_passes;
}

void ErrorList::throw_any() const {
  std::vector<InputError> all;
  std::copy_if(best_->errors.begin(), best_->errors.end(), std::back_inserter(all),
               [&](const InputError& error) {
                 return !error.value().empty() || !misspelled_.contains(error.key());
               });
  if (all.size() == 1) throw InputError(all.front());
  if (all.size() > 1) throw InputErrors(all);
}

void ErrorList::throw_all() {
  throw InputErrors(std::move(found_.errors));
}

double ErrorList::number(const std::string& key, const std::string& unit) {
  if (guess_ == 0) {
    const auto before = number_at(*root_, neighbor(key, -1), unit);
    const auto after = number_at(*root_, neighbor(key, 1), unit);
    if (before && after) return (*before + *after) / 2;
    if (before) return *before + std::max(1.0, std::abs(*before));
    if (after) return *after - std::max(1.0, std::abs(*after));
    return 1;
  }
  constexpr std::array values{1e3, 1e6, 1e-3, 10.0, 0.0, -1.0};
  // The same value for all keys, then another one for each key. The sets for more words have positive values only.
  const std::size_t other = guess_ > values.size() ? key.size() : 0;
  const std::size_t count = guess_ < least_guesses ? values.size() : values.size() - 2;
  return values[(guess_ - 1 + other) % count];
}

std::size_t ErrorList::choice(std::size_t count) {
  constexpr std::size_t most_words = 40;
  uncertain_ = true;
  guesses_ = std::max(guesses_, 2 * std::min(count, most_words));  // each word with two numbers
  return guess_ % count;
}

}  // namespace jounce::spec_detail
