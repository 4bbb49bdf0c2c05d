#pragma once

#include <string>
#include <vector>

namespace felt::bench {

/// Counts strokes that snap with the default options, and prints a table. The input is scenes in
/// which no stroke is meant to snap, files of raw strokes, and shapes that are meant to close. Each
/// hand draws them with forces, without forces, and with forces and a tremor; then simulated people
/// draw them with and without forces. `only_hand` selects one hand; "" means all. Returns true if
/// these conditions hold for every hand and for all people together: at most 1 of 500
/// strokes joins or closes unintentionally; at most 1 end per 300 strokes lies on another line
/// unintentionally; the path error is at most 1.1 times the error without snapping; at least 95 %
/// of the shapes close.
bool check_snap_bars(const std::vector<std::string>& files, const std::string& only_hand,
                     std::size_t people);

}  // namespace felt::bench
