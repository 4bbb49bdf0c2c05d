#pragma once

#include <cstdint>

#include "felt/base/random.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt::safety {

/// A body that the pen of a FuzzWorld touches: a ball that becomes larger or smaller while the pen
/// touches it. Checks the force of SolidSurface before the safety chain sees it, because the chain
/// would hide most mistakes. The rules use the geometry of a ball and no code of SolidSurface.
class FuzzBody {
 public:
  /// The pen begins at `start_mm`, a little above the ball.
  FuzzBody(Random& random, const Vec3& start_mm);

  /// Returns the force that the body requests. `dt_s`: time since the last tick.
  Force asked(PenSample sample, const StiffnessScale& scale, double dt_s, Random& random);
  /// Returns the rule that a force broke, or null.
  [[nodiscard]] const char* broken() const { return broken_; }

 private:
  void exchange(const Vec3& pen);
  void follow(const PenSample& sample);
  const char* check(const Force& force, const Force& with_other_velocity) const;

  SolidSurfaceOptions options_;
  Vec3 start_mm_;
  bool is_large_ = false;
  ForceMemory memory_;
  ForceMemory other_memory_;  // of the same pen, whose device reports another velocity
  const char* broken_ = nullptr;
  // True if the pen has been where the ball does not cover it, without a gap since then.
  bool may_touch_ = false;
  bool has_last_ = false;
  Vec3 last_mm_;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt::safety
