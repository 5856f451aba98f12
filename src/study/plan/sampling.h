// Points that fill a box.
#pragma once

#include <cstdint>
#include <vector>

namespace icebow {

// Every combination of the levels, the last axis fastest.
std::vector<std::vector<double>> full_factorial(const std::vector<std::vector<double>>& levels);

// `levels` equally spaced values from lower to upper, both included; one level is the lower bound.
std::vector<double> equally_spaced(double lower, double upper, int levels);

// A Latin hypercube in the unit cube: along every axis each of the n equal intervals holds one point; of many
// such designs one with a large smallest distance (maximin by simulated annealing). The same seed gives the
// same points.
std::vector<std::vector<double>> latin_hypercube(int dimension, int n, std::uint64_t seed);

}  // namespace icebow
