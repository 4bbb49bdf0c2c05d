#pragma once

#include "bench/steady/shaky_strokes.h"

namespace felt::bench {

/// Returns the moving average of the last 20 samples, the kind of Xournal++'s stabiliser.
Line averaged(const Line& line);
/// Returns the line through a one-euro filter for each coordinate (DOI 10.1145/2207676.2208639).
Line one_euro(const Line& line);

}  // namespace felt::bench
