#include "study/plan/augmentation.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_keys.h"

namespace icebow {
namespace {

// The method as far as the points of its first hypercube hang on it.
Json hypercube_of(const Json& document) {
  const Json& method = part_at(document, document_key::method);
  if (text_at(document, document_key::method_type) != "latin_hypercube") return nullptr;
  return {{"variables", part_at(document, document_key::method_variables)},
          {"seed", method.value("seed", Json(1))}};
}

int samples_of(const Json& document) {
  const double given = number_at(document, document_key::method_samples);
  return static_cast<int>(std::isnan(given) ? find_key("method", "samples")->fallback : given);
}

std::vector<int> extends_of(const Json& document) {
  const Json& list = part_at(document, document_key::method_extends);
  return list.is_array() ? list.get<std::vector<int>>() : std::vector<int>();
}

}  // namespace

StudySpec continued_from(StudySpec spec, const Json& before) {
  const Json hypercube = hypercube_of(spec.document);
  if (hypercube.is_null() || hypercube != hypercube_of(before) || !spec.method.extends.empty()) return spec;
  std::vector<int> numbers = extends_of(before);
  numbers.push_back(samples_of(before));
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(),
                               [&](int samples) { return samples >= spec.method.samples; }),
                numbers.end());
  if (numbers.empty()) return spec;
  spec.method.extends = numbers;
  spec.document["method"]["extends"] = numbers;
  return spec;
}

std::string words_on_extension(const StudySpec& given, const StudySpec& continued) {
  if (given.method.extends == continued.method.extends) return "";
  return "the " + std::to_string(continued.method.extends.back()) +
         " samples of before stay, the others are added to them; with \"extends\": " +
         Json(continued.method.extends).dump() + " in its method the study file says so itself";
}

}  // namespace icebow
