#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// Returns a drawing for random gestures, with one or several layers; some layers are hidden or
/// locked. Its strokes have every shape that a document may hold (random ones, ink of the simulated
/// hand, rings of one and two segments, dots, zigzags, cusps; from tiny ones to some that are
/// kilometres away), or are taken from `real`.
Document random_document(Dice& dice, const std::vector<Stroke>& real);

/// Reads the strokes of a file of raw pen strokes or of a sketch. Raw strokes are scaled to a
/// suitable size, because their units differ, and fitted.
Result<std::vector<Stroke>> read_strokes(const std::string& path);

}  // namespace felt::gestures
