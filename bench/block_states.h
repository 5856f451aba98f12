// What blocks of ice cost a step by what has happened to them: sheets all of one kind.
#pragma once

#include <vector>

#include "base/communicator.h"
#include "solver/ice/sheet.h"

namespace icebow {

// In the order of both lists below.
enum class IceState {
  linear,   // hardly deformed: the linear law
  calm,     // all bonds there, hardly strained
  intact,   // all bonds there, strained: short fits
  touched,  // broken bonds, strained: long fits
  stress,   // broken bonds, hardly strained; of ice that breaks by stress, which is looked at
};
constexpr int ice_states = 5;
const char* to_string(IceState state);
// Throws InputError.
IceState ice_state(const std::string& name);

constexpr double still_step = 1e-9;  //!< too short for anything to move far: a state stays [s]

// A sheet all of whose blocks are in one state, in small motion. Nothing breaks.
Scenario slab_scenario(int nx, int ny, int nz, IceState state);
void put_into(IceSheet& sheet, IceState state);

struct StateCost {
  const char* name;
  double ns_per_bond;      //!< of a step's bonds and drift, per directed bond: the fastest step
  double cpu_ns_per_bond;  //!< mean CPU time likewise: what a machine that is not quiet makes of it
};
// On one rank, of sheets as large as a small run's.
std::vector<StateCost> state_costs(int layers);

struct StateShare {
  const char* name;
  double share;  // of the blocks of rows
};
// Collective.
std::vector<StateShare> state_shares(const Communicator& comm, const IceSheet& sheet);

}  // namespace icebow
