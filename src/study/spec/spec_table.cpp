#include "study/spec/spec_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/printable.h"
#include "base/text_encoding.h"
#include "base/text_file.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_variables.h"

namespace icebow {
namespace {

constexpr std::size_t most_rows = 100000;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28;

using Cells = std::vector<std::string>;

struct Line {
  std::size_t number = 0;  // in the file, from 1
  Cells cells;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

// RFC 4180: cells in double quotes may hold separators and line ends. Throws InputError where one is not
// closed.
std::vector<Line> lines_of(const std::string& path, const std::string& text, char separator) {
  std::vector<Line> lines = {{1, {""}}};
  bool quoted = false;
  std::size_t number = 1, opened = 1;
  for (const char c : text) {
    number += c == '\n';
    if (c == '"') {
      quoted = !quoted;
      opened = number;
    } else if (c == separator && !quoted) {
      lines.back().cells.emplace_back();
    } else if (c == '\n' && !quoted) {
      lines.push_back({number, {""}});
    } else {
      lines.back().cells.back() += c;
    }
  }
  if (quoted)
    throw InputError(path + ", line " + std::to_string(opened) + ": has a double quote that is not closed");
  for (Line& line : lines)
    for (std::string& cell : line.cells) cell = trimmed(cell);
  const auto blank = [](const Line& line) { return line.cells.size() == 1 && line.cells[0].empty(); };
  lines.erase(std::remove_if(lines.begin(), lines.end(), blank), lines.end());
  return lines;
}

// Line ends of Windows and of old Macs as those of Unix.
std::string with_unix_lines(const std::string& text) {
  std::string unix;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool before_line_end = i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] != '\r')
      unix += text[i];
    else if (!before_line_end)
      unix += '\n';
  }
  return unix;
}

char separator_of(const std::string& text) {
  const std::string head = text.substr(0, text.find('\n'));
  return head.find(';') != std::string::npos ? ';' : head.find('\t') != std::string::npos ? '\t' : ',';
}

double number_in(const std::string& cell, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  const bool decimal = cell.find_first_not_of("+-.0123456789eE") == std::string::npos;  // no "0x19", no "inf"
  if (!cell.empty() && decimal && *end == '\0' && std::isfinite(value)) return value;
  throw InputError(where + ": \"" + shortened(printable(cell), 40) + "\" is no number" + number_meant(cell));
}

// Columns of other things, like the results of `icebow export`, are left out.
void read_csv(const std::string& path, Json& method) {
  std::string text = read_text_file(path, most_bytes);
  if (text.rfind("\xef\xbb\xbf", 0) == 0) text.erase(0, 3);
  const std::string no_text = why_no_text(text);
  if (!no_text.empty()) throw InputError(path + ": " + no_text);
  text = with_unix_lines(text);
  const std::vector<Line> lines = lines_of(path, text, separator_of(text));
  if (lines.size() < 2)
    throw InputError(path + ": has no designs; give a line of pointers and one line a design");
  const Cells& head = lines[0].cells;
  method["columns"] = Json::array(), method["rows"] = Json::array();
  std::set<std::string> known;
  for (const std::string& cell : head) {
    if (cell.empty() || cell[0] != '/') continue;
    if (!known.insert(cell).second)
      throw InputError(path + ": its first line names " + shortened(printable(cell), 60) +
                       " twice; keep one of the two columns");
    method["columns"].push_back(cell);
  }
  if (method["columns"].empty())
    throw InputError(path +
                     ": its first line names no column by a pointer into the study file, like /bow/stem_deg");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string where = path + ", line " + std::to_string(lines[i].number);
    if (lines[i].cells.size() != head.size())
      throw InputError(where + ": has " + std::to_string(lines[i].cells.size()) +
                       " cells, the first line has " + std::to_string(head.size()));
    Json row = Json::array();
    for (std::size_t k = 0; k < head.size(); ++k)
      if (!head[k].empty() && head[k][0] == '/')
        row.push_back(number_in(lines[i].cells[k], where + ", " + head[k]));
    method["rows"].push_back(std::move(row));
  }
}

bool is_row(const Json& row, std::size_t columns) {
  return row.is_array() && row.size() == columns &&
         std::all_of(row.begin(), row.end(), [](const Json& cell) { return cell.is_number(); });
}

bool read_rows(const Json& rows, std::size_t columns, Method& method, Mistakes& mistakes) {
  if (!rows.is_array() || rows.empty() || rows.size() > most_rows) {
    mistakes.push_back({"/method/rows", "is " + shown(rows) + ", must be a list of 1 to " +
                                            brief(static_cast<double>(most_rows)) +
                                            " rows; or give \"file\": \"designs.csv\""});
    return false;
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!is_row(rows[k], columns)) {
      mistakes.push_back({"/method/rows/" + std::to_string(k),
                          "is " + shown(rows[k]) + ", must be a list of " + std::to_string(columns) +
                              " numbers, one for each of /method/columns"});
      return false;
    }
    method.rows.push_back(rows[k].get<std::vector<double>>());
  }
  return true;
}

}  // namespace

void take_in_table(Json& document, const std::string& study_file) {
  if (text_at(document, "/method/type") != "table") return;
  Json& method = document.at("method");
  const std::string file = text_at(method, "/file");
  if (file.empty() || method.contains("rows")) return;
  read_csv((std::filesystem::path(study_file).parent_path() / file).string(), method);
}

void parse_table(const Json& document, Method& method, Mistakes& mistakes) {
  const Json& columns = part_at(document, "/method/columns");
  const bool named = columns.is_array() && !columns.empty() &&
                     std::all_of(columns.begin(), columns.end(), [](const Json& c) { return c.is_string(); });
  if (!named) {
    mistakes.push_back({"/method/columns", "is " + shown(columns) +
                                               ", must be a list of pointers into this file, like "
                                               "[\"/bow/stem_deg\"]; or give \"file\": \"designs.csv\""});
    return;
  }
  const std::set<std::string> different = columns.get<std::set<std::string>>();
  if (different.size() < columns.size()) {
    mistakes.push_back({"/method/columns", "names a pointer twice; keep one of the two columns"});
    return;
  }
  if (!read_rows(part_at(document, "/method/rows"), columns.size(), method, mistakes)) return;
  const MethodInfo as_values{"table", MethodType::table, {}, {"values"}};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::set<double> values;
    for (const std::vector<double>& row : method.rows) values.insert(row[k]);
    Variable v =
        parse_variable(document, as_values, columns[k].get<std::string>(), {{"values", values}}, mistakes);
    v.values.clear();  // a range is enough to know the table by
    method.variables.push_back(v);
  }
}

}  // namespace icebow
