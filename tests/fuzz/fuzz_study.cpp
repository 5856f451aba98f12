// A study file: mistakes are told, or every design of it can be planned.
#include "base/errors.h"
#include "base/json.h"
#include "study/plan/design_space.h"
#include "study/spec/read_study.h"

using namespace icebow;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Json document = parse_json(std::string(reinterpret_cast<const char*>(data), size), "fuzz.json");
    const StudySpec spec = read_study(document, "fuzz.json");
    double designs = spec.method.samples + spec.designs.size();
    for (const Variable& v : spec.method.variables)
      designs *= v.values.empty() ? v.levels + 1 : v.values.size();
    if (designs * spec.repeats < 10) plan_study(spec);
  } catch (const InputError&) {
  }
  return 0;
}
