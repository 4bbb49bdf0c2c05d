#pragma once

#include <string>
#include <vector>

namespace felt::testing {

/// Names of all NAME.svg below a folder that have a NAME.png beside them, without the ending, in
/// their order.
std::vector<std::string> suite_names(const std::string& root);

/// Whether our picture of a file is that beside it.
struct SuiteResult {
  bool agrees = false;
  std::string why;          ///< where it does not: the error, or how many pixels are apart
  bool needs_more = false;  ///< text, pictures, gradients, patterns, clip paths, masks, filters
};

/// Agrees: at most kPixelsAllowed pixels are apart (pixels_apart). `out`, where it is not empty, is
/// a folder that gets both pictures where they do not.
inline constexpr int kPixelsAllowed = 6;
SuiteResult compare_with_suite(const std::string& root, const std::string& name,
                               const std::string& out = {});

/// The same of a file and a picture anywhere.
SuiteResult compare_pictures(const std::string& svg_path, const std::string& png_path,
                             const std::string& out = {});

}  // namespace felt::testing
