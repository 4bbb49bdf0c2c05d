#include "felt/timelapse/timelapse_film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/ascii.h"
#include "felt/base/atomic_file.h"
#include "felt/timelapse/animated_svg.h"

namespace felt {
namespace {

Result<void> write_svg_film(const std::string& path, const std::string& name,
                            const TimelapseSource& source, const FilmTiming& timing,
                            const TimelapseFilm& film) {
  // The file is created first, so that a wrong name is reported before the work.
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  const Result<PageOptions> page =
      page_in_frame(film.area, film.size.width_px, film.size.height_px);
  if (!page) return tl::unexpected(page.error());
  const Result<std::string> text = animated_svg(
      source, timing, {*page->area, film.paper, film.size.width_px, film.size.height_px});
  if (!text) return tl::unexpected(with_context(text.error(), name));
  if (Result<void> done = file->write(*text); !done) return done;
  return file->commit();
}

Result<void> write_frames(const std::string& path, const TimelapseSource& source,
                          const Document& end, const FilmTiming& timing,
                          const TimelapseFilm& film) {
  Result<PageOptions> page = page_in_frame(film.area, film.size.width_px, film.size.height_px);
  if (!page) return tl::unexpected(page.error());
  page->paper = film.paper;
  page->grain = film.grain;
  FilmOptions options;
  const bool is_gif = film.format == TimelapseFormat::kGif;
  options.format = is_gif ? FilmFormat::kGif : FilmFormat::kWebm;
  options.width_px = film.size.width_px;
  options.height_px = film.size.height_px;
  options.frames_per_second = film.length.frames_per_second;
  options.program = film.program;
  options.is_cancelled = source.is_cancelled;
  std::optional<Image> colors;
  if (is_gif) {
    Result<Image> last = render_page(end, *page, PictureChoice::kMarked);
    if (!last) return tl::unexpected(last.error());
    colors = *std::move(last);
  }
  Result<FilmWriter> writer = FilmWriter::create(path, options, colors ? &*colors : nullptr);
  if (!writer) return tl::unexpected(writer.error());
  std::int64_t done = 0;
  const FrameSink add = [&](const Image& frame) -> Result<void> {
    if (film.on_frame) film.on_frame(++done, timing.frames());
    return writer->add(frame);
  };
  const Result<void> played = play_timelapse(source, timing, *page, add);
  return played ? writer->finish() : played;
}

}  // namespace

std::optional<TimelapseFormat> timelapse_format_of(const std::string& path) {
  if (const std::optional<FilmFormat> film = film_format_of(path)) {
    return *film == FilmFormat::kGif ? TimelapseFormat::kGif : TimelapseFormat::kWebm;
  }
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(), ascii_lower);
  return lower.ends_with(".svg") ? std::optional(TimelapseFormat::kSvg) : std::nullopt;
}

FilmSize film_size(int longer_px, const Rect& area) {
  const double width_mm = std::max(area.width(), 1.0), height_mm = std::max(area.height(), 1.0);
  const double share = std::min(width_mm, height_mm) / std::max(width_mm, height_mm);
  const int shorter =
      std::max(2 * static_cast<int>(std::lround(0.5 * share * longer_px)), FilmOptions::kMinSidePx);
  return width_mm >= height_mm ? FilmSize{longer_px, shorter} : FilmSize{shorter, longer_px};
}

Result<void> write_timelapse(const std::string& path, const std::string& name,
                             const TimelapseSource& source, const TimelapseSurvey& survey,
                             const TimelapseFilm& film) {
  const FilmTiming timing(survey.drawing_ns, film.length);
  const Result<void> done = film.format == TimelapseFormat::kSvg
                                ? write_svg_film(path, name, source, timing, film)
                                : write_frames(path, source, survey.end.document, timing, film);
  if (done || !source.is_cancelled || !source.is_cancelled()) return done;
  return fail(ErrorCode::kIo, (path == "-" ? "stdout" : path) + ": cancelled");
}

}  // namespace felt
