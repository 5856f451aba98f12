// What the parameters of a study do, for other programs and for a terminal.
#pragma once

#include <string>

#include "base/json.h"
#include "study/effects/elementary.h"
#include "study/effects/response_fit.h"

namespace icebow {

// {"rank_by", "designs" (0: no fit), "why" (there is none; null), "terms" (words), "left_out_error",
// "spread", "noise" (over the mean), "explained", "effects": [{"parameter", "lower", "upper", "change",
// "change_ci95", "told", "first_order": {"value", "low", "high"} (null: the fit explains too little),
// "total", "response": {"at", "value", "half_width"}}]}. Unit of the ranked value.
Json effects_json(const ResponseFit& fit, const std::string& rank_by);

// Of a study by the method "morris": [{"parameter", "steps", "mean", "deviation", "mean_size",
// "mean_size_ci95"}].
Json elementary_json(const std::vector<ElementaryEffects>& effects);

// How good the fit is, in one sentence without a stop; why there is none.
std::string fit_in_words(const ResponseFit& fit);

}  // namespace icebow
