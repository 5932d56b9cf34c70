#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <limits>
#include <utility>

#include "jounce/io/detail/exchange_parts.hpp"
#include "jounce/profiles/error.hpp"

// A cam as CODESYS SoftMotion declares it (library SM3_Basic, MC_CAM_REF and SMC_CAMXYVA): an array
// of points, each with dX (master), dY (slave), dV = dY/dX and dA = d2Y/dX2, and a reference to it.
namespace jounce::detail {
namespace {

constexpr std::array fields{"dX", "dY", "dV", "dA"};
constexpr std::size_t most_points =
    std::numeric_limits<std::int16_t>::max();  // nElements is an INT

/// A REAL literal of IEC 61131-3, which has a decimal point.
std::string real(double value) {
  std::string text = number(value);
  if (text.find('.') != text.npos) return text;
  const auto e = text.find('e');
  return text.insert(e == text.npos ? text.size() : e, ".0");
}

/// The text with blanks for its comments, as long and with the same lines.
std::string without_comments(std::string text) {
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, text.size()); ++i)
      if (text[i] != '\n') text[i] = ' ';
  };
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text.compare(i, 2, "//") == 0) blank(i, text.find('\n', i));
    if (text.compare(i, 2, "(*") == 0) {
      const auto end = text.find("*)", i + 2);
      blank(i, end == text.npos ? end : end + 2);
    }
  }
  return text;
}

/// Reads words and signs one after another, and knows its line.
class Tokens {
 public:
  Tokens(const std::string& text, const Place& place) : text_(text), place_(place) {}

  /// The next word, number, ":=" or sign; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
      line_ += text_[at_++] == '\n' ? 1 : 0;
    const std::size_t first = at_;
    if (at_ < text_.size() && is_word(at_)) {
      while (at_ < text_.size() && is_word(at_)) ++at_;
    } else if (text_.compare(at_, 2, ":=") == 0 || text_.compare(at_, 2, "..") == 0) {
      at_ += 2;
    } else if (at_ < text_.size()) {
      ++at_;
    }
    return std::string_view(text_).substr(first, at_ - first);
  }
  void expect(std::string_view wanted) {
    if (const auto found = next(); found != wanted)
      fail("", found,
           "must be `" + std::string(wanted) + "`" +
               (found.empty() ? ": is the file complete?" : ""));
  }
  [[nodiscard]] double number(const std::string& key) {
    const auto found = next();
    return place_.number(line_, key, found);
  }
  [[noreturn]] void fail(const std::string& key, std::string_view value,
                         const std::string& rule) const {
    place_.fail(line_, key, value, rule);
  }
  [[nodiscard]] int line() const { return line_; }

 private:
  /// Letters, digits, and the signs and points of numbers; not the `..` of a range.
  [[nodiscard]] bool is_word(std::size_t i) const {
    const char c = text_[i];
    if (c == '.') return text_.compare(i, 2, "..") != 0 && (i == 0 || text_[i - 1] != '.');
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '+';
  }

  const std::string& text_;
  const Place& place_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// `(dX := 0, dY := 0, ...)` after its parenthesis; what is left out is 0, as in the language.
std::array<double, 4> point(Tokens& tokens) {
  std::array<double, 4> values{};
  std::array<bool, 4> given{};
  for (std::string_view sign = ","; sign == ",";) {
    const auto word = tokens.next();
    const auto field = std::find(fields.begin(), fields.end(), word);
    if (field == fields.end()) tokens.fail("point", word, "must be one of dX, dY, dV, dA");
    const auto i = static_cast<std::size_t>(field - fields.begin());
    if (std::exchange(given[i], true)) tokens.fail(*field, "", "stands twice");
    tokens.expect(":=");
    values[i] = tokens.number(*field);
    sign = tokens.next();
    if (sign != "," && sign != ")")
      tokens.fail("point", sign,
                  sign.empty() ? "ends: is the file complete?" : "must be `,` or `)`");
  }
  return values;
}

void read_points(Tokens& tokens, Exchanged& read) {
  tokens.expect(":=");
  tokens.expect("[");
  for (std::string_view sign = ","; sign == ",";) {
    tokens.expect("(");
    const int line = tokens.line();
    const auto [x, y, v, a] = point(tokens);
    read.columns.x.push_back(x);
    read.columns.p.push_back(y);
    read.columns.v.push_back(v);
    read.columns.a.push_back(a);
    read.lines.push_back(line);
    sign = tokens.next();
    if (sign != "," && sign != "]")
      tokens.fail("points", sign,
                  sign.empty() ? "end: is the file complete?" : "must be `,` or `]`");
  }
}

}  // namespace

Exchanged parse_st(const std::string& text, const Place& place) {
  const std::string code = without_comments(text);
  Tokens tokens(code, place);
  Exchanged read;
  double bounds = -1;  // points that the array has
  for (std::string_view word = tokens.next(); !word.empty(); word = tokens.next()) {
    if (word == "ARRAY") {
      tokens.expect("[");
      const double first = tokens.number("ARRAY");
      tokens.expect("..");
      bounds = tokens.number("ARRAY") - first + 1;
    } else if (word == "SMC_CAMXYVA") {
      if (!read.lines.empty()) tokens.fail("SMC_CAMXYVA", "", "stands twice: one file, one cam");
      read_points(tokens, read);
      if (bounds != static_cast<double>(read.lines.size()))
        tokens.fail("ARRAY", jounce::number(bounds) + " points",
                    "there are " + std::to_string(read.lines.size()) + ": is the file complete?");
    } else if (word == "nElements") {
      tokens.expect(":=");
      const double elements = tokens.number("nElements");
      if (!read.lines.empty() && elements != static_cast<double>(read.lines.size()))
        tokens.fail("nElements", jounce::number(elements),
                    "there are " + std::to_string(read.lines.size()) + " points");
    }
  }
  return read;
}

std::string st_text(const TableFile& file) {
  const auto& [x, p, v, a] = file.table.columns();
  if (x.size() > most_points)
    throw InputError("knots", std::to_string(x.size()),
                     "nElements is an INT: at most " + std::to_string(most_points));
  std::string text = "// a cam for CODESYS SoftMotion, by " + made_by() + "\n" +
                     notes_text(file, "//") +
                     "// once, in the program: Cam.pce := ADR(CamPoints);\n" +
                     "VAR_GLOBAL\n  CamPoints : ARRAY[0.." + std::to_string(x.size() - 1) +
                     "] OF SMC_CAMXYVA := [\n";
  for (std::size_t i = 0; i < x.size(); ++i)
    text += "    (dX := " + real(x[i]) + ", dY := " + real(p[i]) + ", dV := " + real(v[i]) +
            ", dA := " + real(a[i]) + (i + 1 < x.size() ? "),\n" : ")\n");
  return text +
         "  ];\n  Cam : MC_CAM_REF := (byType := 3, nElements := " + std::to_string(x.size()) +
         ", xStart := " + real(x.front()) + ", xEnd := " + real(x.back()) + ");\nEND_VAR\n";
}

}  // namespace jounce::detail
