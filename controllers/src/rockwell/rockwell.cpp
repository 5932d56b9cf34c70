// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "jounce/base/detail/csv.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"

#include "controllers/src/exchange/formats.hpp"

// Cams of Rockwell Logix in an L5X export. A tag of the type CAM is edited by the user. Its
// elements contain Master and Slave (REAL) and SegmentType (0 linear, 1 cubic), the law of the
// segment to the next element. The instruction MCCP computes a CAM_PROFILE from it. Each element of
// that is written as 14 DINTs in the text form "L5K": Status (2: calculated), Master, Slave,
// SegmentType, and c0 to c3 of slave = Slave + c0 + c1 d + c2 d^2 + c3 d^3 with
// d = master - Master. Each number except Status and SegmentType is a double in two DINTs, the high
// word first.
namespace jounce::controllers_detail {
namespace {

constexpr double rounded_joint =
    1e-9;  ///< tolerance at the joints of a calculated profile, as a share of the stroke
constexpr int calculated = 2;  ///< Status of an element of a CAM_PROFILE
constexpr const char* start_slope =
    "StartSlope ";  ///< operands of MCCP, in the description of the tag
constexpr const char* end_slope = "EndSlope ";

/// Numbers of `[[0.0,0.0,1],[120.0,40.0,0]]`, a list for each element.
std::vector<std::vector<double>> elements_of(const std::string& text, int line,
                                             const std::string& tag, const Place& place) {
  std::vector<std::vector<double>> all;
  int depth = 0;
  std::string digits;
  const auto end_number = [&] {
    if (trimmed(digits).empty()) return;
    const auto value = csv_number(trimmed(digits));
    if (!value) place.fail(line, tag, trimmed(digits), "must be a finite number");
    if (all.empty()) place.fail(line, tag, digits, "must be a list of elements in brackets");
    all.back().push_back(*value);
    digits.clear();
  };
  for (const char c : text) {
    if (c == '[' && ++depth == 2) all.emplace_back();
    if (c == ',' || c == ']') end_number();
    if (c == ']') --depth;
    if (c == '\n') ++line;
    if (c != '[' && c != ']' && c != ',' && c != '\n') digits += c;
  }
  if (depth != 0) place.fail(line, tag, "", "ends within brackets: is the file complete?");
  return all;
}

/// A double from two DINTs, high word first.
double joined(double high, double low) {
  const auto word = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
  };
  return std::bit_cast<double>((word(high) << 32U) | word(low));
}

/// One tag of a file.
struct Tag {
  std::string name;
  std::string description;
  int line = 0;
  std::vector<std::vector<double>> elements;
};

/// All columns of a calculated profile, v as the slope at each knot.
struct Piece {
  double x, p;
  std::array<double, 4> c;  ///< in powers of the distance from x

  [[nodiscard]] double value(double d) const {
    return p + c[0] + d * (c[1] + d * (c[2] + d * c[3]));
  }
  [[nodiscard]] double slope(double d) const { return c[1] + d * (2 * c[2] + d * 3 * c[3]); }
};

std::vector<Piece> pieces_of(const Tag& tag, const Place& place) {
  std::vector<Piece> pieces;
  for (const std::vector<double>& e : tag.elements) {
    if (e.size() != 14)
      place.fail(tag.line, tag.name, std::to_string(e.size()) + " numbers",
                 "an element of a CAM_PROFILE has 14");
    if (e[0] != calculated) break;
    pieces.push_back(
        {joined(e[1], e[2]),
         joined(e[3], e[4]),
         {joined(e[6], e[7]), joined(e[8], e[9]), joined(e[10], e[11]), joined(e[12], e[13])}});
  }
  if (pieces.size() < 2)
    place.fail(tag.line, tag.name, std::to_string(pieces.size()) + " calculated elements",
               "must be at least 2: run MCCP, then export the tag");
  return pieces;
}

Exchanged profile_cam(const Tag& tag, const Place& place) {
  const std::vector<Piece> pieces = pieces_of(tag, place);
  Exchanged cam{.name = tag.name, .rule = Interpolation::cubic_hermite};
  const auto [low, high] = std::minmax_element(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.p < b.p; });
  const double near = rounded_joint * std::max(high->p - low->p, std::abs(high->p));
  std::optional<double> slope;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const bool last = i + 1 == pieces.size();
    const double v = last ? *slope : piece.c[1];
    const double d = last ? 1 : pieces[i + 1].x - piece.x;
    const std::string knot = tag.name + "[" + std::to_string(i) + "]";
    if (slope && std::abs(*slope - v) * std::abs(d) > near)
      place.fail(tag.line, knot, number(v),
                 "the slope jumps here from " + number(*slope) +
                     ": Jounce reads only cams without a jump of the velocity");
    if (!last && std::abs(piece.value(d) - pieces[i + 1].p) > near)
      place.fail(tag.line, knot, number(piece.value(d)),
                 "ends the segment, but the next element begins at " + number(pieces[i + 1].p));
    cam.columns.x.push_back(piece.x);
    cam.columns.p.push_back(piece.p);
    cam.columns.v.push_back(v);
    cam.lines.push_back(tag.line);
    slope = piece.slope(d);
  }
  return cam;
}

/// The value after a word in the description of a tag.
std::optional<double> noted(const Tag& tag, const std::string& word) {
  const auto at = tag.description.find(word);
  if (at == std::string::npos) return std::nullopt;
  const std::string rest = tag.description.substr(at + word.size());
  return csv_number(rest.substr(0, rest.find_first_of(",; \t\r\n")));
}

/// The C2 cubic spline through the points with these slopes at its ends.
std::vector<double> clamped(const std::vector<double>& x, const std::vector<double>& p,
                            double first, double last) {
  std::vector<std::optional<double>> v(x.size());
  v.front() = first;
  v.back() = last;
  return filled({.axis = Domain::master, .x = x, .p = p, .v = std::move(v)}).table.columns().v;
}

Exchanged cam_of_tag(const Tag& tag, const Place& place) {
  Exchanged cam{.name = tag.name};
  std::size_t cubic = 0;
  for (std::size_t i = 0; i < tag.elements.size(); ++i) {
    const std::vector<double>& e = tag.elements[i];
    if (e.size() != 3)
      place.fail(tag.line, tag.name, std::to_string(e.size()) + " numbers",
                 "an element of a CAM has 3: Master, Slave, SegmentType");
    cam.columns.x.push_back(e[0]);
    cam.columns.p.push_back(e[1]);
    cam.lines.push_back(tag.line);
    cubic += i + 1 < tag.elements.size() && e[2] == 1 ? 1 : 0;
  }
  cam.rule = Interpolation::linear;
  if (cubic == 0) return cam;
  if (cubic + 1 != tag.elements.size())
    place.fail(tag.line, tag.name, "",
               "mixes linear and cubic segments: read the CAM_PROFILE that MCCP computes from it");
  const auto first = noted(tag, start_slope), last = noted(tag, end_slope);
  if (!first || !last)
    cam.unread.emplace_back(
        "the slopes at the ends are operands of MCCP, not in the file: read as 0");
  const auto& [x, p, v, a] = cam.columns;
  if (std::is_sorted(x.begin(), x.end(), std::less_equal<>{}) && x.size() > 1) {
    cam.rule = Interpolation::cubic_hermite;
    cam.columns.v = clamped(x, p, first.value_or(0), last.value_or(0));
  }
  return cam;
}

/// The elements in the text form of a tag, or from its decorated members.
std::vector<std::vector<double>> data_of(const pugi::xml_node& node, const std::string& text,
                                         const std::string& name, const Place& place) {
  if (const auto list = node.find_child_by_attribute("Data", "Format", "L5K"))
    return elements_of(list.child_value(), line_at(text, list.offset_debug()), name, place);
  std::vector<std::vector<double>> all;
  const auto array = node.find_child_by_attribute("Data", "Format", "Decorated").child("Array");
  for (const auto& element : array.children("Element")) {
    all.emplace_back();
    for (const auto& member : element.child("Structure").children("DataValueMember")) {
      const std::string value = member.attribute("Value").value();
      const auto real = csv_number(value);
      if (!real)
        place.fail(line_at(text, member.offset_debug()), name, value, "must be a finite number");
      all.back().push_back(*real);
    }
  }
  return all;
}

std::vector<Exchanged> read_l5x(const std::string& text, const Place& place) {
  pugi::xml_document document;
  if (const auto result = document.load_buffer(text.data(), text.size()); !result)
    place.fail(line_at(text, result.offset), "", "",
               std::string("is not XML: ") + result.description());
  std::vector<Exchanged> cams;
  for (const auto& found :
       document.select_nodes("//*[@DataType='CAM' or @DataType='CAM_PROFILE'][Data]")) {
    const pugi::xml_node node = found.node();
    Tag tag{.name = node.attribute("Name").value(),
            .description = node.child_value("Description"),
            .line = line_at(text, node.offset_debug()),
            .elements = {}};
    tag.elements = data_of(node, text, tag.name, place);
    const bool profile = std::strcmp(node.attribute("DataType").value(), "CAM_PROFILE") == 0;
    cams.push_back(profile ? profile_cam(tag, place) : cam_of_tag(tag, place));
  }
  if (cams.empty())
    place.fail(1, "", "", "contains no tag of the type CAM or CAM_PROFILE with data");
  return cams;
}

/// A REAL in the shortest form that reads back the same, with a decimal point.
std::string real(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(value));
  std::string text(digits, end.ptr);
  const auto exponent = text.find('e');
  if (text.find('.') == text.npos)
    text.insert(exponent == text.npos ? text.size() : exponent, ".0");
  return text;
}

std::string l5x_text(const TableFile& file) {
  const auto& [x, p, v, a] = file.table.columns();
  const std::size_t n = x.size();
  std::string list, members;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string type = i + 1 < n ? "1" : "0";
    list += (i == 0 ? "[" : ",[") + real(x[i]) + "," + real(p[i]) + "," + type + "]";
    members += "  <Element Index=\"[" + std::to_string(i) + "]\"><Structure DataType=\"CAM\">";
    for (const auto& [name, kind, value] :
         {std::array<std::string, 3>{"Master", R"("REAL" Radix="Float")", real(x[i])},
          {"Slave", R"("REAL" Radix="Float")", real(p[i])},
          {"SegmentType", R"("DINT" Radix="Decimal")", type}})
      members +=
          "<DataValueMember Name=\"" + name + "\" DataType=" + kind + " Value=\"" + value + "\"/>";
    members += "</Structure></Element>\n";
  }
  const std::string size = std::to_string(n);
  const bool persistent = repeats(file.table.outside());
  return "<Tag Name=\"Cam\" TagType=\"Base\" DataType=\"CAM\" Dimensions=\"" + size +
         "\" Constant=\"false\" ExternalAccess=\"Read/Write\">\n <Description><![CDATA[a cam by " +
         made_by() + ". Operands of MCCP: Length " + size + ", " + start_slope + number(v.front()) +
         ", " + end_slope + number(v.back()) + "; MAPC: Execution Mode " +
         (persistent ? "Continuous" : "Once") +
         "]]></Description>\n <Data Format=\"L5K\"><![CDATA[[" + list +
         "]]]></Data>\n <Data Format=\"Decorated\"><Array DataType=\"CAM\" Dimensions=\"" + size +
         "\">\n" + members + " </Array></Data>\n</Tag>\n";
}

}  // namespace

constinit const FormatRow rockwell_format{
    .format = {.name = "rockwell",
               .maker = "Rockwell Logix, tag of the type CAM in L5X",
               .knot = "an element `CAM`: Master, Slave, SegmentType; reads `CAM_PROFILE` too",
               .source = "Rockwell MOTION-RM002H, structures CAM and CAM_PROFILE; L5X exports",
               .extension = ".l5x",
               .join = KnotJoin::clamped_spline,
               .single = true},
    .detects = [](const std::string& text) { return text.find("DataType=\"CAM") != text.npos; },
    .read = read_l5x,
    .write = l5x_text};

}  // namespace jounce::controllers_detail
