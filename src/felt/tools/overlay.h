#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/geometry/point.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// What a tool shows besides the document, as a display list in mm; the canvas and pictures draw
/// it. Reused from frame to frame, so that its vectors keep their memory.
struct Overlay {
  /// Ink that is still wet: segments in drawing order, each with width and tone at both ends.
  struct InkSegment {
    Cubic curve;
    double start_width_mm = 0.0;
    double end_width_mm = 0.0;
    double start_tone = tone_of_width(start_width_mm);  ///< WidthKnot::tone at both ends
    double end_tone = tone_of_width(end_width_mm);

    friend bool operator==(const InkSegment&, const InkSegment&) noexcept = default;
  };
  enum class Role {
    kReach,     ///< a radius within which something acts
    kSnap,      ///< a place that attracts
    kTether,    ///< what holds
    kGuide,     ///< where the hand is led
    kSpan,      ///< what of a stroke an edit reaches
    kVector,    ///< from where a gesture took hold to where it is
    kSelected,  ///< what is selected, or is about to be
    kHandle,    ///< a place to take hold of
    kCut,       ///< what goes
  };
  struct Ring {
    Point center;
    double radius_mm = 0.0;
    Role role = Role::kReach;
  };
  struct Line {
    Point from, to;
    Role role = Role::kGuide;
  };

  /// A piece of a stroke that is marked.
  struct Span {
    Cubic curve;
    double width_mm = 0.0;  ///< of the ink there
    Role role = Role::kSpan;

    friend bool operator==(const Span&, const Span&) noexcept = default;
  };
  struct Outline {
    std::vector<Point> points;
    bool closed = false;
    Role role = Role::kSelected;
  };
  struct Dot {
    Point at;
    Role role = Role::kHandle;
  };
  /// A short text beside a place: a number with its unit.
  struct Label {
    Point at;
    std::string text;
  };

  std::vector<InkSegment> ink;
  Rgba ink_color{};
  /// Identifies the stroke that `ink` shows; 0 if it is unknown.
  std::uint64_t ink_stroke = 0;
  /// Number of first segments that never change again: if two overlays show the same stroke, they
  /// have equal segments up to the smaller number of the two. Set by add_stable_ink().
  std::size_t ink_stable = 0;
  std::vector<Ring> rings;
  std::vector<Line> lines;
  std::vector<Span> spans;
  std::vector<Outline> outlines;
  std::vector<Dot> dots;
  std::vector<Label> labels;

  void clear() noexcept {
    clear_ink();
    rings.clear();
    lines.clear();
    spans.clear();
    outlines.clear();
    dots.clear();
    labels.clear();
  }
  /// Appends the segments of a stroke in progress that never change again. Copies only those that
  /// are new since this overlay showed the stroke, before clear(). Requires a `stroke` that is not
  /// 0 and that no other stroke in the program has.
  void add_stable_ink(std::uint64_t stroke, std::span<const InkSegment> segments);

 private:
  void clear_ink() noexcept;

  // The ink that clear() removed last, so that add_stable_ink() can continue it.
  std::vector<InkSegment> last_ink_;
  std::uint64_t last_stroke_ = 0;
  std::size_t last_stable_ = 0;
};

/// Marks the part [u0, u1] of a stroke; on a closed one u1 <= u0 goes through the seam.
void add_span(Overlay& overlay, const Stroke& stroke, double u0, double u1, Overlay::Role role);

}  // namespace felt
