#include "desktop/files/animation_file.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/numbered_names.h"
#include "felt/formats/drawing_writer.h"
#include "felt/io/svg/svg_animated.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr double kAnimationFramesPerSecond = 24.0;

Result<void> next_picture(const std::string& path, TimelapseProgress& progress) {
  if (progress.is_cancelled) return fail(ErrorCode::kIo, path + ": cancelled");
  ++progress.done;
  return {};
}

Result<void> write_animated_svg(const std::string& path, const KeyFilm& film, const Page& page,
                                TimelapseProgress& progress) {
  std::vector<AnimatedPicture> pictures;
  for (std::size_t i = 0; i < film.size(); ++i) {
    if (auto ok = next_picture(path, progress); !ok) return ok;
    pictures.push_back({film.picture(i), film.frames(i)});
  }
  const Result<std::string> text =
      svg_animated_text(pictures, {page.area(), page.paper, kAnimationFramesPerSecond});
  if (!text) return tl::unexpected(with_context(text.error(), path));
  return write_file(path, *text);
}

Result<void> write_pictures(const NumberedNames& names, const KeyFilm& film, FileFormat format,
                            const WriteOptions& options, TimelapseProgress& progress) {
  for (std::size_t i = 0; i < film.size(); ++i) {
    std::error_code ignored;
    if (std::filesystem::exists(names.name(i + 1), ignored)) {
      return fail(ErrorCode::kInvalidArgument, names.name(i + 1) +
                                                   ": exists already; nothing was written. Choose "
                                                   "another name");
    }
  }
  std::size_t written = 0;
  Result<void> done;
  for (std::size_t i = 0; done && i < film.size(); ++i) {
    const std::string name = names.name(i + 1);
    done = next_picture(name, progress);
    if (done) done = felt::write_drawing(name, film.picture(i), format, options);
    if (done) ++written;
  }
  if (done) return done;
  for (std::size_t i = 0; i < written; ++i) {
    std::error_code ignored;
    std::filesystem::remove(names.name(i + 1), ignored);
  }
  return done;
}

}  // namespace

Result<void> make_animation(const QString& path, const AnimationRequest& request,
                            TimelapseProgress& progress) {
  const std::string name = path.toStdString();
  if (request.keys.size() < 2) {
    return fail(ErrorCode::kInvalidArgument,
                name + ": a film needs two key drawings: layers with lines that are not locked");
  }
  KeyFilm film;
  for (const FilmKey& key : request.keys) {
    if (progress.is_cancelled) return fail(ErrorCode::kIo, name + ": cancelled");
    if (const Result<void> added = film.add(key); !added) {
      return tl::unexpected(with_context(added.error(), name));
    }
  }
  progress.all = static_cast<std::int64_t>(film.size());
  const Page& page = request.keys.front().drawing.page;
  if (request.format == AnimationFormat::kAnimatedSvg) {
    return write_animated_svg(name, film, page, progress);
  }
  WriteOptions options;
  options.area = page.area();
  options.dpi =
      kMmPerInch * request.longer_px / std::max(page.area().width(), page.area().height());
  const bool is_png = request.format == AnimationFormat::kPngFiles;
  return write_pictures(NumberedNames::before_suffix(name), film,
                        is_png ? FileFormat::kPng : FileFormat::kSvg, options, progress);
}

}  // namespace felt::desktop
