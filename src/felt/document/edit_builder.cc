#include "felt/document/edit_builder.h"

#include <algorithm>
#include <map>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

const std::vector<StrokeId>& objects_in(const Layer& layer, StrokeId) {
  return layer.strokes;
}
const std::vector<FillId>& objects_in(const Layer& layer, FillId) {
  return layer.fills;
}

/// Fills in the positions of the changes of strokes or of fills.
template <class Change>
void find_places(const Document& document, std::vector<Change>& changes) {
  using Id = decltype(Change::id);
  std::map<Id, Change*> present;
  std::map<LayerId, std::vector<Change*>> made;
  std::map<LayerId, std::size_t> sizes;  // objects in each changed layer after the edit
  for (Change& c : changes) {
    if (c.before) {
      present[c.id] = &c;
      sizes[c.before_place.layer] = 0;
    } else {
      made[c.after_place.layer].push_back(&c);
      sizes[c.after_place.layer] = 0;
    }
  }
  for (auto& [layer, size] : sizes) {
    const std::vector<Id>& objects = objects_in(*document.layer(layer), Id{});
    if (present.empty()) size = objects.size();
    for (std::size_t i = 0; i < objects.size() && !present.empty(); ++i) {
      const auto found = present.find(objects[i]);
      if (found != present.end()) {
        found->second->before_place.index = i;
        found->second->after_place.index = size;
        if (!found->second->after) continue;
      }
      ++size;
    }
    for (Change* c : made[layer]) c->after_place.index = size++;
  }
  // Unused places get the same value, so that equal edits compare equal.
  for (Change& c : changes) {
    if (!c.after) c.after_place = {};
  }
}

}  // namespace

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

FillId EditBuilder::add_fill(LayerId layer, FillPtr fill) {
  FELT_CHECK(fill && document_.layer(layer));
  const FillId id = document_.new_fill_id(made_++);
  fills_.push_back({id, nullptr, std::move(fill), {}, {layer, 0}});
  return id;
}

void EditBuilder::replace_fill(FillId id, FillPtr fill) {
  const LayerId layer = document_.layer_of_fill(id);
  FELT_CHECK(fill);
  fills_.push_back({id, document_.find_fill(id), std::move(fill), {layer, 0}, {layer, 0}});
}

void EditBuilder::remove_fill(FillId id) {
  fills_.push_back({id, document_.find_fill(id), nullptr, {document_.layer_of_fill(id), 0}, {}});
}

Edit EditBuilder::build(std::string label) && {
  find_places(document_, changes_);
  find_places(document_, fills_);
  return {std::move(label), std::move(changes_), {}, std::move(fills_)};
}

StrokeReplacement::StrokeReplacement(const Document& document, StrokeId id)
    : id_(id), before_(document.find(id)), place_(document.place(id)) {}

Edit StrokeReplacement::with(StrokePtr after, std::string label) const {
  const StrokePlace after_place = after ? place_ : StrokePlace{};
  return {std::move(label), {{id_, before_, std::move(after), place_, after_place}}};
}

}  // namespace felt
