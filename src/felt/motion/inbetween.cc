#include "felt/motion/inbetween.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "felt/base/check.h"
#include "felt/document/fill.h"
#include "felt/document/visible_strokes.h"
#include "felt/motion/end_links.h"
#include "felt/motion/lone_stroke.h"
#include "felt/motion/oriented_pair.h"
#include "felt/motion/stroke_blend.h"
#include "felt/motion/stroke_shape.h"

namespace felt {
namespace {

/// Lone strokes follow the strokes within about this distance.
constexpr double kNearMm = 5.0;

/// Where a stroke between is in the drawing.
struct BetweenPlace {
  std::size_t layer = 0;
  double a_rank = 0.0, b_rank = 0.0;  ///< in drawing order, 0..1
};

double key_rank(std::size_t i, std::size_t count) noexcept {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(std::max<std::size_t>(count, 1));
}

/// Returns for each layer of `to` the index of the layer of `from` that takes its lone strokes.
std::vector<std::size_t> layer_map(const Document& from, const Document& to) {
  std::size_t highest = 0;
  for (std::size_t i = 0; i < from.layers().size(); ++i) {
    if (from.layers()[i].visible) highest = i;
  }
  std::vector<std::size_t> map;
  for (const Layer& layer : to.layers()) {
    std::size_t found = highest;
    for (std::size_t i = 0; i < from.layers().size(); ++i) {
      const Layer& other = from.layers()[i];
      if (other.visible && other.name == layer.name) found = i;
    }
    map.push_back(found);
  }
  return map;
}

/// Returns the name of a stroke that it can have under another id, or "".
std::string own_name(const Drawing& drawing, StrokeId id) {
  std::string name = name_in_file(drawing, id);
  return stroke_id_of_name(name).value == 0 ? name : std::string();
}

FillPtr faded(const Fill& fill, const Similarity& motion, double t, bool appears) {
  Fill result{{}, fill.color, 0.0};
  for (const FillLoop& loop : fill.loops) {
    FillLoop there{loop.points, {}};
    for (Point& p : there.points) {
      p = moved(motion, appears ? moved_back(motion, p) : p, t);
    }
    there.points.back() = there.points.front();
    result.loops.push_back(std::move(there));
  }
  result.color.a = static_cast<std::uint8_t>(std::lround((appears ? t : 1.0 - t) * fill.color.a));
  return result.color.a > 0 ? std::make_shared<const Fill>(std::move(result)) : nullptr;
}

}  // namespace

KeyStrokes key_strokes(const Document& document) {
  KeyStrokes key;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    const Layer& layer = document.layers()[i];
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      key.strokes.push_back(document.find(id));
      key.ids.push_back(id);
      key.layers.push_back(i);
    }
  }
  return key;
}

/// All that does not depend on t.
struct Inbetween::Plan {
  /// A stroke between: a blend, or a lone stroke.
  struct Item {
    bool is_lone = false;
    std::size_t index = 0;  // in blends or lone
    BetweenPlace place;
    std::string name{};  // own_name()
  };
  struct MovingFill {
    FillPtr fill;
    bool appears = false;
    std::size_t layer = 0;
  };
  /// A stroke at t.
  struct Made {
    double rank = 0.0;
    std::size_t layer = 0;
    StrokePtr stroke;
    std::string name{};
  };

  Drawing from, to;
  LoneStroke how = LoneStroke::kFade;
  Correspondence correspondence;
  std::vector<LinkedBlend> blends;
  std::vector<LoneMotion> lone;
  EndLinks links;
  std::vector<Item> items;
  std::vector<MovingFill> fills;

  void add_matches(const KeyStrokes& a, const KeyStrokes& b);
  void add_lone(const KeyStrokes& a, const KeyStrokes& b, const StrokeMatch& match);
  void add_fills();
  [[nodiscard]] std::vector<Made> made_at(double t) const;
  /// Sets the document and the names of strokes of a drawing to those at t.
  void set_strokes(double t, Drawing& drawing) const;
};

void Inbetween::Plan::add_lone(const KeyStrokes& a, const KeyStrokes& b, const StrokeMatch& match) {
  const bool appears = !match.from;
  const KeyStrokes& key = appears ? b : a;
  const std::size_t i = appears ? *match.to : *match.from;
  const double rank = key_rank(i, key.strokes.size());
  const std::size_t layer =
      appears ? layer_map(from.document, to.document)[key.layers[i]] : key.layers[i];
  items.push_back(
      {true, lone.size(), {layer, rank, rank}, own_name(appears ? to : from, key.ids[i])});
  lone.push_back({key.strokes[i], appears, {}});
}

void Inbetween::Plan::add_matches(const KeyStrokes& a, const KeyStrokes& b) {
  const Similarity& motion = correspondence.motion;
  std::vector<LocalMotion> local;
  for (const StrokeMatch& match : correspondence.matches) {
    std::optional<OrientedPair> pair;
    if (match.from && match.to) {
      pair = oriented_pair(*a.strokes[*match.from], *b.strokes[*match.to], match, motion);
    }
    if (!pair) {
      StrokeMatch first = match, second = match;
      first.to.reset();
      second.from.reset();
      if (first.from) add_lone(a, b, first);
      if (second.to) add_lone(a, b, second);
      continue;
    }
    const BetweenPlace place{a.layers[*match.from], key_rank(*match.from, a.strokes.size()),
                             key_rank(*match.to, b.strokes.size())};
    items.push_back({false, blends.size(), place, own_name(from, a.ids[*match.from])});
    const Point there = moved(motion, shape_of(pair->a).centre);
    local.push_back({there, shape_of(pair->b).centre - there});
    StrokeBlend blend(pair->a, pair->b, motion);
    blends.push_back({*std::move(pair), std::move(blend)});
  }
  for (LoneMotion& l : lone) {
    const Point centre = shape_of(*l.stroke).centre;
    l.shift = shift_near(local, l.appears ? centre : moved(motion, centre), kNearMm);
  }
  links = find_end_links(blends);
}

void Inbetween::Plan::add_fills() {
  const std::vector<std::size_t> map = layer_map(from.document, to.document);
  for (const bool appears : {false, true}) {
    const Document& document = appears ? to.document : from.document;
    for (std::size_t i = 0; i < document.layers().size(); ++i) {
      const Layer& layer = document.layers()[i];
      if (!layer.visible) continue;
      for (const FillId id : layer.fills) {
        fills.push_back({document.find_fill(id), appears, appears ? map[i] : i});
      }
    }
  }
}

std::vector<Inbetween::Plan::Made> Inbetween::Plan::made_at(double t) const {
  std::vector<BlendPose> poses(blends.size());
  for (std::size_t i = 0; i < blends.size(); ++i) blends[i].blend.pose(t, poses[i]);
  hold_ends(blends, links, t, poses);
  std::vector<Made> made;
  made.reserve(items.size());
  for (const Item& item : items) {
    const double rank = (1.0 - t) * item.place.a_rank + t * item.place.b_rank;
    if (item.is_lone) {
      auto stroke = lone_stroke_at(lone[item.index], correspondence.motion, t, how);
      if (!stroke) continue;
      made.push_back(
          {rank, item.place.layer, std::make_shared<const Stroke>(*std::move(stroke)), item.name});
      continue;
    }
    Result<Stroke> stroke = blends[item.index].blend.stroke(t, poses[item.index]);
    if (!stroke) continue;  // beyond the range of coordinates
    made.push_back(
        {rank, item.place.layer, std::make_shared<const Stroke>(*std::move(stroke)), item.name});
  }
  std::stable_sort(made.begin(), made.end(), [](const Made& x, const Made& y) {
    return x.layer != y.layer ? x.layer < y.layer : x.rank < y.rank;
  });
  return made;
}

void Inbetween::Plan::set_strokes(double t, Drawing& drawing) const {
  Edit edit{"In-between", {}};
  const Document empty;
  const Layer& first = empty.layers().front();
  std::vector<LayerId> ids;
  for (std::size_t i = 0; i < from.document.layers().size(); ++i) {
    LayerChange change;
    change.id = i == 0 ? first.id : empty.new_layer_id(i - 1);
    if (i == 0) change.before = first.state();
    change.after = from.document.layers()[i].state();
    change.after->timing = nullptr;
    change.after_index = i;
    ids.push_back(change.id);
    edit.layers.push_back(std::move(change));
  }
  std::vector<std::size_t> counts(ids.size(), 0), fill_counts(ids.size(), 0);
  std::uint64_t number = 0;
  auto names = std::make_shared<StrokeNames>();
  std::set<std::string> used;  // two parts of a stroke have its name, and only one can keep it
  for (Made& m : made_at(t)) {
    const StrokePlace place{ids[m.layer], counts[m.layer]++};
    const StrokeId id = empty.new_id(number++);
    edit.changes.push_back({id, nullptr, std::move(m.stroke), {}, place});
    if (!m.name.empty() && used.insert(m.name).second) names->emplace(id, std::move(m.name));
  }
  for (const MovingFill& moving : fills) {
    const FillPtr fill = faded(*moving.fill, correspondence.motion, t, moving.appears);
    if (!fill) continue;
    const StrokePlace place{ids[moving.layer], fill_counts[moving.layer]++};
    edit.fills.push_back({empty.new_fill_id(number++), nullptr, fill, {}, place});
  }
  for (const auto& [id, guide] : from.document.guides()) {
    edit.guides.push_back({empty.new_guide_id(number++), nullptr, guide});
  }
  edit.toggles_guides = from.document.shows_guides() != empty.shows_guides();
  drawing.document = {};
  FELT_CHECK(drawing.document.apply(edit).has_value());
  drawing.names = names->empty() ? nullptr : std::move(names);
}

Inbetween::Inbetween(std::unique_ptr<const Plan> plan) noexcept : plan_(std::move(plan)) {}
Inbetween::Inbetween(Inbetween&&) noexcept = default;
Inbetween& Inbetween::operator=(Inbetween&&) noexcept = default;
Inbetween::~Inbetween() = default;

Result<Inbetween> Inbetween::create(const Drawing& from, const Drawing& to,
                                    const InbetweenOptions& options) {
  const KeyStrokes a = key_strokes(from.document), b = key_strokes(to.document);
  Result<Correspondence> matched = match_strokes(a.strokes, b.strokes, options.pairs);
  if (!matched) return tl::unexpected(matched.error());
  auto plan = std::make_unique<Plan>();
  plan->from = from;
  plan->to = to;
  plan->how = options.lone;
  plan->correspondence = *std::move(matched);
  plan->add_matches(a, b);
  plan->add_fills();
  return Inbetween(std::move(plan));
}

Drawing Inbetween::at(double t) const {
  if (!(t > 0.0)) return plan_->from;
  if (t >= 1.0) return plan_->to;
  Drawing drawing = plan_->from;
  plan_->set_strokes(t, drawing);
  drawing.layer = {};
  drawing.extras = nullptr;
  return drawing;
}

std::vector<StrokePtr> Inbetween::strokes_at(double t) const {
  std::vector<StrokePtr> strokes;
  for (auto& made : plan_->made_at(t)) strokes.push_back(std::move(made.stroke));
  return strokes;
}

const Correspondence& Inbetween::correspondence() const noexcept {
  return plan_->correspondence;
}

}  // namespace felt
