// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/plot/figure.hpp"

namespace jounce {

/// Text; an empty line begins a new paragraph.
struct Prose {
  std::string text{};
};

/// Names with their values: "stroke", "232.362 pulse".
struct Facts {
  std::vector<std::pair<std::string, std::string>> rows{};
};

/// A table. Columns with numbers only are aligned right; a broken row is tinted and has a cross.
struct DataTable {
  struct Row {
    std::vector<std::string> cells;  ///< one for each column; missing ones are empty
    bool broken = false;
  };

  std::string caption{};
  std::vector<std::string> columns{};  ///< "acceleration [mm/s^2]" is shown with ²
  std::vector<Row> rows{};
};

/// A figure and a line of text below it.
struct Chart {
  Figure figure{};
  std::string caption{};
};

using Block = std::variant<Prose, Facts, DataTable, Chart>;

struct Section {
  std::string heading{};
  std::vector<Block> blocks{};
};

/// Verdict at the top of the page: a sign, and a sentence.
struct Headline {
  bool ok = true;
  std::string text{};
};

struct Page {
  std::string title{};
  std::string subtitle{};
  std::optional<Headline> verdict{};
  std::vector<Section> sections{};
  std::string footer{};  ///< origin: version, hash of the table
};

/// The page as one self-contained HTML file. It has no script and loads nothing, and its
/// Content-Security-Policy makes the browser refuse both; all text is escaped, so that a name in a
/// spec cannot become markup. Light or dark as the reader prefers, legible on a phone (figures are
/// drawn a second time for narrow windows), printed on white. Equal pages give equal bytes.
std::string html(const Page& page);

/// The CSS of that page, for other pages with the same look: colours as variables (--paper, --ink,
/// --soft, --grid, --frame, --limit, --one to --four), light or dark as the reader prefers; its text
/// and tables.
std::string page_style();

}  // namespace jounce
