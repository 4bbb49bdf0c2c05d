#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "pen_strokes.h"

namespace felt::bench {

/// Draws strokes with one medium on white paper.
class Artist {
 public:
  virtual ~Artist() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// Returns the colour of solid ink.
  [[nodiscard]] virtual Rgba ink() const = 0;
  [[nodiscard]] virtual Result<Image> draw(const TestPage& page, double dpi) const = 0;
};

/// Returns our medium with this id on the surface "paper". Requires that the medium exists.
std::unique_ptr<Artist> our_medium(const std::string& id);

/// Returns a preset of libmypaint in black, "ramon/2B_pencil", at the size that its author gave it
/// at 144 dpi; or null if libmypaint or the preset is not installed.
std::unique_ptr<Artist> mypaint_preset(const std::string& preset);

}  // namespace felt::bench
