// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/drawing.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/file.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/drawing/strokes.hpp"

namespace jounce {
namespace io_detail {
namespace {

constexpr double gap_share = 1e-5;  ///< gap that joins two curves, as a share of the drawing

/// The path of a file, and the name of a layer after #.
std::pair<std::string, std::string> path_and_layer(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string ending : {".dxf", ".svg"}) {
    if (lower.ends_with(ending)) return {std::string(path), ""};
    if (const auto mark = lower.rfind(ending + "#"); mark != lower.npos)
      return {std::string(path.substr(0, mark + ending.size())),
              std::string(path.substr(mark + ending.size() + 1))};
  }
  return {};
}

/// The extent of curves.
struct Box {
  double left = std::numeric_limits<double>::infinity();
  double right = -left, bottom = left, top = -left;

  void add(PlanePoint p) {
    left = std::min(left, p.real()), right = std::max(right, p.real());
    bottom = std::min(bottom, p.imag()), top = std::max(top, p.imag());
  }
  [[nodiscard]] double size() const { return std::max(right - left, top - bottom); }
  [[nodiscard]] bool contains(const Box& other, double margin) const {
    return left <= other.left + margin && right >= other.right - margin &&
           bottom <= other.bottom + margin && top >= other.top - margin;
  }
};

void add_stroke(Box& box, const Stroke& stroke) {
  const PlanePoint chord = stroke.to - stroke.from;
  box.add(stroke.from);
  box.add(stroke.to);
  box.add(stroke.from + chord * PlanePoint(0.5, -0.5 * stroke.bulge));
}

struct Chain {
  std::vector<Stroke> strokes = {};
  bool closed = false;
  Box box = {};
};

/// Joins curves whose ends meet.
class Joiner {
 public:
  explicit Joiner(std::vector<Stroke> strokes) : strokes_(std::move(strokes)) {
    Box box;
    double sum = 0;
    for (const Stroke& stroke : strokes_) {
      add_stroke(box, stroke);
      sum += std::norm(stroke.from) + std::norm(stroke.to) + std::abs(stroke.bulge);
    }
    if (!std::isfinite(sum))
      throw InputError("curve", "", "has coordinates beyond the range of numbers");
    gap_ = gap_share * box.size();
    std::erase_if(strokes_, [&](const Stroke& s) { return std::abs(s.to - s.from) <= gap_; });
    used_.resize(strokes_.size(), false);
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      ends_.push_back({strokes_[i].from, i, false});
      ends_.push_back({strokes_[i].to, i, true});
    }
    std::sort(ends_.begin(), ends_.end(),
              [](const End& a, const End& b) { return a.at.real() < b.at.real(); });
  }

  std::vector<Chain> chains() {
    std::vector<Chain> all;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      Chain chain;
      chain.strokes.push_back(strokes_[i]);
      extend(chain);
      if (!is_closed(chain)) {
        reverse(chain.strokes);
        extend(chain);
        reverse(chain.strokes);
      }
      chain.closed = is_closed(chain);
      for (const Stroke& stroke : chain.strokes) add_stroke(chain.box, stroke);
      all.push_back(std::move(chain));
    }
    return all;
  }
  [[nodiscard]] double gap() const { return gap_; }

 private:
  struct End {
    PlanePoint at;
    std::size_t stroke = 0;
    bool is_to = false;
  };

  [[nodiscard]] bool is_closed(const Chain& chain) const {
    return chain.strokes.size() > 1 &&
           std::abs(chain.strokes.back().to - chain.strokes.front().from) <= gap_;
  }
  static Stroke reversed(const Stroke& stroke) { return {stroke.to, stroke.from, -stroke.bulge}; }
  static void reverse(std::vector<Stroke>& strokes) {
    std::reverse(strokes.begin(), strokes.end());
    for (Stroke& stroke : strokes) stroke = reversed(stroke);
  }

  void extend(Chain& chain) {
    while (!is_closed(chain)) {
      const PlanePoint at = chain.strokes.back().to;
      const End* next = nullptr;
      for (auto end = std::lower_bound(ends_.begin(), ends_.end(), at.real() - gap_,
                                       [](const End&each, double x) { return each.at.real() < x; });
           end != ends_.end() && end->at.real() <= at.real() + gap_; ++end) {
        if (used_[end->stroke] || std::abs(end->at - at) > gap_) continue;
        if (next != nullptr)
          throw InputError("curve", "",
                           "three curves meet at " + six_digits(at.real()) + ", " +
                               six_digits(at.imag()) + ": leave only the outline on the layer");
        next = &*end;
      }
      if (next == nullptr) return;
      used_[next->stroke] = true;
      const Stroke& stroke = strokes_[next->stroke];
      chain.strokes.push_back(next->is_to ? reversed(stroke) : stroke);
    }
  }

  std::vector<Stroke> strokes_;
  std::vector<bool> used_ = {};
  std::vector<End> ends_ = {};
  double gap_ = 0;
};

/// The only curve, or the closed curve around all others.
Chain outline_of(std::vector<Stroke> strokes) {
  Joiner joiner(std::move(strokes));
  std::vector<Chain> all = joiner.chains();
  if (all.empty()) throw InputError("curve", "", "has no length");
  for (Chain& chain : all)
    if (all.size() == 1 ||
        (chain.closed && std::all_of(all.begin(), all.end(), [&](const Chain& other) {
           return chain.box.contains(other.box, joiner.gap());
         })))
      return std::move(chain);
  throw InputError(
      "curve", "",
      "is not the only one: there are " + std::to_string(all.size()) +
          " separate curves, and none surrounds the others. Put the outline on a layer of "
          "its own, or close its gaps (greatest gap " +
          six_digits(joiner.gap()) + ")");
}

const Layer& selected(const Layers& drawing, const std::string& name, const std::string& document) {
  std::vector<std::string> names;
  for (const auto& [layer, contents] : drawing.layers) names.push_back(layer);
  if (names.empty()) throw InputError("", "", "contains no curve").at(document, 0);
  if (const auto found = drawing.layers.find(name); found != drawing.layers.end())
    return found->second;
  if (name.empty() && names.size() == 1) return drawing.layers.begin()->second;
  throw InputError("layer", name,
                   (name.empty() ? "is missing: name one after #, such as " + document + "#" +
                                       names.front() + "; the layers are "
                                 : std::string("is not in the drawing, whose layers are ")) +
                       listed(names))
      .at(document, 0);
}

}  // namespace
}  // namespace io_detail

bool is_drawing(std::string_view path) {
  return !io_detail::path_and_layer(path).first.empty();
}

Outline parse_outline(std::string_view text, const std::string& document) {
  const auto [path, name] = io_detail::path_and_layer(document);
  const auto first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool xml = first != text.npos && text[first] == '<';
  const io_detail::Layers drawing =
      xml ? io_detail::read_svg(text, path) : io_detail::read_dxf(text, path);
  const io_detail::Layer& layer = io_detail::selected(drawing, name, path);
  if (!layer.unsupported.empty())
    throw InputError(layer.unsupported, "",
                     "is not supported: convert the block or group to lines, arcs or curves in the "
                     "drawing program")
        .at(path, layer.line);
  try {
    const io_detail::Chain chain = io_detail::outline_of(layer.strokes);
    Outline outline{path, drawing.unit, chain.closed, {}};
    for (const io_detail::Stroke& s : chain.strokes)
      outline.pieces.push_back({s.from.real(), s.from.imag(), s.bulge});
    const io_detail::PlanePoint end = chain.strokes.back().to;
    if (!chain.closed) outline.pieces.push_back({end.real(), end.imag()});
    return outline;
  } catch (const InputError& error) {
    throw error.document().empty() ? InputError(error).at(path, 0) : error;
  }
}

Outline read_outline(const std::string& path) {
  return parse_outline(read_file(io_detail::path_and_layer(path).first), path);
}

}  // namespace jounce
