#include "reports/html/table_view.h"

#include "reports/text/text_format.h"

namespace icebow {

Json row_view(const std::string& label, const std::vector<std::string>& values, const std::string& kind) {
  return {{"label", label}, {"values", values}, {"kind", kind}};
}

Json table_view(const std::string& caption, const std::vector<std::string>& columns, const Json& rows,
                const std::vector<std::string>& notes) {
  if (rows.empty()) return nullptr;
  return {{"caption", caption}, {"columns", columns}, {"rows", rows}, {"notes", notes}};
}

Json tables_view(const std::vector<Json>& tables) {
  Json list = Json::array();
  for (const Json& table : tables)
    if (!table.is_null()) list.push_back(table);
  return list;
}

Json facts_view(const std::vector<Fact>& facts, bool small) {
  Json list = Json::array();
  for (const Fact& fact : facts)
    if (!fact.value.empty())
      list.push_back({{"label", fact.label}, {"value", fact.value}, {"code", nullptr}});
  return {{"small", small}, {"facts", list}};
}

Json outline_view(const BowOutline& outline) {
  if (outline.path.empty()) return nullptr;
  const std::string width = csv_number(outline.width + 2.0), height = csv_number(outline.height + 2.0);
  return {{"path", outline.path}, {"width", width}, {"height", height}};
}

}  // namespace icebow
