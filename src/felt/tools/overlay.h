#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/geometry/cubic.h"
#include "felt/geometry/point.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A display list, in mm, of everything that a tool shows on top of the document. The canvas and
/// pictures draw it. It is reused from frame to frame, so that its vectors keep their memory.
struct Overlay {
  /// Wet ink: a segment, with width and tone at both ends. Segments are in drawing order.
  struct InkSegment {
    Cubic curve;
    double start_width_mm = 0.0;
    double end_width_mm = 0.0;
    double start_tone = tone_of_width(start_width_mm);  ///< as WidthKnot::tone
    double end_tone = tone_of_width(end_width_mm);

    friend bool operator==(const InkSegment&, const InkSegment&) noexcept = default;
  };
  enum class Role {
    kReach,     ///< a radius within which something acts
    kSnap,      ///< a point that attracts the pen
    kTether,    ///< a connection that holds the pen or a stroke back
    kGuide,     ///< a path or point that the hand is guided to
    kSpan,      ///< the part of a stroke that an edit affects
    kVector,    ///< a line from the start of a gesture to the pen
    kSelected,  ///< selected, or about to be selected
    kHandle,    ///< a handle that can be grabbed
    kCut,       ///< ink that will be removed
    kRule,      ///< a line of a guide of the drawing
    kTick,      ///< a tick or an auxiliary line of such a guide
    kAxis,      ///< a mirror axis
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

  /// A marked part of a stroke.
  struct Span {
    Cubic curve;
    double width_mm = 0.0;  ///< width of the ink at this part
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
  /// A short text next to a point: a number with its unit.
  struct Label {
    Point at;
    std::string text;
  };

  std::vector<InkSegment> ink;
  Rgba ink_color{};
  /// Identifies the stroke that `ink` shows; 0 if unknown.
  std::uint64_t ink_stroke = 0;
  /// Number of leading segments that never change again: if two overlays show the same stroke,
  /// their segments are equal up to the smaller of the two numbers. add_stable_ink() sets this
  /// number.
  std::size_t ink_stable = 0;
  /// The mappings at which `ink` is shown besides where it is: its mirror images.
  std::vector<Affine> ink_images;
  std::vector<Ring> rings;
  std::vector<Line> lines;
  std::vector<Span> spans;
  std::vector<Outline> outlines;
  std::vector<Dot> dots;
  std::vector<Label> labels;

  void clear() noexcept {
    clear_ink();
    ink_images.clear();
    rings.clear();
    lines.clear();
    spans.clear();
    outlines.clear();
    dots.clear();
    labels.clear();
  }
  /// Appends the segments of a stroke in progress that never change again. Copies only the segments
  /// that this overlay did not already have before clear(). Requires a `stroke` that is not 0 and
  /// is unique in the program.
  void add_stable_ink(std::uint64_t stroke, std::span<const InkSegment> segments);

 private:
  void clear_ink() noexcept;

  // The ink that clear() removed last, so that add_stable_ink() can continue it.
  std::vector<InkSegment> last_ink_;
  std::uint64_t last_stroke_ = 0;
  std::size_t last_stable_ = 0;
};

/// Returns a segment as it is at one of Overlay::ink_images.
Overlay::InkSegment mapped(const Overlay::InkSegment& segment, const Affine& image) noexcept;

/// Adds marks for the part [u0, u1] of a stroke. On a closed stroke, u1 <= u0 means that the part
/// crosses the seam.
void add_span(Overlay& overlay, const Stroke& stroke, double u0, double u1, Overlay::Role role);

}  // namespace felt
