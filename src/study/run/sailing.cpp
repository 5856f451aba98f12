#include "study/run/sailing.h"

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

const Json::json_pointer sailed_to_at(result_key::sailed_to), ended_at(result_key::sailing_ended);

}  // namespace

void adopt_first_leg(Store& store, const PlannedDesign& planned) {
  if (planned.other_key.empty() || store.find(planned.key)) return;
  std::optional<Evaluation> other = store.find(planned.other_key);
  if (!other || other->status != EvaluationStatus::ok) return;
  const double first_leg = planned.design.given->advance;
  const bool races = planned.design.sail_to > 0.0;
  if (!races && number_at(other->result, result_key::sailed_to) != first_leg) return;
  other->key = planned.key;
  if (races) other->result[sailed_to_at] = first_leg;
  if (!races) other->result.erase(sailed_to_at.back());
  store.together([&] {
    store.remove(planned.other_key);
    store.put(*other);
  });
}

bool is_far_enough(const PlannedDesign& planned, const Evaluation& stored) {
  if (planned.design.sail_to == 0.0 || stored.status != EvaluationStatus::ok) return true;
  return !(number_at(stored.result, result_key::sailed_to) < planned.design.sail_to);
}

bool has_ended(const Evaluation& stored) {
  return !text_at(stored.result, result_key::sailing_ended).empty();
}

std::string end_sailing(Evaluation& stored, const std::string& reason) {
  stored.result[ended_at] = reason;
  return stored.name + ": cannot be sailed on: " + reason +
         "; what it has sailed stands (--retry-failed tries it again)";
}

}  // namespace icebow
