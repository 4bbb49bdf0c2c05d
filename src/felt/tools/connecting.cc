#include "felt/tools/connecting.h"

#include "felt/stroke/edit/join.h"
#include "felt/stroke/edit/split.h"

namespace felt {

StrokePtr stroke_with_tip(const Document& document, const std::optional<TipId>& tip) {
  if (!tip) return nullptr;
  StrokePtr stroke = document.find(tip->stroke);
  return stroke && !stroke->closed() ? stroke : nullptr;
}

bool look_alike(const Stroke& a, const Stroke& b) noexcept {
  return a.medium() == b.medium() && a.color() == b.color();
}

bool is_editable(const Document& document, LayerId layer) noexcept {
  const Layer* found = document.layer(layer);
  return found && found->visible && !found->locked;
}

Result<Stroke> joined_at(const Stroke& base, StrokeTip tip, const Stroke& more, StrokeTip at) {
  const Stroke turned = tip == at ? reversed(more) : more;
  return tip == StrokeTip::kEnd ? joined(base, turned) : joined(turned, base);
}

}  // namespace felt
