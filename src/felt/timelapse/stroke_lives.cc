#include "felt/timelapse/stroke_lives.h"

namespace felt {

/// Ends the time of the present shape if it changed or is gone, and begins that of the next one.
template <class Id, class Ptr>
void StrokeLives::see_shape(std::map<Id, std::size_t>& seen, Id id, const Ptr& shape,
                            const Layer* layer, std::int64_t now_ns, std::int64_t drawn_from_ns) {
  const bool is_seen = shape && layer != nullptr && layer->visible;
  if (const auto old = seen.find(id); old != seen.end()) {
    ShapeLife& life = lives_[old->second];
    if (is_seen && life.layer == layer->id && std::get<Ptr>(life.shape) == shape) return;
    life.times.back().to_ns = now_ns;
    seen.erase(old);
  }
  if (!is_seen) return;
  std::vector<std::size_t>& known = known_[{layer->id, shape.get()}];
  for (const std::size_t at : known) {
    if (lives_[at].id != id.value || !lives_[at].times.back().to_ns) continue;
    lives_[at].times.push_back({now_ns});
    seen.emplace(id, at);
    return;
  }
  known.push_back(lives_.size());
  seen.emplace(id, lives_.size());
  lives_.push_back({shape, id.value, layer->id, drawn_from_ns, {{now_ns}}});
}

void StrokeLives::see(const Edit& edit, const Document& document, std::int64_t now_ns,
                      std::optional<std::int64_t> drawn_from_ns) {
  for (const StrokeChange& c : edit.changes) {
    const std::int64_t from_ns = c.before ? now_ns : drawn_from_ns.value_or(now_ns);
    const Layer* layer = c.after ? document.layer(c.after_place.layer) : nullptr;
    see_shape(strokes_, c.id, c.after, layer, now_ns, from_ns);
  }
  for (const FillChange& c : edit.fills) {
    const Layer* layer = c.after ? document.layer(c.after_place.layer) : nullptr;
    see_shape(fills_, c.id, c.after, layer, now_ns, now_ns);
  }
  see_layers(edit, document, now_ns);
}

void StrokeLives::see_start(const Document& document) {
  see_view(document, 0);
}

void StrokeLives::see_view(const Document& seen, std::int64_t now_ns) {
  for (const Layer& layer : seen.layers()) see_layer(layer, seen, now_ns);
}

void StrokeLives::see_layer(const Layer& layer, const Document& document, std::int64_t now_ns) {
  for (const StrokeId id : layer.strokes) {
    see_shape(strokes_, id, document.find(id), &layer, now_ns, now_ns);
  }
  for (const FillId id : layer.fills) {
    see_shape(fills_, id, document.find_fill(id), &layer, now_ns, now_ns);
  }
}

/// Shows and hides what is in layers that the edit changes.
void StrokeLives::see_layers(const Edit& edit, const Document& document, std::int64_t now_ns) {
  for (const LayerChange& c : edit.layers) {
    if (const Layer* layer = document.layer(c.id)) see_layer(*layer, document, now_ns);
  }
}

}  // namespace felt
