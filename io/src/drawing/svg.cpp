// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <pugixml.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/drawing/svg_path.hpp"

namespace jounce::io_detail {
namespace {

/// A length with a unit of CSS.
struct Length {
  double value = 0;
  double mm = 0;  ///< millimeters of its unit; 0: no physical unit
};

Length length_of(const std::string& text) {
  constexpr double inch = 25.4;
  constexpr std::array<std::pair<std::string_view, double>, 5> units{
      {{"mm", 1}, {"cm", 10}, {"in", inch}, {"pt", inch / 72}, {"pc", inch / 6}}};
  Length length;
  try {
    length.value = SvgScanner(text).number();
  } catch (const InputError&) {
    return {};
  }
  for (const auto& [unit, mm] : units)
    if (text.ends_with(unit)) length.mm = mm;
  return length;
}

/// Reads the elements of a drawing.
class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& document)
      : text_(text), document_(document) {}

  Layers read() {
    pugi::xml_document xml;
    const pugi::xml_parse_result parsed =
        xml.load_buffer(text_.data(), text_.size(), pugi::parse_default);
    if (!parsed)
      fail(parsed.offset, "", "", std::string("is not well-formed XML: ") + parsed.description());
    const pugi::xml_node root = xml.document_element();
    if (name_of(root) != "svg") fail(0, "", "", "is not an SVG drawing");
    read_children(root, page_of(root), "");
    return std::move(all_);
  }

 private:
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& key, const std::string& value,
                         const std::string& rule) const {
    throw InputError(key, value, rule).at(document_, line_at(offset));
  }
  [[nodiscard]] int line_at(std::ptrdiff_t offset) const {
    const auto end = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + end, '\n'));
  }
  static std::string name_of(const pugi::xml_node& node) {
    const std::string name = node.name();
    const auto colon = name.find(':');
    return colon == name.npos ? name : name.substr(colon + 1);
  }
  static double value(const pugi::xml_node& node, const char* attribute) {
    return SvgScanner(node.attribute(attribute).as_string("0")).number();
  }

  /// The map from the coordinates of the root to millimeters with y upwards. Without a physical
  /// size, the coordinates keep their size.
  Affine page_of(const pugi::xml_node& root) {
    const Length width = length_of(root.attribute("width").value());
    const Length height = length_of(root.attribute("height").value());
    double scale = 1;
    if (SvgScanner box(root.attribute("viewBox").value()); !box.is_at_end()) {
      (void)box.point();
      const PlanePoint size = box.point();
      if (width.mm > 0) scale = width.value * width.mm / size.real();
      if (width.mm > 0 && height.mm > 0 &&
          std::abs(height.value * height.mm - scale * size.imag()) > 1e-3 * scale * size.imag())
        fail(root.offset_debug(), "viewBox", root.attribute("viewBox").value(),
             "has another ratio of width and height than the drawing");
    } else if (width.mm > 0) {
      scale = 25.4 / 96;  // without a viewBox, a coordinate is a CSS pixel
    }
    if (width.mm > 0) all_.unit = "mm";
    return {scale, 0, 0, -scale, 0, 0};
  }

  void read_children(const pugi::xml_node& parent, const Affine& map, const std::string& layer) {
    for (const pugi::xml_node& node : parent.children())
      if (node.type() == pugi::node_element) {
        try {
          read_element(node, map, layer);
        } catch (const InputError& error) {
          throw error.document().empty()
              ? InputError(error).at(document_, line_at(node.offset_debug()))
              : error;
        }
      }
  }

  void read_element(const pugi::xml_node& node, const Affine& outer, const std::string& of_parent) {
    const std::string name = name_of(node);
    if (std::string(node.attribute("display").value()) == "none") return;
    const Affine map = outer * read_transform(node.attribute("transform").value());
    std::string layer = of_parent;
    for (const char* attribute : {"class", "inkscape:label", "id"})
      if (const std::string own = node.attribute(attribute).value(); !own.empty()) layer = own;
    if (name == "g" || name == "a") {
      if (++depth_ > most_groups)
        throw InputError("g", "", "is nested more than " + std::to_string(most_groups) + " deep");
      read_children(node, map, layer);
      --depth_;
      return;
    }
    const std::vector<std::string> rejected{"use", "svg", "image"};
    if (std::find(rejected.begin(), rejected.end(), name) != rejected.end()) {
      Layer& all = all_.layers[layer];
      if (all.unsupported.empty()) all.unsupported = name, all.line = line_at(node.offset_debug());
      return;
    }
    std::vector<Stroke> strokes;
    add_shape(strokes, node, name, map);
    if (strokes.empty()) return;
    auto& to = all_.layers[layer].strokes;
    to.insert(to.end(), strokes.begin(), strokes.end());
  }

  static void add_shape(std::vector<Stroke>& strokes, const pugi::xml_node& node,
                        const std::string& name, const Affine& map) {
    if (name == "path") add_path(strokes, node.attribute("d").value(), map);
    if (name == "circle" || name == "ellipse") {
      const bool circle = name == "circle";
      add_svg_ellipse(strokes, {value(node, "cx"), value(node, "cy")},
                      value(node, circle ? "r" : "rx"), value(node, circle ? "r" : "ry"), map);
    }
    if (name == "line")
      add_lines(strokes,
                {map({value(node, "x1"), value(node, "y1")}),
                 map({value(node, "x2"), value(node, "y2")})},
                false);
    if (name == "rect") add_rectangle(strokes, node, map);
    if (name == "polyline" || name == "polygon") {
      std::vector<PlanePoint> points;
      for (SvgScanner scan(node.attribute("points").value()); !scan.is_at_end();)
        points.push_back(map(scan.point()));
      add_lines(strokes, points, name == "polygon");
    }
  }

  static void add_rectangle(std::vector<Stroke>& strokes, const pugi::xml_node& node,
                            const Affine& map) {
    if (value(node, "rx") != 0 || value(node, "ry") != 0)
      throw InputError("rect", "", "has round corners: draw it as a path");
    const double x = value(node, "x"), y = value(node, "y"), w = value(node, "width"),
                 h = value(node, "height");
    add_lines(strokes, {map({x, y}), map({x + w, y}), map({x + w, y + h}), map({x, y + h})}, true);
  }

  std::string_view text_;
  const std::string& document_;
  Layers all_ = {};
  static constexpr int most_groups = 200;
  int depth_ = 0;
};

}  // namespace

Layers read_svg(std::string_view text, const std::string& document) {
  return SvgReader(text, document).read();
}

}  // namespace jounce::io_detail
