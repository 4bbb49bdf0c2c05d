#pragma once

#include <QMimeData>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/rect.h"
#include "felt/io/import.h"
#include "felt/stroke/sketch.h"

namespace felt::desktop {

/// Type of our own strokes on the clipboard: lines of .ndjson, exact.
inline constexpr const char* kStrokesMime = "application/x-feltline-strokes";
/// Beside it, where they are of media that Feltline does not bring: the texts of these media, an
/// array of strings of JSON.
inline constexpr const char* kMaterialsMime = "application/x-feltline-materials";

/// Strokes for the clipboard: our own types, image/svg+xml and a picture at 300 dots per inch (less
/// where that would be a very large one). The last two are made when somebody asks for them.
/// `materials`: texts of the media that they are of and that Feltline does not bring.
std::unique_ptr<QMimeData> strokes_mime(Sketch sketch, std::vector<std::string> materials = {});
/// One of the two alone, for programs that choose the wrong one.
std::unique_ptr<QMimeData> svg_mime(const Sketch& sketch,
                                    std::span<const std::string> materials = {});
std::unique_ptr<QMimeData> png_mime(const Sketch& sketch);

/// What a clipboard carries: our own strokes, else SVG, InkML or lines of JSON of any program, by
/// their types or as text. Nothing where it has none of them; error where it is damaged.
struct PastedStrokes {
  Sketch sketch;
  ImportReport report;
  /// Texts of materials that come along, at most limits::kMaxMaterialTexts of is_material_text().
  /// Nobody vouches for them: a text may say no material.
  std::vector<std::string> materials{};
};
Result<PastedStrokes> strokes_of(const QMimeData& data);

/// What the ink covers, with a margin of a millimetre.
Rect ink_area(const Sketch& sketch);

}  // namespace felt::desktop
