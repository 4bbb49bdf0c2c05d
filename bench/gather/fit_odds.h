#pragma once

#include <span>

#include "felt/gather/testing/labelled_drawing.h"

namespace felt::bench {

/// Fits the weights of log_odds (felt/gather/line_affinity.h) to labelled drawings, and prints them
/// as the source of odds_weights.h. Each drawing has a weight that grows with the square root of
/// its number of pairs. Newton's method for logistic regression with a small quadratic penalty.
void print_fitted_odds(std::span<const LabelledDrawing* const> drawings);

}  // namespace felt::bench
