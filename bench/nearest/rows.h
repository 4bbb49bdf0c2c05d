#pragma once

#include <cstddef>

#include "table.h"

namespace felt::bench {

/// Adds rows for the nearest point on one cubic, per kind of case, with our code and with lib2geom.
void cubic_rows(Table& table, Stopwatch& watch);

/// Adds rows for the tree with n segments: build, queries, refit.
void tree_rows(Table& table, Stopwatch& watch, std::size_t n);

/// Adds rows for the worst known input, for which the cap on work per query must hold.
void adversarial_rows(Table& table, Stopwatch& watch);

/// Compares `cases` nearest points, shared among all kinds of case, with dense sampling and
/// polishing. Prints the largest error and returns the number of wrong results.
std::size_t check(std::size_t cases);

}  // namespace felt::bench
