#pragma once

#include <string>
#include <vector>

namespace felt::testing {

/// Returns the sorted names, without the ending, of all NAME.svg below a folder for which a
/// NAME.png exists.
std::vector<std::string> suite_names(const std::string& root);

/// The result of comparing our picture of a file with the PNG file.
struct SuiteResult {
  bool agrees = false;
  std::string why;          ///< if not `agrees`: the error, or the number of different pixels
  bool needs_more = false;  ///< text, pictures, gradients, patterns, clip paths, masks, filters
};

/// What is compared: the shapes that the reader finds, or the imported drawing as Feltline draws
/// it.
enum class SuitePicture { kShapes, kDrawing };

/// Compares our picture of NAME.svg with NAME.png. They agree if at most kPixelsAllowed pixels
/// differ (pixels_apart). If they do not agree and `out` is not empty, writes both pictures to the
/// folder `out`.
inline constexpr int kPixelsAllowed = 6;
SuiteResult compare_with_suite(const std::string& root, const std::string& name,
                               const std::string& out = {},
                               SuitePicture what = SuitePicture::kShapes);

/// Same as compare_with_suite(), for an SVG file and a picture with any paths.
SuiteResult compare_pictures(const std::string& svg_path, const std::string& png_path,
                             const std::string& out = {},
                             SuitePicture what = SuitePicture::kShapes);

}  // namespace felt::testing
