// Whole files of text.
#pragma once

#include <cstdint>
#include <string>

namespace icebow {

// Writes under a temporary name, to the disk itself, then renames: a reader never sees half a file, nor does
// a kill or a power cut leave one. Links are not followed. Throws RuntimeError.
void write_text_file(const std::string& path, const std::string& text);

// Throws InputError where it cannot be read or has more than `most` bytes.
std::string read_text_file(const std::string& path, std::uint64_t most = std::uint64_t{1} << 36);

}  // namespace icebow
