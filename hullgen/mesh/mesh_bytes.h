// The bytes of a mesh file, read once from front to back in pieces of a fixed size, with the line and the
// place for complaints.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace icebow {

// Told now and then how far a long job is: its name and the share done, 0 to 1.
using ImportProgress = std::function<void(const std::string& stage, double share)>;

class MeshBytes {
 public:
  // Skips the byte order mark of UTF-8. Throws InputError where the file is absent, empty, a directory or
  // cannot be opened, and where it is text of two bytes a letter (UTF-16).
  explicit MeshBytes(const std::string& path, ImportProgress progress = {});

  bool line(std::string& out);  // the next line without its end (LF, CR LF or CR); false at the end
  bool word(std::string& out);  // the next word between blanks, a comma at its end left out; false at the end
  std::string rest_of_line();   // from here on
  bool read(void* to, std::size_t bytes);  // false where fewer are left
  std::string peek(std::size_t bytes);     // the next ones, fewer at the end; at most 1000

  std::uint64_t size() const { return size_; }  // of the file
  std::uint64_t left() const { return size_ - place_; }
  std::uint64_t place() const { return place_; }  // of the next byte
  int line_number() const { return line_; }       // of what was read last, from 1

  [[noreturn]] void fail(const std::string& what) const;  // InputError: file, line, what
  [[noreturn]] void fail_at_line(int line, const std::string& what) const;
  [[noreturn]] void fail_at_place(const std::string& what) const;  // InputError: file, byte, what
  [[noreturn]] void fail_file(const std::string& what) const;      // InputError: file, what
  // The word as a finite number. Throws InputError with the line.
  double number(const std::string& word) const;

 private:
  int get();  // the next byte, -1 at the end
  void fill();
  void refuse_two_byte_text();

  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, end_ = 0;
  std::uint64_t size_ = 0, place_ = 0;
  int line_ = 1;
  bool line_ended_ = false;
  ImportProgress progress_;
};

}  // namespace icebow
