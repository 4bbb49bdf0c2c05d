#include "felt/io/svg_import.h"

#include <utility>

#include "felt/io/svg_reader.h"

namespace felt {

Result<ImportedDrawing> import_svg(std::string_view bytes, const ImportOptions&) {
  return parse_svg(bytes).map([](SvgDrawing svg) {
    ImportedDrawing imported;
    if (!svg.sketch.empty()) imported.drawing.layers.push_back({"Ink", true, false, {}});
    if (!svg.sketch.empty()) imported.drawing.layers.back().strokes = std::move(svg.sketch);
    imported.drawing.page = SheetPage{svg.area.width(), svg.area.height(), svg.paper};
    return imported;
  });
}

}  // namespace felt
