// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/style.hpp"

#include <array>
#include <string_view>

namespace jounce {
namespace {

struct Color {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

// Lines and limit: M. Okabe and K. Ito, "Color Universal Design" (2008), lightened for dark paper.
constexpr std::array palette{
    Color{"paper", "#ffffff", "#16181b"}, Color{"ink", "#1c1e21", "#e8e8e6"},
    Color{"soft", "#5b6168", "#a3a9b0"},  Color{"grid", "#e4e7ea", "#2a2e33"},
    Color{"knot", "#c3c9d0", "#454b52"},  Color{"frame", "#8d949c", "#6b727a"},
    Color{"pale", "#c9ced4", "#50565d"},  Color{"limit", "#c0440f", "#ff9063"},
    Color{"zone", "#009e73", "#2fc79b"},  Color{"one", "#0072b2", "#56b4e9"},
    Color{"two", "#b3478a", "#e3a3c8"},   Color{"three", "#00805d", "#35cfa2"},
    Color{"four", "#a87400", "#f0b429"},
};

constexpr std::string_view shape_rules =
    ".jf{font-family:system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif;"
    "font-size:11px}"
    ".jf .title{font-size:15px;font-weight:600}.jf .label{font-size:12px}"
    ".jf .mid{text-anchor:middle}.jf .end{text-anchor:end}"
    ".jf path{fill:none}"
    ".jf .grid,.jf .knot,.jf .frame{stroke-width:1}"
    ".jf .l{stroke-width:1.5;stroke-linejoin:round;stroke-linecap:round}"
    ".jf .l2{stroke-dasharray:7 4}.jf .l3{stroke-dasharray:1.5 3.5}.jf .l4{stroke-dasharray:9 4 "
    "1.5 "
    "4}"
    ".jf .under{stroke-width:4;stroke-linejoin:round}"
    ".jf .dots{stroke-width:3.5;stroke-linecap:round;stroke-dasharray:none}"
    ".jf .lim{stroke-width:1.2;stroke-dasharray:6 4}.jf .bad,.jf .limtext{font-weight:600}"
    ".jf .halo{paint-order:stroke;stroke-width:3px;stroke-linejoin:round}"
    ".jf .mark,.jf .badmark{stroke-width:1.3}";

constexpr std::string_view color_rules =
    ".jf .paper{fill:@paper}.jf text{fill:@ink}.jf .soft{fill:@soft}"
    ".jf .grid{stroke:@grid}.jf .knot{stroke:@knot}.jf .frame{stroke:@frame}"
    ".jf .l1{stroke:@one}.jf .l2{stroke:@two}.jf .l3{stroke:@three}.jf .l4{stroke:@four}"
    ".jf .under{stroke:@pale}.jf .lim{stroke:@limit}"
    ".jf .over{fill:@limit;fill-opacity:.07}"
    ".jf .zone{fill:@zone;fill-opacity:.09;stroke:@zone;stroke-opacity:.3}.jf "
    ".zonetext{fill:@three}"
    ".jf .bad,.jf .limtext{fill:@limit}"
    ".jf .halo{stroke:@paper}.jf .mark{fill:@paper;stroke:@ink}"
    ".jf .badmark{fill:@limit;stroke:@limit}";

/// The rules with each @name replaced by what color_of gives for it.
template <class ColorOf>
std::string colored(std::string_view rules, ColorOf color_of) {
  std::string out;
  while (!rules.empty()) {
    const std::size_t at = rules.find('@');
    out += rules.substr(0, at);
    if (at == std::string_view::npos) break;
    rules.remove_prefix(at + 1);
    const std::size_t end = rules.find_first_of(";}");
    for (const Color& color : palette)
      if (color.name == rules.substr(0, end)) out += color_of(color);
    rules.remove_prefix(end);
  }
  return out;
}

}  // namespace

std::string figure_style() {
  const auto light = [](const Color& c) { return c.light; };
  const auto dark = [](const Color& c) { return c.dark; };
  return std::string(shape_rules) + colored(color_rules, light) +
         "@media (prefers-color-scheme:dark){" + colored(color_rules, dark) + "}";
}

std::string inlined_figure_style() {
  const auto variable = [](const Color& c) { return "var(--" + std::string(c.name) + ")"; };
  return std::string(shape_rules) + colored(color_rules, variable);
}

std::string color_variables(bool dark) {
  std::string out;
  for (const Color& c : palette) {
    out += "--" + std::string(c.name) + ":";
    out += dark ? c.dark : c.light;
    out += ";";
  }
  return out;
}

}  // namespace jounce
