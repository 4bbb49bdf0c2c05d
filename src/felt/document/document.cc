#include "felt/document/document.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "felt/base/check.h"
#include "felt/document/layer_plan.h"
#include "felt/document/reorder.h"

namespace felt {
namespace {

std::string name_of(StrokeId id) {
  return "stroke " + std::to_string(id.value);
}
std::string name_of(FillId id) {
  return "fill " + std::to_string(id.value);
}
std::string name_of(GuideId id) {
  return "guide " + std::to_string(id.value);
}
std::string name_of(SymmetryId id) {
  return "symmetry " + std::to_string(id.value);
}
std::string name_of(BodyEditId id) {
  return "body edit " + std::to_string(id.value);
}
std::string name_of(LayerId id) {
  return "layer " + std::to_string(id.value);
}

tl::unexpected<Error> misfit(std::string what) {
  return fail(ErrorCode::kInvalidArgument, std::move(what));
}

const std::vector<StrokeId>& list_of(const Layer& layer, StrokeId) {
  return layer.strokes;
}
const std::vector<FillId>& list_of(const Layer& layer, FillId) {
  return layer.fills;
}

/// The new orders of one kind of object, by layer.
template <class Id>
using Orders = std::map<LayerId, Reordered<Id>>;

/// Fails if an id is zero, or if the same id changes twice, because it would be undefined which
/// change is the final one.
template <class Change>
Result<void> check_ids(const std::vector<Change>& changes) {
  std::vector<decltype(Change::id)> ids;
  ids.reserve(changes.size());
  for (const Change& c : changes) {
    if (!c.id) return misfit("a change without an id");
    if (!c.before && !c.after) return misfit(name_of(c.id) + " has neither an old nor a new state");
    ids.push_back(c.id);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) return misfit(name_of(*twice) + " is changed twice");
  return {};
}

}  // namespace

/// The result of an edit. prepare() computes it and finds every error before anything changes, so
/// carry_out() cannot fail.
class Document::Plan {
 public:
  Plan(Document& document, const Edit& edit)
      : document_(document), edit_(edit), layers_(document.layers_, edit.layers) {}

  /// Checks everything that can be wrong with the edit.
  Result<void> prepare() {
    return check_ids(edit_.changes)
        .and_then([&] { return check_ids(edit_.layers); })
        .and_then([&] { return check_ids(edit_.fills); })
        .and_then([&] { return check_ids(edit_.guides); })
        .and_then([&] { return check_ids(edit_.symmetries); })
        .and_then([&] { return check_ids(edit_.body_edits); })
        .and_then([&] { return check_unplaced(edit_.guides, document_.guides_); })
        .and_then([&] {
          return check_count(edit_.guides, document_.guides_, kMaxDrawingGuides, "guides");
        })
        .and_then([&] { return check_unplaced(edit_.body_edits, document_.body_edits_); })
        .and_then([&] {
          return check_count(edit_.body_edits, document_.body_edits_, kMaxBodyEdits, "body edits");
        })
        .and_then([&] { return check_unplaced(edit_.symmetries, document_.symmetries_); })
        .and_then([&] { return layers_.prepare(); })
        .and_then([&] { return prepare_objects(edit_.changes, document_.strokes_, orders_); })
        .and_then([&] { return prepare_objects(edit_.fills, document_.fills_, fill_orders_); })
        .and_then([&] { return check_removed_layers(orders_, "strokes"); })
        .and_then([&] { return check_removed_layers(fill_orders_, "fills"); });
  }

  /// Changes the document. Requires that prepare() succeeded.
  void carry_out() {
    layers_.carry_out(document_.layers_);
    for (const LayerChange& c : edit_.layers) {
      document_.last_layer_id_ = std::max(document_.last_layer_id_, c.id.value);
    }
    reorder_objects(orders_, &Layer::strokes);
    reorder_objects(fill_orders_, &Layer::fills);
    for (const StrokeChange& c : edit_.changes) change_object(c, document_.strokes_);
    for (const FillChange& c : edit_.fills) change_object(c, document_.fills_);
    for (const GuideChange& c : edit_.guides) change_unplaced(c, document_.guides_);
    for (const BodyEditChange& c : edit_.body_edits) change_unplaced(c, document_.body_edits_);
    change_symmetries();
    document_.shows_guides_ = document_.shows_guides_ != edit_.toggles_guides;
  }

 private:
  template <class Id>
  void reorder_objects(const Orders<Id>& orders, std::vector<Id> Layer::*list) {
    for (const auto& [id, order] : orders) {
      if (Layer* layer = document_.layers_.find(id)) order.apply_to(layer->*list);
    }
  }

  /// Checks the changes of objects that are in no layer.
  template <class Change, class Table>
  static Result<void> check_unplaced(const std::vector<Change>& changes, const Table& table) {
    for (const Change& c : changes) {
      const auto found = table.find(c.id);
      if (c.before && found == table.end()) return misfit(name_of(c.id) + " does not exist");
      if (!c.before && found != table.end()) return misfit(name_of(c.id) + " already exists");
      if (c.before && found->second != c.before && *found->second != *c.before) {
        return misfit(name_of(c.id) + " has changed in the meantime");
      }
    }
    return {};
  }

  template <class Change, class Table>
  static Result<void> check_count(const std::vector<Change>& changes, const Table& table,
                                  std::size_t limit, const char* objects) {
    std::size_t count = table.size();
    for (const Change& c : changes) {
      count += c.after ? 1 : 0;
      count -= c.before ? 1 : 0;
    }
    if (count <= limit) return {};
    return misfit("a drawing has at most " + std::to_string(limit) + " " + objects);
  }

  template <class Change, class Id>
  static void note_moves(const Change& c, std::map<LayerId, Moves<Id>>& moves) {
    if (c.before && c.after && c.before_place == c.after_place) {
      moves[c.before_place.layer].keep(c.before_place.index, c.id);
      return;
    }
    if (c.before) moves[c.before_place.layer].remove(c.before_place.index);
    if (c.after) moves[c.after_place.layer].add(c.after_place.index, c.id);
  }

  /// Checks the changes of strokes or of fills, and computes the new orders in their layers.
  template <class Change, class Table, class Id>
  Result<void> prepare_objects(const std::vector<Change>& changes, const Table& table,
                               Orders<Id>& orders) {
    std::map<LayerId, Moves<Id>> moves;
    for (const Change& c : changes) {
      if (auto ok = check_before(c, table); !ok) return ok;
      if (c.after && !layers_.is_kept(c.after_place.layer)) {
        return misfit(name_of(c.id) + ": " + name_of(c.after_place.layer) + " does not exist");
      }
      note_moves(c, moves);
    }
    for (auto& [id, m] : moves) {
      const Layer* present = document_.layer(id);
      const std::span<const Id> old =
          present ? std::span<const Id>(list_of(*present, Id{})) : std::span<const Id>();
      auto order = m.template reorder<Id>(old);
      if (!order) return tl::unexpected(with_context(order.error(), name_of(id)));
      orders.emplace(id, *std::move(order));
    }
    return {};
  }

  template <class Change, class Table>
  [[nodiscard]] Result<void> check_before(const Change& c, const Table& table) const {
    const auto found = table.find(c.id);
    const bool present = found != table.end();
    if (!c.before) {
      return present ? Result<void>(misfit(name_of(c.id) + " already exists")) : Result<void>();
    }
    if (!present) return misfit(name_of(c.id) + " does not exist");
    const auto& object = found->second.object;
    if (object != c.before && *object != *c.before) {
      return misfit(name_of(c.id) + " has changed in the meantime");
    }
    const Layer* l = document_.layer(c.before_place.layer);
    const std::size_t index = c.before_place.index;
    if (!l || index >= list_of(*l, c.id).size() || list_of(*l, c.id)[index] != c.id) {
      return misfit(name_of(c.id) + " is not at index " + std::to_string(index) + " of " +
                    name_of(c.before_place.layer));
    }
    return {};
  }

  template <class Id>
  [[nodiscard]] Result<void> check_removed_layers(const Orders<Id>& orders,
                                                  const char* objects) const {
    for (const LayerChange& c : edit_.layers) {
      if (c.after) continue;
      const auto order = orders.find(c.id);
      const std::size_t left =
          order != orders.end() ? order->second.size : list_of(*document_.layer(c.id), Id{}).size();
      if (left > 0) {
        return misfit(name_of(c.id) + " cannot be removed: " + std::to_string(left) + " " +
                      objects + " are on it");
      }
    }
    return {};
  }

  template <class Change, class Table>
  void change_object(const Change& c, Table& table) {
    if (c.after) {
      // Inserts at the end, because strokes of a file come in the order of their ids.
      table.insert_or_assign(table.end(), c.id,
                             typename Table::mapped_type{c.after, c.after_place.layer});
    } else {
      table.erase(c.id);
    }
    document_.last_id_ = std::max(document_.last_id_, c.id.value);
  }

  template <class Change, class Table>
  void change_unplaced(const Change& c, Table& table) {
    if (c.after) {
      table.insert_or_assign(c.id, c.after);
    } else {
      table.erase(c.id);
    }
    document_.last_id_ = std::max(document_.last_id_, c.id.value);
  }

  void change_symmetries() {
    std::map<StrokeId, SymmetryId>& of = document_.symmetry_of_;
    for (const SymmetryChange& c : edit_.symmetries) {
      change_unplaced(c, document_.symmetries_);
      if (!c.before) continue;
      for (const SymmetryImage& image : c.before->images) {
        const auto found = of.find(image.stroke);
        if (found != of.end() && found->second == c.id) of.erase(found);
      }
    }
    for (const SymmetryChange& c : edit_.symmetries) {
      if (!c.after) continue;
      for (const SymmetryImage& image : c.after->images) of.try_emplace(image.stroke, c.id);
    }
  }

  Document& document_;
  const Edit& edit_;
  LayerPlan layers_;
  Orders<StrokeId> orders_;
  Orders<FillId> fill_orders_;
};

Document::Document() : layers_(Layer{.id = {1}, .name = "Ink", .strokes = {}}) {}

Result<void> Document::apply(const Edit& edit) {
  Plan plan(*this, edit);
  if (auto ok = plan.prepare(); !ok) {
    if (edit.label.empty()) return ok;
    return tl::unexpected(
        with_context(ok.error(), "the edit '" + edit.label + "' does not match the document"));
  }
  plan.carry_out();
  return {};
}

namespace {

template <class Table, class Id>
auto find_object(const Table& table, Id id) {
  const auto found = table.find(id);
  return found == table.end() ? nullptr : found->second.object;
}

template <class Table, class Id>
LayerId layer_of_object(const Table& table, Id id) {
  const auto found = table.find(id);
  FELT_CHECK(found != table.end());
  return found->second.layer;
}

template <class Id>
std::size_t index_in(const std::vector<Id>& list, Id id) {
  // Searches from the top, because users mostly change what they drew last.
  const auto found = std::find(list.rbegin(), list.rend(), id);
  FELT_CHECK(found != list.rend());
  return static_cast<std::size_t>(std::distance(found, list.rend())) - 1;
}

/// Returns true if two tables have equal objects in the same layers.
template <class Table>
bool equal_tables(const Table& a, const Table& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && x.second.layer == y.second.layer &&
           (x.second.object == y.second.object || *x.second.object == *y.second.object);
  });
}

}  // namespace

StrokePtr Document::find(StrokeId id) const {
  return find_object(strokes_, id);
}
FillPtr Document::find_fill(FillId id) const {
  return find_object(fills_, id);
}

LayerId Document::layer_of(StrokeId id) const {
  return layer_of_object(strokes_, id);
}
LayerId Document::layer_of_fill(FillId id) const {
  return layer_of_object(fills_, id);
}

StrokePlace Document::place(StrokeId id) const {
  const LayerId in = layer_of(id);
  return {in, index_in(layer(in)->strokes, id)};
}
StrokePlace Document::fill_place(FillId id) const {
  const LayerId in = layer_of_fill(id);
  return {in, index_in(layer(in)->fills, id)};
}

GroupId Document::new_group_id() const {
  constexpr std::uint64_t kLargest = std::uint64_t{1} << 53;  // that files may have
  std::uint64_t largest = 0;
  for (const Layer& l : layers()) {
    if (l.group) largest = std::max(largest, l.group->id.value);
  }
  if (largest < kLargest) return {largest + 1};
  std::set<GroupId> taken;
  for (const Layer& l : layers()) {
    if (l.group) taken.insert(l.group->id);
  }
  GroupId id{1};
  while (taken.contains(id)) ++id.value;
  return id;
}

LayerGroupPtr Document::group(GroupId id) const noexcept {
  const auto found = std::find_if(layers().begin(), layers().end(),
                                  [id](const Layer& l) { return l.group && l.group->id == id; });
  return found == layers().end() ? nullptr : found->group;
}

void Document::reserve_ids(StrokeId stroke, LayerId layer) noexcept {
  last_id_ = std::max(last_id_, stroke.value);
  last_layer_id_ = std::max(last_layer_id_, layer.value);
}

bool operator==(const Document& a, const Document& b) {
  const auto equal = [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || *x.second == *y.second);
  };
  return std::equal(a.layers().begin(), a.layers().end(), b.layers().begin(), b.layers().end()) &&
         equal_tables(a.strokes_, b.strokes_) && equal_tables(a.fills_, b.fills_) &&
         (a.shows_guides_ == b.shows_guides_ || a.guides_.empty()) &&
         std::equal(a.guides_.begin(), a.guides_.end(), b.guides_.begin(), b.guides_.end(),
                    equal) &&
         std::equal(a.body_edits_.begin(), a.body_edits_.end(), b.body_edits_.begin(),
                    b.body_edits_.end(), equal) &&
         std::equal(a.symmetries_.begin(), a.symmetries_.end(), b.symmetries_.begin(),
                    b.symmetries_.end(), equal);
}

}  // namespace felt
