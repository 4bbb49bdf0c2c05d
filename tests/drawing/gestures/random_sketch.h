#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// A drawing for gestures to be made on: strokes of every shape that a document may hold (random
/// ones, ink of the simulated hand, rings of one and two segments, dots, zigzags, cusps, from tiny
/// to kilometres away), or some of `real`, in one layer or several, of which some are hidden or
/// locked.
Document random_document(Dice& dice, const std::vector<Stroke>& real);

/// The strokes of a file, raw pen strokes or a sketch; raw ones are fitted, each scaled to a
/// handy size since their units differ.
Result<std::vector<Stroke>> read_strokes(const std::string& path);

}  // namespace felt::gestures
