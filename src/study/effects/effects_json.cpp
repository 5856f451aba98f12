#include "study/effects/effects_json.h"

#include <cmath>

#include "base/json_fields.h"
#include "base/text.h"

namespace icebow {
namespace {

Json share_json(const Share& share, bool known) {
  if (!known) return nullptr;
  return {{"value", share.value}, {"low", share.low}, {"high", share.high}};
}

Json effect_json(const Effect& e, bool has_sobol) {
  return {{"parameter", e.pointer},
          {"lower", e.lower},
          {"upper", e.upper},
          {"change", finite_or_null(e.change)},
          {"change_ci95", finite_or_null(e.ci95)},
          {"told", e.told()},
          {"first_order", share_json(e.sobol.first, has_sobol)},
          {"total", share_json(e.sobol.total, has_sobol)},
          {"response", {{"at", e.at}, {"value", e.value}, {"half_width", e.half_width}}}};
}

}  // namespace

Json effects_json(const ResponseFit& fit, const std::string& rank_by) {
  Json effects = Json::array();
  for (const Effect& e : fit.effects) effects.push_back(effect_json(e, fit.has_sobol));
  return {{"rank_by", rank_by},
          {"designs", fit.designs},
          {"why", fit.told() ? Json(nullptr) : Json(fit.why)},
          {"terms", fit.told() ? Json(terms_in_words(fit.terms)) : Json(nullptr)},
          {"left_out_error", finite_or_null(fit.left_out_error)},
          {"spread", finite_or_null(fit.spread)},
          {"noise", finite_or_null(fit.noise)},
          {"explained", fit.told() ? Json(fit.explained) : Json(nullptr)},
          {"effects", effects}};
}

Json elementary_json(const std::vector<ElementaryEffects>& effects) {
  Json list = Json::array();
  for (const ElementaryEffects& e : effects)
    list.push_back({{"parameter", e.pointer},
                    {"steps", e.steps},
                    {"mean", finite_or_null(e.mean)},
                    {"deviation", finite_or_null(e.deviation)},
                    {"mean_size", finite_or_null(e.mean_size)},
                    {"mean_size_ci95", finite_or_null(e.mean_size_ci95)}});
  return list;
}

std::string fit_in_words(const ResponseFit& fit) {
  if (!fit.told()) return "the data carry no fit: " + fit.why;
  std::string words = text(
      "a polynomial %s, fitted to %d designs; it misses a design that is left out by %.1f %% of the "
      "mean (root mean square), the designs scatter by %.1f %%",
      terms_in_words(fit.terms).c_str(), fit.designs, 100.0 * fit.left_out_error, 100.0 * fit.spread);
  if (fit.noise > 0.0) words += text(", their records err by %.1f %%", 100.0 * fit.noise);
  if (!fit.has_sobol)
    words += text(
        "; it explains %.0f %% of the variance of designs left out, less than the half that Sobol' "
        "indices take",
        100.0 * fit.explained);
  return words;
}

}  // namespace icebow
