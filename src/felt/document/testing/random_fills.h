#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// Makes a valid fill: one to three loops of curves, with or without pieces.
inline Fill random_fill(RandomStroke& random) {
  Fill fill;
  const auto point = [&] { return Point{random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)}; };
  for (int k = random.pick(1, 3); k > 0; --k) {
    FillLoop loop;
    const int n = random.pick(1, 5);
    for (int i = 0; i < 3 * n; ++i) loop.points.push_back(point());
    loop.points.push_back(loop.points.front());
    for (int i = random.chance(0.5) ? random.pick(1, n) : 0; i > 0; --i) {
      FillPiece piece;
      if (random.chance(0.8)) {
        piece = {{static_cast<std::uint64_t>(random.pick(1, 99))},
                 random.uniform(0.0, 9.0),
                 random.uniform(0.0, 9.0)};
      }
      loop.pieces.push_back(piece);
    }
    fill.loops.push_back(std::move(loop));
  }
  const auto byte = [&] { return static_cast<std::uint8_t>(random.pick(0, 255)); };
  fill.color = {byte(), byte(), byte(), byte()};
  if (random.chance(0.5)) fill.max_gap_mm = random.uniform(0.0, 3.0);
  return fill;
}

/// Makes random changes of fills that fit a document and an edit of its layers, for property tests:
/// fills are added, removed, replaced and moved between layers.
class RandomFills {
 public:
  explicit RandomFills(std::uint64_t seed) : random_(seed) {}

  /// Appends the changes to the edit. `layers` are the layers after the edit. New fills get ids
  /// from `first_id` on.
  void add_changes(const Document& document, const std::vector<LayerId>& layers, FillId first_id,
                   Edit& edit) {
    const Places before = places_of(document);
    Lists lists;
    for (const LayerId id : layers) {
      const Layer* layer = document.layer(id);
      lists.push_back({id, layer ? layer->fills : std::vector<FillId>()});
    }
    std::vector<FillId> replaced;
    if (random_.chance(0.3)) remove(any(lists));
    if (random_.chance(0.3)) move(lists);
    for (int k = random_.pick(0, 2); k > 0; --k) {
      insert(any(lists), first_id);
      ++first_id.value;
    }
    if (const auto& list = any(lists); !list.empty() && random_.chance(0.5)) {
      replaced.push_back(list[index_in(list.size())]);
    }
    write(document, before, places_of(lists), replaced, edit);
  }

 private:
  using Lists = std::vector<std::pair<LayerId, std::vector<FillId>>>;
  using Places = std::vector<std::pair<FillId, StrokePlace>>;

  std::size_t index_in(std::size_t size) {
    return static_cast<std::size_t>(random_.pick(0, static_cast<int>(size) - 1));
  }
  std::vector<FillId>& any(Lists& lists) { return lists[index_in(lists.size())].second; }

  FillId remove(std::vector<FillId>& list) {
    if (list.empty()) return {};
    const std::size_t i = index_in(list.size());
    const FillId id = list[i];
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    return id;
  }
  void insert(std::vector<FillId>& list, FillId id) {
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(index_in(list.size() + 1)), id);
  }
  void move(Lists& lists) {
    if (const FillId id = remove(any(lists))) insert(any(lists), id);
  }

  static Places places_of(const Document& document) {
    Lists lists;
    for (const Layer& layer : document.layers()) lists.push_back({layer.id, layer.fills});
    return places_of(lists);
  }
  static Places places_of(const Lists& lists) {
    Places places;
    for (const auto& [layer, fills] : lists) {
      for (std::size_t i = 0; i < fills.size(); ++i) places.push_back({fills[i], {layer, i}});
    }
    return places;
  }

  void write(const Document& document, const Places& was, const Places& is,
             const std::vector<FillId>& replaced, Edit& edit) {
    const auto find = [](const Places& places, FillId id) {
      return std::find_if(places.begin(), places.end(),
                          [id](const auto& place) { return place.first == id; });
    };
    const auto fill = [this] { return std::make_shared<const Fill>(random_fill(random_)); };
    for (const auto& [id, place] : was) {
      FillChange c{id, document.find_fill(id), nullptr, place, {}};
      if (const auto now = find(is, id); now != is.end()) {
        const bool changes = std::find(replaced.begin(), replaced.end(), id) != replaced.end();
        if (now->second == place && !changes) continue;
        c.after = changes ? fill() : c.before;
        c.after_place = now->second;
      }
      edit.fills.push_back(c);
    }
    for (const auto& [id, place] : is) {
      if (find(was, id) == was.end()) edit.fills.push_back({id, nullptr, fill(), {}, place});
    }
  }

  RandomStroke random_;
};

}  // namespace felt::testing
