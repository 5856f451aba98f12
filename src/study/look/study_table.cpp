#include "study/look/study_table.h"

#include <cmath>
#include <set>

#include "base/communicator.h"
#include "base/csv_cell.h"
#include "base/errors.h"
#include "base/json_words.h"
#include "base/parallel_file.h"
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

// One line's cells of some columns.
std::string cells(const std::map<std::string, std::vector<double>>& columns, std::size_t k) {
  std::string line;
  for (const auto& [column, numbers] : columns)
    line += "," + (std::isfinite(numbers[k]) ? Json(numbers[k]).dump() : std::string());
  return line;
}

std::string cells(const std::map<std::string, std::vector<std::string>>& columns, std::size_t k) {
  std::string line;
  for (const auto& [column, words] : columns) line += "," + csv_cell(words[k]);
  return line;
}

// The list of a column, as long as there are designs.
template <class T>
std::vector<T>& list_of(std::map<std::string, std::vector<T>>& columns, const std::string& column,
                        std::size_t designs, const T& none) {
  std::vector<T>& list = columns[column];
  if (list.empty()) list.assign(designs, none);
  return list;
}

void add(StudyColumns& columns, std::size_t k, const Json& row, std::size_t designs) {
  for (const char* key : {"design", "status", "reason", "front"})
    if (row.contains(key))
      list_of(columns.texts, key, designs, std::string())[k] = row.at(key).get<std::string>();
  columns.ranks.push_back(row.at("rank").get<int>());
  for (const auto& [pointer, value] : row.at("parameters").items())
    if (value.is_number())
      list_of(columns.parameters, pointer, designs, double(NAN))[k] = value.get<double>();
  for (const auto& [pointer, word] : words_at(row.at("result"), result_key::choices))
    list_of(columns.choices, pointer, designs, std::string())[k] = word;
  Numbers numbers;
  for (const auto& [part, value] : row.at("result").items())
    if (part != "parameters") collect(value, "/" + part, numbers);
  for (const auto& [pointer, value] : numbers)
    list_of(columns.results, pointer, designs, double(NAN))[k] = value;
}

// Lists below a group, by their pointers; the groups between are made.
template <class T, class Write>
void write_below(ParallelFile& file, const std::string& group,
                 const std::map<std::string, std::vector<T>>& columns, const Write& write) {
  std::set<std::string> groups;
  file.group(group);
  for (const auto& [pointer, list] : columns) {
    for (std::size_t end = pointer.find('/', 1); end != std::string::npos; end = pointer.find('/', end + 1)) {
      const std::string part = pointer.substr(0, end);
      if (columns.count(part) > 0)
        throw InputError(part +
                         ": is a number in one design and has parts in another, for which HDF5 has no "
                         "column; take --csv");
      if (groups.insert(part).second) file.group(group + part);
    }
    write(group + pointer, list);
  }
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

StudyColumns study_columns(const Json& table) {
  StudyColumns columns;
  for (std::size_t k = 0; k < table.size(); ++k) add(columns, k, table[k], table.size());
  return columns;
}

std::string study_csv(const Json& table) {
  const StudyColumns columns = study_columns(table);
  const bool two = !table.empty() && table[0].contains("front");
  std::string csv = std::string("design,status,reason,rank") + (two ? ",front" : "");
  for (const auto& [column, words] : columns.choices) csv += "," + csv_cell("choice:" + column);
  for (const auto& [column, numbers] : columns.parameters) csv += "," + csv_cell(column);
  for (const auto& [column, numbers] : columns.results) csv += "," + csv_cell("result:" + column);
  csv += "\r\n";
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (const char* key : {"design", "status", "reason"}) csv += csv_cell(columns.texts.at(key)[k]) + ",";
    csv += std::to_string(columns.ranks[k]) + (two ? "," + columns.texts.at("front")[k] : "") +
           cells(columns.choices, k) + cells(columns.parameters, k) + cells(columns.results, k) + "\r\n";
  }
  return csv;
}

void write_study_hdf5(const Json& table, const std::string& path) {
  const StudyColumns columns = study_columns(table);
  ParallelFile file = ParallelFile::create(Communicator::serial(), path);
  const auto write_numbers = [&](const std::string& name, const std::vector<double>& numbers) {
    file.write_list(name, numbers);
  };
  const auto write_words = [&](const std::string& name, const std::vector<std::string>& words) {
    file.write_texts(name, words);
  };
  for (const auto& [name, words] : columns.texts) file.write_texts(name, words);
  file.write_list("rank", columns.ranks);
  write_below(file, "choices", columns.choices, write_words);
  write_below(file, "parameters", columns.parameters, write_numbers);
  write_below(file, "results", columns.results, write_numbers);
  file.close();
}

}  // namespace icebow
