// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "plot/src/figure/path.hpp"

namespace jounce {

/// An element of an SVG or HTML document, with the text directly in it, entities as written.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;

  [[nodiscard]] bool has_class(std::string_view wanted) const {
    const auto it = attributes.find("class");
    return it != attributes.end() &&
           (" " + it->second + " ").find(" " + std::string(wanted) + " ") != std::string::npos;
  }
  [[nodiscard]] double number(const std::string& attribute) const {
    return std::stod(attributes.at(attribute));
  }
};

/// A strict reader of the markup that Jounce writes: elements balanced and in one root, attributes
/// quoted and not repeated, every & an entity, no raw < in text. Throws std::runtime_error. With
/// `html`, a doctype and the void elements meta, link are allowed, and style and script are raw text.
class Markup {
 public:
  explicit Markup(std::string_view text, bool html = false) : rest_(text), html_(html) {
    if (html_) expect("<!doctype html>\n");
    while (!rest_.empty()) rest_[0] == '<' ? tag() : character();
    if (!open_.empty()) fail("not closed: " + elements_[open_.back()].name);
  }

  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }

  [[nodiscard]] std::vector<Element> with(std::string_view name, std::string_view kind = {}) const {
    std::vector<Element> found;
    for (const Element& e : elements_)
      if (e.name == name && (kind.empty() || e.has_class(kind))) found.push_back(e);
    return found;
  }

 private:
  [[noreturn]] static void fail(const std::string& why) { throw std::runtime_error(why); }

  void expect(std::string_view literal) {
    if (!rest_.starts_with(literal)) fail("expected " + std::string(literal));
    rest_.remove_prefix(literal.size());
  }

  std::string name() {
    std::size_t n = 0;
    while (n < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[n])) != 0 ||
                                rest_[n] == '-' || rest_[n] == ':'))
      ++n;
    if (n == 0) fail("no name at: " + std::string(rest_.substr(0, 20)));
    const std::string out(rest_.substr(0, n));
    rest_.remove_prefix(n);
    return out;
  }

  void tag() {
    expect("<");
    if (rest_.starts_with("/")) {
      expect("/");
      const std::string closed = name();
      expect(">");
      if (open_.empty() || elements_[open_.back()].name != closed) fail("misplaced </" + closed);
      open_.pop_back();
      return;
    }
    if (open_.empty() && !elements_.empty()) fail("a second root");
    Element element{name(), {}, {}};
    while (rest_.starts_with(" ")) attribute(element);
    const bool empty = rest_.starts_with("/");
    if (empty) expect("/");
    expect(">");
    const bool is_void = html_ && (element.name == "meta" || element.name == "link");
    elements_.push_back(element);
    if (empty || is_void) return;
    open_.push_back(elements_.size() - 1);
    if (element.name == "style" || element.name == "script") {
      const std::size_t end = rest_.find("</" + element.name);
      if (end == std::string_view::npos) fail(element.name + " without an end");
      elements_.back().text = rest_.substr(0, end);
      rest_.remove_prefix(end);
    }
  }

  void attribute(Element& element) {
    expect(" ");
    const std::string key = name();
    expect("=\"");
    const std::size_t end = rest_.find('"');
    const std::string value(rest_.substr(0, end));
    if (end == std::string_view::npos || value.find('<') != std::string::npos) fail("bad " + key);
    for (std::size_t at = 0; (at = value.find('&', at)) != std::string::npos; ++at)
      require_entity(std::string_view(value).substr(at));
    rest_.remove_prefix(end + 1);
    if (!element.attributes.emplace(key, value).second) fail("repeated " + key);
  }

  static void require_entity(std::string_view text) {
    for (const std::string_view entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"})
      if (text.starts_with(entity)) return;
    fail("raw &");
  }

  void character() {
    const char c = rest_[0];
    if (c == '&') require_entity(rest_);
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') fail("control character");
    if (open_.empty() && c != '\n') fail("text outside the root");
    if (!open_.empty()) elements_[open_.back()].text += c;
    rest_.remove_prefix(1);
  }

  std::string_view rest_;
  bool html_;
  std::vector<Element> elements_;
  std::vector<std::size_t> open_;
};

/// The lines of SVG path data with the commands M m L l H h V v, both ends of each step.
inline std::vector<std::vector<Pixel>> lines_of(std::string_view d) {
  std::vector<std::vector<Pixel>> lines;
  Pixel at;
  char command = 0;
  const auto read = [&] {
    while (!d.empty() && d[0] == ' ') d.remove_prefix(1);
    std::size_t used = 0;
    const double value = std::stod(std::string(d), &used);
    d.remove_prefix(used);
    return value;
  };
  while (!d.empty()) {
    if (std::isalpha(static_cast<unsigned char>(d[0])) != 0) {
      command = d[0];
      d.remove_prefix(1);
    }
    const bool relative = command >= 'a';
    const Pixel from = relative ? at : Pixel{0, 0};
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'H':
        at.x = from.x + read();
        break;
      case 'V':
        at.y = from.y + read();
        break;
      case 'M':
      case 'L':
        at.x = from.x + read();
        at.y = from.y + read();
        break;
      default:
        throw std::runtime_error("unknown command");
    }
    if (command == 'M') lines.emplace_back();
    lines.back().push_back(at);
  }
  return lines;
}

}  // namespace jounce
