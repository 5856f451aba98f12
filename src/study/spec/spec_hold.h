// A displacement that the bows of a study keep: docs/study_file.md, "Hold".
//
// It is kept in the document: each design's document carries the dimension that follows as a value of its
// section "bow", so its key, its hull and its results are those of the same bow given directly.
#pragma once

#include <optional>
#include <string>

#include "hullgen/bow/bow_volume.h"
#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Section "hold" of a document.
struct Hold {
  double displacement = 0.0;  //!< [m^3], NaN where it is left out or wrong
  std::string by = "length";
};
Hold read_hold(const Json& document, Mistakes& mistakes);
bool has_hold(const Json& document);

// The dimension that follows from the displacement, as the document spells it: "/bow/length_m". "" where the
// document has no section "hold", or is not read far enough to tell.
std::string held_pointer(const Json& document);

// The dimension itself [m], and which it is.
HeldBy dimension_of(const Hold& hold);
double held_value(const BowParameters& bow, const Hold& hold);
// Whether dimensions and angles are in range, so that a displacement can be computed.
bool in_range(const BowParameters& bow);

// What a design's document holds; nothing where it has no section "hold".
std::optional<HeldDisplacement> held_displacement(const Json& document);

// Notes the mistakes of section "hold", and a bow in range that does not displace what is held.
void check_hold(const Json& document, const Case& c, Mistakes& mistakes);

// "the displacement is held at 17886 m3 by /bow/length_m"; "" without a hold.
std::string hold_in_words(const Json& document);

}  // namespace icebow
