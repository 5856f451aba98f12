// A store's file: refused in words, or rows that are whole or said to be damaged, with names that are safe.
#include <cstdlib>

#include "base/errors.h"
#include "study/plan/ranking.h"
#include "study/spec/design_name.h"
#include "study/store/store.h"
#include "tests/fuzz/memory_file.h"

using namespace icebow;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Store store = Store::open_read_only(memory_file(".sqlite", data, size));
    store.fact("rank_by");
    const std::vector<Evaluation> rows = store.all();
    for (const Evaluation& e : rows)
      if (!is_stored_name(e.name)) std::abort();
    to_json(rank_designs(rows, "mean_load"));
  } catch (const RuntimeError&) {
  }
  return 0;
}
