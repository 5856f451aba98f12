#include "hullgen/mesh/ply_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "base/errors.h"
#include "base/json.h"
#include "base/text.h"
#include "hullgen/mesh/ply_header.h"

namespace icebow {
namespace {

// The rows behind the header, number by number.
class Body {
 public:
  Body(const std::string& content, const PlyHeader& header)
      : at_(content.data() + header.body),
        end_(content.data() + content.size()),
        encoding_(header.encoding) {}

  // False where there is no number of this kind any more.
  bool read(PlyType type, double& value) {
    return encoding_ == PlyEncoding::ascii ? read_word(value) : read_bytes(type, value);
  }
  // Whether so many numbers can stand in what is left.
  bool has_room(double count, PlyType type) const {
    const std::size_t each = encoding_ == PlyEncoding::ascii ? 2 : bytes_of(type);
    return count <= double((static_cast<std::size_t>(end_ - at_) + 1) / each);
  }
  std::string next_word() const {
    const char* from = std::find_if_not(at_, end_, is_space);
    return std::string(from, std::find_if(from, end_, is_space));
  }
  bool is_text() const { return encoding_ == PlyEncoding::ascii; }
  bool at_end() const { return std::find_if_not(at_, end_, is_space) == end_; }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  bool read_word(double& value) {
    const char* from = std::find_if_not(at_, end_, is_space);
    if (from != end_ && *from == '+') ++from;
    const auto [end, error] = std::from_chars(from, end_, value);
    if (error != std::errc() || (end != end_ && !is_space(*end))) return false;
    at_ = end;
    return true;
  }

  template <class T>
  double taken() {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, at_, sizeof(T));
    if (encoding_ == PlyEncoding::big_endian) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    at_ += sizeof(T);
    return static_cast<double>(value);
  }

  bool read_bytes(PlyType type, double& value) {
    if (static_cast<std::size_t>(end_ - at_) < bytes_of(type)) return false;
    switch (type) {
      case PlyType::int8:
        value = taken<std::int8_t>();
        break;
      case PlyType::uint8:
        value = taken<std::uint8_t>();
        break;
      case PlyType::int16:
        value = taken<std::int16_t>();
        break;
      case PlyType::uint16:
        value = taken<std::uint16_t>();
        break;
      case PlyType::int32:
        value = taken<std::int32_t>();
        break;
      case PlyType::uint32:
        value = taken<std::uint32_t>();
        break;
      case PlyType::float32:
        value = taken<float>();
        break;
      case PlyType::float64:
        value = taken<double>();
        break;
    }
    return true;
  }

  const char *at_, *end_;
  PlyEncoding encoding_;
};

// The byte order mark some editors put before a text says nothing of a mesh.
std::string without_mark(std::string content) {
  if (content.compare(0, 3, "\xEF\xBB\xBF") == 0) content.erase(0, 3);
  return content;
}

class PlyReader {
 public:
  explicit PlyReader(const std::string& path)
      : path_(path),
        content_(without_mark(read_text_file(path))),
        header_(read_ply_header(content_, path)),
        body_(content_, header_) {}

  PolygonMesh read() {
    for (const PlyElement& element : header_.elements) read_element(element);
    check_corners();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(text("%s, row %llu of element %s: %s", path_.c_str(), row_ + 1,
                          excerpt(element_->name).c_str(), what.c_str()));
  }

  void read_element(const PlyElement& element) {
    element_ = &element;
    row_ = 0;
    const bool points = element.name == "vertex" || element.name == "vertices";
    const bool strips = element.name == "tristrips";
    const bool panels = element.name == "face" || element.name == "faces" || strips;
    const int columns[3] = {points ? column("x", false) : -1, points ? column("y", false) : -1,
                            points ? column("z", false) : -1};
    const int corners = panels ? corner_column() : -1;
    for (; row_ < element.rows; ++row_) {
      read_row(corners);
      if (points) add_point(columns);
      if (strips) add_strips();
      if (panels && !strips) add_panel();
    }
  }

  int column(const char* name, bool is_list) const {
    const std::vector<PlyProperty>& p = element_->properties;
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k].name == name && p[k].is_list == is_list) return static_cast<int>(k);
    if (is_list) return -1;
    throw InputError(text("%s: its points have no coordinate \"%s\" in the header", path_.c_str(), name));
  }

  int corner_column() const {
    const int usual = column("vertex_indices", true);
    const int other = usual >= 0 ? usual : column("vertex_index", true);
    if (other < 0 && element_->rows > 0)
      throw InputError(text("%s: its element %s has no list \"vertex_indices\" in the header", path_.c_str(),
                            excerpt(element_->name).c_str()));
    return other;
  }

  // Fills values_ with the row's numbers and list_ with the numbers of the list in column `wanted`.
  void read_row(int wanted) {
    values_.clear();
    list_.clear();
    for (std::size_t k = 0; k < element_->properties.size(); ++k) {
      const PlyProperty& p = element_->properties[k];
      values_.push_back(number(p.is_list ? p.count_type : p.type));
      if (!p.is_list) continue;
      const double count = values_.back();
      if (!(count >= 0.0) || count != std::floor(count))
        fail(text("a list of %g numbers: its count must be a whole number from 0 on", count));
      if (!body_.has_room(count, p.type))
        fail(text("a list of %.0f numbers is longer than the rest of the file", count));
      for (double n = 0.0; n < count; n += 1.0) {
        const double value = number(p.type);
        if (static_cast<int>(k) == wanted) list_.push_back(value);
      }
    }
  }

  double number(PlyType type) {
    double value = 0.0;
    if (body_.read(type, value)) return value;
    if (body_.is_text() && !body_.at_end())
      fail(excerpt(body_.next_word()) + " stands where a number is expected");
    fail("the file ends here; its header announces more");
  }

  void add_point(const int (&columns)[3]) {
    if (mesh_.points.size() >= most) fail("more points than can be counted");
    mesh_.points.emplace_back(values_[columns[0]], values_[columns[1]], values_[columns[2]]);
  }

  // Points may stand behind the panels: whether there are so many is asked at the end.
  int corner(double value) const {
    if (!(value >= 0.0 && value < double(most)) || value != std::floor(value))
      fail(text("a panel names the point %g: points are counted in whole numbers from 0 on", value));
    return static_cast<int>(value);
  }

  void add_panel() {
    if (list_.size() < 3) fail(text("a panel of %zu points: it needs three or more", list_.size()));
    for (const double value : list_) mesh_.corners.push_back(corner(value));
    close();
  }

  // Every point from the third on makes a triangle with the two before it; each second one is turned.
  void add_strips() {
    std::vector<int> strip;
    for (const double value : list_) {
      if (value == -1.0) {
        strip.clear();
        continue;
      }
      strip.push_back(corner(value));
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const int a = strip[n - 3], b = strip[n - 2], c = strip[n - 1];
      if (a == b || b == c || c == a) continue;  // joins two strips
      mesh_.corners.insert(mesh_.corners.end(), {n % 2 == 1 ? a : b, n % 2 == 1 ? b : a, c});
      close();
    }
  }

  void close() {
    mesh_.close_polygon(Patch::other);
    place_.emplace_back(element_, row_);
  }

  void check_corners() {
    for (std::size_t k = 0; k < mesh_.size(); ++k)
      for (std::size_t n = mesh_.begin_of(k); n < mesh_.ends[k]; ++n)
        if (static_cast<std::size_t>(mesh_.corners[n]) >= mesh_.points.size()) {
          std::tie(element_, row_) = place_[k];
          fail(text("a panel names the point %d, but there are %zu, counted from 0: export it again",
                    mesh_.corners[n], mesh_.points.size()));
        }
  }

  static constexpr std::size_t most = std::numeric_limits<int>::max();
  std::string path_, content_;
  PlyHeader header_;
  Body body_;
  const PlyElement* element_ = nullptr;
  unsigned long long row_ = 0;
  std::vector<double> values_, list_;
  std::vector<std::pair<const PlyElement*, unsigned long long>> place_;  // one per panel
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_ply(const std::string& path) {
  return PlyReader(path).read();
}

}  // namespace icebow
