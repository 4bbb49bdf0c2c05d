#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/sheet_page.h"
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

/// What pictures of a sketch (.png, .svg) look like.
struct PictureOptions {
  double dpi = 300.0;         ///< of a .png
  std::optional<Rect> sheet;  ///< none: all ink and a margin, or the drawing's own page
  bool fit = false;           ///< --page fit: all ink and a margin, even where there is a page
  std::optional<Rgba> paper;  ///< none: white in a .png, nothing in an .svg
  std::shared_ptr<const HeightField> own_relief{};  ///< a user's own picture, that relief is then
  const HeightField* relief = nullptr;              ///< of --surface; null: smooth
  Grain grain;               ///< the relief of the sheet in the ink; solid ink without
  bool has_surface = false;  ///< --surface says which relief
  bool wants_grain = false;  ///< --grain: in an .svg or .pdf too, and of the drawing's own sheet
  double grain_dpi = 200.0;  ///< in an .svg or .pdf
  /// Known here; a person's own are among them where grain is to be seen.
  Materials materials = Materials::built_in();
};

/// The options as written, before they are understood.
struct PictureArguments {
  double dpi = 300.0;
  std::string page;
  std::string paper;
  std::string surface;
  bool grain = false;
  double grain_dpi = 200.0;

  /// Adds --dpi, --page, --paper and --surface to a sub-command.
  void add_to(CLI::App& command);
  /// Adds --grain and --grain-dpi, of commands that have the drawing as a whole.
  void add_grain_to(CLI::App& command);
  /// What is wrong with a person's own materials is a notice. Error: an option makes no sense; it
  /// is a usage error.
  [[nodiscard]] Result<PictureOptions> parse(Console& console) const;
};

/// "" or "fit" (none), a DIN A size "A0".."A6" with "A4-landscape", or "WxH" in mm.
Result<std::optional<Rect>> parse_page(const std::string& text);

/// The sheet of a drawing of that size. Error: no sheet can have it.
Result<SheetPage> sheet_page(const Rect& sheet, Rgba paper);

/// "#rrggbb", "#rrggbbaa", "white" or "transparent".
Result<Rgba> parse_paper(const std::string& text);

/// The usual colour of a sheet or a medium, 0xRRGGBB, as ink and pages have it.
Rgba usual_color(std::uint32_t rgb) noexcept;

/// The ids of surface_materials(): "paper, rough-paper, ... or glass".
std::string surface_names();
/// Sets the relief to that of one of options.materials, by id, or of a file NAME.png or NAME.toml,
/// and the grain to it with their media; "" is none.
Result<void> parse_surface(const std::string& text, PictureOptions& options);

/// The grain with the media that the drawing brings along, too; where grain was asked for and no
/// surface, of the drawing's sheet, or of paper where it says none. Error: a sheet that is not
/// known here.
Result<void> use_surface_of(const Drawing& drawing, PictureOptions& options);

}  // namespace felt::cli
