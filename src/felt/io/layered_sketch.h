#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/document/sheet_page.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// A layer as formats know it, with its strokes in drawing order.
struct SketchLayer {
  std::string name;
  bool visible = true;
  bool locked = false;
  Sketch strokes;

  friend bool operator==(const SketchLayer&, const SketchLayer&) = default;
};

/// A drawing as it travels between programs: layers from the lowest to the topmost, and the sheet
/// where there is one. What writers of whole drawings take and readers of foreign files return.
struct LayeredSketch {
  std::vector<SketchLayer> layers;
  std::optional<SheetPage> page;
  /// Texts of the materials that it uses and that Feltline does not bring (is_material_text), as
  /// their own files have them; no format looks into them.
  std::vector<std::string> materials{};
  /// SheetPage::surface where there is no page: what it is drawn on is known, not how large it is.
  std::string surface{};

  friend bool operator==(const LayeredSketch&, const LayeredSketch&) = default;
};

}  // namespace felt
