#include "felt/document/edit_builder.h"

#include <algorithm>
#include <map>
#include <utility>

#include "felt/base/check.h"

namespace felt {

StrokeId EditBuilder::add(LayerId layer, StrokePtr stroke) {
  FELT_CHECK(stroke && document_.layer(layer));
  const StrokeId id = document_.new_id(made_++);
  changes_.push_back({id, nullptr, std::move(stroke), {}, {layer, 0}});
  return id;
}

void EditBuilder::replace(StrokeId id, StrokePtr stroke) {
  const LayerId layer = document_.layer_of(id);
  FELT_CHECK(stroke);
  changes_.push_back({id, document_.find(id), std::move(stroke), {layer, 0}, {layer, 0}});
}

void EditBuilder::remove(StrokeId id) {
  changes_.push_back({id, document_.find(id), nullptr, {document_.layer_of(id), 0}, {}});
}

Edit EditBuilder::build(std::string label) && {
  find_places();
  return {std::move(label), std::move(changes_)};
}

StrokeReplacement::StrokeReplacement(const Document& document, StrokeId id)
    : id_(id), before_(document.find(id)), place_(document.place(id)) {}

Edit StrokeReplacement::with(StrokePtr after, std::string label) const {
  const StrokePlace after_place = after ? place_ : StrokePlace{};
  return {std::move(label), {{id_, before_, std::move(after), place_, after_place}}};
}

void EditBuilder::find_places() {
  std::map<StrokeId, StrokeChange*> present;
  std::map<LayerId, std::vector<StrokeChange*>> made;
  std::map<LayerId, std::size_t> sizes;  // strokes in each changed layer after the edit
  for (StrokeChange& c : changes_) {
    if (c.before) {
      present[c.id] = &c;
      sizes[c.before_place.layer] = 0;
    } else {
      made[c.after_place.layer].push_back(&c);
      sizes[c.after_place.layer] = 0;
    }
  }
  for (auto& [layer, size] : sizes) {
    const auto& strokes = document_.layer(layer)->strokes;
    if (present.empty()) size = strokes.size();
    for (std::size_t i = 0; i < strokes.size() && !present.empty(); ++i) {
      const auto found = present.find(strokes[i]);
      if (found != present.end()) {
        found->second->before_place.index = i;
        found->second->after_place.index = size;
        if (!found->second->after) continue;
      }
      ++size;
    }
    for (StrokeChange* c : made[layer]) c->after_place.index = size++;
  }
  // Unused places get the same value, so that equal edits compare equal.
  for (StrokeChange& c : changes_) {
    if (!c.after) c.after_place = {};
  }
}

}  // namespace felt
