// Records in JSON or lines that pass between processes, runs and versions: an evaluation, a design, a race, a
// child's progress; and a table of designs. The first byte says which.
#include "base/errors.h"
#include "base/json_fields.h"
#include "study/evaluate/design.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/progress_json.h"
#include "study/plan/race_record.h"
#include "study/spec/spec_table.h"
#include "tests/fuzz/memory_file.h"

using namespace icebow;

namespace {

// As their readers do, who tell whatever is wrong by exceptions.
template <class Read>
void told(const Read& read) {
  try {
    read();
  } catch (const std::exception&) {
  }
}

void read_table(const std::uint8_t* data, std::size_t size) {
  Json document = {{"method", {{"type", "table"}, {"file", memory_file(".csv", data, size)}}}};
  take_in_table(document, "");
  for (const Json& row : document.at("method").at("rows"))
    if (row.size() != document.at("method").at("columns").size()) std::abort();
}

void read_race_record(const Json& json) {
  const RaceRecord record = race_record_from_json(json);
  to_json(record);
  race_in_words(record);
  for (const auto& [name, key] : record.keys) place_in_race(record, name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 5) {
    case 0:
      told([&] { to_json(evaluation_from_json(parse_json(text, "evaluation"))); });
      break;
    case 1:
      told([&] { to_json(design_from_json(parse_json(text, "design"))); });
      break;
    case 2:
      told([&] { read_race_record(parse_json(text, "race")); });
      break;
    case 3:
      progress_from_line(text);
      trouble_from_line(text);
      break;
    default:
      told([&] { read_table(data + 1, size - 1); });
  }
  return 0;
}
