// The points that a search begins with: spread over the feasible part of the unit cube.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace icebow {

// `n` points that keep apart from each other and from `known` ones: a Latin hypercube, of which every point
// that is not feasible gives way to the feasible one, of many of a Sobol' sequence, that lies farthest from
// all others. Fewer where the sequence has no feasible point. The same seed gives the same points.
std::vector<std::vector<double>> first_points(
    int dimension, int n, std::uint64_t seed, const std::vector<std::vector<double>>& known,
    const std::function<bool(const std::vector<double>&)>& feasible);

// Points of a Sobol' sequence in the unit cube, turned by a random vector.
std::vector<std::vector<double>> turned_sequence(int dimension, int n, std::uint64_t seed);

double distance(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace icebow
