#pragma once

#include <cstddef>

#include "table.h"

namespace felt::bench {

/// Nearest point on one cubic, by kind of case, ours and lib2geom's.
void cubic_rows(Table& table, Stopwatch& watch);

/// The tree at n segments: build, queries, refit.
void tree_rows(Table& table, Stopwatch& watch, std::size_t n);

/// Input made to hurt: the cap has to hold.
void adversarial_rows(Table& table, Stopwatch& watch);

/// Compares `cases` nearest points, shared among all kinds of case, with dense sampling and
/// polishing; prints the worst and returns the number of wrong ones.
std::size_t check(std::size_t cases);

}  // namespace felt::bench
