#include "solver/lattice/field.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace icebow {

Field::Field(std::size_t n, Precision precision, int stagger) : fp64_(precision == Precision::fp64) {
  constexpr std::size_t line = 64, lines_apart = 5;
  const std::size_t offset = stagger * lines_apart * line;
  const std::size_t bytes = offset + (n * element_size() + line - 1) / line * line;
  memory_.reset(static_cast<std::byte*>(std::aligned_alloc(line, bytes)));
  if (!memory_) throw std::bad_alloc();
  std::memset(memory_.get(), 0, bytes);
  data_ = memory_.get() + offset;
}

void Field::Free::operator()(std::byte* p) const {
  std::free(p);
}

}  // namespace icebow
