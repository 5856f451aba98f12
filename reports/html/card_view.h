// A ranked design's card, as the templates card.html and card_body.html take it.
#pragma once

#include "reports/content/report_content.h"

namespace icebow {

// Without "body", "open".
Json card_head_view(const ReportContent& content, std::size_t design);
Json card_body_view(const ReportContent& content, std::size_t design);

}  // namespace icebow
