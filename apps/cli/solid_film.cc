#include "solid_film.h"

#include "felt/film/film_writer.h"
#include "felt/solid/solid_picture.h"
#include "interrupt.h"

namespace felt::cli {
namespace {

constexpr int kTurnFrames = 72;
constexpr int kTurnWidthPx = 640, kTurnHeightPx = 480;

Result<Image> turned(const Solid& solid, const FrontPaint* paint, int frame) {
  return paint_solid(solid,
                     {.width_px = kTurnWidthPx,
                      .height_px = kTurnHeightPx,
                      .turn_deg = 360.0 * frame / kTurnFrames,
                      .rise_deg = 12.0,
                      .fit = SolidFit::kTurn},
                     paint);
}

}  // namespace

Result<void> write_turning_film(const Solid& solid, const FrontPaint* paint,
                                const std::string& path) {
  const Interrupt interrupt;
  FilmOptions options;
  options.format = film_format_of(path).value_or(FilmFormat::kWebm);
  options.width_px = kTurnWidthPx;
  options.height_px = kTurnHeightPx;
  options.is_cancelled = [] { return Interrupt::was_asked(); };
  const Result<Image> first = turned(solid, paint, 0);
  if (!first) return tl::unexpected(with_context(first.error(), path));
  Result<FilmWriter> film = FilmWriter::create(path, options, &*first);
  if (!film) return tl::unexpected(film.error());
  for (int frame = 0; frame < kTurnFrames; ++frame) {
    const Result<Image> image = turned(solid, paint, frame);
    if (!image) return tl::unexpected(with_context(image.error(), path));
    if (auto done = film->add(*image); !done) return done;
  }
  return film->finish();
}

}  // namespace felt::cli
