#include "demo_ending.h"

#include <filesystem>
#include <utility>

#include "demo_scripts.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/svg/svg_animated.h"
#include "felt/motion/ease.h"
#include "felt/motion/inbetween.h"
#include "output.h"
#ifdef FELT_SOLIDS
#include "felt/io/picture/png.h"
#include "felt/solid/gap_search.h"
#include "felt/solid/inflate.h"
#include "felt/solid/solid_picture.h"
#include "felt/solid/solid_writer.h"
#include "solid_film.h"
#endif

namespace felt::cli {
namespace {

constexpr int kSwimFrames = 10;  // from one key drawing to the other
constexpr double kSwimMarginMm = 3.0;

Result<void> write_file(const std::string& folder, const char* name, const std::string& bytes) {
  return Output::create((std::filesystem::path(folder) / name).string()).and_then([&](Output out) {
    return out.write_all(bytes);
  });
}

/// Returns the pictures of the fish from key drawing `from` on, without the other one.
Result<std::vector<AnimatedPicture>> swim(const Drawing& from, const Drawing& to) {
  const Result<Ease> ease = Ease::parse("ease-in-out");
  const Result<Inbetween> motion = Inbetween::create(from, to, {});
  if (!ease) return tl::unexpected(ease.error());
  if (!motion) return tl::unexpected(motion.error());
  std::vector<AnimatedPicture> pictures{{from}};
  for (int i = 1; i <= kSwimFrames; ++i) {
    pictures.push_back({motion->at(ease->at(i / (kSwimFrames + 1.0)))});
  }
  return pictures;
}

Result<void> write_fish(const std::string& folder) {
  std::vector<Drawing> keys;
  for (const std::string_view text : demo_fish()) {
    Result<Imported> key = parse_drawing(text, "fish.svg");
    if (!key) return tl::unexpected(key.error());
    keys.push_back(std::move(key->drawing));
  }
  Rect ink = ink_bounds(keys[0].document);
  ink.extend(ink_bounds(keys[1].document));
  Result<std::vector<AnimatedPicture>> pictures = swim(keys[0], keys[1]);
  Result<std::vector<AnimatedPicture>> back = swim(keys[1], keys[0]);
  if (!pictures) return tl::unexpected(pictures.error());
  if (!back) return tl::unexpected(back.error());
  pictures->insert(pictures->end(), back->begin(), back->end());
  return svg_animated_text(*pictures,
                           {.area = ink.inflated(kSwimMarginMm), .paper = Rgba{255, 255, 255, 255}})
      .and_then([&](const std::string& text) { return write_file(folder, "swim.svg", text); });
}

#ifdef FELT_SOLIDS

constexpr double kDemoPictureDpi = 96.0;

/// Writes the film if ffmpeg is there. Returns true if it has been written.
Result<bool> write_film(const std::string& folder, const Solid& solid, const FrontPaint* paint) {
  const auto path = (std::filesystem::path(folder) / "solid.webm").string();
  const Result<void> done = write_turning_film(solid, paint, path);
  if (done) return true;
  if (done.error().code == ErrorCode::kUnsupported) return false;
  return tl::unexpected(done.error());
}

Result<void> write_solid(const Drawing& drawing, const std::string& folder, int size_px,
                         std::vector<std::string>& names) {
  InflateOptions options;
  options.max_gap_mm = automatic_gap_mm(drawing.document);
  options.holes = HoleChoice::kFill;
  const Result<InflatedDrawing> inflated = inflate(drawing.document, options);
  if (!inflated) return tl::unexpected(inflated.error());
  const Solid& solid = inflated->solid;
  const auto paint = grain_of(drawing).and_then(
      [&](const Grain& grain) { return front_paint(drawing.document, solid, grain); });
  if (!paint) return tl::unexpected(paint.error());
  const FrontPaint* const front = *paint ? &**paint : nullptr;
  const auto glb = encode_solid(solid, SolidFormat::kGlb, front);
  const auto png =
      paint_solid(solid, {.width_px = size_px, .height_px = 3 * size_px / 4}, front)
          .and_then([](const Image& image) { return encode_png(image, kDemoPictureDpi); });
  for (const auto& [name, bytes] : {std::pair("solid.png", &png), std::pair("solid.glb", &glb)}) {
    if (!*bytes) return tl::unexpected(bytes->error());
    if (auto done = write_file(folder, name, **bytes); !done) return done;
    names.emplace_back(name);
  }
  const Result<bool> film = write_film(folder, solid, front);
  if (!film) return tl::unexpected(film.error());
  if (*film) names.emplace_back("solid.webm");
  return {};
}

#endif

}  // namespace

Result<std::vector<std::string>> write_demo_ending([[maybe_unused]] const Drawing& drawing,
                                                   const std::string& folder,
                                                   [[maybe_unused]] int size_px) {
  std::vector<std::string> names;
#ifdef FELT_SOLIDS
  if (auto done = write_solid(drawing, folder, size_px, names); !done) {
    return tl::unexpected(done.error());
  }
#endif
  if (auto done = write_fish(folder); !done) return tl::unexpected(done.error());
  names.emplace_back("swim.svg");
  return names;
}

}  // namespace felt::cli
