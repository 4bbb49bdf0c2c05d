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

/// What would go if the eraser touched here: shown before it does, in the modes that take more
/// than they cover. Crossings are looked for a little with each sample, so that the mark appears a
/// few samples after a pen has come to a long line.
class EraserAim {
 public:
  /// Marks that long are made anew: the strokes around may have changed (undo).
  static constexpr std::int64_t kFreshNs = 250'000'000;
  /// More strokes than that under the ring are not marked.
  static constexpr std::size_t kMostMarked = 64;

  /// The pen is in the air over this place.
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
