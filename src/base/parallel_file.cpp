#include "base/parallel_file.h"

#include <hdf5.h>

#include <algorithm>
#include <cassert>
#include <cstdio>

#include "base/collective.h"
#include "base/errors.h"

namespace icebow {
namespace {

// At the end of the program HDF5 would try again, and crash, on a file that a full disk left unfinished;
// those that were closed are whole. HDF5 that begins after MPI would end with MPI: it begins before main.
[[maybe_unused]] const bool begun = [] {
  H5dont_atexit();
  return H5open() >= 0 && H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
}();

// An identifier of HDF5, given back at the end of its life.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }
  bool ok() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// What HDF5 says went wrong, from the innermost call; of what it says of a disk the system's words alone.
std::string last_error() {
  std::string text;
  const auto take = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    std::string& first = *static_cast<std::string*>(out);
    if (first.empty() && error->desc) first = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &text);
  const std::string before = "error message = '";
  const std::size_t words = text.find(before), end = text.find('\'', words + before.size());
  if (words != std::string::npos && end != std::string::npos)
    return text.substr(words + before.size(), end - words - before.size());
  return text.empty() ? "HDF5 does not say why" : text;
}

std::vector<hsize_t> sizes(const std::vector<std::uint64_t>& values) {
  return {values.begin(), values.end()};
}

// Chunks have no place for an array without elements.
bool is_empty(const Slab& slab) {
  for (std::uint64_t n : slab.extent) {
    if (n == 0) return true;
  }
  return false;
}

constexpr hsize_t most_listed = hsize_t{1} << 32;  // elements that every rank reads
constexpr hsize_t most_part_bytes = 1 << 20;

// Parts of an array that carry a checksum each: whole along the last axes, a megabyte at most.
std::vector<hsize_t> part_of(const std::vector<std::uint64_t>& extent, std::size_t element) {
  std::vector<hsize_t> part = sizes(extent);
  hsize_t bytes = element;
  for (const hsize_t n : part) bytes *= n;
  for (hsize_t& n : part) {
    const hsize_t times = std::min(n, (bytes + most_part_bytes - 1) / most_part_bytes);
    bytes = bytes / n;
    n = (n + times - 1) / times;
    bytes *= n;
  }
  return part;
}

hid_t text_type(std::uint64_t width) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, width);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

std::uint64_t elements(const Slab& slab) {
  std::uint64_t n = 1;
  for (const std::uint64_t along : slab.count) n *= along;
  return n;
}

// A selection of HDF5; nothing where a count is 0.
hid_t selection(const Slab& slab) {
  const std::vector<hsize_t> extent = sizes(slab.extent), start = sizes(slab.start),
                             count = sizes(slab.count);
  const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
  if (space < 0) return space;
  bool empty = false;
  for (hsize_t n : count) empty = empty || n == 0;
  if (empty) {
    H5Sselect_none(space);
  } else {
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  }
  return space;
}

}  // namespace

Slab Slab::whole(const std::vector<std::uint64_t>& extent) {
  return {extent, std::vector<std::uint64_t>(extent.size(), 0), extent};
}

Slab Slab::nothing(const std::vector<std::uint64_t>& extent) {
  return {extent, std::vector<std::uint64_t>(extent.size(), 0), std::vector<std::uint64_t>(extent.size(), 0)};
}

// Where a disk fails while several ranks write one file by MPI-IO, those it does not touch wait for ever in
// HDF5. So the root alone writes: the others send it their parts, one after the other. To read, each rank
// opens the file by itself.
struct ParallelFile::Native {
  Communicator comm;
  std::string path;
  hid_t file = H5I_INVALID_HID;
  bool writing = false, checksums = false;

  Native(const Communicator& c, const std::string& p, bool w) : comm(c), path(p), writing(w) {}
  ~Native() {
    if (file >= 0) H5Fclose(file);
  }

  bool has_file() const { return !writing || comm.is_root(); }

  static hid_t access() {
    const hid_t properties = H5Pcreate(H5P_FILE_ACCESS);
    // Nobody reads a file before it has its name, and some file systems have no locks.
    H5Pset_file_locking(properties, false, true);
    return properties;
  }

  void agree(bool ok, const std::string& why) const {
    fail_together(comm, ok ? "" : "cannot " + std::string(writing ? "write " : "read ") + path + ": " + why);
  }
  void agree(bool ok) const { agree(ok, ok ? std::string() : last_error()); }

  hid_t new_set(const std::string& name, hid_t type, const Slab& in_file) const {
    const Handle there(selection(in_file), H5Sclose), layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (checksums && !is_empty(in_file)) {
      const std::vector<hsize_t> part = part_of(in_file.extent, H5Tget_size(type));
      H5Pset_chunk(layout, static_cast<int>(part.size()), part.data());
      H5Pset_fletcher32(layout);
    }
    return H5Dcreate2(file, name.c_str(), type, there, H5P_DEFAULT, layout, H5P_DEFAULT);
  }

  void write(const std::string& name, hid_t type, const Slab& in_file, const void* memory,
             const Slab& in_memory) const {
    assert(in_file.count.size() == in_file.extent.size());
    const Handle set(has_file() ? new_set(name, type, in_file) : H5I_INVALID_HID, H5Dclose);
    agree(!has_file() || set.ok());
    if (is_empty(in_file)) return;
    std::vector<std::uint64_t> own = in_file.start;
    own.insert(own.end(), in_file.count.begin(), in_file.count.end());
    const std::vector<std::uint64_t> boxes = gather(comm, own);
    std::string trouble;
    if (has_file()) {
      const Handle there(selection(in_file), H5Sclose), here(selection(in_memory), H5Sclose);
      if (H5Dwrite(set, type, here, there, H5P_DEFAULT, memory) < 0) trouble = last_error();
      for (int rank = 1; rank < comm.size(); ++rank) {
        const auto at = boxes.begin() + static_cast<std::ptrdiff_t>(own.size()) * rank;
        const auto middle = at + static_cast<std::ptrdiff_t>(in_file.extent.size());
        const Slab part{in_file.extent, {at, middle}, {middle, at + static_cast<std::ptrdiff_t>(own.size())}};
        write_part_of(rank, set, type, part, trouble);
      }
    } else {
      send(type, memory, in_memory);
    }
    agree(trouble.empty(), trouble);
  }

  // Where there was trouble before, the rank's part is taken and let go.
  void write_part_of(int rank, hid_t set, hid_t type, const Slab& part, std::string& trouble) const {
    std::vector<char> bytes(elements(part) * H5Tget_size(type));
    for (std::size_t at = 0; at < bytes.size(); at += Communicator::largest_message)
      comm.shift(nullptr, -1, bytes.data() + at, rank,
                 std::min(bytes.size() - at, Communicator::largest_message));
    if (bytes.empty() || !trouble.empty()) return;
    const hsize_t n = elements(part);
    const Handle there(selection(part), H5Sclose), here(H5Screate_simple(1, &n, nullptr), H5Sclose);
    if (H5Dwrite(set, type, here, there, H5P_DEFAULT, bytes.data()) < 0) trouble = last_error();
  }

  void send(hid_t type, const void* memory, const Slab& in_memory) const {
    std::vector<char> bytes(elements(in_memory) * H5Tget_size(type));
    if (bytes.empty()) return;
    const Handle here(selection(in_memory), H5Sclose);
    [[maybe_unused]] const herr_t packed =
        H5Dgather(here, memory, type, bytes.size(), bytes.data(), nullptr, nullptr);
    assert(packed >= 0);
    for (std::size_t at = 0; at < bytes.size(); at += Communicator::largest_message)
      comm.shift(bytes.data() + at, 0, nullptr, -1,
                 std::min(bytes.size() - at, Communicator::largest_message));
  }

  void read(const std::string& name, hid_t type, const Slab& in_file, void* memory,
            const Slab& in_memory) const {
    const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    agree(set.ok());
    const Handle stored(H5Dget_space(set), H5Sclose), there(selection(in_file), H5Sclose),
        here(selection(in_memory), H5Sclose);
    agree(H5Sextent_equal(stored, there) > 0, name + " has another size than it should");
    if (is_empty(in_file)) return;
    agree(H5Dread(set, type, here, there, H5P_DEFAULT, memory) >= 0);
  }

  static hid_t native_type(Type type) {
    switch (type) {
      case Type::f32:
        return H5T_NATIVE_FLOAT;
      case Type::f64:
        return H5T_NATIVE_DOUBLE;
      case Type::i8:
        return H5T_NATIVE_INT8;
      case Type::u8:
        return H5T_NATIVE_UINT8;
      case Type::i16:
        return H5T_NATIVE_INT16;
      case Type::u16:
        return H5T_NATIVE_UINT16;
      case Type::i32:
        return H5T_NATIVE_INT32;
      case Type::u32:
        return H5T_NATIVE_UINT32;
      case Type::i64:
        return H5T_NATIVE_INT64;
      case Type::u64:
        return H5T_NATIVE_UINT64;
    }
    return H5I_INVALID_HID;
  }
};

ParallelFile::ParallelFile(const Communicator& comm, const std::string& path, bool writing)
    : native_(std::make_unique<Native>(comm, path, writing)) {}
ParallelFile::ParallelFile(ParallelFile&&) noexcept = default;
ParallelFile::~ParallelFile() = default;

ParallelFile ParallelFile::create(const Communicator& comm, const std::string& path, Checksums checksums) {
  ParallelFile f(comm, path, true);
  Native& n = *f.native_;
  n.checksums = checksums == Checksums::yes;
  if (n.has_file()) {
    const Handle access(Native::access(), H5Pclose);
    // HDF5's records have checksums in the formats from 1.10 on only.
    if (n.checksums) H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    n.file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    n.agree(n.file >= 0);
  } else {
    n.agree(true);
  }
  return f;
}

ParallelFile ParallelFile::open(const Communicator& comm, const std::string& path) {
  ParallelFile f(comm, path, false);
  Native& n = *f.native_;
  const Handle access(Native::access(), H5Pclose);
  n.file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  n.agree(n.file >= 0);
  return f;
}

bool ParallelFile::is_root() const {
  return native_->comm.is_root();
}

// Datasets whose sizes differ between ranks part their ideas of the file: it is damaged, or never closed.
std::uint64_t ParallelFile::of_root(std::uint64_t value) const {
  broadcast(native_->comm, value);
  return value;
}

void ParallelFile::group(const std::string& name) {
  if (!native_->has_file()) return native_->agree(true);
  const Handle made(H5Gcreate2(native_->file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  native_->agree(made.ok());
}

void ParallelFile::write_raw(const std::string& name, Type type, const Slab& in_file, const void* memory,
                             const Slab& in_memory) {
  native_->write(name, Native::native_type(type), in_file, memory, in_memory);
}

void ParallelFile::read_raw(const std::string& name, Type type, const Slab& in_file, void* memory,
                            const Slab& in_memory) {
  native_->read(name, Native::native_type(type), in_file, memory, in_memory);
}

std::uint64_t ParallelFile::length(const std::string& name) {
  const Handle set(H5Dopen2(native_->file, name.c_str(), H5P_DEFAULT), H5Dclose);
  native_->agree(set.ok());
  const Handle space(H5Dget_space(set), H5Sclose);
  native_->agree(H5Sget_simple_extent_ndims(space) == 1, name + " is not a list");
  hsize_t n = 0;
  H5Sget_simple_extent_dims(space, &n, nullptr);
  native_->agree(n <= most_listed, name + " is longer than a list may be");
  return n;
}

void ParallelFile::write_text(const std::string& name, const std::string& text) {
  write_list(name, std::vector<std::uint8_t>(text.begin(), text.end()));
}

std::string ParallelFile::read_text(const std::string& name) {
  const std::vector<std::uint8_t> bytes = read_list<std::uint8_t>(name);
  return std::string(bytes.begin(), bytes.end());
}

void ParallelFile::write_texts(const std::string& name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  const std::uint64_t width = of_root(longest);
  const Slab all = Slab::whole({of_root(texts.size())});
  std::string padded;
  for (const std::string& text : texts) padded += text + std::string(longest - text.size(), '\0');
  const Handle type(text_type(width), H5Tclose);
  const Slab own = is_root() ? all : Slab::nothing(all.extent);
  native_->write(name, type, own, padded.data(), own);
}

std::vector<std::string> ParallelFile::read_texts(const std::string& name) {
  const Slab all = Slab::whole({length(name)});
  std::size_t width = 0;
  {
    const Handle set(H5Dopen2(native_->file, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle type(H5Dget_type(set), H5Tclose);
    native_->agree(H5Tget_class(type) == H5T_STRING, name + " is no list of texts");
    width = H5Tget_size(type);
  }
  std::string padded(width * all.extent[0], '\0');
  const Handle type(text_type(width), H5Tclose);
  native_->read(name, type, all, padded.data(), all);
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < padded.size(); at += width) {
    const std::size_t end = padded.find_last_not_of('\0', at + width - 1);
    texts.push_back(end == std::string::npos || end < at ? "" : padded.substr(at, end + 1 - at));
  }
  return texts;
}

void ParallelFile::attribute(const std::string& object, const std::string& name,
                             const std::vector<std::int64_t>& values) {
  if (!native_->has_file()) return native_->agree(true);
  const hsize_t n = values.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const Handle made(H5Acreate_by_name(native_->file, object.c_str(), name.c_str(), H5T_NATIVE_INT64, space,
                                      H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose);
  native_->agree(made.ok() && H5Awrite(made, H5T_NATIVE_INT64, values.data()) >= 0);
}

void ParallelFile::attribute(const std::string& object, const std::string& name, const std::string& text) {
  if (!native_->has_file()) return native_->agree(true);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose), type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.size());
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Handle made(H5Acreate_by_name(native_->file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                      H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose);
  native_->agree(made.ok() && H5Awrite(made, type, text.data()) >= 0);
}

void ParallelFile::close() {
  const hid_t file = native_->file;  // none where the root alone writes
  native_->file = H5I_INVALID_HID;
  native_->agree(file < 0 || H5Fclose(file) >= 0);
}

}  // namespace icebow
