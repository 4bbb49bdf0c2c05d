#include "felt/document/stroke_divisions.h"

#include <algorithm>
#include <cstdint>

#include "felt/base/check.h"

namespace felt {
namespace {

/// Returns the place of a stroke. Layers are filled from the bottom up, so the ids in a layer
/// mostly ascend, and a binary search usually finds the stroke.
StrokePlace place_of(const Document& document, StrokeId id) {
  const LayerId in = document.layer_of(id);
  const auto& strokes = document.layer(in)->strokes;
  const auto guess = std::lower_bound(strokes.begin(), strokes.end(), id);
  if (guess != strokes.end() && *guess == id) {
    return {in, static_cast<std::size_t>(guess - strokes.begin())};
  }
  return document.place(id);
}

}  // namespace

void StrokeDivisions::set(const Document& document, StrokeId id, std::vector<StrokePtr> parts) {
  const auto known = places_.find(id);
  if (known != places_.end()) {
    Division& division = divided_.at(known->second);
    parts_ += parts.size();
    parts_ -= division.parts.size();
    division.parts = std::move(parts);
    return;
  }
  StrokePtr before = document.find(id);
  FELT_CHECK(before != nullptr);
  const StrokePlace at = place_of(document, id);
  const Place place{at.layer, at.index};
  parts_ += parts.size();
  places_.emplace(id, place);
  divided_.emplace(place, Division{id, std::move(before), std::move(parts)});
}

void StrokeDivisions::unset(StrokeId id) {
  const auto known = places_.find(id);
  if (known == places_.end()) return;
  const auto division = divided_.find(known->second);
  parts_ -= division->second.parts.size();
  divided_.erase(division);
  places_.erase(known);
}

void StrokeDivisions::clear() noexcept {
  places_.clear();
  divided_.clear();
  parts_ = 0;
}

Edit StrokeDivisions::build(const Document& document, std::string label) const {
  Edit edit{std::move(label), {}};
  edit.changes.reserve(divided_.size() + parts_);
  std::uint64_t made = 0;
  LayerId layer;
  std::size_t added = 0, removed = 0;  // parts and divided strokes below in the layer
  for (const auto& [place, division] : divided_) {
    if (place.first != layer) {
      layer = place.first;
      added = removed = 0;
    }
    edit.changes.push_back(
        {division.id, division.before, nullptr, {place.first, place.second}, {}});
    std::size_t at = place.second + added - removed;
    for (const StrokePtr& part : division.parts) {
      edit.changes.push_back({document.new_id(made++), nullptr, part, {}, {layer, at++}});
    }
    added += division.parts.size();
    ++removed;
  }
  return edit;
}

}  // namespace felt
