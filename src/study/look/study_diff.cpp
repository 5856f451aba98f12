#include "study/look/study_diff.h"

#include <map>
#include <set>

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/look/stored_design.h"
#include "study/plan/ranking.h"
#include "study/spec/design_name.h"

namespace icebow {
namespace {

Json asked_differently(const Json& first, const Json& second) {
  const Json a = first.flatten(), b = second.flatten();
  std::set<std::string> pointers;
  for (const auto& [pointer, value] : a.items()) pointers.insert(pointer);
  for (const auto& [pointer, value] : b.items()) pointers.insert(pointer);
  Json list = Json::array();
  for (const std::string& pointer : pointers) {
    const Json one = a.contains(pointer) ? a.at(pointer) : Json(nullptr),
               other = b.contains(pointer) ? b.at(pointer) : Json(nullptr);
    if (one != other) list.push_back({{"at", pointer}, {"first", one}, {"second", other}});
  }
  return list;
}

using Rows = std::map<std::string, RankedDesign>;

// What a point of a method is known by: its numbers and its words.
std::string point_of(const Evaluation& e) {
  return Json{parameters_json(e.parameters), part_at(e.result, result_key::choices)}.dump();
}

// What a design is known by in both.
Rows rows_of(const Ranking& ranking) {
  Rows rows;
  for (const RankedDesign& row : ranking.rows) {
    const Evaluation& e = row.evaluation;
    rows[is_numbered_name(e.name) ? point_of(e) : e.name] = row;
  }
  return rows;
}

Json side(const RankedDesign& row) {
  return {{"design", row.evaluation.name}, {"rank", row.rank}, {"value", finite_or_null(row.value)}};
}

}  // namespace

Json study_diff(const std::string& first, const std::string& second) {
  const Store a = open_store_of(first), b = open_store_of(second);
  const Ranking ranked_a = stored_ranking(a), ranked_b = stored_ranking(b);
  const Rows rows_a = rows_of(ranked_a), rows_b = rows_of(ranked_b);
  const bool one_number = ranked_a.rank_by == ranked_b.rank_by;
  Json diff = {{"study", asked_differently(document_of(a), document_of(b))},
               {"rank_by", {ranked_a.rank_by, ranked_b.rank_by}},
               {"designs", Json::array()},
               {"only_first", Json::array()},
               {"only_second", Json::array()}};
  for (const auto& [known_by, row] : rows_a) {
    const auto other = rows_b.find(known_by);
    if (other == rows_b.end()) {
      diff["only_first"].push_back(row.evaluation.name);
    } else {
      diff["designs"].push_back(
          {{"first", side(row)},
           {"second", side(other->second)},
           {"ratio", one_number ? finite_or_null(other->second.value / row.value) : Json(nullptr)}});
    }
  }
  for (const auto& [known_by, row] : rows_b)
    if (rows_a.count(known_by) == 0) diff["only_second"].push_back(row.evaluation.name);
  return diff;
}

}  // namespace icebow
