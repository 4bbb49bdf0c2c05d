#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/sheet_page.h"
#include "felt/geometry/rect.h"
#include "felt/render/grain.h"
#include "felt/stroke/stroke.h"

namespace felt::cli {

/// What pictures of a sketch (.png, .svg) look like.
struct PictureOptions {
  double dpi = 300.0;         ///< of a .png
  std::optional<Rect> sheet;  ///< none: all ink and a margin, or the drawing's own page
  bool fit = false;           ///< --page fit: all ink and a margin, even where there is a page
  std::optional<Rgba> paper;  ///< none: white in a .png, nothing in an .svg
  Grain grain;                ///< the relief of the sheet in the ink of a .png; smooth without
};

/// The options as written, before they are understood.
struct PictureArguments {
  double dpi = 300.0;
  std::string page;
  std::string paper;
  std::string surface;

  /// Adds --dpi, --page, --paper and --surface to a sub-command.
  void add_to(CLI::App& command);
  /// Error: one of them makes no sense; it is a usage error.
  [[nodiscard]] Result<PictureOptions> parse() const;
};

/// "" or "fit" (none), a DIN A size "A0".."A6" with "A4-landscape", or "WxH" in mm.
Result<std::optional<Rect>> parse_page(const std::string& text);

/// The sheet of a drawing of that size. Error: no sheet can have it.
Result<SheetPage> sheet_page(const Rect& sheet, Rgba paper);

/// "#rrggbb", "#rrggbbaa", "white" or "transparent".
Result<Rgba> parse_paper(const std::string& text);

/// The relief of one of surface_materials(), by id; "" is smooth.
Result<Grain> parse_surface(const std::string& text);

}  // namespace felt::cli
