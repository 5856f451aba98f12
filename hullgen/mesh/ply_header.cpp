#include "hullgen/mesh/ply_header.h"

#include <array>
#include <charconv>
#include <sstream>

#include "base/errors.h"
#include "base/text.h"

namespace icebow {
namespace {

struct TypeName {
  const char *name, *other;
  PlyType type;
  std::size_t bytes;
};

constexpr std::array<TypeName, 8> types = {{{"char", "int8", PlyType::int8, 1},
                                            {"uchar", "uint8", PlyType::uint8, 1},
                                            {"short", "int16", PlyType::int16, 2},
                                            {"ushort", "uint16", PlyType::uint16, 2},
                                            {"int", "int32", PlyType::int32, 4},
                                            {"uint", "uint32", PlyType::uint32, 4},
                                            {"float", "float32", PlyType::float32, 4},
                                            {"double", "float64", PlyType::float64, 8}}};

constexpr std::size_t longest_header = 1 << 20;  // bytes; those of programs have some hundreds

class HeaderReader {
 public:
  HeaderReader(const std::string& content, const std::string& path) : content_(content), path_(path) {}

  PlyHeader read() {
    if (next_line() != "ply") fail("a PLY file begins with the line \"ply\"");
    read_format();
    while (read_entry()) {
    }
    header_.body = at_;
    for (const PlyElement& element : header_.elements) check_size(element);
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(text("%s, line %d: %s", path_.c_str(), header_.lines, what.c_str()));
  }

  // Without the end of the line, which some programs write as "\r\n".
  std::string next_line() {
    const std::size_t end = content_.find('\n', at_);
    if (end == std::string::npos || end > longest_header)
      fail("the header has no end: the line \"end_header\" is missing");
    std::string line = content_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at_ = end + 1;
    ++header_.lines;
    return line;
  }

  void read_format() {
    std::string line = next_line();
    while (line.rfind("comment", 0) == 0 || line.rfind("obj_info", 0) == 0) line = next_line();
    std::istringstream words(line);
    std::string word, encoding;
    words >> word >> encoding;
    if (word != "format") fail("expected \"format ascii 1.0\" or a binary one");
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      fail("unknown format " + excerpt(encoding) +
           ": allowed are ascii, binary_little_endian, binary_big_endian");
    }
  }

  // False at the header's end.
  bool read_entry() {
    std::istringstream words(next_line());
    std::string kind;
    words >> kind;
    if (kind == "end_header") return false;
    if (kind == "element") {
      read_element(words);
    } else if (kind == "property") {
      read_property(words);
    } else if (!kind.empty() && kind != "comment" && kind != "obj_info") {
      fail("unknown word " + excerpt(kind) + " in the header: allowed are element, property, comment");
    }
    return true;
  }

  void read_element(std::istringstream& words) {
    PlyElement element;
    std::string rows;
    words >> element.name >> rows;
    const auto [end, error] = std::from_chars(rows.data(), rows.data() + rows.size(), element.rows);
    if (rows.empty() || error != std::errc() || end != rows.data() + rows.size())
      fail("an element needs a name and the number of its rows, not " + excerpt(rows));
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::istringstream& words) {
    if (header_.elements.empty()) fail("a property stands before the first element");
    PlyProperty property;
    std::string type;
    words >> type;
    property.is_list = type == "list";
    if (property.is_list) {
      words >> type;
      property.count_type = type_of(type);
      if (!is_whole(property.count_type)) fail("a list is counted in whole numbers, not in " + type);
      words >> type;
    }
    property.type = type_of(type);
    if (!(words >> property.name)) fail("a property needs a type and a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_of(const std::string& word) const {
    for (const TypeName& t : types)
      if (word == t.name || word == t.other) return t.type;
    fail("unknown type " + excerpt(word) +
         ": allowed are char, uchar, short, ushort, int, uint, float, double");
  }

  // A number in words takes a digit and what separates it from the next; an empty list takes its count.
  void check_size(const PlyElement& element) const {
    if (element.rows == 0) return;
    if (element.properties.empty())
      throw InputError(text("%s: element %s has %llu rows without a property", path_.c_str(),
                            excerpt(element.name).c_str(), static_cast<unsigned long long>(element.rows)));
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties)
      least += header_.encoding == PlyEncoding::ascii ? 2 : bytes_of(p.is_list ? p.count_type : p.type);
    const std::size_t there = content_.size() - header_.body + 1;  // the last number may end with the file
    if (element.rows > there / least)
      throw InputError(
          text("%s: its header announces %llu rows of %s, which take %zu bytes each at least, but "
               "%zu bytes follow: the file is cut off or damaged, export it again",
               path_.c_str(), static_cast<unsigned long long>(element.rows), excerpt(element.name).c_str(),
               least, there - 1));
  }

  const std::string &content_, &path_;
  std::size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
  return types[static_cast<std::size_t>(type)].bytes;
}

bool is_whole(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader read_ply_header(const std::string& content, const std::string& path) {
  return HeaderReader(content, path).read();
}

}  // namespace icebow
