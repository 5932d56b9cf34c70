// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/page.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/hash.hpp"
#include "jounce/plot/label.hpp"

#include "plot/src/figure/style.hpp"
#include "plot/src/figure/text.hpp"
#include "plot_files.hpp"

namespace jounce {
namespace {

constexpr double wide_figure = 860;    // px, of a figure on a screen or on paper
constexpr double narrow_figure = 370;  // px, on a phone

constexpr std::string_view page_rules =
    R"(*{box-sizing:border-box}
html{color-scheme:light dark;-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);line-height:1.5;
font-family:system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif}
main{max-width:920px;margin:0 auto;padding:32px 24px 48px;overflow-wrap:break-word}
h1{font-size:1.7rem;line-height:1.25;margin:0}
h2{font-size:1.15rem;margin:2.2em 0 .6em;padding-bottom:.25em;border-bottom:1px solid var(--grid)}
.sub,figcaption,caption,footer{color:var(--soft)}
.sub{margin:.3em 0 0}
p{max-width:44em;margin:.6em 0}
.verdict{display:flex;gap:.6em;max-width:none;margin:1.4em 0 0;padding:.6em .9em;border-radius:6px;
border:1px solid var(--frame);border-left-width:5px}
.verdict.ok{border-left-color:var(--three)}.verdict.no{border-left-color:var(--limit)}
.verdict b{flex:none}.ok b{color:var(--three)}.no b{color:var(--limit)}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.25em 1.4em;margin:.8em 0}
dt{color:var(--soft)}dd{margin:0;min-width:0;font-variant-numeric:tabular-nums}
.scroll{overflow-x:auto;margin:.9em 0}
table{border-collapse:collapse;font-size:.8125rem;line-height:1.35;font-variant-numeric:tabular-nums}
caption{text-align:left;padding-bottom:.5em}
th,td{text-align:left;vertical-align:top;padding:.4em .65em;border-bottom:1px solid var(--grid)}
th{font-weight:600;border-bottom-color:var(--frame);vertical-align:bottom}
td.n,th.n{text-align:right;white-space:nowrap}
td.m,th.m{padding-right:0;width:1.4em}td.m{color:var(--limit);font-weight:700}
tr.broken{background:color-mix(in srgb,var(--limit) 9%,transparent)}
td.w{min-width:14em}
.drawing img{display:block;max-width:100%;height:auto}
.code td{border:0;padding:.05em .65em;white-space:pre;font-family:ui-monospace,Consolas,monospace}
.code td.no{text-align:right;color:var(--soft);user-select:none}
.code .remark td,.code .remark button{white-space:normal;font-family:system-ui,sans-serif;color:var(--limit)}
.code .remark.fine td,.code .remark.fine button{color:var(--soft)}
figure{margin:1em 0 1.6em}figcaption{font-size:.875rem;margin-top:.4em}
.jf{display:block;width:100%;height:auto}.jf.narrow{display:none}
footer{margin-top:3em;padding-top:.8em;border-top:1px solid var(--grid);font-size:.8125rem}
@media screen and (max-width:600px){main{padding:20px 12px 32px}
dl{grid-template-columns:1fr;gap:0}dd{margin-bottom:.5em}
.jf.wide{display:none}.jf.narrow{display:block}}
@media print{@page{margin:14mm}body{font-size:10pt;line-height:1.4}main{max-width:none;padding:0}
h2{margin:1.3em 0 .5em;break-after:avoid}figure{margin:.6em 0 1em}.verdict{margin-top:.8em}
figure,tr,.verdict{break-inside:avoid}.scroll{overflow:visible}
table{font-size:7pt}th,td{padding:.3em .4em}td.w{min-width:10em}.code td{white-space:pre-wrap}}
)";

std::string prose(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find("\n\n", at), text.size());
    if (end > at) out += fmt::format("<p>{}</p>\n", escaped(text.substr(at, end - at)));
    at = end + 2;
  }
  return out;
}

std::string facts(const Facts& block) {
  std::string out = "<dl>\n";
  for (const auto& [name, value] : block.rows)
    out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(superscripts(name)), escaped(value));
  return out + "</dl>\n";
}

bool is_number(std::string_view cell) {
  for (const std::string_view sign : {"< ", "> ", "-", "+", "−", "±"})
    if (cell.starts_with(sign)) cell.remove_prefix(sign.size());
  return !cell.empty() && cell[0] >= '0' && cell[0] <= '9';
}

/// True if the column holds only numbers and gaps. Names of segments may begin with their number.
bool is_numeric(const DataTable& table, std::size_t column) {
  if (table.columns[column] == "segment") return false;
  bool any = false;
  for (const DataTable::Row& row : table.rows) {
    if (column >= row.cells.size() || row.cells[column].empty()) continue;
    if (!is_number(row.cells[column])) return false;
    any = true;
  }
  return any;
}

/// Numbers are aligned right; long text gets a wide column.
const char* kind(const DataTable& table, std::size_t column) {
  constexpr std::size_t long_text = 30;
  const bool wide =
      std::any_of(table.rows.begin(), table.rows.end(), [&](const DataTable::Row& row) {
        return column < row.cells.size() && row.cells[column].size() > long_text;
      });
  return is_numeric(table, column) ? " class=\"n\"" : wide ? " class=\"w\"" : "";
}

std::string place_of(const std::optional<DataTable::Place>& place) {
  return place ? fmt::format(" data-from=\"{}\" data-to=\"{}\"", place->from, place->to) : "";
}

std::string table_row(const DataTable::Row& row, const std::vector<const char*>& kinds,
                      bool marked) {
  std::string out = row.broken ? "<tr class=\"broken\"" : "<tr";
  out += place_of(row.place) + ">";
  if (marked) out += row.broken ? "<td class=\"m\" title=\"broken\">✗</td>" : "<td></td>";
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    out +=
        fmt::format("<td{}>{}</td>", kinds[k], k < row.cells.size() ? escaped(row.cells[k]) : "");
  }
  return out + "</tr>\n";
}

std::string table(const DataTable& block) {
  const bool marked = std::any_of(block.rows.begin(), block.rows.end(),
                                  [](const DataTable::Row& row) { return row.broken; });
  std::vector<const char*> kinds;
  std::string out = "<div class=\"scroll\" tabindex=\"0\"><table>\n";
  if (!block.caption.empty()) out += fmt::format("<caption>{}</caption>\n", escaped(block.caption));
  out += marked ? "<thead><tr><td class=\"m\"></td>" : "<thead><tr>";
  for (std::size_t k = 0; k < block.columns.size(); ++k) {
    kinds.push_back(kind(block, k));
    out += fmt::format("<th scope=\"col\"{}>{}</th>", kinds[k],
                       escaped(superscripts(block.columns[k])));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const DataTable::Row& row : block.rows) out += table_row(row, kinds, marked);
  return out + "</tbody>\n</table></div>\n";
}

/// JSON that cannot end its script element: a < is only in strings, where an escape stands for it.
std::string in_script(std::string_view data) {
  std::string out;
  for (const char c : data) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

std::string chart(const Chart& block) {
  const auto drawn = [&](double width, const char* kind) {
    std::string out = svg(block.figure, {.width = width, .inlined = true});
    const std::string_view plain = "class=\"jf\"";
    return out.replace(out.find(plain), plain.size(), fmt::format("class=\"jf {}\"", kind));
  };
  std::string out = "<figure>\n" + drawn(wide_figure, "wide") + drawn(narrow_figure, "narrow");
  if (!block.data.empty())
    out += fmt::format("<script type=\"application/json\">{}</script>\n", in_script(block.data));
  if (!block.caption.empty())
    out += fmt::format("<figcaption>{}</figcaption>\n", escaped(block.caption));
  return out + "</figure>\n";
}

/// The digits of base 64 (RFC 4648).
std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char byte : bytes) {
    bits = bits << 8U | static_cast<unsigned char>(byte);
    for (held += 8; held >= 6; held -= 6)
      out += digits[bits >> static_cast<unsigned>(held - 6) & 63U];
  }
  if (held > 0) out += digits[bits << static_cast<unsigned>(6 - held) & 63U];
  return out.append((4 - out.size() % 4) % 4, '=');
}

/// An image, so that the style sheet of the drawing does not apply to the page.
std::string image(const Image& block) {
  const auto address = [](const std::string& svg) {
    return "data:image/svg+xml;base64," + base64(svg);
  };
  const std::string narrow =
      block.narrow.empty()
          ? ""
          : fmt::format("<source media=\"screen and (max-width:600px)\" srcset=\"{}\">",
                        address(block.narrow));
  return fmt::format(
      "<figure class=\"drawing\"><picture>{}<img alt=\"{}\" src=\"{}\"></picture>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      narrow, escaped(block.title), address(block.svg), escaped(block.caption));
}

constexpr int whole_listing = 1500;  // lines; of a longer text, only the surroundings of remarks
constexpr int surroundings = 3;      // lines before and after a remark

std::string listing(const Listing& block) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < block.text.size();) {
    const std::size_t end = std::min(block.text.find('\n', at), block.text.size());
    lines.push_back(std::string_view(block.text).substr(at, end - at));
    at = end + 1;
  }
  const auto count = static_cast<int>(lines.size());
  const auto is_shown = [&](int line) {
    return count <= whole_listing ||
           std::any_of(block.remarks.begin(), block.remarks.end(), [&](const auto& remark) {
             return std::abs(remark.line - line) <= surroundings;
           });
  };
  std::string out = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\"><table class=\"code\">\n<caption>{}</caption>\n",
      escaped(block.caption));
  bool gap = false;
  for (int line = 1; line <= count; ++line) {
    if (!is_shown(line)) {
      if (!std::exchange(gap, true)) out += "<tr><td class=\"no\">⋮</td><td></td></tr>\n";
      continue;
    }
    gap = false;
    out += fmt::format("<tr><td class=\"no\">{}</td><td>{}</td></tr>\n", line,
                       escaped(lines[static_cast<std::size_t>(line - 1)]));
    for (const Listing::Remark& remark : block.remarks)
      if (remark.line == line)
        out += fmt::format("<tr class=\"remark{}\"{}><td class=\"m\">{}</td><td>{}</td></tr>\n",
                           remark.broken ? "" : " fine", place_of(remark.place),
                           remark.broken ? "✗" : "", escaped(remark.text));
  }
  return out + "</table></div>\n";
}

struct Write {
  std::string operator()(const Prose& block) const { return prose(block.text); }
  std::string operator()(const Facts& block) const { return facts(block); }
  std::string operator()(const DataTable& block) const { return table(block); }
  std::string operator()(const Chart& block) const { return chart(block); }
  std::string operator()(const Image& block) const { return image(block); }
  std::string operator()(const Listing& block) const { return listing(block); }
};

bool has_script(const Page& page) {
  const auto live = [](const Block& block) {
    const auto* found = std::get_if<Chart>(&block);
    return found != nullptr && !found->data.empty();
  };
  return std::any_of(page.sections.begin(), page.sections.end(), [&](const Section& section) {
    return std::any_of(section.blocks.begin(), section.blocks.end(), live);
  });
}

/// The hash of the script, as a Content-Security-Policy has it.
std::string script_source() {
  const Sha256 hash = sha256(plot_files::report_script);
  return fmt::format("; script-src 'sha256-{}'", base64(std::string(hash.begin(), hash.end())));
}

std::string head(const Page& page) {
  const bool script = has_script(page);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<link rel=\"icon\" "
      "href=\"data:,\">\n<title>{}</title>\n<style>\n{}{}{}\n</style>\n</head>\n",
      script ? script_source() : "", escaped(page.title), page_style(), inlined_figure_style(),
      script ? plot_files::report_rules : "");
}

}  // namespace

std::string page_style() {
  return fmt::format(
      ":root{{{}}}\n@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}\n{}",
      color_variables(false), color_variables(true), page_rules);
}

std::string_view report_script() {
  return plot_files::report_script;
}

std::string report_style() {
  return inlined_figure_style() + std::string(plot_files::report_rules);
}

std::string html(const Page& page) {
  std::string out = head(page) + "<body>\n<main>\n<header>\n";
  out += fmt::format("<h1>{}</h1>\n", escaped(page.title));
  if (!page.subtitle.empty())
    out += fmt::format("<p class=\"sub\">{}</p>\n", escaped(page.subtitle));
  if (page.verdict) {
    out += fmt::format("<p class=\"verdict {}\"><b>{}</b><span>{}</span></p>\n",
                       page.verdict->ok ? "ok" : "no", page.verdict->ok ? "✓" : "✗",
                       escaped(page.verdict->text));
  }
  out += "</header>\n";
  for (const Section& section : page.sections) {
    out += "<section>\n";
    if (!section.heading.empty()) out += fmt::format("<h2>{}</h2>\n", escaped(section.heading));
    for (const Block& block : section.blocks) out += std::visit(Write{}, block);
    out += "</section>\n";
  }
  if (!page.footer.empty()) out += fmt::format("<footer>{}</footer>\n", escaped(page.footer));
  out += "</main>\n";
  if (has_script(page)) out += fmt::format("<script>{}</script>\n", plot_files::report_script);
  return out + "</body>\n</html>\n";
}

}  // namespace jounce
