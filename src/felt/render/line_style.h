#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/material/materials.h"

namespace felt {

/// The style of a medium's lines, prepared for drawing.
struct LineStyle {
  MediumStyle how;
  StyleShape shape;  ///< of `how.shape`; empty if the kind needs none

  friend bool operator==(const LineStyle& a, const LineStyle& b) { return a.how == b.how; }
};

/// The styles of all media that have one, by the id of the medium. A value type whose copies share
/// the styles. Safe to use from any thread.
class LineStyles {
 public:
  /// The styles of the built-in media.
  LineStyles() noexcept;
  /// The styles of these media. A medium whose shape cannot be read has none.
  explicit LineStyles(const Materials& materials);

  /// Returns the style of the medium with this id, or null if its lines are plain. The pointer is
  /// valid as long as any copy of this object.
  [[nodiscard]] const LineStyle* find(std::string_view medium) const noexcept;

  friend bool operator==(const LineStyles& a, const LineStyles& b) {
    return a.all_ == b.all_ || *a.all_ == *b.all_;
  }

 private:
  std::shared_ptr<const std::vector<std::pair<std::string, LineStyle>>> all_;
};

}  // namespace felt
