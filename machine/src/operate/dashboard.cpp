// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/dashboard.hpp"

#include <algorithm>

#include "machine/src/operate/dashboard_axis.hpp"
#include "machine/src/operate/dashboard_text.hpp"

namespace jounce::dashboard {

using namespace machine_detail;

namespace {

/// Index of the chosen axis; 0 if there is none of this name.
std::size_t index_of(const std::vector<Watched>& axes, const std::string& name) {
  const auto found =
      std::find_if(axes.begin(), axes.end(), [&](const Watched& a) { return a.name == name; });
  return found == axes.end() ? 0 : static_cast<std::size_t>(found - axes.begin());
}

Row last_row(const View& view) {
  if (view.asks) return {{"Stop " + view.chosen + "?  y: yes  any other key: no", Tone::wrong}};
  Row row{{view.ascii ? "up/down axis  h hold  r resume  s stop  q quit"
                      : "↑↓ axis  h hold  r resume  s stop  q quit",
           Tone::faint}};
  if (!view.note.empty()) row.push_back({"   " + view.note, Tone::strong});
  return row;
}

/// The part of the axes that the list shows: "  axes 1 to 4 of 6".
Row shown_part(std::size_t first, std::size_t shown, std::size_t all) {
  return {{"  axes " + std::to_string(first + 1) + " to " + std::to_string(first + shown) + " of " +
               std::to_string(all),
           Tone::faint}};
}

/// Cut to the screen.
void fit(Row& row, int width) {
  std::size_t left = static_cast<std::size_t>(std::max(width, 0));
  for (Span& span : row) {
    span.text = cut(span.text, left);
    left -= columns(span.text);
  }
}

}  // namespace

std::vector<Row> rows_of(const std::vector<Watched>& axes, const View& view) {
  std::vector<Row> rows;
  rows.push_back({{padded("  axis", 16) + padded("state", 21) + padded("position", 17) +
                       padded("velocity", 17) + "fault",
                   Tone::faint}});
  if (axes.empty()) rows.push_back({{"  no message yet", Tone::faint}});
  const std::size_t at = index_of(axes, view.chosen);
  const std::vector<Row> chosen = axes.empty() ? std::vector<Row>{} : details(axes[at], view);
  // The list gives way to the details, down to three axes; the chosen one is always among them.
  const int room = std::max(3, view.height - 3 - static_cast<int>(chosen.size()));
  const std::size_t shown = std::min(axes.size(), static_cast<std::size_t>(room));
  const std::size_t first = at >= shown ? at + 1 - shown : 0;
  for (std::size_t i = first; i < std::min(axes.size(), first + shown); ++i)
    rows.push_back(listed(axes[i], view, i == at));
  rows.push_back(shown < axes.size() ? shown_part(first, shown, axes.size()) : Row{});
  rows.insert(rows.end(), chosen.begin(), chosen.end());
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(std::max(view.height - 1, 0))));
  if (view.height > 0) rows.push_back(last_row(view));
  for (Row& row : rows) fit(row, view.width);
  return rows;
}

Action press(View& view, const std::vector<Watched>& axes, Key key) {
  const auto c = static_cast<int>(key);
  if (c == 'q') return Action::quit;
  if (view.asks) {
    view.asks = false;
    view.note = c == 'y' ? "" : "not stopped";
    return c == 'y' ? Action::stop : Action::nothing;
  }
  if (axes.empty()) return Action::nothing;
  const std::size_t at = index_of(axes, view.chosen);
  const std::size_t step = key == Key::up ? axes.size() - 1 : key == Key::down || c == '\t' ? 1 : 0;
  view.chosen = axes[(at + step) % axes.size()].name;
  if (step > 0) view.note.clear();
  view.asks = c == 's';
  return c == 'h' ? Action::hold : c == 'r' ? Action::resume : Action::nothing;
}

}  // namespace jounce::dashboard
