#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/edit.h"
#include "felt/document/palette.h"
#include "felt/document/sheet_page.h"

namespace felt {

/// The part of a drawing that a window shows. Changing it leaves nothing to save.
struct Viewport {
  static constexpr double kMaxMm =
      1e6;  ///< distance of `center` from the page's origin, in x and y
  static constexpr double kMinPxPerMm = 1e-4;
  static constexpr double kMaxPxPerMm = 1e5;

  Point center;            ///< mm, in the middle of the window
  double px_per_mm = 4.0;  ///< device-independent pixels
  double angle_deg = 0.0;  ///< clockwise as seen, -180..180; mirroring comes first
  bool mirrored = false;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Data that a drawing carries and that nobody looks at unless asked: recordings of how it was
/// made, and what a newer Feltline stores in its files. The .felt format defines it (FeltExtras).
/// Immutable; copies of a drawing share it.
class DrawingExtras {
 public:
  virtual ~DrawingExtras() = default;
  [[nodiscard]] virtual bool equals(const DrawingExtras& other) const = 0;

 protected:
  DrawingExtras() = default;
  DrawingExtras(const DrawingExtras&) = default;
  DrawingExtras& operator=(const DrawingExtras&) = default;
};

/// A whole drawing: readers return it, writers take it. Undo history and selection are not part of
/// it. A copy shares the strokes and costs time linear in their number.
struct Drawing {
  Document document{};
  SheetPage page{};
  /// False if the file that it was read from states no page: `page` has the default size then, but
  /// its surface counts.
  bool has_page = true;
  Rgba color{};                    ///< of new ink
  LayerId layer{};                 ///< in use; none if none was chosen
  Palette palette{};               ///< the drawing's own colours, within PaletteLimits
  std::optional<Viewport> view{};  ///< none if it was never shown
  /// Texts of the materials that it uses and that Feltline does not bring (is_material_text), at
  /// most limits::kMaxMaterialTexts.
  std::vector<std::string> materials{};
  std::shared_ptr<const DrawingExtras> extras{};  ///< may be null

  /// Compares by value, strokes and extras too.
  friend bool operator==(const Drawing& a, const Drawing& b);
};

}  // namespace felt
