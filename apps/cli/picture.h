#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/layer_picture.h"
#include "felt/document/page.h"
#include "felt/geometry/rect.h"
#include "felt/material/materials.h"
#include "felt/render/grain.h"
#include "felt/store/felt_file.h"
#include "felt/stroke/stroke.h"

namespace CLI {
class App;
}

namespace felt::cli {

class Console;

/// Options for pictures of a sketch (.png, .svg).
struct PictureOptions {
  double dpi = 300.0;  ///< resolution of a .png
  /// The shown area. If nullopt, the drawing's page is shown; if the drawing has no page, all ink
  /// and a margin are shown.
  std::optional<Rect> area;
  bool fit = false;           ///< --page fit: shows all ink and a margin, even if a page exists
  std::optional<Rgba> paper;  ///< nullopt: white in a .png, transparent in an .svg
  std::shared_ptr<const HeightField>
      custom_relief{};                  ///< a user-defined picture, used as the relief
  const HeightField* relief = nullptr;  ///< relief of the surface; null if the surface is smooth
  Grain grain;                          ///< the relief shown in the ink; default: solid ink
  bool has_surface = false;             ///< --surface was given and sets the relief
  bool wants_grain = false;  ///< --grain was given: grain is also shown in .svg and .pdf, and for
                             ///< the drawing's own surface
  double grain_dpi = 200.0;  ///< resolution of the grain in an .svg or .pdf
  bool compact = false;      ///< --compact was given: an .svg is small, for web pages
  PictureChoice pictures = PictureChoice::kMarked;  ///< kAll: --pictures was given
  /// The known materials; includes user-defined ones if grain is shown.
  Materials materials = Materials::built_in();
};

/// Resolution of a picture at the scale 1: that of a CSS pixel
/// (<https://www.w3.org/TR/css-values-4/#reference-pixel>).
inline constexpr double kScreenDpi = 96.0;

/// The picture options of the command line, before they are parsed.
struct PictureArguments {
  double dpi = 300.0;
  std::optional<double> scale;  ///< 1 means kScreenDpi
  std::string page;
  std::string paper;
  std::string surface;
  bool grain = false;
  double grain_dpi = 200.0;

  /// Adds --dpi, --scale, --page, --paper and --surface to a sub-command.
  void add_to(CLI::App& command);
  /// Adds --grain and --grain-dpi, for commands that read a drawing as a whole.
  void add_grain_to(CLI::App& command);
  /// Returns the parsed options. Errors in user-defined materials are only shown as notices. Fails
  /// with a usage error if an option is invalid.
  [[nodiscard]] Result<PictureOptions> parse(Console& console) const;
};

/// Parses a page size: a DIN A size such as "A4" or "A4-landscape" (A0 to A6), or "WxH" in mm.
/// Returns nullopt for an empty text and for "fit".
Result<std::optional<Rect>> parse_page(const std::string& text);

/// Returns a page for a drawing, with the size of `area` and the colour `paper`. Fails if the size
/// is not allowed.
Result<Page> page_for(const Rect& area, Rgba paper);

/// Parses "#rrggbb", "#rrggbbaa", "white" or "transparent".
Result<Rgba> parse_paper(const std::string& text);

/// Converts the default colour of a surface or a medium from 0xRRGGBB to Rgba.
Rgba usual_color(std::uint32_t rgb) noexcept;

/// Returns the ids of surface_materials(): "paper, rough-paper, ... or glass".
std::string surface_names();
/// Sets the relief that `text` specifies: the id of a surface in options.materials, or a file
/// NAME.png or NAME.toml. Sets the grain to that relief, with the media of options.materials. An
/// empty text changes nothing.
Result<void> parse_surface(const std::string& text, PictureOptions& options);

/// Adds the media in the drawing to the grain. If grain is requested without a surface, uses the
/// drawing's surface, or paper if the drawing has no surface. Fails if the surface is unknown.
Result<void> use_surface_of(const Drawing& drawing, PictureOptions& options);

}  // namespace felt::cli
