#pragma once

#include <string>
#include <vector>

namespace felt::bench {

/// Counts what snaps with the shipped defaults: scenes in which nothing is meant to, files of raw
/// strokes, and shapes that are meant to close, drawn by each hand with forces and without, and by
/// one that trembles. Prints a table. Returns true if in every hand at most 1 of 500 strokes joins
/// or closes unasked, the path error is at most 1.1 times that with snapping off, and 95 % of the
/// shapes close. `only_hand`: "" for all.
bool check_snap_bars(const std::vector<std::string>& files, const std::string& only_hand);

}  // namespace felt::bench
