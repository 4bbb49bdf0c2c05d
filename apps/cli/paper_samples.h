#pragma once

#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt::cli {

/// Returns the pen samples of the sample cat, stroke by stroke.
Result<std::vector<std::vector<InkSample>>> cat_samples();

/// Returns the cat, fitted by this scheme.
Result<std::vector<StrokePtr>> cat_fitted_by(FitScheme scheme,
                                             int shared_samples = InkFitOptions{}.shared_samples);

}  // namespace felt::cli
