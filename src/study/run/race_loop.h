// A study that decides: its voyages are sailed on, leg by leg, until the best is known (study/plan/race.h).
//
// What it has decided stands in the store, beside the results: a race that was cut short goes on where it
// was, and ends as one that was not.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/plan/design_space.h"
#include "study/plan/race_record.h"
#include "study/spec/study_spec.h"
#include "study/store/store.h"

namespace icebow {

// What the race asks of the study's loop.
struct RaceHooks {
  // Evaluates these voyages as far as each is to go, or takes them from the store.
  std::function<void(const std::vector<PlannedDesign>&)> sail;
  std::function<void(const RaceRecord&)> told;  // after each leg
};

// `designs` have been sailed their first leg. Returns the record as it is stored.
RaceRecord run_race(const StudySpec& spec, Store& store, const std::vector<PlannedDesign>& designs,
                    const RaceHooks& hooks);

// How far the race may sail a voyage at most, full scale [m].
double longest_voyage(const Decide& decide, const Case& c);

// The race of the store's present study; a record without a race where there is none, or it is damaged.
RaceRecord read_race(const Store& store);
void forget_race(Store& store);

}  // namespace icebow
