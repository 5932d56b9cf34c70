// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/plot/figure.hpp"

namespace jounce {

/// Text in a page. An empty line begins a new paragraph.
struct Prose {
  std::string text{};
};

/// A list of names and values in a page: "stroke", "232.362 pulse".
struct Facts {
  std::vector<std::pair<std::string, std::string>> rows{};
};

/// A table in a page. Columns that contain only numbers are aligned to the right. A broken row is
/// tinted and has a cross.
struct DataTable {
  /// A range of the x axis of the page's chart with data; from == to is a point.
  struct Place {
    double from = 0;
    double to = 0;
  };
  struct Row {
    std::vector<std::string> cells = {};  ///< one for each column; missing cells are empty
    bool broken = false;                  ///< true: the row shows a broken limit
    std::optional<Place> place = {};      ///< place in the chart that the script shows for this row
  };

  std::string caption{};               ///< text below the table
  std::vector<std::string> columns{};  ///< headings; "^2" is shown as "²"
  std::vector<Row> rows{};
};

/// A figure in a page, with a line of text below it.
struct Chart {
  Figure figure{};
  std::string caption{};  ///< text below the figure
  /// The numbers behind the figure, chart_data(): the script of the page then draws the figure, and
  /// the reader can zoom and read values. Empty: the figure is a still picture.
  std::string data{};
};

/// A drawing with a scale of its own, such as the plate of a disc cam.
struct Image {
  std::string svg{};      ///< an SVG document
  std::string title{};    ///< the content in words, for readers who cannot see it
  std::string caption{};  ///< text below the drawing
  std::string narrow{};   ///< the drawing for a phone, about 370 px wide; "": `svg`, made smaller
};

/// A text with the numbers of its lines, and remarks below them.
struct Listing {
  struct Remark {
    int line = 0;                                ///< line of the text, from 1
    std::string text{};                          ///< the remark
    bool broken = false;                         ///< true: the remark is on a broken limit
    std::optional<DataTable::Place> place = {};  ///< see DataTable::Row
  };

  std::string caption{};  ///< text above the lines
  std::string text{};     ///< the text
  std::vector<Remark> remarks{};
};

/// Any part of a section.
using Block = std::variant<Prose, Facts, DataTable, Chart, Image, Listing>;

/// A section of a page.
struct Section {
  std::string heading{};
  std::vector<Block> blocks{};
};

/// The verdict at the top of a page: a mark and a sentence.
struct Headline {
  bool ok = true;  ///< true: a good result
  std::string text{};
};

/// A page.
struct Page {
  std::string title{};
  std::string subtitle{};
  std::optional<Headline> verdict{};  ///< nullopt: no verdict
  std::vector<Section> sections{};
  std::string footer{};  ///< origin of the page: version of the program, hash of the table
};

/// Returns the page as one HTML file that needs no other file and loads nothing. If no chart has
/// data, the page has no script. Otherwise the page has the script of plot/assets, and is complete
/// without it. The Content-Security-Policy makes the browser reject every other script and all
/// further files. All text is escaped, so a name in a spec cannot become markup. Colors are light
/// or dark as the reader prefers; a printed page is white. Figures are included a second time for
/// narrow windows, such as on a phone. Equal pages give equal bytes.
std::string html(const Page& page);

/// Returns the CSS of html(), for other pages with the same appearance: colors as variables
/// (--paper, --ink, --soft, --grid, --frame, --limit, --one to --four), light or dark as the reader
/// prefers, and the styles of text and tables.
std::string page_style();

/// Return the script of a page whose chart has data (plot/assets), and the CSS of its elements and
/// of figures, to follow page_style(). For other pages that draw chart_data().
std::string_view report_script();
std::string report_style();

}  // namespace jounce
