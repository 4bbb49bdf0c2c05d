#include <mypaint-brush.h>
#include <mypaint-fixed-tiled-surface.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include "artist.h"

namespace felt::bench {
namespace {

/// The resolution at which a preset is drawn at the size that its author gave it.
constexpr double kUsualDpi = 144.0;

/// Where Debian's package mypaint-brushes has its presets.
constexpr const char* kFolder = "/usr/share/mypaint-data/2.0/brushes/";

class MypaintPreset : public Artist {
 public:
  MypaintPreset(std::string name, std::string text)
      : name_(std::move(name)), text_(std::move(text)) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] Rgba ink() const override { return {0, 0, 0, 255}; }

  [[nodiscard]] Result<Image> draw(const TestPage& page, double dpi) const override {
    const double px_per_mm = dpi / 25.4;
    auto image = Image::create(static_cast<int>(std::ceil(px_per_mm * page.width_mm)),
                               static_cast<int>(std::ceil(px_per_mm * page.height_mm)));
    if (!image) return image;
    MyPaintFixedTiledSurface* tiles =
        mypaint_fixed_tiled_surface_new(image->width(), image->height());
    MyPaintSurface* surface = mypaint_fixed_tiled_surface_interface(tiles);
    for (const PenStroke& stroke : page.strokes) {
      MyPaintBrush* brush = mypaint_brush_new();
      mypaint_brush_from_defaults(brush);
      mypaint_brush_from_string(brush, text_.c_str());
      mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_COLOR_V, 0.0F);
      mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_COLOR_S, 0.0F);
      const float radius =
          mypaint_brush_get_base_value(brush, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC);
      mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC,
                                   radius + static_cast<float>(std::log(dpi / kUsualDpi)));
      mypaint_surface_begin_atomic(surface);
      mypaint_brush_reset(brush);
      const auto to = [&](const InkSample& s, double pressure, double seconds) {
        mypaint_brush_stroke_to(brush, surface, static_cast<float>(px_per_mm * s.position.x),
                                static_cast<float>(px_per_mm * s.position.y),
                                static_cast<float>(pressure), 0.0F, 0.0F, seconds);
      };
      to(stroke.front(), 0.0, 10.0);  // the pen arrives from the air
      for (const InkSample& s : stroke) to(s, *s.pressure, 0.0075);
      mypaint_surface_end_atomic(surface, nullptr);
      mypaint_brush_unref(brush);
    }
    copy(reinterpret_cast<MyPaintTiledSurface*>(surface), image->pixels());
    mypaint_surface_unref(surface);
    return image;
  }

 private:
  /// Copies the tiles, premultiplied with 15 bits per channel, over white.
  static void copy(MyPaintTiledSurface* surface, Pixels to) {
    constexpr int kSide = 64;
    for (int ty = 0; ty * kSide < to.height; ++ty) {
      for (int tx = 0; tx * kSide < to.width; ++tx) {
        MyPaintTileRequest request;
        mypaint_tile_request_init(&request, 0, tx, ty, TRUE);
        mypaint_tiled_surface_tile_request_start(surface, &request);
        for (int y = 0; y < kSide && ty * kSide + y < to.height; ++y) {
          for (int x = 0; x < kSide && tx * kSide + x < to.width; ++x) {
            const std::uint16_t* from = request.buffer + 4 * (y * kSide + x);
            std::uint8_t* pixel =
                to.data + (ty * kSide + y) * to.stride + std::ptrdiff_t{4} * (tx * kSide + x);
            for (int k = 0; k < 3; ++k) {
              pixel[k] =
                  static_cast<std::uint8_t>(255.0 * (from[k] + 32768.0 - from[3]) / 32768.0 + 0.5);
            }
            pixel[3] = 255;
          }
        }
        mypaint_tiled_surface_tile_request_end(surface, &request);
      }
    }
  }

  std::string name_, text_;
};

}  // namespace

std::unique_ptr<Artist> mypaint_preset(const std::string& preset) {
  std::ifstream in(kFolder + preset + ".myb", std::ios::binary);
  if (!in) return nullptr;
  std::string text{std::istreambuf_iterator<char>(in), {}};
  return std::make_unique<MypaintPreset>(preset, std::move(text));
}

}  // namespace felt::bench
