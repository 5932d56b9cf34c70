// SPDX-License-Identifier: Apache-2.0
#include "io/src/gcode/block.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "jounce/base/detail/printable.hpp"

namespace jounce::io_detail {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr const char* no_variables =
    "variables (#1) and expressions ([1+2]) are not supported: have the CAM program write numbers";

/// The letter in upper case; 0 for any other character.
char letter(char c) {
  if (c >= 'a' && c <= 'z') return static_cast<char>(c - 'a' + 'A');
  return c >= 'A' && c <= 'Z' ? c : '\0';
}

/// Reads the words of one line, from left to right.
class Line {
 public:
  Line(std::string_view text, int number) : text_(text), number_(number) {}

  std::vector<GcodeWord> words() {
    std::vector<GcodeWord> all;
    skip_spaces();
    if (at_ < text_.size() && text_[at_] == '%') {
      ++at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;  // the number of the program
      skip_comments();
      if (at_ < text_.size())
        fail(at_, shown(at_, text_.size()),
             "must not follow % on the same line: only the number of the program may follow it");
      return all;
    }
    for (skip_comments(); at_ < text_.size(); skip_comments()) all.push_back(word());
    return all;
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& value, const std::string& rule) const {
    throw InputError('"' + value + '"', "", rule).at({}, number_, static_cast<int>(at) + 1);
  }

  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  void skip_comments() {
    for (skip_spaces(); at_ < text_.size(); skip_spaces()) {
      if (text_[at_] == ';') {
        at_ = text_.size();
      } else if (text_[at_] == '(') {
        const std::size_t end = text_.find(')', at_);
        if (end == std::string_view::npos)
          fail(at_, shown(at_, text_.size()),
               "is a comment without its closing ): close it on the same line");
        at_ = end + 1;
      } else {
        return;
      }
    }
  }

  GcodeWord word() {
    const std::size_t begin = at_;
    const char first = letter(text_[at_]);
    const bool behind_number = begin > 0 && (is_digit(text_[begin - 1]) || text_[begin - 1] == '.');
    if (first == '\0') fail_without_letter(begin, behind_number);
    if (first == 'E' && behind_number)
      fail(begin, "E",
           "follows a number: G-code numbers have no exponent. Write 100000, not 1e5; put a space "
           "before E if it is an acceleration");
    if (first == 'O' && behind_number) fail(begin, "O", "follows a number: is this letter a 0?");
    if (first == 'O') require_no_subprogram(begin);
    ++at_;
    GcodeWord word{std::string(1, first), 0, "", static_cast<int>(begin) + 1};
    const bool prefix = (first == 'F' || first == 'E') && at_ < text_.size();
    if (prefix && letter(text_[at_]) == 'F') {
      word.letters += 'F';
      ++at_;
    }
    skip_spaces();
    word.text = number(begin, word.letters);
    word.value = value(begin, word.text);
    return word;
  }

  /// For a character that begins no word.
  [[noreturn]] void fail_without_letter(std::size_t at, bool behind_number) const {
    const bool is_comma =
        text_[at] == ',' && behind_number && at + 1 < text_.size() && is_digit(text_[at + 1]);
    if (text_[at] == '#' || text_[at] == '[') fail(at, shown(at, at + 1), no_variables);
    if (text_[at] == '/')
      fail(at, "/",
           "skips a block at the control, which is not supported: remove the / or the block");
    if (!is_comma)
      fail(at, shown(at, at + 1),
           "is not a G-code word: a word is a letter and a number, such as X10");
    if (const std::size_t rest = text_.find_first_not_of("0123456789", at + 1);
        rest != std::string_view::npos && text_[rest] == '.')
      fail(at, ",", "must not divide a number: write its digits without a comma");
    const std::size_t before = text_.find_last_not_of("0123456789.+-", at - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before;
    std::size_t end = at + 1;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    fail(at, shown(begin, end),
         "a number has a decimal point: write " + shown(begin, at) + '.' + shown(at + 1, end));
  }

  /// For letters without a number. `rest`: what stands in its place.
  [[noreturn]] void fail_without_number(std::size_t begin, const std::string& letters,
                                        std::size_t rest) const {
    const char next = rest < text_.size() ? text_[rest] : '\0';
    const bool computes = next == '#' || next == '[';
    std::size_t end = begin;
    while (end < text_.size() && letter(text_[end]) != '\0') ++end;
    if (end > begin + letters.size() && letter(text_[end - 1]) != 'O')
      fail(
          begin, shown(begin, end),
          "is not a G-code word: a word is one letter and a number, such as X10; conditions, loops "
          "and calls are not supported");
    fail(begin, letters + (computes ? shown(rest, rest + 1) : ""),
         "needs a number after " + letters +
             (computes              ? std::string(": ") + no_variables
              : letter(next) == 'O' ? ": is the letter O a 0?"
                                    : ", such as " + letters + "10"));
  }

  /// Rejects `o100 sub`, `o100 call`, `o101 while` and the like of LinuxCNC.
  void require_no_subprogram(std::size_t begin) const {
    const auto is_name = [](char c) {
      return letter(c) != '\0' || is_digit(c) || c == '<' || c == '>' || c == '_';
    };
    std::size_t end = begin;
    while (end < text_.size() && is_name(text_[end])) ++end;
    std::size_t next = end;
    while (next < text_.size() && is_space(text_[next])) ++next;
    if (next >= text_.size() || letter(text_[next]) == '\0') return;
    std::size_t last = next;
    while (last < text_.size() && letter(text_[last]) != '\0') ++last;
    fail(begin, shown(begin, last),
         "subprograms, loops and conditions are not supported: have the CAM program write all "
         "motions in one program");
  }

  /// The text of a number: sign, digits, one point.
  std::string number(std::size_t begin, const std::string& letters) {
    const std::size_t first = at_;
    if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
    std::size_t digits = 0;
    bool point = false;
    for (; at_ < text_.size() && (is_digit(text_[at_]) || (text_[at_] == '.' && !point)); ++at_) {
      if (text_[at_] == '.')
        point = true;
      else
        ++digits;
    }
    if (digits == 0) fail_without_number(begin, letters, first);
    return std::string(text_.substr(first, at_ - first));
  }

  [[nodiscard]] double value(std::size_t begin, std::string_view text) const {
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc() || !std::isfinite(value))
      fail(begin, std::string(text.substr(0, 40)), "must be less than 1.8e308 in magnitude");
    return value;
  }

  [[nodiscard]] std::string shown(std::size_t begin, std::size_t end) const {
    begin = std::min(begin, text_.size());
    return printable(std::string(text_.substr(begin, end - begin)));
  }

  std::string_view text_;
  int number_;
  std::size_t at_ = 0;
};

}  // namespace

const GcodeWord* GcodeBlock::find(std::string_view letters) const {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const GcodeWord& word) { return word.letters == letters; });
  return found == words.end() ? nullptr : &*found;
}

GcodeBlock read_block(std::string_view line, int number) {
  GcodeBlock block{Line(line, number).words(), number};
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    const GcodeWord& word = block.words[i];
    if (word.letters == "G" || word.letters == "M") continue;
    if (block.find(word.letters) != &word)
      throw InputError(word.letters + word.text, "",
                       "is the second " + word.letters + " of this block: remove one")
          .at({}, number, word.column);
  }
  return block;
}

}  // namespace jounce::io_detail
