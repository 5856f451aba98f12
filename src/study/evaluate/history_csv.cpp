#include "study/evaluate/history_csv.h"

#include <cmath>
#include <cstdint>

#include "base/text.h"
#include "solver/model/describe_history.h"

namespace icebow {
namespace {

struct Head {
  std::string text;
  template <class T>
  void column(const char* name, const T& /*value*/) {
    text += (text.empty() ? "" : ",") + std::string(name);
  }
  template <class T>
  void sometimes(const char* name, const T& value) {
    column(name, value);
  }
};

struct Line {
  std::string text;
  void column(const char* /*name*/, double value) { add(icebow::text("%.17g", value)); }
  void column(const char* /*name*/, std::int64_t value) { add(std::to_string(value)); }
  // Empty where it was not evaluated.
  void sometimes(const char* name, double value) {
    if (std::isnan(value)) return add("");
    column(name, value);
  }

 private:
  void add(const std::string& cell) {
    if (!first_) text += ",";
    first_ = false;
    text += cell;
  }
  bool first_ = true;
};

template <class Visitor>
std::string told_of(const HistoryRow& row) {
  Visitor visitor;
  describe(visitor, row);
  return visitor.text + "\n";
}

}  // namespace

std::string history_csv(const History& history) {
  std::string text = told_of<Head>(HistoryRow());
  for (const HistoryRow& row : history.rows) text += told_of<Line>(row);
  return text;
}

}  // namespace icebow
