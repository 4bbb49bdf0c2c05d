#pragma once

#include <array>

/// The weights of log_odds (line_affinity.h): the mean and the spread of each feature, and the
/// weight of each term. `bench_gather --drawings FOLDER --fit` prints them.
namespace felt {

inline constexpr std::array<double, 6> kOddsMean{-4.526, -4.303, 1.47, 0.2027, 0.3482, 1.294};
inline constexpr std::array<double, 6> kOddsSpread{1.193, 1.116, 1.253, 0.1368, 0.2891, 1.764};
inline constexpr std::array<double, 28> kOddsWeights{
    -1.131, -0.2009, -0.9431, -1.24,  -0.4502, 0.2198,  0.5704, 0.01817, 0.4731, -0.7818,
    0.153,  -0.3841, 0.388,   0.2569, -0.247,  0.136,   0.1263, -0.376,  0.5864, -0.01445,
    -0.011, -0.3394, -0.1658, 0.3484, -0.495,  -0.3261, 0.7257, -0.0858};

}  // namespace felt
