// Where the parts of a study file are, for those who look into a document that the reader has read: the one
// place that spells these pointers outside the reader (spec_*.cpp). A test holds all that is listed here
// against a file.
#pragma once

namespace icebow::document_key {

constexpr const char* name = "/name";
constexpr const char* purpose = "/purpose";
constexpr const char* operation = "/operation";
constexpr const char* solver = "/solver";
constexpr const char* solver_seed = "/solver/seed";
constexpr const char* constraints = "/constraints";
constexpr const char* evaluators = "/evaluators";
constexpr const char* scenarios = "/scenarios";
constexpr const char* over_scenarios = "/ranking/over_scenarios";
constexpr const char* second_objective = "/ranking/by/1";  // a word, a pointer, or an object with "by"
constexpr const char* second_objective_by = "/ranking/by/1/by";
constexpr const char* derived = "/derived";
constexpr const char* method = "/method";
constexpr const char* method_type = "/method/type";
constexpr const char* method_variables = "/method/variables";
constexpr const char* method_samples = "/method/samples";
constexpr const char* method_extends = "/method/extends";

constexpr const char* all[] = {name,        evaluators,       purpose,        operation,      solver,
                               solver_seed, constraints,      scenarios,      over_scenarios, method,
                               method_type, method_variables, method_samples, method_extends};

// Inside one entry of a list above.
constexpr const char* constraint_at = "/at";
constexpr const char* scenario_name = "/name";
constexpr const char* scenario_weight = "/weight";
constexpr const char* variable_min = "/min";
constexpr const char* variable_max = "/max";

}  // namespace icebow::document_key
