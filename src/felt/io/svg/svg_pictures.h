#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/layer_picture.h"
#include "felt/io/import.h"
#include "felt/io/svg/svg_limits.h"

namespace felt {

/// Loads the pictures of an SVG file, each of them once.
class SvgPictures {
 public:
  explicit SvgPictures(const ImportOptions& options)
      : folder_(options.folder), to_png_(options.to_png) {}

  /// Returns the picture that `href` refers to: a data URI with a PNG file (or another format that
  /// ImportOptions::to_png converts), or a file below ImportOptions::folder. `href` must stay
  /// valid. The pixels were decoded once, so that the picture is not damaged. Fails if the picture
  /// cannot be used or if a limit is exceeded; the message is a clause that follows the name of the
  /// element.
  Result<std::shared_ptr<const PictureData>> load(std::string_view href);

  /// Counts one more use of a picture. Returns false if the file has too many.
  [[nodiscard]] bool count() noexcept { return ++uses_ <= limits::kMaxSvgPictures; }

 private:
  using Loaded = Result<std::shared_ptr<const PictureData>>;
  Loaded load_new(std::string_view href);
  Loaded load_file(const std::string& name);  // in svg_picture_files.cc, as is bytes_of_file
  Result<std::string> bytes_of_file(const std::string& path, const std::string& shown);
  Loaded decoded(std::string bytes);

  std::string folder_;
  PictureConverter to_png_;
  std::map<std::string_view, Loaded> loaded_;
  std::map<std::string, Loaded> files_;  // by their paths, because they may have several names
  std::size_t uses_ = 0, loads_ = 0;
  std::int64_t pixels_left_ = limits::kMaxSvgPicturePixels;
  std::size_t file_bytes_left_ = limits::kMaxSvgPictureFileBytes;
};

}  // namespace felt
