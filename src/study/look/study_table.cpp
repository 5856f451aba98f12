#include "study/look/study_table.h"

#include <map>
#include <set>

#include "base/json_fields.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/result_keys.h"
#include "study/look/stored_design.h"
#include "study/plan/ranking.h"

namespace icebow {
namespace {

using Numbers = std::map<std::string, double>;

void collect(const Json& part, const std::string& pointer, Numbers& numbers) {
  if (part.is_number()) numbers[pointer] = part.get<double>();
  if (part.is_array() && pointer == result_key::scenarios)
    for (std::size_t k = 0; k < part.size(); ++k)
      collect(part[k], pointer + std::string("/") + std::to_string(k), numbers);
  if (!part.is_object()) return;
  for (const auto& [key, value] : part.items()) collect(value, pointer + "/" + key, numbers);
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cells(const Numbers& numbers, const std::set<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) {
    const auto found = numbers.find(column);
    line += "," + (found == numbers.end() ? std::string() : Json(found->second).dump());
  }
  return line;
}

std::string words(const std::map<std::string, std::string>& choices, const std::set<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) {
    const auto found = choices.find(column);
    line += "," + (found == choices.end() ? std::string() : cell(found->second));
  }
  return line;
}

struct Line {
  std::string head;
  std::map<std::string, std::string> choices;
  Numbers parameters, results;
};

Line line_of(const Json& row) {
  Line line;
  for (const char* key : {"design", "status", "reason"})
    line.head += cell(row.at(key).get<std::string>()) + ",";
  line.head += std::to_string(row.at("rank").get<int>());
  if (row.contains("front")) line.head += "," + row.at("front").get<std::string>();
  for (const auto& [pointer, value] : row.at("parameters").items())
    if (value.is_number()) line.parameters[pointer] = value.get<double>();
  const Json& choices = part_at(row.at("result"), result_key::choices);
  if (choices.is_object())
    for (const auto& [pointer, value] : choices.items()) line.choices[pointer] = value.get<std::string>();
  for (const auto& [part, value] : row.at("result").items())
    if (part != "parameters") collect(value, "/" + part, line.results);
  return line;
}

}  // namespace

Json study_table(const std::string& directory) {
  const Store store = open_store_of(directory);
  const std::vector<Evaluation> evaluations = store.all();
  const Ranking ranking = stored_ranking(store);
  std::map<std::string, const RankedDesign*> ranks;
  for (const RankedDesign& row : ranking.rows) ranks[row.evaluation.name] = &row;
  Json table = Json::array();
  for (const Evaluation& e : evaluations) {
    const RankedDesign* row = ranks[e.name];
    table.push_back({{"design", e.name},
                     {"status", to_string(e.status)},
                     {"reason", e.reason},
                     {"rank", row ? row->rank : 0},
                     {"parameters", parameters_json(e.parameters)},
                     {"result", e.result.is_object() ? e.result : Json::object()}});
    if (ranking.objective.given()) table.back()["front"] = row ? to_string(row->front) : "";
  }
  return table;
}

std::string study_csv(const Json& table) {
  std::vector<Line> lines;
  std::set<std::string> choices, parameters, results;
  for (const Json& row : table) {
    lines.push_back(line_of(row));
    for (const auto& [column, value] : lines.back().choices) choices.insert(column);
    for (const auto& [column, value] : lines.back().parameters) parameters.insert(column);
    for (const auto& [column, value] : lines.back().results) results.insert(column);
  }
  std::string csv = "design,status,reason,rank";
  if (!table.empty() && table[0].contains("front")) csv += ",front";
  for (const std::string& column : choices) csv += "," + cell("choice:" + column);
  for (const std::string& column : parameters) csv += "," + cell(column);
  for (const std::string& column : results) csv += "," + cell("result:" + column);
  csv += "\r\n";
  for (const Line& line : lines)
    csv += line.head + words(line.choices, choices) + cells(line.parameters, parameters) +
           cells(line.results, results) + "\r\n";
  return csv;
}

}  // namespace icebow
