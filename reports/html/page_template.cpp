#include "reports/html/page_template.h"

#include <kainjow/mustache.hpp>
#include <map>
#include <stdexcept>

#include "reports/html/report_assets.h"
#include "reports/text/text_format.h"

namespace icebow {
namespace {

namespace mustache = kainjow::mustache;

mustache::data data_of(const Json& value) {
  if (value.is_object()) {
    mustache::data object(mustache::data::type::object);
    for (const auto& [name, part] : value.items()) object.set(name, data_of(part));
    return object;
  }
  if (value.is_array()) {
    mustache::data list(mustache::data::type::list);
    for (const Json& part : value) list.push_back(data_of(part));
    return list;
  }
  if (value.is_boolean()) return mustache::data(value.get<bool>());
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    return text.empty() ? mustache::data(false) : mustache::data(text);
  }
  return value.is_null() ? mustache::data(false) : mustache::data(value.dump());
}

const std::map<std::string, mustache::data>& partials() {
  static const std::map<std::string, mustache::data> all = [] {
    std::map<std::string, mustache::data> made;
    for (const auto& [name, text] : report_templates())
      made.emplace(name, mustache::data(mustache::partial([text = text] { return text; })));
    return made;
  }();
  return all;
}

// Mustache leaves out what it does not know; a page with a hole is a mistake of ours.
class StrictContext : public mustache::context<std::string> {
 public:
  using mustache::context<std::string>::context;

  const mustache::data* get(const std::string& name) const override {
    const mustache::data* const found = mustache::context<std::string>::get(name);
    if (!found) throw std::logic_error("report template: no value for " + name);
    return found;
  }
  const mustache::data* get_partial(const std::string& name) const override {
    const auto found = partials().find(name);
    if (found == partials().end()) throw std::logic_error("report template: there is no " + name);
    return &found->second;
  }
};

std::string filled(mustache::mustache& page, const Json& values) {
  if (!page.is_valid()) throw std::logic_error("report template: " + page.error_message());
  page.set_custom_escape(html_escaped);
  const mustache::data data = data_of(values);
  StrictContext context(&data);
  return page.render(context);
}

}  // namespace

std::string rendered_text(const std::string& text, const Json& values) {
  mustache::mustache page(text);
  return filled(page, values);
}

std::string rendered(const std::string& name, const Json& values) {
  static std::map<std::string, mustache::mustache> parsed;  // a page has hundreds of cards of one template
  auto known = parsed.find(name);
  if (known == parsed.end()) {
    const auto& texts = report_templates();
    const auto text = texts.find(name);
    if (text == texts.end()) throw std::logic_error("report template: there is no " + name);
    known = parsed.emplace(name, mustache::mustache(text->second)).first;
  }
  return filled(known->second, values);
}

}  // namespace icebow
