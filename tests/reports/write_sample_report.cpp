// write_sample_report DIRECTORY [unfinished|formula|pareto|large]: a made-up study and its reports, for a
// look in the browser.
#include <filesystem>
#include <iostream>
#include <string>

#include "reports/html/html_report.h"
#include "reports/tables/table_report.h"
#include "tests/support/sample_study.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: write_sample_report DIRECTORY [unfinished|formula|pareto|large]\n";
    return 2;
  }
  const std::string directory = argv[1], kind = argc > 2 ? argv[2] : "";
  icebow::SampleStudy options;
  options.finished = kind != "unfinished";
  options.pareto = kind == "pareto";
  options.peridynamics = kind != "formula";
  if (kind == "formula") options.odd_name = std::string(64, 'x');  // the longest one
  if (kind == "large") options.picture_width = 560;
  if (kind == "large") options.history_rows = 4000;
  if (kind == "large") options.odd_name = "concave";
  std::filesystem::remove_all(directory);
  icebow::write_sample_study(directory, options);
  icebow::write_html_report(directory, directory + "/report.html");
  icebow::write_table_reports(directory);
}
