#pragma once

#include <memory>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/motion/stroke_matches.h"

namespace felt {

/// How a stroke that only one key drawing has comes or goes.
enum class LoneStroke : std::uint8_t {
  kFade,  ///< it becomes more and more transparent
  kGrow,  ///< it is drawn from its start, or taken back to it
};

/// Options of an in-between.
struct InbetweenOptions {
  std::vector<GivenPair> pairs{};  ///< as indices in key_strokes()
  LoneStroke lone = LoneStroke::kFade;
};

/// The strokes of a key drawing that move: those of visible layers, in drawing order.
struct KeyStrokes {
  std::vector<StrokePtr> strokes;
  std::vector<StrokeId> ids;
  std::vector<std::size_t> layers;  ///< index of the layer of each stroke
};

/// Returns the strokes of a drawing by which matches name them.
KeyStrokes key_strokes(const Document& document);

/// The drawings between two key drawings (docs/design/motion.md).
///
///   const auto motion = Inbetween::create(first, second, {});
///   for (int i = 1; i <= 12; ++i) write(motion->at(i / 13.0));
///
/// Matched strokes change their shape (StrokeBlend), and ends that touch in both drawings stay
/// together. Fills fade over and move with the drawing. The in-betweens have the page, the layers
/// and the guides of the first drawing; a stroke that only the second one has is in the layer of
/// the same name or, without such a layer, in the highest visible one. Hidden layers are empty.
/// Strokes are numbered again, but keep their names (Drawing::names): matched strokes those of the
/// first drawing.
///
/// Immutable, so several threads may use it. Keeps the strokes of both drawings.
class Inbetween {
 public:
  /// Finds the correspondence and prepares the in-betweens. Fails like match_strokes().
  static Result<Inbetween> create(const Drawing& from, const Drawing& to,
                                  const InbetweenOptions& options);
  Inbetween(Inbetween&&) noexcept;
  Inbetween& operator=(Inbetween&&) noexcept;
  ~Inbetween();

  /// Returns the drawing at t, 0..1. At 0 (or less, or NaN) it is the first key drawing, and at 1
  /// (or more) the second one, unchanged.
  [[nodiscard]] Drawing at(double t) const;
  /// Returns the strokes of at(t) in drawing order, without their layers. Requires 0 < t < 1.
  [[nodiscard]] std::vector<StrokePtr> strokes_at(double t) const;
  [[nodiscard]] const Correspondence& correspondence() const noexcept;

 private:
  struct Plan;
  explicit Inbetween(std::unique_ptr<const Plan> plan) noexcept;

  std::unique_ptr<const Plan> plan_;
};

}  // namespace felt
