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
// such designs one with a large smallest distance (maximin by simulated annealing). More than 100 points are
// Sobol' points made Latin, in a time that grows with their number. The same seed gives the same points.
std::vector<std::vector<double>> latin_hypercube(int dimension, int n, std::uint64_t seed);

// A Latin hypercube of n points that begins with `points`, themselves fewer: the new ones fill the intervals
// of the n that are empty, as far from the others as the best of many random fillings brings them. Where
// `points` share an interval, so many stay empty in the end.
std::vector<std::vector<double>> augmented_hypercube(std::vector<std::vector<double>> points, int n,
                                                     std::uint64_t seed);

// The first n points of a sequence in the unit cube (Sobol' 1967, Halton 1960): a longer one begins with the
// shorter.
enum class Sequence { sobol, halton };
std::vector<std::vector<double>> sequence(Sequence kind, int dimension, int n);

// Trajectories in a grid of four levels (Morris 1991): each starts at a random point of it and changes every
// axis once, in random order, by two thirds of its length: dimension + 1 points each.
std::vector<std::vector<double>> morris(int dimension, int trajectories, std::uint64_t seed);

// In the unit cube: the centre, the middles of the faces and the corners.
std::vector<std::vector<double>> central_composite(int dimension);

// In the unit cube: the centre, and the middles of the edges between any two axes (Box and Behnken 1960), for
// 3 to 5 axes.
std::vector<std::vector<double>> box_behnken(int dimension);

}  // namespace icebow
