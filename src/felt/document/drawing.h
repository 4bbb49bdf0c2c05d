#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/edit.h"
#include "felt/document/page.h"
#include "felt/document/palette.h"

namespace felt {

/// The part of a drawing that a window shows. A change of the viewport does not count as an unsaved
/// change.
struct Viewport {
  static constexpr double kMaxMm = 1e6;  ///< limit of the coordinates of `center`
  static constexpr double kMinPxPerMm = 1e-4;
  static constexpr double kMaxPxPerMm = 1e5;

  Point center;            ///< mm, shown at the middle of the window
  double px_per_mm = 4.0;  ///< scale, in device-independent pixels
  double angle_deg = 0.0;  ///< clockwise on the screen, -180..180; applied after mirroring
  bool mirrored = false;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Data of a drawing that is only read on request: recordings of how the drawing was made, and
/// content that a newer version of Feltline stored in the file. The .felt format defines these data
/// (FeltExtras). Immutable; copies of a drawing share it.
class DrawingExtras {
 public:
  virtual ~DrawingExtras() = default;
  [[nodiscard]] virtual bool equals(const DrawingExtras& other) const = 0;

 protected:
  DrawingExtras() = default;
  DrawingExtras(const DrawingExtras&) = default;
  DrawingExtras& operator=(const DrawingExtras&) = default;
};

/// Names of strokes, by their ids.
using StrokeNames = std::map<StrokeId, std::string>;

/// A whole drawing, as readers return it and writers accept it. It has no undo history and no
/// selection. A copy shares the strokes and takes linear time in their number.
struct Drawing {
  Document document{};
  Page page{};
  /// False if the drawing was read from a file without a page size. In that case, `page` has the
  /// default size; the other values of `page` are valid.
  bool has_page = true;
  Rgba color{};                    ///< colour of new ink
  LayerId layer{};                 ///< active layer; zero if the user has not chosen one
  Palette palette{};               ///< the drawing's own colours, within PaletteLimits
  std::optional<Viewport> view{};  ///< absent if the drawing was never shown
  /// Texts of the materials that the drawing uses and that are not built in (is_material_text); at
  /// most limits::kMaxMaterialTexts.
  std::vector<std::string> materials{};
  std::shared_ptr<const DrawingExtras> extras{};  ///< may be null
  /// The names that strokes had in the file from which they were read, if they differ from
  /// stroke_name(). May be null, and may contain strokes that the document does not have any more.
  std::shared_ptr<const StrokeNames> names{};

  /// Compares by value, including strokes and extras.
  friend bool operator==(const Drawing& a, const Drawing& b);
};

/// Returns the names of the strokes that the document has.
StrokeNames used_names(const Drawing& drawing);
/// Returns the name of a stroke in files: its own name if it has one, otherwise stroke_name().
std::string name_in_file(const Drawing& drawing, StrokeId id);

}  // namespace felt
