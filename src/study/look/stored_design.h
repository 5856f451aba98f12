// A study directory taken up again: its study, and each of its designs as a ship.
#pragma once

#include <optional>
#include <string>

#include "study/plan/design_space.h"
#include "study/plan/ranking.h"
#include "study/store/store.h"

namespace icebow {

// Whether there is a store in it.
bool is_study_directory(const std::string& path);

// For readers, also while a run writes. Throws InputError where there is none.
Store open_store_of(const std::string& directory);

// The ranking of the present study, with its race where it has one.
Ranking stored_ranking(const Store& store);

// The document that the directory was last run with.
Json document_of(const Store& store);

struct StoredDesign {
  PlannedDesign planned;
  std::optional<Evaluation> evaluation;
  // Whether the design, as this program reads it, is the one that was evaluated: false where the study file
  // was changed or another version of the program evaluated it.
  bool is_same = false;
};

// The design of that name: of the study file, of its method, proposed by an optimiser, a repeat of one
// ("NAME#2") or its confirmation ("NAME@solver"); of a race as far as it has sailed. Nothing where the study
// has no such design.
std::optional<StoredDesign> stored_design(const StudySpec& spec, const Store& store, const std::string& name);

}  // namespace icebow
