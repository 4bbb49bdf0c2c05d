// What lupdate reads: the texts of the tools' tables and the labels of edits, which the library
// knows in English only. A test holds the first list against the tables.
#include <QtGlobal>

#include "desktop/panels/tool_texts.h"

namespace felt::desktop {
namespace {

constexpr const char* kToolTexts[] = {
    QT_TRANSLATE_NOOP(
        "tools",
        "A line drawn round what is to be selected, or a rectangle from corner to corner."),
    QT_TRANSLATE_NOOP("tools", "A line farther from the pen than this is not taken hold of."),
    QT_TRANSLATE_NOOP("tools",
                      "A line goes where the eraser covers its ink, instead of its middle."),
    QT_TRANSLATE_NOOP("tools",
                      "A short touch selects the whole nearest line within this distance."),
    QT_TRANSLATE_NOOP("tools",
                      "Above 1 a light hand stays thin for longer, below 1 it broadens sooner."),
    QT_TRANSLATE_NOOP("tools", "Amount"),
    QT_TRANSLATE_NOOP("tools",
                      "An end that is let go beside all others stays there; without it, it goes "
                      "back. The first modifier chooses the other."),
    QT_TRANSLATE_NOOP("tools", "Attraction"),
    QT_TRANSLATE_NOOP("tools", "Blackboard"),
    QT_TRANSLATE_NOOP("tools", "Broad lines sooner"),
    QT_TRANSLATE_NOOP("tools", "Broadest line"),
    QT_TRANSLATE_NOOP("tools",
                      "Brush: thicker or thinner under the pen. Retrace: drawing along a line "
                      "gives it the new pressure. Scale: dragging up or down scales a whole line."),
    QT_TRANSLATE_NOOP("tools",
                      "By pressure, hard for thicker and light for thinner, or always the same "
                      "way. The first button of the pen makes thinner, the second thicker."),
    QT_TRANSLATE_NOOP("tools", "By the handle that is touched (auto), or always the same."),
    QT_TRANSLATE_NOOP("tools", "Combine"),
    QT_TRANSLATE_NOOP("tools", "Connect"),
    QT_TRANSLATE_NOOP("tools", "Constrain"),
    QT_TRANSLATE_NOOP(
        "tools",
        "Corrects lines: take hold of one and pull it into shape, or push it from outside."),
    QT_TRANSLATE_NOOP("tools", "Direction of the brush"),
    QT_TRANSLATE_NOOP("tools", "Draws lines; pressing harder draws them broader."),
    QT_TRANSLATE_NOOP("tools", "Duplicate"),
    QT_TRANSLATE_NOOP("tools",
                      "Ends and corners go along, instead of staying unless taken hold of; the "
                      "first modifier turns this round for one gesture."),
    QT_TRANSLATE_NOOP("tools", "Eraser"),
    QT_TRANSLATE_NOOP("tools",
                      "Erases what it covers, lines up to their next crossings, or whole lines."),
    QT_TRANSLATE_NOOP("tools", "Felt"),
    QT_TRANSLATE_NOOP("tools",
                      "Fits the finished line again, with fewer segments within the same "
                      "tolerance; lines of more than a minute stay as drawn."),
    QT_TRANSLATE_NOOP("tools", "Force that draws the pen to the end of a line."),
    QT_TRANSLATE_NOOP("tools", "Free ends and corners"),
    QT_TRANSLATE_NOOP("tools", "Glass"),
    QT_TRANSLATE_NOOP(
        "tools",
        "Grab divides the line so that no more than this is bent; 0 takes segments as they are."),
    QT_TRANSLATE_NOOP("tools", "Grab radius"),
    QT_TRANSLATE_NOOP("tools",
                      "Heavier draws smoother and trails more; for the stabiliser 'inertia'."),
    QT_TRANSLATE_NOOP(
        "tools",
        "How far a line may move when the brush lets go of it; more leaves fewer segments."),
    QT_TRANSLATE_NOOP("tools", "How far the brush reaches along the line, to each side."),
    QT_TRANSLATE_NOOP("tools",
                      "How far the finished line may be from the ironed one, for fewer segments."),
    QT_TRANSLATE_NOOP("tools", "How fast it irons; pressing harder irons faster too."),
    QT_TRANSLATE_NOOP("tools", "How fast the width changes, per unit of pressure."),
    QT_TRANSLATE_NOOP(
        "tools",
        "How grab bends a segment: with least motion (soft), by the paper's three cases (paper), "
        "or by its equation 7 as printed, which does not reach the pen."),
    QT_TRANSLATE_NOOP("tools", "How near to the end of a line the pen takes hold of it."),
    QT_TRANSLATE_NOOP("tools", "How slowly a line gives way to the pen that sweeps it."),
    QT_TRANSLATE_NOOP("tools", "Irons the jitter out of lines and leaves their shape."),
    QT_TRANSLATE_NOOP("tools",
                      "Joins ends of lines, or closes a line: drag an end onto another, or tap "
                      "where two ends are near."),
    QT_TRANSLATE_NOOP("tools", "Keep lines separate"),
    QT_TRANSLATE_NOOP("tools", "Largest distance between the pen's way and the line."),
    QT_TRANSLATE_NOOP("tools", "Lasso"),
    QT_TRANSLATE_NOOP("tools", "Leave the end where it is let go"),
    QT_TRANSLATE_NOOP(
        "tools", "Leaves the lines and transforms a copy; as the second button of the pen does."),
    QT_TRANSLATE_NOOP("tools", "Length bent by grab"),
    QT_TRANSLATE_NOOP("tools", "Lines that meet share the point but stay two lines."),
    QT_TRANSLATE_NOOP("tools",
                      "Longer draws smoother and trails more; for the stabiliser 'towed'."),
    QT_TRANSLATE_NOOP("tools", "Makes lines broader and thinner, here and there or as a whole."),
    QT_TRANSLATE_NOOP("tools", "Mass of the stabiliser"),
    QT_TRANSLATE_NOOP("tools", "Material"),
    QT_TRANSLATE_NOOP("tools", "Mode"),
    QT_TRANSLATE_NOOP("tools",
                      "Moves along one axis, turns in steps of 15 degrees, corners stretch both "
                      "axes freely; as the first button of the pen does."),
    QT_TRANSLATE_NOOP("tools",
                      "Moves, turns, scales and stretches what is selected, held back by the lines "
                      "that lead out of it."),
    QT_TRANSLATE_NOOP("tools", "No line is made broader than this; one that is may stay so."),
    QT_TRANSLATE_NOOP("tools", "Of retracing: above 1 a light hand stays thin for longer."),
    QT_TRANSLATE_NOOP("tools", "Paper"),
    QT_TRANSLATE_NOOP("tools", "Pencil"),
    QT_TRANSLATE_NOOP("tools", "Pressure curve"),
    QT_TRANSLATE_NOOP("tools", "Pressure of a device that knows neither pressure nor depth."),
    QT_TRANSLATE_NOOP("tools", "Pressure of a mouse"),
    QT_TRANSLATE_NOOP("tools", "Pull"),
    QT_TRANSLATE_NOOP("tools",
                      "Pull a stretch of a line (brush), bend one segment (grab), push lines from "
                      "outside (push), or draw a line over again (sweep)."),
    QT_TRANSLATE_NOOP("tools", "Radius"),
    QT_TRANSLATE_NOOP("tools",
                      "Radius around the end of a line within which it attracts the dragged end; a "
                      "tap connects ends that are this near."),
    QT_TRANSLATE_NOOP("tools", "Radius around the end of a line within which it attracts the pen."),
    QT_TRANSLATE_NOOP("tools", "Radius of the eraser."),
    QT_TRANSLATE_NOOP("tools", "Radius of the nib"),
    QT_TRANSLATE_NOOP("tools",
                      "Radius within which a line that begins or ends there is connected."),
    QT_TRANSLATE_NOOP("tools", "Radius within which the dragged end is connected."),
    QT_TRANSLATE_NOOP("tools", "Reach"),
    QT_TRANSLATE_NOOP("tools", "Reach of a click"),
    QT_TRANSLATE_NOOP("tools", "Reach of the attraction"),
    QT_TRANSLATE_NOOP("tools", "Reach of the brush"),
    QT_TRANSLATE_NOOP("tools", "Refine at pen-up"),
    QT_TRANSLATE_NOOP("tools", "Rope of the stabiliser"),
    QT_TRANSLATE_NOOP("tools", "Rounds corners, which otherwise stay; ends of lines always do."),
    QT_TRANSLATE_NOOP("tools", "Scale widths"),
    QT_TRANSLATE_NOOP("tools", "Scaling makes lines broader or thinner as well."),
    QT_TRANSLATE_NOOP("tools", "Select"),
    QT_TRANSLATE_NOOP("tools", "Selects what a line is drawn round; a short touch takes a line."),
    QT_TRANSLATE_NOOP("tools", "Shape"),
    QT_TRANSLATE_NOOP(
        "tools", "Share of friction and grain that is felt; the sheet stays as hard as it is."),
    QT_TRANSLATE_NOOP(
        "tools", "Share of friction and roughness that is felt; the sheet stays as hard as it is."),
    QT_TRANSLATE_NOOP("tools",
                      "Share of friction, grain, attraction and pull that is felt; the sheet stays "
                      "as hard as it is."),
    QT_TRANSLATE_NOOP("tools",
                      "Share of friction, grain, attraction and stabiliser that is felt; the sheet "
                      "stays as hard as it is."),
    QT_TRANSLATE_NOOP(
        "tools",
        "Share of friction, stops and pull that is felt; the sheet stays as hard as it is."),
    QT_TRANSLATE_NOOP("tools",
                      "Share of the counter-force, friction and grain that is felt; the sheet "
                      "stays as hard as it is."),
    QT_TRANSLATE_NOOP(
        "tools",
        "Share of the sheet's friction and grain that is felt; the sheet stays as hard as it is."),
    QT_TRANSLATE_NOOP("tools", "Share of the tethers, friction and grain that is felt."),
    QT_TRANSLATE_NOOP("tools", "Sheet"),
    QT_TRANSLATE_NOOP("tools", "Size of the round nib that pushes lines."),
    QT_TRANSLATE_NOOP("tools", "Smooth"),
    QT_TRANSLATE_NOOP("tools", "Smooth corners too"),
    QT_TRANSLATE_NOOP("tools", "Snap radius"),
    QT_TRANSLATE_NOOP("tools", "Snapping"),
    QT_TRANSLATE_NOOP("tools", "Speed of the brush"),
    QT_TRANSLATE_NOOP("tools", "Stabiliser"),
    QT_TRANSLATE_NOOP("tools",
                      "Steadies the hand: the line is drawn by a mass, or by a nib on a rope."),
    QT_TRANSLATE_NOOP("tools", "Strength of forces"),
    QT_TRANSLATE_NOOP(
        "tools",
        "The parts of lines inside by their control points (points) or by their joints only "
        "(on-curve), or whole lines of which any part is inside (strokes)."),
    QT_TRANSLATE_NOOP("tools", "Thinnest line"),
    QT_TRANSLATE_NOOP("tools", "Thinnest retraced line"),
    QT_TRANSLATE_NOOP("tools", "Time of sweep"),
    QT_TRANSLATE_NOOP("tools", "Tolerance"),
    QT_TRANSLATE_NOOP("tools", "Transform"),
    QT_TRANSLATE_NOOP("tools",
                      "Way along the line, to both sides of the pen, that is ironed; waves up to "
                      "this long can be taken away."),
    QT_TRANSLATE_NOOP(
        "tools", "Way along the line, to both sides of the pen, within which the width changes."),
    QT_TRANSLATE_NOOP("tools", "Weights of grab"),
    QT_TRANSLATE_NOOP("tools", "What a touch does"),
    QT_TRANSLATE_NOOP("tools",
                      "What becomes of what was selected before; the first button of the pen adds, "
                      "the second takes away."),
    QT_TRANSLATE_NOOP("tools", "What goes"),
    QT_TRANSLATE_NOOP(
        "tools",
        "What is covered, the part of a line up to its next crossings, or the whole line."),
    QT_TRANSLATE_NOOP("tools", "What the pen is made of: how it looks and how it slides."),
    QT_TRANSLATE_NOOP("tools", "What the sheet is made of: its hardness and its friction."),
    QT_TRANSLATE_NOOP(
        "tools", "Whether ends of lines attract the pen (force), connect to it (snap), or both."),
    QT_TRANSLATE_NOOP("tools",
                      "Whether ends of lines attract the pen (force), connect to the dragged end "
                      "(snap), or both."),
    QT_TRANSLATE_NOOP("tools", "Width"),
    QT_TRANSLATE_NOOP("tools",
                      "Width of a line at full pressure; at least that of the thinnest line."),
    QT_TRANSLATE_NOOP("tools", "Width of a line without pressure."),
    QT_TRANSLATE_NOOP("tools", "Width of a retraced line without pressure."),
    QT_TRANSLATE_NOOP(
        "tools", "With nothing selected, a touch takes the nearest line within this distance."),
    QT_TRANSLATE_NOOP("tools", "add"),
    QT_TRANSLATE_NOOP("tools", "auto"),
    QT_TRANSLATE_NOOP("tools", "blackboard"),
    QT_TRANSLATE_NOOP("tools", "both"),
    QT_TRANSLATE_NOOP("tools", "brush"),
    QT_TRANSLATE_NOOP("tools", "chalk"),
    QT_TRANSLATE_NOOP("tools", "crayon"),
    QT_TRANSLATE_NOOP("tools", "crossing"),
    QT_TRANSLATE_NOOP("tools", "felt"),
    QT_TRANSLATE_NOOP("tools", "felt-tip"),
    QT_TRANSLATE_NOOP("tools", "force"),
    QT_TRANSLATE_NOOP("tools", "free"),
    QT_TRANSLATE_NOOP("tools", "glass"),
    QT_TRANSLATE_NOOP("tools", "grab"),
    QT_TRANSLATE_NOOP("tools", "inertia"),
    QT_TRANSLATE_NOOP("tools", "move"),
    QT_TRANSLATE_NOOP("tools", "off"),
    QT_TRANSLATE_NOOP("tools", "on-curve"),
    QT_TRANSLATE_NOOP("tools", "paper"),
    QT_TRANSLATE_NOOP("tools", "pencil"),
    QT_TRANSLATE_NOOP("tools", "points"),
    QT_TRANSLATE_NOOP("tools", "pressure"),
    QT_TRANSLATE_NOOP("tools", "printed"),
    QT_TRANSLATE_NOOP("tools", "push"),
    QT_TRANSLATE_NOOP("tools", "rectangle"),
    QT_TRANSLATE_NOOP("tools", "replace"),
    QT_TRANSLATE_NOOP("tools", "retrace"),
    QT_TRANSLATE_NOOP("tools", "rotate"),
    QT_TRANSLATE_NOOP("tools", "scale"),
    QT_TRANSLATE_NOOP("tools", "snap"),
    QT_TRANSLATE_NOOP("tools", "soft"),
    QT_TRANSLATE_NOOP("tools", "stretch"),
    QT_TRANSLATE_NOOP("tools", "stroke"),
    QT_TRANSLATE_NOOP("tools", "strokes"),
    QT_TRANSLATE_NOOP("tools", "subtract"),
    QT_TRANSLATE_NOOP("tools", "sweep"),
    QT_TRANSLATE_NOOP("tools", "thicker"),
    QT_TRANSLATE_NOOP("tools", "thinner"),
    QT_TRANSLATE_NOOP("tools", "touched"),
    QT_TRANSLATE_NOOP("tools", "towed"),
};

constexpr const char* kEditTexts[] = {
    QT_TRANSLATE_NOOP("edits", "Add layer"),    QT_TRANSLATE_NOOP("edits", "Close"),
    QT_TRANSLATE_NOOP("edits", "Connect"),      QT_TRANSLATE_NOOP("edits", "Delete"),
    QT_TRANSLATE_NOOP("edits", "Draw"),         QT_TRANSLATE_NOOP("edits", "Duplicate"),
    QT_TRANSLATE_NOOP("edits", "Erase"),        QT_TRANSLATE_NOOP("edits", "Hide layer"),
    QT_TRANSLATE_NOOP("edits", "Import"),       QT_TRANSLATE_NOOP("edits", "Lock layer"),
    QT_TRANSLATE_NOOP("edits", "Lower layer"),  QT_TRANSLATE_NOOP("edits", "Move"),
    QT_TRANSLATE_NOOP("edits", "Move end"),     QT_TRANSLATE_NOOP("edits", "Move layer"),
    QT_TRANSLATE_NOOP("edits", "Pull"),         QT_TRANSLATE_NOOP("edits", "Push"),
    QT_TRANSLATE_NOOP("edits", "Raise layer"),  QT_TRANSLATE_NOOP("edits", "Redraw"),
    QT_TRANSLATE_NOOP("edits", "Remove layer"), QT_TRANSLATE_NOOP("edits", "Rename layer"),
    QT_TRANSLATE_NOOP("edits", "Rotate"),       QT_TRANSLATE_NOOP("edits", "Scale"),
    QT_TRANSLATE_NOOP("edits", "Show layer"),   QT_TRANSLATE_NOOP("edits", "Smooth"),
    QT_TRANSLATE_NOOP("edits", "Stretch"),      QT_TRANSLATE_NOOP("edits", "Unlock layer"),
    QT_TRANSLATE_NOOP("edits", "Width"),
};

}  // namespace

std::span<const char* const> tool_texts() {
  return kToolTexts;
}

std::span<const char* const> edit_texts() {
  return kEditTexts;
}

}  // namespace felt::desktop
