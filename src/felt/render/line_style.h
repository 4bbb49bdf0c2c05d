#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/material/materials.h"

namespace felt {

/// The style of a medium's lines, prepared for drawing.
struct StrokeStyle {
  MediumStyle how;
  StyleShape shape;  ///< of `how.shape`; empty if the kind needs none

  friend bool operator==(const StrokeStyle& a, const StrokeStyle& b) { return a.how == b.how; }
};

/// The styles of all media that have one, by the id of the medium. A value type whose copies share
/// the styles. Safe to use from any thread.
class StrokeStyles {
 public:
  /// The styles of the built-in media.
  StrokeStyles() noexcept;
  /// The styles of these media. A medium whose shape cannot be read has none.
  explicit StrokeStyles(const Materials& materials);

  /// Returns the style of the medium with this id, or null if its lines are plain. The pointer is
  /// valid as long as any copy of this object.
  [[nodiscard]] const StrokeStyle* find(std::string_view medium) const noexcept;

  friend bool operator==(const StrokeStyles& a, const StrokeStyles& b) {
    return a.all_ == b.all_ || *a.all_ == *b.all_;
  }

 private:
  std::shared_ptr<const std::vector<std::pair<std::string, StrokeStyle>>> all_;
};

}  // namespace felt
