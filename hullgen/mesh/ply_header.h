// The header of a PLY file: which elements follow it, how many rows each has, and of what numbers a row is
// made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace icebow {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  // where the rows begin, in bytes
  int lines = 0;
};

std::size_t bytes_of(PlyType type);
bool is_whole(PlyType type);

// `path` is for messages. Throws InputError with file and line, also where the rows that are announced cannot
// stand in the bytes there are.
PlyHeader read_ply_header(const std::string& content, const std::string& path);

}  // namespace icebow
