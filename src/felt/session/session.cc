#include "felt/session/session.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "felt/base/check.h"
#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/fill/document_map.h"
#include "felt/geometry/tilt.h"
#include "felt/material/material_file.h"
#include "felt/session/layer_edit.h"
#include "felt/session/old_defaults.h"
#include "felt/session/selection_edit.h"
#include "felt/session/session_medium.h"
#include "felt/session/session_parts.h"
#include "felt/stroke/color_text.h"
#include "felt/tools/choice_ring.h"
#include "felt/tools/edge_ridges.h"
#include "felt/tools/exact_ink.h"
#include "felt/tools/guide_picture.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/stroke_guide.h"

namespace felt {
namespace {

std::optional<double> clean_pressure(std::optional<double> pressure) {
  if (!pressure || std::isnan(*pressure)) return {};
  return std::clamp(*pressure, 0.0, 1.0);
}

constexpr std::string_view kSurface = "surface", kInkColor = "ink.color";

/// Returns the colour of an option's value. Fails if the value is not the text of a colour.
Result<Rgba> color_of(const OptionValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  const std::optional<Rgba> color = text ? color_from_text(*text) : std::nullopt;
  if (color) return *color;
  return fail(ErrorCode::kInvalidArgument,
              "color: " + (text ? "\"" + *text + "\"" : "a number or switch") +
                  " is not #rrggbb or #rrggbbaa");
}

/// Splits an id at the dot: "pencil.snap" -> {"pencil", "snap"}. If the id has no dot, the second
/// part is empty.
std::pair<std::string_view, std::string_view> split_id(std::string_view id) {
  const std::size_t dot = id.find('.');
  if (dot == std::string_view::npos) return {id, {}};
  return {id.substr(0, dot), id.substr(dot + 1)};
}

/// A guide of a study has priority over those of the drawing, these over a line that is drawn over,
/// and this over a contour of a picture.
ActiveGuide active_guide(const GuideTrack* study, const StrokeGuide& drawing,
                         const Retrace& retrace, const Retrace& contours) noexcept {
  if (study) return {&study->guide(), study->number()};
  if (drawing.force()) return {drawing.force(), drawing.number(), drawing.is_near()};
  if (retrace.force()) return {retrace.force(), retrace.number(), true};
  if (contours.force()) return {contours.force(), contours.number(), true};
  return {};
}

Edit import_edit(const Document& document, LayerId layer, std::span<const StrokePtr> strokes,
                 std::span<const FillPtr> fills = {}) {
  EditBuilder builder(document);
  std::map<StrokeId, StrokeId> ids;
  for (const StrokePtr& stroke : strokes) {
    ids.emplace(StrokeId{ids.size() + 1}, builder.add(layer, stroke));
  }
  for (const FillPtr& fill : fills) {
    RenamedFill renamed = with_other_strokes(*fill, ids);
    builder.add_fill(layer, std::make_shared<const Fill>(std::move(renamed.fill)));
  }
  return std::move(builder).build("Import");
}

}  // namespace

/// Applies one event. One overload for each type of event.
struct Session::Apply {
  Session& session;
  std::int64_t time_ns;

  Result<void> operator()(const SelectTool& e) const { return session.select(e.id); }
  Result<void> operator()(const SetOption& e) const {
    return session.set_option(time_ns, e.id, e.value);
  }
  Result<void> operator()(const PenEvent& e) const {
    Result<void> done =
        session.sample({time_ns, e.position, {}, e.pressure, e.buttons, e.tilt_deg});
    if (!done && done.error().code == ErrorCode::kLimitExceeded) return {};
    return done;
  }
  Result<void> operator()(const HandEvent&) const {
    return fail(ErrorCode::kUnsupported,
                "hand events can only be played by the player, which moves the device");
  }
  Result<void> operator()(const UndoEvent&) const { return session.undo(); }
  Result<void> operator()(const RedoEvent&) const { return session.redo(); }
  Result<void> operator()(const CancelEvent&) const {
    session.cancel();
    return {};
  }
  Result<void> operator()(const AsDrawnEvent&) const { return session.show_as_drawn(); }
  Result<void> operator()(const ImportEvent&) const {
    return fail(ErrorCode::kUnsupported,
                "import events can only be handled by the reader of the file");
  }
  Result<void> operator()(const SelectStrokes& e) const { return session.select_strokes(e.what); }
  Result<void> operator()(const DeleteEvent&) const { return session.delete_selected(); }
  Result<void> operator()(const DuplicateEvent&) const { return session.duplicate_selected(); }
  Result<void> operator()(const MoveEvent& e) const { return session.move_selected(time_ns, e); }
  Result<void> operator()(const OrderEvent& e) const { return session.order_selected(e.to); }
  Result<void> operator()(const RestyleEvent& e) const { return session.restyle_selected(e); }
  Result<void> operator()(const LayerEvent& e) const { return session.change_layer(e); }
  Result<void> operator()(const AddPicture& e) const { return session.add_picture(e); }
  Result<void> operator()(const AddLine& e) const { return session.add_line(e); }
  Result<void> operator()(const UseDevice& e) const {
    Result<void> ended = session.finish();
    session.options_.device = e.capabilities;
    if (e.defaults < kFirmPushDefaults) session.options_.device.full_push_n = kOldFullPushN;
    if (!ended) return ended;
    return session.use_defaults(e.defaults);
  }
  Result<void> operator()(const UseMaterial& e) const { return session.use_material(e); }
  Result<void> operator()(const UseGuide& e) const { return session.use_guide(e); }
  Result<void> operator()(const ChooseOffer& e) const { return session.choose(e.what); }
  Result<void> operator()(const GuidesEvent& e) const { return session.change_guides(e); }
  Result<void> operator()(const TimingEvent& e) const { return session.change_timing(time_ns, e); }
  Result<void> operator()(const BodyEvent& e) const { return session.change_body(e); }
  Result<void> operator()(const ExactEvent&) const { return session.make_exact(); }
  Result<void> operator()(const UseEdges& e) const { return session.use_edges(e); }
  Result<void> operator()(const UseRing& e) const { return session.use_ring(e); }
  Result<void> operator()(const UseView& e) const { return session.use_view(e); }
};

Session::Session(std::vector<std::unique_ptr<Tool>> tools, SessionOptions options)
    : options_(std::move(options)),
      tools_(std::move(tools)),
      document_(std::move(options_.document)),
      parts_(std::make_unique<Parts>(document_)),
      selection_(std::move(options_.selection)),
      history_(options_.history_limit_bytes),
      stroke_guide_(std::make_unique<StrokeGuide>()) {
  selection_.hold_to(document_);
  parts_->visible_guides = document_.visible_guides();
  parts_->selection_view.look_at_all(document_, selection_);
  FELT_CHECK(!tools_.empty());
  const auto draws = [](const auto& tool) { return tool->info().kind == ToolKind::kDraws; };
  const auto first = std::find_if(tools_.begin(), tools_.end(), draws);
  if (first != tools_.end()) active_ = static_cast<std::size_t>(first - tools_.begin());
  parts_->surface.follow(options_.materials);
  parts_->ink_medium = drawing_medium(*this);
  if (document_.layers().empty()) {
    const Edit edit = add_layer_on_top(document_);
    FELT_CHECK(document_.apply(edit).has_value());
    follow(edit);
  }
  keep_layer_open();
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const SurfaceMaterial& Session::surface() const noexcept {
  return parts_->surface.material();
}

Rgba Session::ink_color() const noexcept {
  return parts_->ink_color;
}

Result<void> Session::apply(const Event& event) {
  if (const auto* option = std::get_if<SetOption>(&event.what)) {
    std::string id = current_option_id(option->id);
    if (id != option->id) return apply({event.time_ns, SetOption{std::move(id), option->value}});
  }
  Result<void> done = std::visit(Apply{*this, event.time_ns}, event.what);
  // sample() itself records pen events, after cleaning them.
  if (done && !std::holds_alternative<PenEvent>(event.what)) record(event);
  return done;
}

Result<void> Session::sample(const PenSample& reported) {
  if (!is_pen_position(reported.position)) {
    ++dropped_;
    return {};
  }
  PenSample sample = reported;
  sample.pressure = clean_pressure(reported.pressure);
  sample.tilt_deg = checked_tilt(reported.tilt_deg);
  const double dt_s = static_cast<double>(sample.time_ns - last_sample_ns_) * 1e-9;
  sample.velocity = parts_->velocity.update(sample.position, dt_s);
  last_sample_ns_ = sample.time_ns;
  Result<void> opened = begins_ink(sample) ? open_layer_for_ink() : Result<void>();
  if (!opened) {
    must_lift_ = true;  // before the gesture begins
    opened = refusals_.add(opened.error());
  }
  if (options_.on_event) {
    record({sample.time_ns,
            PenEvent{sample.position, sample.pressure, sample.buttons, sample.tilt_deg}});
  }

  follow_ring(sample);
  if (parts_->guide) parts_->guide->update(sample);
  follow_edges(sample);
  const bool was_down = std::exchange(pen_is_down_, in_contact(sample));
  const Contact::Change contact = parts_->contact.update(sample);
  if (must_lift_ && parts_->contact.is_down()) return opened;
  must_lift_ = false;
  if (pen_is_down_ && !was_down) {
    gesture_is_open_ = true;
    offer_.reset();
  }
  if (contact == Contact::Change::kTouched) exact_.reset();
  follow_guides(sample);
  Result<void> taken = take(tools_[active_]->sample(sample, contact, scene()));
  if (!pen_is_down_) gesture_is_open_ = false;
  if (!parts_->contact.is_down() && !gesture_in_progress()) ink_layer_step_.reset();
  return taken;
}

Result<void> Session::import(std::int64_t time_ns, const ImportEvent& event,
                             std::span<const StrokePtr> strokes, std::span<const FillPtr> fills) {
  if (Result<void> ended = finish(); !ended) return ended;
  const bool has_ink = !strokes.empty() || !fills.empty();
  if (Result<void> opened = has_ink ? open_layer_for_ink() : Result<void>(); !opened) return opened;
  Edit edit = import_edit(document_, layer_, strokes, fills);
  Selection added = made_by(edit);
  if (Result<void> done = commit(std::move(edit)); !done) {
    if (ink_layer_step_ == history_.position()) static_cast<void>(undo());
    return done;
  }
  if (event.select) set_selection(std::move(added));
  record({time_ns, event});
  return {};
}

Result<void> Session::finish() {
  Result<void> taken = take(tools_[active_]->finish(scene()));
  offer_.reset();
  show({});
  gesture_is_open_ = false;
  ink_layer_step_.reset();
  stroke_guide_->stop();
  parts_->retrace.stop();
  parts_->contour_hold.stop();
  // The next touch begins a new gesture. If the pen is down, or had to be lifted before, it must be
  // lifted first.
  const bool was_down = std::exchange(pen_is_down_, false);
  must_lift_ = must_lift_ || was_down;
  if (!must_lift_) parts_->contact.reset();
  return taken;
}

Result<void> Session::select(const std::string& id) {
  const Result<std::size_t> found = find_tool(id);
  if (!found) return tl::unexpected(found.error());
  static_cast<void>(use_ring({}));  // closes it, which never fails
  if (*found == active_) return {};
  Result<void> ended = finish();
  active_ = *found;
  return ended;
}

Result<void> Session::set_option(std::int64_t time_ns, const std::string& id,
                                 const OptionValue& value) {
  const auto [owner, name] = split_id(id);
  const auto in_context = [owner = std::string(owner)](const Error& error) {
    return tl::unexpected(with_context(error, owner));
  };
  if (id == kInkColor) {
    const Result<Rgba> color = color_of(value);
    if (!color) return in_context(color.error());
    parts_->ink_color = *color;
    return {};
  }
  if (owner == kSurface) {
    if (Result<void> done = parts_->surface.set(name, value, options_.materials); !done) {
      return in_context(done.error());
    }
    if (name == "material") report_material(time_ns, OpenChoice::kSurfaces, value);
    return {};
  }
  const Result<std::size_t> found = find_tool(owner);
  if (!found) return tl::unexpected(found.error());
  Tool& tool = *tools_[*found];
  OpenChoice open = OpenChoice::kNone;
  for (const OptionSpec& row : tool.info().options) {
    if (row.id != name) continue;
    open = row.open;
    if (Result<void> known = check_choice(row, value, options_.materials); !known) {
      return in_context(known.error());
    }
  }
  if (Result<void> done = tool.set_option(name, value); !done) return in_context(done.error());
  parts_->ink_medium = drawing_medium(*this);
  report_material(time_ns, open, value);
  return {};
}

Result<void> Session::use_defaults(int version) {
  if (std::exchange(option_defaults_, version) == version) return {};
  parts_->contact.set_landed_ns(landed_ns(version));
  if (version < kLateLayerDefaults) add_first_open_layer();
  for (const SetOption& old : old_defaults(version)) {
    const auto [owner, name] = split_id(old.id);
    const Result<std::size_t> found = find_tool(owner);
    if (!found) continue;
    Tool& tool = *tools_[*found];
    for (const OptionSpec& row : tool.info().options) {
      if (row.id != name || tool.option(name) != default_value(row)) continue;
      if (Result<void> done = tool.set_option(name, old.value); !done) return done;
    }
  }
  return {};
}

Result<void> Session::use_material(const UseMaterial& event) {
  Result<AnyMaterial> material = read_material(event.text);
  if (!material) return tl::unexpected(material.error());
  reported_.push_back(material_key(*material));
  put(options_.materials, *std::move(material));
  parts_->surface.follow(options_.materials);
  return {};
}

Result<void> Session::use_guide(const UseGuide& event) {
  if (Result<void> fine = check_guide(event.line); !fine) return fine;
  if (parts_->guide) parts_->guide_number = parts_->guide->hold();
  parts_->guide.reset();
  if (event.line.kind != GuideKind::kNone)
    parts_->guide.emplace(event.line, ++parts_->guide_number);
  return {};
}

void Session::follow_edges(const PenSample& sample) {
  if (!edge_ridges_) return;
  edge_ridges_->set(edges_.page, edges_.selection ? parts_->selection_view.box() : Rect{});
  edge_ridges_->update(sample);
}

const GuideLine* Session::guide() const noexcept {
  return parts_->guide ? &parts_->guide->line() : nullptr;
}

std::optional<StrokeId> Session::retraced() const noexcept {
  return parts_->retrace.line();
}

const DrawingGuide* Session::symmetry() const noexcept {
  const auto& guides = parts_->visible_guides;
  const auto found = std::find_if(guides.rbegin(), guides.rend(), [](const auto& guide) {
    return guide->kind == DrawingGuideKind::kSymmetry;
  });
  return found == guides.rend() ? nullptr : found->get();
}

void Session::follow(const Edit& applied) {
  ++edits_;
  if (seen_) {
    const Edit edit = seen_edit(applied);
    FELT_CHECK(seen_->apply(edit).has_value());
    follow_seen(edit);
  } else {
    follow_seen(applied);
  }
  if (!applied.layers.empty()) keep_layer_open();
  if (!applied.guides.empty() || applied.toggles_guides) {
    parts_->visible_guides = document_.visible_guides();
  }
  if (options_.on_edit) options_.on_edit(applied);
}

void Session::follow_seen(const Edit& applied) {
  parts_->index.update(applied, seen());
  const bool is_selected =
      !applied.layers.empty() || std::any_of(applied.changes.begin(), applied.changes.end(),
                                             [this](const StrokeChange& change) {
                                               return selection_.find(change.id) != nullptr;
                                             });
  selection_.follow(applied, seen());
  ++selections_;
  if (is_selected) parts_->selection_view.look_at_all(seen(), selection_);
}

void Session::set_selection(Selection selection) {
  selection_ = std::move(selection);
  selection_.hold_to(seen());
  ++selections_;
  parts_->selection_view.look_at_all(seen(), selection_);
}

void Session::record(const Event& event) const {
  if (options_.on_event) options_.on_event(event);
}

void Session::draw(Overlay& overlay) const {
  overlay.clear();
  const ToolKind kind = tool().info().kind;
  if (kind != ToolKind::kSelects && kind != ToolKind::kTransforms)
    parts_->selection_view.draw(overlay);
  tool().draw(overlay);
  draw_offer(overlay);
  if (draws_ink()) {
    if (const DrawingGuide* guide = symmetry()) add_ink_images(overlay, *guide);
  }
  stroke_guide_->draw(overlay);
  if (!options_.device.has_force()) draw_guide_spring(overlay);
  if (const StrokePtr exact = exact_offer()) draw_exact(*exact, overlay);
  draw_ring(overlay);
}

std::vector<std::string> Session::option_ids() const {
  std::vector<std::string> ids;
  const auto add = [&ids](std::string_view owner, std::span<const OptionSpec> table) {
    for (const OptionSpec& row : table) {
      ids.push_back(std::string(owner) + "." + std::string(row.id));
    }
  };
  for (const auto& tool : tools_) add(tool->info().id, tool->info().options);
  add(kSurface, SurfaceOptions::table());
  ids.emplace_back(kInkColor);
  return ids;
}

std::string Session::current_option_id(std::string_view id) const {
  if (id == "sheet.material") return "surface.material";
  if (id == "sheet.color") return std::string(kInkColor);
  const auto [owner, name] = split_id(id);
  if (const Result<std::size_t> found = find_tool(owner)) {
    for (const OptionSpec& row : tools_[*found]->info().options) {
      if (!name.empty() && row.former_id == name)
        return std::string(owner) + "." + std::string(row.id);
    }
  }
  return std::string(id);
}

Result<OptionValue> Session::option(std::string_view any_id) const {
  const std::string id = current_option_id(any_id);
  const auto [owner, name] = split_id(id);
  if (id == kInkColor) return OptionValue(color_to_text(parts_->ink_color));
  if (owner == kSurface) return parts_->surface.get(name);
  const Result<std::size_t> found = find_tool(owner);
  if (!found) return tl::unexpected(found.error());
  return tools_[*found]->option(name);
}

Scene Session::scene() const {
  const Tool* draws = first_tool(ToolKind::kDraws);
  const std::optional<ToolSize> size = draws ? draws->size() : std::nullopt;
  return {seen(),
          parts_->index,
          selection_,
          layer_,
          surface(),
          options_.device,
          ink_color(),
          options_.materials,
          active_guide(parts_->guide ? &*parts_->guide : nullptr, *stroke_guide_, parts_->retrace,
                       parts_->contour_hold),
          parts_->ink_medium,
          size ? size->mm : Scene::kUsualInkWidthMm,
          parts_->visible_guides,
          option_defaults_ < kFirmPushDefaults ? kOldFeltWidthToleranceMm
                                               : Scene::kFeltWidthToleranceMm,
          option_defaults_ >= kFirmPushDefaults,
          parts_->surface.law(),
          !parts_->surface.plane_only()};
}

const Tool* Session::first_tool(ToolKind kind) const noexcept {
  const auto found = std::find_if(tools_.begin(), tools_.end(),
                                  [kind](const auto& tool) { return tool->info().kind == kind; });
  return found == tools_.end() ? nullptr : found->get();
}

Document document_of(std::span<const StrokePtr> strokes) {
  Document document;
  const Edit edit = import_edit(document, document.layers().back().id, strokes);
  FELT_CHECK(document.apply(edit).has_value());
  return document;
}

}  // namespace felt
