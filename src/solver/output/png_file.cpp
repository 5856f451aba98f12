#include "solver/output/png_file.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/errors.h"
#include "base/json.h"
#include "solver/output/palette.h"

namespace icebow {
namespace {

constexpr std::size_t signature = 8, frame_size = 12;  // bytes: of a file's head, of a chunk around its data

// A PNG in memory, of `image.format`.
std::string encoded(png_image image, const void* pixels, const void* palette, const std::string& path) {
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(bytes, '\0');
  if (!png_image_write_to_memory(&image, file.data(), &bytes, 0, pixels, 0, palette))
    throw RuntimeError("cannot write " + path + ": " + image.message);
  file.resize(bytes);
  return file;
}

void put_u16(std::string& out, unsigned value) {
  out += static_cast<char>(value >> 8);
  out += static_cast<char>(value & 0xFF);
}
void put_u32(std::string& out, std::uint32_t value) {
  put_u16(out, value >> 16);
  put_u16(out, value & 0xFFFF);
}

void put_chunk(std::string& out, const std::string& type, const std::string& data) {
  put_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::string body = type + data;
  out += body;
  put_u32(out, static_cast<std::uint32_t>(
                   crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
}

struct Chunk {
  std::string type, data;
};

std::vector<Chunk> chunks(const std::string& png) {
  std::vector<Chunk> list;
  for (std::size_t at = signature; at + frame_size <= png.size();) {
    std::size_t size = 0;
    for (std::size_t k = 0; k < 4; ++k) size = size << 8 | static_cast<unsigned char>(png[at + k]);
    list.push_back({png.substr(at + 4, 4), png.substr(at + 8, size)});
    at += size + frame_size;
  }
  return list;
}

// The indexed pixels of a rectangle as a PNG; every one with the whole palette.
std::string encoded(const Indexed& frame, const Rectangle& part, const Palette& palette,
                    const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.width = static_cast<png_uint_32>(part.width);
  image.height = static_cast<png_uint_32>(part.height);
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  std::vector<std::uint8_t> pixels;
  for (int row = part.top; row < part.top + part.height; ++row) {
    const auto from = frame.pixels.begin() + static_cast<std::ptrdiff_t>(row) * frame.width + part.left;
    pixels.insert(pixels.end(), from, from + part.width);
  }
  return encoded(image, pixels.data(), palette.rgb().data(), path);
}

std::string frame_control(std::uint32_t sequence, const Rectangle& part, double seconds) {
  std::string data;
  put_u32(data, sequence);
  for (const int value : {part.width, part.height, part.left, part.top})
    put_u32(data, static_cast<std::uint32_t>(value));
  put_u16(data, static_cast<unsigned>(std::clamp(std::lround(1000.0 * seconds), 1L, 65000L)));
  put_u16(data, 1000);
  return data + std::string(2, '\0');  // the frame stays, and what is drawn replaces what was
}

}  // namespace

void write_png(const std::string& path, const Raster& raster) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGB;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);
  write_text_file(path, encoded(image, raster.rgb.data(), nullptr, path));
}

Raster read_png(const std::string& path) {
  constexpr std::uint64_t most_pixels = 100'000'000;  // ours have a hundredth; a header may say anything
  const std::string file = read_text_file(path, std::uint64_t{1} << 28);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Raster raster;
  bool read = png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0;
  if (read && std::uint64_t{image.width} * image.height > most_pixels) {
    png_image_free(&image);
    throw InputError(path + ": a picture of " + std::to_string(image.width) + " x " +
                     std::to_string(image.height) + " pixels is none of a run's");
  }
  if (read) {
    image.format = PNG_FORMAT_RGB;
    raster.width = static_cast<int>(image.width), raster.height = static_cast<int>(image.height);
    raster.rgb.resize(PNG_IMAGE_SIZE(image));
    read = png_image_finish_read(&image, nullptr, raster.rgb.data(), 0, nullptr) != 0;
  }
  if (!read) throw InputError(path + ": no PNG picture: " + image.message);
  return raster;
}

void write_animated_png(const std::string& path, const std::vector<Raster>& frames, double seconds) {
  if (frames.empty()) throw std::invalid_argument("an animation needs a frame");
  for (const Raster& frame : frames)
    if (frame.width != frames[0].width || frame.height != frames[0].height)
      throw std::invalid_argument("the pictures of an animation are of one size");
  const Palette palette(frames);
  std::string out;
  std::uint32_t sequence = 0;
  Indexed before;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Indexed now = palette.indexed(frames[k]);
    const Rectangle part = k == 0 ? Rectangle{0, 0, now.width, now.height} : changed(before, now);
    const std::string png = encoded(now, part, palette, path);
    const double shown = seconds + (k + 1 == frames.size() ? 2.0 : 0.0);
    std::string data;
    for (const Chunk& chunk : chunks(png)) {
      if (chunk.type == "IDAT") data += chunk.data;
      if (k == 0 && chunk.type != "IDAT" && chunk.type != "IEND") {
        if (out.empty()) out = png.substr(0, signature);
        put_chunk(out, chunk.type, chunk.data);
      }
    }
    if (k == 0) {
      std::string control;
      put_u32(control, static_cast<std::uint32_t>(frames.size()));
      put_u32(control, 0);  // for ever
      put_chunk(out, "acTL", control);
    }
    put_chunk(out, "fcTL", frame_control(sequence++, part, shown));
    if (k == 0) {
      put_chunk(out, "IDAT", data);
    } else {
      std::string numbered;
      put_u32(numbered, sequence++);
      put_chunk(out, "fdAT", numbered + data);
    }
    before = std::move(now);
  }
  put_chunk(out, "IEND", "");
  write_text_file(path, out);
}

}  // namespace icebow
