#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/tools/eraser/crossing_span.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/overlay.h"
#include "felt/tools/scene.h"

namespace felt {

/// Marks the ink that a touch would erase, in the modes that erase more than the eraser covers.
/// Each update searches for a limited number of crossings, so on a long line the mark appears only
/// after some samples.
class EraserAim {
 public:
  /// Maximum age of the marks. Older marks are computed again, because nearby strokes may have
  /// changed, for example by an undo.
  static constexpr std::int64_t kFreshNs = 250'000'000;
  /// Maximum number of marked strokes under the ring.
  static constexpr std::size_t kMaxMarked = 64;

  /// Updates the marks for a pen that hovers at this position.
  void update(Point pen, std::int64_t time_ns, EraserMode mode, const EraserSettings& settings,
              const Scene& scene);
  void clear();
  void draw(Overlay& overlay) const;

 private:
  struct Mark {
    StrokePtr stroke;
    double from = 0.0;
    double to = 0.0;
  };

  void aim_at_part(Point pen, const EraserSettings& settings, const Scene& scene);
  void aim_at_strokes(Point pen, const EraserSettings& settings, const Scene& scene);
  [[nodiscard]] bool is_marked(double u) const noexcept;

  std::vector<Mark> marks_;
  std::optional<StrokeCrossings> crossings_;
  std::optional<SpanSearch> search_;
  std::int64_t since_ns_ = 0;
};

}  // namespace felt
