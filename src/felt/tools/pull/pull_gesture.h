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

/// What the hand feels while a pull gesture lasts; pull_force.h makes a model of it.
struct PullFeel {
  enum class Kind : std::uint8_t {
    kNone,    ///< the sheet alone: nothing has been taken hold of
    kSpring,  ///< EditSpring: back to where the gesture took hold
    kSweep,   ///< SweepSpring: to a curve that gives way with a time constant
    kPush,    ///< PushSpring: against what the nib pushes
  };
  Kind kind = Kind::kNone;
  Point origin{};           ///< kSpring: where the pen was when it took hold
  CurveNear curve{};        ///< kSweep
  std::uint32_t leaps = 0;  ///< kSweep: another number is another place, and faded over to
  LineUnderNib line{};      ///< kPush
};

/// One gesture of one mode of the pull tool: what the pen has made of the strokes so far. Modes
/// that only know the pen's present place (brush, grab) are functions of it and of the document at
/// the touch; push and sweep remember their way. Edit thread only.
class PullGesture {
 public:
  virtual ~PullGesture() = default;
  /// The pen is here now. What it has made so far, to be shown; nothing when nothing changed since
  /// the last call.
  virtual std::optional<Edit> move(const PenSample& pen, const Scene& scene) = 0;
  /// The pen was lifted: what is to be committed, refitted where the tolerance asks; empty when
  /// nothing changed.
  virtual Edit end(const Scene& scene) = 0;
  [[nodiscard]] virtual PullFeel feel() const = 0;
  virtual void draw(Overlay& overlay) const = 0;
};

}  // namespace felt
