#include "hullgen/mesh/mesh_bytes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/errors.h"
#include "base/file_kind.h"
#include "base/text.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t piece = 1 << 20, longest_word = 1 << 16;

bool blank(int c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

}  // namespace

MeshBytes::MeshBytes(const std::string& path, ImportProgress progress)
    : path_(path), buffer_(piece), progress_(std::move(progress)) {
  if (!fs::is_regular_file(path)) fail_file(why_no_file(path));
  file_.reset(std::fopen(path.c_str(), "rb"));
  if (!file_) fail_file("cannot be opened: may it be read?");
  size_ = fs::file_size(path);
  if (size_ == 0) fail_file("is empty: export the mesh again");
  refuse_two_byte_text();
  if (peek(3) == "\xEF\xBB\xBF") {
    char mark[3];
    read(mark, 3);
  }
}

void MeshBytes::refuse_two_byte_text() {
  const std::string head = peek(2);
  if (head == "\xFF\xFE" || head == "\xFE\xFF")
    fail_file("is text in UTF-16, two bytes a letter: save it as plain text (ASCII or UTF-8)");
}

void MeshBytes::fill() {
  std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
  end_ -= at_;
  at_ = 0;
  end_ += std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
  if (progress_) progress_("reading", static_cast<double>(place_) / static_cast<double>(size_));
}

int MeshBytes::get() {
  if (at_ == end_) fill();
  if (at_ == end_) return -1;
  ++place_;
  return static_cast<unsigned char>(buffer_[at_++]);
}

std::string MeshBytes::peek(std::size_t bytes) {
  if (end_ - at_ < bytes) fill();
  return {buffer_.data() + at_, std::min(bytes, end_ - at_)};
}

bool MeshBytes::read(void* to, std::size_t bytes) {
  char* out = static_cast<char*>(to);
  while (bytes > 0) {
    if (at_ == end_) fill();
    const std::size_t n = std::min(bytes, end_ - at_);
    if (n == 0) return false;
    std::memcpy(out, buffer_.data() + at_, n);
    at_ += n, place_ += n, out += n, bytes -= n;
  }
  return true;
}

bool MeshBytes::line(std::string& out) {
  out.clear();
  if (line_ended_) ++line_, line_ended_ = false;
  int c = get();
  if (c < 0) return false;
  for (; c >= 0 && c != '\n' && c != '\r'; c = get()) out += static_cast<char>(c);
  if (c == '\r' && peek(1) == "\n") get();
  line_ended_ = true;
  return true;
}

bool MeshBytes::word(std::string& out) {
  do {
    out.clear();
    int c = get();
    while (blank(c)) {
      if (c == '\n' || (c == '\r' && peek(1) != "\n")) ++line_;
      c = get();
    }
    if (c < 0) return false;
    for (; c >= 0; c = get()) {
      out += static_cast<char>(c);
      if (out.size() > longest_word) fail(excerpt(out) + " is no word of a mesh file");
      if (blank(peek(1).empty() ? ' ' : peek(1)[0])) break;
    }
    if (out.back() == ',') out.pop_back();
  } while (out.empty());
  return true;
}

std::string MeshBytes::rest_of_line() {
  std::string rest;
  for (std::string next = peek(1); !next.empty() && next != "\n" && next != "\r"; next = peek(1))
    rest += static_cast<char>(get());
  return rest;
}

void MeshBytes::fail(const std::string& what) const {
  fail_at_line(line_, what);
}

void MeshBytes::fail_at_line(int line, const std::string& what) const {
  throw InputError(text("%s, line %d: %s", path_.c_str(), line, what.c_str()));
}

void MeshBytes::fail_at_place(const std::string& what) const {
  throw InputError(
      text("%s, byte %llu: %s", path_.c_str(), static_cast<unsigned long long>(place_), what.c_str()));
}

void MeshBytes::fail_file(const std::string& what) const {
  throw InputError(path_ + ": " + what);
}

double MeshBytes::number(const std::string& word) const {
  const char* first = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  const char* last = word.data() + word.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc() && end == last && std::isfinite(value)) return value;
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is zero; too large is no coordinate.
    if (word.find("e-") != std::string::npos || word.find("E-") != std::string::npos) return 0.0;
    fail(excerpt(word) + " is too large for a coordinate");
  }
  if (error == std::errc() && end == last)
    fail(excerpt(word) + " is not a finite number: export the mesh again");
  if (word.find(',') != std::string::npos)
    fail(excerpt(word) + " has a comma: write numbers with a decimal point, and blanks between them");
  fail(excerpt(word) + " is not a number");
}

}  // namespace icebow
