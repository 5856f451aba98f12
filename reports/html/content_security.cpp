#include "reports/html/content_security.h"

#include "base/sha256.h"
#include "reports/text/text_format.h"

namespace icebow {

std::string content_security_policy(const std::string& script) {
  const std::string digits = sha256(script);
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(k, 2), nullptr, 16));
  return "default-src 'none'; script-src 'sha256-" + base64(bytes) +
         "'; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; base-uri 'none'; form-action "
         "'none'";
}

}  // namespace icebow
