#include "reports/tables/table_report.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "study/plan/confirmation.h"
#include "study/store/store.h"
#include "tests/support/sample_study.h"
#include "tests/support/scratch.h"

namespace icebow {
namespace {

// A reader of RFC 4180 that knows nothing of the writer.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& field = rows.back().back();
    if (quoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && text[i] == ',') {
      rows.back().emplace_back();
    } else if (!quoted && text[i] == '\n') {
      rows.emplace_back(1);
    } else {
      field += text[i];
    }
  }
  rows.pop_back();
  return rows;
}

std::map<std::string, std::string> row_named(const std::vector<std::vector<std::string>>& rows,
                                             const std::string& name) {
  std::map<std::string, std::string> fields;
  for (const auto& row : rows)
    if (row.at(1) == name)
      for (std::size_t i = 0; i < row.size(); ++i) fields[rows[0].at(i)] = row[i];
  return fields;
}

}  // namespace

TEST_CASE("ranking.csv gives every number back to the last bit") {
  const Scratch study("csv");
  SampleStudy options;
  options.odd_name = "comma, \"quote\"";
  write_sample_study(study.path(), options);
  write_table_reports(study.path());
  const auto rows = parse_csv(read_text_file(study.path() + "/ranking.csv"));
  const StudyResults results = read_study_results(study.path());
  REQUIRE(rows.size() == results.ranking.rows.size() + 1);
  for (const auto& row : rows) CHECK(row.size() == rows[0].size());
  for (const RankedDesign& ranked : results.ranking.rows) {
    INFO(ranked.evaluation.name);
    auto fields = row_named(rows, ranked.evaluation.name);
    REQUIRE(fields.count("reason") == 1);
    CHECK(fields["status"] == to_string(ranked.evaluation.status));
    CHECK(fields["reason"] == ranked.evaluation.reason);
    CHECK(std::strtod(fields["/bow/stem_deg"].c_str(), nullptr) ==
          ranked.evaluation.parameters.at("/bow/stem_deg"));
    if (ranked.rank == 0) {
      CHECK(fields["rank"].empty());
      CHECK(fields["mean_load_N"].empty());
      continue;
    }
    CHECK(std::stoi(fields["rank"]) == ranked.rank);
    CHECK(std::strtod(fields["mean_load_N"].c_str(), nullptr) == ranked.mean_load);
    CHECK(std::strtod(fields["mean_load_ci95_N"].c_str(), nullptr) == ranked.mean_load_ci95);
    CHECK(std::strtod(fields["lindqvist_breaking_N"].c_str(), nullptr) == ranked.lindqvist_breaking);
    CHECK(fields["tied_with_best"] == (ranked.tied_with_best ? "1" : "0"));
  }
}

TEST_CASE("a study that confirms has the cycle's and the simulated load in its tables, with intervals") {
  const Scratch study("confirmed");
  SampleStudy options;
  options.odd_name = "odd";
  write_sample_study(study.path(), options);
  {
    Store store = Store::open(study.path() + "/results.sqlite");
    const std::vector<Evaluation> all = store.all();
    int n = 0;
    for (Evaluation e : all) {
      if (e.status != EvaluationStatus::ok) continue;
      ++n;
      e.result["cycle"] = {{"mean_load_N", 4e5 + 1e3 * n}, {"mean_load_ci95_N", 1e4}};
      Evaluation simulated = e;
      simulated.name = confirmation_name(e.name), simulated.key = e.key + "@";
      e.result["metrics"]["full_scale"]["mean_load_N"] = 4e5 + 1e3 * n;
      store.put(e);
      if (n < 3) store.put(simulated);
    }
  }
  write_table_reports(study.path());
  const StudyResults results = read_study_results(study.path());
  REQUIRE(results.ranking.confirmed.designs == 2);
  const auto rows = parse_csv(read_text_file(study.path() + "/ranking.csv"));
  const auto number = [](const std::string& field) { return std::strtod(field.c_str(), nullptr); };
  int simulated = 0;
  for (const RankedDesign& ranked : results.ranking.rows) {
    if (ranked.rank == 0) continue;
    auto fields = row_named(rows, ranked.evaluation.name);
    CHECK(number(fields["cycle_load_N"]) == ranked.cycle_load);
    CHECK(number(fields["cycle_load_ci95_N"]) == 1e4);
    CHECK(fields["solver_load_N"].empty() == std::isnan(ranked.solver_load));
    if (std::isnan(ranked.solver_load)) continue;
    ++simulated;
    CHECK(number(fields["solver_load_N"]) == ranked.solver_load);
    CHECK(number(fields["solver_load_ci95_N"]) == ranked.solver_ci95);
  }
  CHECK(simulated == 2);
  CHECK(read_text_file(study.path() + "/ranking.md").find("| cycle, MN | simulated, MN |") !=
        std::string::npos);
}

TEST_CASE("choices that are no words, in a store of somebody else, cost their cells alone") {
  const Scratch study("choices");
  SampleStudy options;
  write_sample_study(study.path(), options);
  {
    Store store = Store::open(study.path() + "/results.sqlite");
    for (Evaluation e : store.all()) {
      e.result["choices"] = {{"/bow/family", 7}, {"/bow/kind", "=1+1"}};
      store.put(e);
    }
  }
  write_table_reports(study.path());
  const auto rows = parse_csv(read_text_file(study.path() + "/ranking.csv"));
  REQUIRE(rows.size() > 1);
  auto fields = row_named(rows, rows[1].at(1));
  CHECK(fields.count("/bow/family") == 0);
  CHECK(fields["/bow/kind"] == "'=1+1");
}

TEST_CASE("ranking.md has the verdict, a row for each ranked design and the reasons of the others") {
  const Scratch study("md");
  SampleStudy options;
  options.odd_name = "a|b";
  write_sample_study(study.path(), options);
  write_table_reports(study.path());
  const std::string text = read_text_file(study.path() + "/ranking.md");
  std::istringstream lines(text);
  int rows = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("| ", 0) == 0 && line.find("design") == std::string::npos) ++rows;
  CHECK(rows == 10);
  CHECK(text.find("**Thyssen-Waas (stem 14.0\u00b0") != std::string::npos);
  CHECK(text.find("a\\|b") != std::string::npos);
  CHECK(text.find("| 1 | Thyssen-Waas | 14.0 | 39.0 | 13.0 | 77.0 | 0.747\u00a0\u00b1\u00a00.061 |") !=
        std::string::npos);
  CHECK(text.find("- **fast water** failed: unstable at step 8120") != std::string::npos);
  CHECK(text.find("`icebow run studies/bows.json --out out/bows`") != std::string::npos);
}

}  // namespace icebow
