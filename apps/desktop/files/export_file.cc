#include "desktop/files/export_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "desktop/files/clipboard.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/io/drawing_builder.h"

namespace felt::desktop {

Drawing selected_only(Drawing drawing, const Selection& selection) {
  DrawingBuilder builder;
  const auto is_selected = [&](StrokeId id) { return selection.find(id) != nullptr; };
  for (const Layer& layer : drawing.document.layers()) {
    std::optional<std::size_t> added;
    const auto kept = [&] {
      if (!added) {
        LayerState state = layer.state();
        state.picture = nullptr;
        added = builder.add_layer(std::move(state));
      }
      return *added;
    };
    for (const FillId id : layer.fills) {
      const FillPtr fill = drawing.document.find_fill(id);
      if (goes_with_strokes(*fill, is_selected)) builder.add_fill(kept(), fill, fill_name(id));
    }
    for (const StrokeId id : layer.strokes) {
      if (is_selected(id)) builder.add(kept(), drawing.document.find(id), id);
    }
  }
  drawing.document = std::move(builder).build().document;
  drawing.layer = {};
  return drawing;
}

Rect export_area(const Rect& ink, const Page& page, const ExportOptions& options) {
  return options.part != ExportPart::kPage && !ink.empty() ? ink_area(ink) : page.area();
}

Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options, SwellReport* swell) {
  if (options.swell) {
    SwellReport report;
    const Result<Drawing> black = prepare_for_swell_paper(drawing, report);
    if (!black) return tl::unexpected(black.error());
    if (swell) *swell = report;
    ExportOptions rest = options;
    rest.swell = rest.grain = rest.pictures = rest.background = false;
    rest.compact = options.format == FileFormat::kSvg;
    return export_drawing(path, *black, rest);
  }
  WriteOptions how;
  how.dpi = options.dpi;
  how.compact = options.compact;
  if (options.pictures) how.pictures = PictureChoice::kAll;
  if (options.grain && !options.compact && traits_of(options.format).picture) {
    Result<Grain> grain = grain_of(drawing);
    if (!grain) return tl::unexpected(grain.error());
    how.grain = *grain;
    how.grain_print =
        GrainPrint{*grain, std::clamp(options.dpi, GrainPrint::kMinDpi, GrainPrint::kMaxDpi)};
  }
  if (!options.background) how.paper = Rgba{255, 255, 255, 0};
  if (options.part != ExportPart::kPage) {
    how.area = export_area(ink_bounds(drawing.document), drawing.page, options);
  }
  return felt::write_drawing(path.toStdString(), drawing, options.format, how);
}

}  // namespace felt::desktop
