// What a browser is told that the report may do.
#pragma once

#include <string>

namespace icebow {

// The text of a Content-Security-Policy: the page's one script, known by its digest, runs and no other;
// nothing is loaded from anywhere, nor sent. Styles stand in the page, pictures and fonts in data: addresses.
std::string content_security_policy(const std::string& script);

}  // namespace icebow
