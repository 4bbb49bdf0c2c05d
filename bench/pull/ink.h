#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"

namespace felt::bench {

/// Reads a file of raw pen strokes and fits them as the pencil does at pen-up.
Result<std::vector<StrokePtr>> fitted_file(const std::string& path, double mm_per_unit);

/// Returns the project's own sample sets, drawn by the simulated hand and fitted.
std::vector<StrokePtr> fitted_samples();

}  // namespace felt::bench
