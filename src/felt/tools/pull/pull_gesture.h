#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/overlay.h"
#include "felt/tools/scene.h"

namespace felt {

/// The kind and the parameters of the force during a pull gesture. pull_force.h makes the force
/// model from them.
struct PullFeel {
  enum class Kind : std::uint8_t {
    kNone,    ///< the force of the surface only, because nothing is grabbed
    kSpring,  ///< EditSpring: back to the point of the grab
    kSweep,   ///< SweepSpring: towards a curve that yields with a time constant
    kPush,    ///< PushSpring: against the lines that the nib pushes
  };
  Kind kind = Kind::kNone;
  Point origin{};           ///< kSpring: position of the pen at the grab
  CurveNear curve{};        ///< kSweep
  std::uint32_t leaps = 0;  ///< kSweep: counts leaps of `curve`, which cross-fade the force
  LineUnderNib line{};      ///< kPush
};

/// One gesture in one mode of the pull tool. It contains the strokes as the pen has changed them so
/// far. In brush, grab, bulge and pinch mode, these strokes depend only on the pen's current
/// position and the document at the touch; in push and sweep mode they depend on the path of the
/// pen. Edit thread only.
class PullGesture {
 public:
  virtual ~PullGesture() = default;
  /// Handles the next pen sample. Returns the changes so far, to be shown, or nullopt if nothing
  /// changed since the last call.
  virtual std::optional<Edit> move(const PenSample& pen, const Scene& scene) = 0;
  /// Called when the pen is lifted. Returns the edit to commit, refitted within the tolerance, or
  /// an empty edit if nothing changed.
  virtual Edit end(const Scene& scene) = 0;
  [[nodiscard]] virtual PullFeel feel() const = 0;
  virtual void draw(Overlay& overlay) const = 0;
};

}  // namespace felt
