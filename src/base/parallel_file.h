// HDF5 behind a wall: one file that all ranks of a group write or read together, each its part of global
// arrays. The root has the file and writes what the others send, one rank's part of one array at a time; to
// read, each rank opens it.
//
// Every call is collective, with the same name on all ranks. Whatever goes wrong on any rank becomes one
// RuntimeError on all of them; it names the file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "base/communicator.h"

namespace icebow {

// A box of an array: `count` elements from `start` on along each axis of an array of `extent`.
struct Slab {
  std::vector<std::uint64_t> extent, start, count;
  static Slab whole(const std::vector<std::uint64_t>& extent);
  static Slab nothing(const std::vector<std::uint64_t>& extent);
};

// What a file says of itself when it is read: with checksums, each part of an array and HDF5's own records
// carry one (Fletcher's of 32 bits, Jenkins' lookup3), and reading what a disk has changed is an error. For
// files of ours; other programs' versions of HDF5 may be too old.
enum class Checksums { no, yes };

class ParallelFile {
 public:
  static ParallelFile create(const Communicator& comm, const std::string& path,
                             Checksums checksums = Checksums::no);              // replaces what is there
  static ParallelFile open(const Communicator& comm, const std::string& path);  // to read
  ~ParallelFile();
  ParallelFile(ParallelFile&&) noexcept;

  void group(const std::string& name);

  // `memory` holds an array of in_memory.extent; both slabs have the same counts. float, double, (u)int8, 16,
  // 32, 64. Reading checks that the dataset has the extent that `in_file` says.
  template <class T>
  void write(const std::string& name, const Slab& in_file, const T* memory, const Slab& in_memory) {
    write_raw(name, type_of<T>(), in_file, memory, in_memory);
  }
  template <class T>
  void read(const std::string& name, const Slab& in_file, T* memory, const Slab& in_memory) {
    read_raw(name, type_of<T>(), in_file, memory, in_memory);
  }

  // Small one-dimensional things: written by the root, read by every rank. The root's are what counts; the
  // others' may differ, in length too (a text with a time measured has as many digits as it has).
  template <class T>
  void write_list(const std::string& name, const std::vector<T>& values) {
    const Slab all = Slab::whole({of_root(values.size())});
    write(name, is_root() ? all : Slab::nothing(all.extent), values.data(),
          is_root() ? all : Slab::nothing(all.extent));
  }
  template <class T>
  std::vector<T> read_list(const std::string& name) {
    const Slab all = Slab::whole({length(name)});
    std::vector<T> values(all.count[0]);
    read(name, all, values.data(), all);
    return values;
  }
  void write_text(const std::string& name, const std::string& text);
  std::string read_text(const std::string& name);
  // Of UTF-8, as strings of one length that zero bytes fill up: such bytes at a text's end do not come back.
  void write_texts(const std::string& name, const std::vector<std::string>& texts);
  std::vector<std::string> read_texts(const std::string& name);

  // Attributes of a group or, with "/", of the file. The same values on all ranks.
  void attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values);
  void attribute(const std::string& object, const std::string& name, const std::string& text);

  // Flushes and closes: only after this is the file whole.
  void close();

 private:
  enum class Type { f32, f64, i8, u8, i16, u16, i32, u32, i64, u64 };
  struct Native;
  ParallelFile(const Communicator& comm, const std::string& path, bool writing);

  template <class T>
  static constexpr Type type_of() {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 4 ? Type::f32 : Type::f64;
    constexpr int log2_size = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
    return static_cast<Type>(static_cast<int>(Type::i8) + 2 * log2_size + std::is_unsigned_v<T>);
  }
  bool is_root() const;
  std::uint64_t of_root(std::uint64_t value) const;
  std::uint64_t length(const std::string& name);
  void write_raw(const std::string& name, Type type, const Slab& in_file, const void* memory,
                 const Slab& in_memory);
  void read_raw(const std::string& name, Type type, const Slab& in_file, void* memory, const Slab& in_memory);

  std::unique_ptr<Native> native_;
};

}  // namespace icebow
