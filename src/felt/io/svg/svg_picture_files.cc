// The pictures of an SVG file that are in other files. The page for browsers, which has no files,
// does without them.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "felt/base/read_file.h"
#include "felt/io/svg/svg_pictures.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> skipped_file(const std::string& why) {
  return fail(ErrorCode::kUnsupported, "was skipped: " + why);
}

/// Returns the path of a file below a folder, with all links resolved; nothing if there is no such
/// file, or if it is hidden or not below the folder.
std::optional<fs::path> path_below(const std::string& folder, const std::string& name) {
  const fs::path relative(name);
  if (name.empty() || name.find('\0') != std::string::npos || relative.is_absolute()) return {};
  for (const fs::path& part : relative) {
    const std::string text = part.string();
    if (text.starts_with(".") && text != ".") return {};
  }
  std::error_code error;
  const fs::path base = fs::canonical(folder, error);
  if (error) return {};
  const fs::path path = fs::canonical(base / relative, error);
  if (error) return {};
  const bool is_below =
      std::mismatch(base.begin(), base.end(), path.begin(), path.end()).first == base.end();
  return is_below ? std::optional(path) : std::nullopt;
}

}  // namespace

Result<std::shared_ptr<const PictureData>> SvgPictures::load_file(const std::string& name) {
  const std::string shown = "'" + name + "'";
  if (folder_.empty()) {
    return skipped_file("it is in another file, " + shown + ", which is not opened");
  }
  const std::optional<fs::path> path = path_below(folder_, name);
  if (!path) return skipped_file("there is no file " + shown + " in the folder of the drawing");
  const auto known = files_.find(path->string());
  if (known != files_.end()) return known->second;
  Loaded loaded = bytes_of_file(path->string(), shown).and_then([this](std::string bytes) {
    return decoded(std::move(bytes));
  });
  return files_.emplace(path->string(), std::move(loaded)).first->second;
}

/// Reads a file and subtracts its size from the budget.
Result<std::string> SvgPictures::bytes_of_file(const std::string& path, const std::string& shown) {
  const std::size_t largest = std::min(PictureData::kMaxBytes, file_bytes_left_);
  Result<std::string> bytes = read_regular_file(path, largest);
  if (bytes) {
    file_bytes_left_ -= bytes->size();
    return bytes;
  }
  if (bytes.error().code == ErrorCode::kLimitExceeded && largest < PictureData::kMaxBytes) {
    return skipped_file("the pictures in other files are larger than 256 MiB together");
  }
  return skipped_file(shown + " cannot be read, or is larger than 48 MiB");
}

}  // namespace felt
