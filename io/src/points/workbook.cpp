// SPDX-License-Identifier: Apache-2.0
#include "io/src/points/workbook.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <memory>
#include <optional>

#include <pugixml.hpp>
#include <zip.h>

#include "jounce/profiles/error.hpp"

namespace jounce::io_detail {
namespace {

constexpr zip_uint64_t most_bytes = zip_uint64_t{1} << 28U;  ///< size of one part, unpacked
constexpr std::uint32_t most_sheet_rows = 1'048'576;         ///< limit of the programs
constexpr std::uint32_t most_columns = 16'384;               ///< limit of the programs

[[noreturn]] void fail(const std::string& rule) {
  throw InputError("", "", rule);
}

/// An archive in memory.
class ZipArchive {
 public:
  explicit ZipArchive(std::string_view bytes) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source != nullptr) archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    if (archive_) return;
    if (source != nullptr) zip_source_free(source);
    fail("is not a complete zip archive: " + reason);
  }

  /// The content of a part; none if the archive has no such part.
  std::optional<std::string> part(const std::string& name) {
    zip_stat_t about;
    zip_stat_init(&about);
    if (zip_stat(archive_.get(), name.c_str(), 0, &about) != 0) return std::nullopt;
    if ((about.valid & ZIP_STAT_SIZE) == 0 || about.size > most_bytes)
      fail("has a part of more than 256 MiB: " + name);
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
        zip_fopen_index(archive_.get(), about.index, 0), &zip_fclose);
    if (!file) fail("has a part that cannot be read, " + name + ": " + reason());
    std::string content(about.size, '\0');
    char end = 0;  // libzip compares the checksum when it reads the end
    if (zip_fread(file.get(), content.data(), about.size) != static_cast<zip_int64_t>(about.size) ||
        zip_fread(file.get(), &end, 1) != 0)
      fail("has a damaged part: " + name);
    return content;
  }

 private:
  struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };
  [[nodiscard]] std::string reason() const { return zip_strerror(archive_.get()); }

  std::unique_ptr<zip_t, Discard> archive_;
};

/// The name without a prefix of a namespace, which some programs write.
std::string_view local(const char* name) {
  const char* const colon = std::strchr(name, ':');
  return colon == nullptr ? name : colon + 1;
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([&](const auto& each) { return local(each.name()) == name; });
}

std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
  return node.find_attribute([&](const auto& each) { return local(each.name()) == name; }).value();
}

template <class Act>
void each_child(const pugi::xml_node& node, std::string_view name, const Act& act) {
  for (const pugi::xml_node& each : node)
    if (local(each.name()) == name) act(each);
}

/// All text of a string: `t`, or those of its runs `r`. Phonetic texts are not part of it.
std::string text_of(const pugi::xml_node& string) {
  std::string text;
  for (const pugi::xml_node& each : string) {
    if (local(each.name()) == "t") text += each.text().get();
    if (local(each.name()) == "r") text += child(each, "t").text().get();
  }
  return text;
}

template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A reference such as "B7": row 7, column 1.
struct Reference {
  std::uint32_t row = 0, column = 0;
};
std::optional<Reference> reference(std::string_view text) {
  std::uint64_t column = 0;
  while (!text.empty() && text.front() >= 'A' && text.front() <= 'Z' && column <= most_columns) {
    column = 26 * column + static_cast<std::uint64_t>(text.front() - 'A' + 1);
    text.remove_prefix(1);
  }
  const auto row = whole<std::uint32_t>(text);
  if (!row || *row < 1 || *row > most_sheet_rows || column < 1 || column > most_columns)
    return std::nullopt;
  return Reference{*row, static_cast<std::uint32_t>(column - 1)};
}

/// True if a format of numbers shows dates or times: a d, h, m, s or y outside quotes and brackets.
bool shows_dates(std::string_view code) {
  bool quoted = false;
  int brackets = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\\' || c == '_') {
      ++i;
      continue;
    }
    // [h], [mm] and [ss] are durations; other brackets are colors, conditions and locales.
    if (c == '[') {
      const auto end = code.find(']', i);
      const std::string_view inside = code.substr(i + 1, end == code.npos ? 0 : end - i - 1);
      if (!inside.empty() && inside.find_first_not_of("hHmMsS") == inside.npos) return true;
      ++brackets;
    }
    if (c == ']') --brackets;
    if (brackets <= 0 && std::strchr("dhmsyDHMSY", c) != nullptr) return true;
  }
  return false;
}

/// True for the numbers of built-in formats of dates and times (ECMA-376 part 1, 18.8.30).
bool is_built_in_date(unsigned id) {
  return (id >= 14 && id <= 22) || (id >= 27 && id <= 36) || (id >= 45 && id <= 47) ||
         (id >= 50 && id <= 58);
}

class Workbook {
 public:
  explicit Workbook(std::string_view bytes) : archive_(bytes) {
    workbook_ = document("xl/workbook.xml");
    if (!workbook_)
      fail(
          "is a zip archive, but not a workbook of the format .xlsx: save the table as .xlsx or "
          "CSV");
    read_relations();
    read_strings();
    read_formats();
  }

  Sheet sheet(const std::string& wanted) {
    std::string names;
    std::optional<Sheet> first;
    each_child(child(workbook_->document_element(), "sheets"), "sheet",
               [&](const pugi::xml_node& each) {
                 const std::string name(attribute(each, "name"));
                 names += (names.empty() ? "" : ", ") + name;
                 if (first || (!wanted.empty() && name != wanted)) return;
                 Sheet read = read_one(name, std::string(attribute(each, "id")));
                 if (!wanted.empty() || !read.rows.empty()) first = std::move(read);
               });
    if (first) return *std::move(first);
    if (!wanted.empty())
      throw InputError("sheet", wanted, "is not in the workbook, whose sheets are " + names);
    fail("has no sheet with cells");
  }

 private:
  using Document = std::unique_ptr<pugi::xml_document>;

  Document document(const std::string& part) {
    const auto text = archive_.part(part);
    if (!text) return nullptr;
    auto made = std::make_unique<pugi::xml_document>();
    if (const auto result = made->load_buffer(text->data(), text->size()); !result)
      fail("has a part that is not XML, " + part + ": " + result.description());
    return made;
  }

  void read_relations() {
    if (const Document relations = document("xl/_rels/workbook.xml.rels"))
      each_child(relations->document_element(), "Relationship", [&](const pugi::xml_node& each) {
        const std::string target(attribute(each, "Target"));
        paths_[std::string(attribute(each, "Id"))] =
            target.starts_with('/') ? target.substr(1) : "xl/" + target;
      });
  }

  void read_strings() {
    if (const Document strings = document("xl/sharedStrings.xml"))
      each_child(strings->document_element(), "si",
                 [&](const pugi::xml_node& each) { strings_.push_back(text_of(each)); });
  }

  void read_formats() {
    const Document styles = document("xl/styles.xml");
    if (!styles) return;
    std::map<unsigned, bool> dates;
    const pugi::xml_node root = styles->document_element();
    each_child(child(root, "numFmts"), "numFmt", [&](const pugi::xml_node& each) {
      if (const auto id = whole<unsigned>(attribute(each, "numFmtId")))
        dates[*id] = shows_dates(attribute(each, "formatCode"));
    });
    each_child(child(root, "cellXfs"), "xf", [&](const pugi::xml_node& each) {
      const unsigned id = whole<unsigned>(attribute(each, "numFmtId")).value_or(0);
      const auto own = dates.find(id);
      is_date_.push_back(own != dates.end() ? own->second : is_built_in_date(id));
    });
  }

  Sheet read_one(const std::string& name, const std::string& id) {
    Sheet sheet{name, {}};
    const auto path = paths_.find(id);
    const Document content = path == paths_.end() ? nullptr : document(path->second);
    if (!content) fail("does not contain its sheet " + name);
    std::uint32_t row = 0;
    each_child(child(content->document_element(), "sheetData"), "row",
               [&](const pugi::xml_node& each) {
                 row = whole<std::uint32_t>(attribute(each, "r")).value_or(row + 1);
                 read_row(each, row, sheet);
               });
    return sheet;
  }

  void read_row(const pugi::xml_node& node, std::uint32_t row, Sheet& sheet) {
    std::uint32_t next = 0;
    each_child(node, "c", [&](const pugi::xml_node& each) {
      const std::string_view r = attribute(each, "r");
      const auto at = r.empty() ? Reference{row, next} : reference(r);
      if (!at || at->row != row || row < 1 || row > most_sheet_rows || at->column >= most_columns)
        throw InputError(sheet.name, std::string(r), "is not the reference of a cell in its row");
      next = at->column + 1;
      if (auto cell = cell_of(each, sheet.name + "!" + cell_name(row, at->column)))
        sheet.rows[row][at->column] = *std::move(cell);
    });
  }

  /// The value of a cell; none if it is empty.
  std::optional<SheetCell> cell_of(const pugi::xml_node& node, const std::string& place) const {
    const std::string_view type = attribute(node, "t");
    const std::string value = child(node, "v").text().get();
    if (type == "inlineStr") return text_cell(text_of(child(node, "is")));
    if (type == "e") return SheetCell{CellType::error, value};
    if (type == "str") return text_cell(value);
    if (type == "d") return SheetCell{CellType::date, value};
    if (value.empty() && child(node, "f")) return SheetCell{CellType::formula, ""};
    if (value.empty()) return std::nullopt;
    if (type == "s") {
      const auto index = whole<std::size_t>(value);
      if (!index || *index >= strings_.size())
        throw InputError(place, value, "is not the number of a text of the workbook");
      return text_cell(strings_[*index]);
    }
    const auto style = whole<std::size_t>(attribute(node, "s"));
    const bool date = style && *style < is_date_.size() && is_date_[*style];
    return SheetCell{date ? CellType::date : CellType::number, value};
  }

  static std::optional<SheetCell> text_cell(const std::string& text) {
    const bool blank =
        std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
    return blank ? std::nullopt : std::optional(SheetCell{CellType::text, text});
  }

  ZipArchive archive_;
  Document workbook_;
  std::map<std::string, std::string> paths_ = {};  ///< paths of the sheets, by their relations
  std::vector<std::string> strings_ = {};
  std::vector<bool> is_date_ = {};  ///< for each style of cells
};

}  // namespace

Sheet read_sheet(std::string_view bytes, const std::string& name) {
  return Workbook(bytes).sheet(name);
}

std::string cell_name(std::uint32_t row, std::uint32_t column) {
  std::string letters;
  for (std::uint32_t n = column + 1; n > 0; n = (n - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
  return letters + std::to_string(row);
}

}  // namespace jounce::io_detail
