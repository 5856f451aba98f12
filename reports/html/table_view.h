// Tables and lists of facts, as the templates table.html, tables.html and facts.html take them.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "reports/content/conditions.h"
#include "reports/content/hull_outline.h"

namespace icebow {

Json row_view(const std::string& label, const std::vector<std::string>& values, const std::string& kind = "");
// null where there are no rows.
Json table_view(const std::string& caption, const std::vector<std::string>& columns, const Json& rows,
                const std::vector<std::string>& notes = {});
// A list of those tables that are not null.
Json tables_view(const std::vector<Json>& tables);
Json facts_view(const std::vector<Fact>& facts, bool small);
Json outline_view(const BowOutline& outline);  // null where there is no waterline

}  // namespace icebow
