// Replaces the parts of the library that the page does without: packed files, which JavaScript
// unpacks, and pictures in other files.

#include "felt/base/check.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/io/svg/svg_pictures.h"
#include "felt/io/unpack.h"

namespace felt {
namespace {

tl::unexpected<Error> left_out(const char* what) {
  return fail(ErrorCode::kUnsupported, what);
}

}  // namespace

/// A failed check ends the core. JavaScript throws a CoreError.
void detail::check_failed(const char* /*condition*/, const char* /*file*/, int /*line*/) noexcept {
  __builtin_trap();
}

bool is_gzip(std::string_view bytes) noexcept {
  return bytes.starts_with("\x1f\x8b");
}
bool is_zip(std::string_view bytes) noexcept {
  return bytes.starts_with("PK\x03\x04");
}
Result<std::string> gunzip(std::string_view, const UnpackLimits&) {
  return left_out("is packed in a way that the page cannot unpack");
}
Result<std::string> file_in_zip(std::string_view, const std::string&, const UnpackLimits&) {
  return left_out("is a zip archive, which the page cannot unpack");
}

bool looks_like_quickdraw(std::string_view) noexcept {
  return false;
}

// The masks of grain in an .svg file are pictures.
GrainMasks::GrainMasks(const GrainPrint& print, const Rect& area) noexcept
    : print_(print), area_(area) {}
Result<std::optional<GrainMask>> GrainMasks::of(const Stroke&) {
  return std::nullopt;
}
Result<std::string> GrainMask::png(double) const {
  return left_out("cannot be written on the page");
}

Result<std::shared_ptr<const PictureData>> SvgPictures::load_file(const std::string& name) {
  return left_out(
      ("was skipped: it is in another file, '" + name + "', which is not opened").c_str());
}

}  // namespace felt
