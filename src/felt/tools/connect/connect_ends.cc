#include "felt/tools/connect/connect_ends.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/stroke/edit/join.h"
#include "felt/tools/connect/tip_lead.h"
#include "felt/tools/connecting.h"

namespace felt {
namespace {

constexpr const char* kConnect = "Connect";
constexpr const char* kClose = "Close";

StrokePtr share(Stroke stroke) {
  return std::make_shared<const Stroke>(std::move(stroke));
}

/// Returns true if both ends can meet halfway by bending alone. A wider gap is bridged from one
/// end, and the other end stays.
bool is_small_gap(const Stroke& a, StrokeTip tip_a, const Stroke& b, StrokeTip tip_b) {
  const double gap = distance(tip_point(a, tip_a), tip_point(b, tip_b));
  return 0.5 * gap <= std::min(TipLead(a, tip_a).small_gap_mm(), TipLead(b, tip_b).small_gap_mm());
}

Edit close(const Document& document, TipId moved, const Stroke& stroke, Point meet) {
  const StrokeTip other = opposite(moved.tip);
  const auto half = TipLead(stroke, moved.tip).at(meet, -tip_direction(stroke, other));
  if (!half) return {};
  const auto both = TipLead(*half, other).at(meet);
  if (!both) return {};
  auto ring = closed(*both);
  if (!ring) return {};
  return StrokeReplacement(document, moved.stroke).with(share(*std::move(ring)), kClose);
}

/// Makes an edit after which two strokes share a point and keep their positions in the layers.
Edit share_point(const Document& document, TipId moved, const Stroke& a, TipId to,
                 const Stroke& b) {
  EditBuilder edit(document);
  if (a != *document.find(moved.stroke)) edit.replace(moved.stroke, share(a));
  if (b != *document.find(to.stroke)) edit.replace(to.stroke, share(b));
  return std::move(edit).build(kConnect);
}

/// Returns the stroke after an edit.
StrokePtr after(const Edit& edit, const Document& document, StrokeId id) {
  for (const StrokeChange& c : edit.changes) {
    if (c.id == id) return c.after;
  }
  return document.find(id);
}

/// Joins two strokes that share a point after an edit. Returns the same edit if that fails.
Edit with_joined(const Document& document, TipId moved, TipId to, Edit edit) {
  auto one = joined_at(*after(edit, document, to.stroke), to.tip,
                       *after(edit, document, moved.stroke), moved.tip);
  if (!one) return edit;
  EditBuilder joined(document);
  joined.replace(to.stroke, share(*std::move(one)));
  joined.remove(moved.stroke);
  for (const StrokeChange& c : edit.changes) {
    if (c.id != moved.stroke && c.id != to.stroke) joined.replace(c.id, c.after);
  }
  return std::move(joined).build(kConnect);
}

}  // namespace

Edit connect_ends(const Document& document, TipId moved, TipId to,
                  const ConnectEndsOptions& options) {
  const StrokePtr a = stroke_with_tip(document, moved), b = stroke_with_tip(document, to);
  if (!a || !b || moved == to) return {};
  const LayerId layer = document.layer_of(moved.stroke), other = document.layer_of(to.stroke);
  if (!is_editable(document, layer)) return {};
  const Point target = tip_point(*b, to.tip);
  const bool half = options.place == MeetingPlace::kHalfWay && is_editable(document, other) &&
                    is_small_gap(*a, moved.tip, *b, to.tip);
  const Point meet = half ? lerp(tip_point(*a, moved.tip), target, 0.5) : target;
  const auto complete = [&options](Edit edit) {
    if (options.complete && !edit.empty()) options.complete(edit);
    return edit;
  };
  if (moved.stroke == to.stroke) return complete(close(document, moved, *a, meet));

  const auto led = TipLead(*a, moved.tip).at(meet, -tip_direction(*b, to.tip));
  const auto met = half ? TipLead(*b, to.tip).at(meet) : Result<Stroke>(*b);
  if (!led || !met) return {};
  Edit edit = complete(share_point(document, moved, *led, to, *met));
  if (options.keep_separate || layer != other || !look_alike(*a, *b)) return edit;
  return with_joined(document, moved, to, std::move(edit));
}

}  // namespace felt
