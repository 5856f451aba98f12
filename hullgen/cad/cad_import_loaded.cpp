// Stands in front of cad_import.cpp, which is loaded with OpenCASCADE when a file is first read.
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "base/errors.h"
#include "base/file_kind.h"
#include "base/guarded_work.h"
#include "base/plugin.h"
#include "hullgen/cad/cad_import.h"
#include "hullgen/mesh/mesh_io.h"

namespace icebow {

bool is_cad_file(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".step" || ending == ".stp" || ending == ".igs" || ending == ".iges";
}

namespace {

constexpr int most_seconds = 300;  // a frigate's hull takes eight

template <class T>
void put(std::string& bytes, const std::vector<T>& list) {
  const std::uint64_t count = list.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(list.data()), count * sizeof(T));
}

template <class T>
std::vector<T> taken(const std::string& bytes, std::size_t& at) {
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data() + at, sizeof count);
  std::vector<T> list(count);
  std::memcpy(list.data(), bytes.data() + at + sizeof count, count * sizeof(T));
  at += sizeof count + count * sizeof(T);
  return list;
}

using Read = void (*)(const std::string&, bool, std::vector<std::string>&, QuadMesh&);

// "E" and a message, or "M", the mesh, and the notes each with a line end.
std::string packed(Read read, const std::string& path, bool step) {
  std::vector<std::string> notes;
  QuadMesh mesh;
  try {
    read(path, step, notes, mesh);
  } catch (const std::exception& error) {
    return std::string("E") + error.what();
  }
  std::string bytes = "M";
  std::vector<std::array<double, 3>> points;
  for (const Vec3& p : mesh.points) points.push_back({p.x(), p.y(), p.z()});
  put(bytes, points);
  put(bytes, mesh.quads);
  put(bytes, mesh.patch);
  for (const std::string& note : notes) bytes += note + "\n";
  return bytes;
}

QuadMesh unpacked(const std::string& bytes, std::vector<std::string>& notes) {
  QuadMesh mesh;
  std::size_t at = 1;
  for (const auto& p : taken<std::array<double, 3>>(bytes, at)) mesh.points.emplace_back(p[0], p[1], p[2]);
  mesh.quads = taken<std::array<int, 4>>(bytes, at);
  mesh.patch = taken<Patch>(bytes, at);
  std::istringstream lines(bytes.substr(at));
  for (std::string note; std::getline(lines, note);) notes.push_back(note);
  return mesh;
}

}  // namespace

// OpenCASCADE crashes on files with one word misspelt, and searches for ever in others.
QuadMesh read_cad(const std::string& path, std::vector<std::string>& notes) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": " + why_no_file(path));
  static const auto read = reinterpret_cast<Read>(plugin_function("libicebow_cad.so", "icebow_read_cad"));
  const std::string ending = ending_of(path);
  const bool step = ending == ".step" || ending == ".stp";
  const GuardedResult result = guarded_work([&] { return packed(read, path, step); }, most_seconds);
  if (!result.trouble.empty() || result.bytes.empty())
    throw InputError(path + ": is damaged, or too much for OpenCASCADE, which " + result.trouble +
                     " while it read the file: export it again, or as a mesh (.stl, .obj, .ply)");
  if (result.bytes[0] == 'E') throw InputError(result.bytes.substr(1));
  return unpacked(result.bytes, notes);
}

}  // namespace icebow
