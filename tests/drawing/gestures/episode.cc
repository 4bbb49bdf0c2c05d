#include "tests/drawing/gestures/episode.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <initializer_list>
#include <utility>

#include "felt/base/hash.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/session/layer_edit.h"
#include "felt/stroke/color_text.h"
#include "tests/drawing/gestures/counted_tools.h"
#include "tests/drawing/gestures/random_gesture.h"
#include "tests/drawing/gestures/random_sketch.h"

namespace felt::gestures {
namespace {

constexpr double kChecked = 0.12;  // share of the samples
constexpr double kMeant = 0.08;  // share of the gestures that the pencil may take for more than ink

const Capabilities& any_device(Dice& dice) {
  static constexpr std::array<std::string_view, 5> kNames{"touch", "premium", "omega", "mouse",
                                                          "tablet"};
  return find_stylus_preset(dice.any(kNames))->capabilities;
}

/// Returns the force limit of a tool, in N. It is higher if the tool draws, because attraction and
/// stabiliser add up; the limit of all other tools is 1 N (R29, R35).
double force_limit_n(bool draws) {
  return draws ? 2.0 : 1.0;
}

/// Returns true if an edit only adds the layer that ink needs where all others are hidden or
/// locked.
bool opens_layer(const Document& before, const Edit& edit) {
  return !highest_open_layer(before) && edit == add_layer_on_top(before);
}

std::string text_of(const OptionValue& value) {
  if (const double* number = std::get_if<double>(&value)) return std::to_string(*number);
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
  return std::get<std::string>(value);
}

OptionValue any_value(Dice& dice, const OptionSpec& spec) {
  switch (spec.kind) {
    case OptionKind::kSwitch:
      return dice.chance(0.5);
    case OptionKind::kChoice:
      return std::string(dice.any(spec.choices));
    case OptionKind::kNumber:
      break;
  }
  const double k = dice.between(0.0, 1.0);
  if (k < 0.2) return spec.min;
  if (k < 0.4) return spec.max;
  if (k < 0.6) return spec.fallback;
  if (k < 0.8 && spec.min > 0.0 && spec.max > spec.min) {
    return std::clamp(dice.over_decades(spec.min, spec.max), spec.min, spec.max);
  }
  return std::clamp(dice.between(spec.min, spec.max), spec.min, spec.max);
}

void add_numbers(std::string& bytes, std::initializer_list<double> numbers) {
  for (const double x : numbers) {
    const auto raw = std::bit_cast<std::array<char, sizeof x>>(x);
    bytes.append(raw.data(), raw.size());
  }
}

bool changes_something(const Edit& edit) {
  return !edit.layers.empty() || !edit.fills.empty() || !edit.guides.empty() ||
         !edit.symmetries.empty() || !edit.body_edits.empty() || edit.toggles_guides ||
         std::any_of(edit.changes.begin(), edit.changes.end(), [](const StrokeChange& c) {
           return !c.before || !c.after || !(*c.before == *c.after) ||
                  !(c.before_place == c.after_place);
         });
}

}  // namespace

std::string bytes_of(const Document& document) {
  std::string bytes;
  for (const Layer& layer : document.layers()) {
    bytes += layer.name + (layer.visible ? " visible" : "") + (layer.locked ? " locked\n" : "\n");
    for (const StrokeId id : layer.strokes) {
      append_sketch_line(bytes, std::to_string(id.value), document.find(id)->data());
    }
    for (const FillId id : layer.fills) {
      const Fill& fill = *document.find_fill(id);
      bytes += "fill " + std::to_string(id.value) + ' ' + color_to_text(fill.color);
      for (const FillLoop& loop : fill.loops) {
        for (const Point& p : loop.points) add_numbers(bytes, {p.x, p.y});
        for (const FillPiece& piece : loop.pieces) {
          add_numbers(bytes, {static_cast<double>(piece.stroke.value), piece.from, piece.to});
        }
      }
      bytes += '\n';
    }
  }
  for (const auto& [id, guide] : document.guides()) {
    bytes += "guide " + std::to_string(id.value) + (document.shows_guides() ? " shown" : "");
    add_numbers(bytes, {guide->origin.x, guide->origin.y, guide->angle_rad, guide->size_mm,
                        guide->second_mm, static_cast<double>(guide->stroke.value)});
    for (const Point& p : guide->points) add_numbers(bytes, {p.x, p.y});
  }
  for (const auto& [id, group] : document.symmetries()) {
    bytes += "symmetry " + std::to_string(id.value);
    add_numbers(bytes, {group->center.x, group->center.y, group->angle_rad});
    for (const SymmetryImage& image : group->images) {
      bytes += ' ' + std::to_string(image.stroke.value);
    }
  }
  return bytes;
}

Episode::Episode(const EpisodeOptions& options, const std::vector<Stroke>& real, Totals& totals)
    : options_(options),
      totals_(totals),
      dice_(options.seed),
      probe_(any_device(dice_)),
      session_(make_counted_tools(touches_), session_options(real)) {}

SessionOptions Episode::session_options(const std::vector<Stroke>& real) {
  SessionOptions options;
  Dice same(options_.seed);
  options.device = any_device(same);
  options.document = random_document(dice_, real);
  last_ = start_ = options.document;
  options.on_edit = [this](const Edit& edit) { see_edit(edit); };
  return options;
}

ToolTotals& Episode::tool_totals() {
  return totals_.tools[std::string(session_.tool().info().id)];
}

void Episode::break_rule(Broken broken) {
  if (!broken_) broken_ = std::move(broken);
}

void Episode::see_edit(const Edit& edit) {
  ++edits_;
  if (!is_command_) {
    // A layer that is opened for ink is one step with the ink.
    const bool is_layer = opens_layer(last_, edit);
    if (!is_layer) ++commits_;
    ++tool_totals().edits;
    break_rule(check_edit(last_, edit));
    const std::span<const std::string_view> named = session_.tool().info().edits;
    const bool is_named = std::find(named.begin(), named.end(), edit.label) != named.end();
    if (!is_named && edit.label != "Import" && !is_layer) {
      break_rule("an edit whose label \"" + edit.label + "\" the tool's info does not name");
    }
    if (!changes_something(edit)) break_rule("an edit that changes nothing");
  }
  break_rule(check_locality(last_, session_.document(), edit));
  last_ = session_.document();
}

template <class What>
void Episode::apply(const What& what) {
  if (broken_) return;
  Event event;
  event.time_ns = now_ns_;
  event.what.emplace<What>(what);
  const Result<void> done = session_.apply(event);
  if (!done) break_rule("an event is refused: " + done.error().message);
  break_rule(check_selection(session_.document(), session_.selection()));
}

template <class What>
void Episode::command(const What& what) {
  is_command_ = true;
  apply(what);
  is_command_ = false;
}

void Episode::take(const PenSample& sample) {
  if (broken_) return;
  now_ns_ = sample.time_ns;
  ++totals_.samples;
  ++samples_in_gesture_;
  const Result<void> done = session_.sample(sample);
  if (!done) return break_rule("a sample is refused: " + done.error().message);
  if (commits_ > touches_) return break_rule("a gesture is more than one step");
  if (!is_pen_position(sample.position)) return;
  if (session_.preview()) ++tool_totals().previews;
  if (const Reading* reading = session_.tool().reading()) {
    if (std::exchange(last_news_, reading->news) != reading->news) ++tool_totals().readings;
    break_rule(check_reading(*reading, session_.document()));
  }
  if (!(session_.selection() == last_selection_)) {
    last_selection_ = session_.selection();
    ++tool_totals().selections;
  }
  if (dice_.chance(kChecked)) check_state(sample);
}

void Episode::check_state(const PenSample& reported) {
  if (session_.preview()) break_rule(check_edit(session_.document(), *session_.preview()));
  break_rule(check_selection(session_.document(), session_.selection()));
  PenSample sample = reported;
  if (sample.pressure && !(*sample.pressure >= 0.0)) sample.pressure.reset();
  const double dt_s = 1e-9 * static_cast<double>(sample.time_ns - velocity_ns_);
  sample.velocity = velocity_.update(sample.position, dt_s);
  velocity_ns_ = sample.time_ns;
  const bool draws = session_.tool().info().kind == ToolKind::kDraws;
  // The safety chain scales the tool's force and the ridge down near an edge.
  const bool has_edge = session_.edges() != UseEdges{};
  break_rule(probe_.check(session_.force(), sample, force_limit_n(draws) + (has_edge ? 0.2 : 0.0),
                          draws || has_edge));
  ToolTotals& totals = tool_totals();
  totals.largest_n = std::max(totals.largest_n, probe_.take_largest_n());
  session_.draw(overlay_);
  break_rule(check_overlay(overlay_, session_.document(), samples_in_gesture_));
}

Broken Episode::run() {
  for (int k = 0; k < options_.gestures && !broken_; ++k) one_gesture(k);
  if (!broken_) back_and_forth();
  return broken_;
}

void Episode::one_gesture(int number) {
  where_ = "gesture " + std::to_string(number);
  // What the last gesture offers, before anything else happens.
  if (dice_.chance(0.5)) choose_offer();
  if (session_.exact_offer() && dice_.chance(0.5)) make_exact();
  const bool is_meant = dice_.chance(kMeant);
  if (is_meant) {
    mean_something();
  } else {
    choose_tool();
  }
  where_ += ", " + std::string(session_.tool().info().id);
  if (!is_meant) choose_options();
  between_gestures();
  const PenGesture gesture = is_meant
                                 ? meant_gesture(dice_, session_.document(), now_ns_ + 1'000'000)
                                 : random_gesture(dice_, session_.document(), now_ns_ + 1'000'000);
  where_ += ", " + std::string(gesture.kind);
  if (options_.trace) std::fprintf(stderr, "%s\n", where_.c_str());
  ++tool_totals().gestures;
  samples_in_gesture_ = 0;
  std::optional<std::size_t> interference;
  if (dice_.chance(0.2)) interference = dice_.pick(gesture.samples.size());
  for (std::size_t i = 0; i < gesture.samples.size() && !broken_; ++i) {
    if (interference == i) interfere();
    take(gesture.samples[i]);
  }
}

void Episode::choose_tool() {
  if (!dice_.chance(0.7)) return;
  const auto tools = session_.tools();
  std::string id(dice_.any(tools)->info().id);
  if (!options_.tool.empty() && dice_.chance(0.8)) id = options_.tool;
  apply(SelectTool{id});
}

void Episode::choose_options() {
  const ToolInfo& tool = session_.tool().info();
  if (dice_.chance(0.5) && !tool.options.empty()) {
    for (int k = dice_.pick(1, 4); k > 0; --k) choose_option(tool.id, dice_.any(tool.options));
  }
  if (!dice_.chance(0.05)) return;
  // The literal forces of the paper jump, so they cannot claim their stiffness.
  const OptionSpec& row = dice_.any(SurfaceOptions::table());
  if (row.id != "law") choose_option("surface", row);
}

void Episode::choose_option(std::string_view owner, const OptionSpec& spec) {
  const OptionValue value = any_value(dice_, spec);
  const std::string id = std::string(owner) + "." + std::string(spec.id);
  where_ += ", " + id + " = " + text_of(value);
  apply(SetOption{id, value});
}

void Episode::between_gestures() {
  const double k = dice_.between(0.0, 1.0);
  if (k < 0.15) return undo_and_redo();
  if (k < 0.2) return cancel();
  if (k < 0.23) return import();
  if (k < 0.33) return select_or_delete();
  if (k < 0.38) return change_layers();
  if (k < 0.42) return change_edges();
  if (k < 0.46) return use_ring();
  if (k < 0.66) return choose_offer();
  if (k < 0.78) return change_guides();
  if (k < 0.84) return make_exact();
}

/// Takes the pencil with all its gestures on.
void Episode::mean_something() {
  apply(SelectTool{"pencil"});
  for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
    apply(SetOption{id, true});
  }
}

/// Chooses one of the meanings of the last stroke, or one that is not offered. Choices replace the
/// step of the stroke, so they are no steps of their own.
void Episode::choose_offer() {
  const std::optional<OfferView> offer = session_.offered();
  OfferKind kind = static_cast<OfferKind>(dice_.pick(kOfferKinds.size()));
  if (offer && dice_.chance(0.9)) kind = dice_.any(offer->rows).kind;
  const bool is_offered = offer && std::any_of(offer->rows.begin(), offer->rows.end(),
                                               [&](const OfferRow& r) { return r.kind == kind; });
  where_ += ", chooses " + std::string(kOfferKinds[static_cast<std::size_t>(kind)]);
  const std::uint64_t edits = edits_;
  const std::size_t steps = session_.history().undo_count();
  command(ChooseOffer{kind});
  if (!is_offered && edits_ != edits) break_rule("what is not offered changed something");
  if (session_.history().undo_count() > steps) break_rule("a choice is a step of its own");
  if (is_offered) ++totals_.chosen;
}

/// Interrupts a gesture: undoes, changes the tool or an option, imports, cancels ...
void Episode::interfere() {
  switch (dice_.pick(12)) {
    case 0:
      return undo_and_redo();
    case 1:
      where_ += ", a tool is chosen";
      return choose_tool();
    case 2:
      return choose_options();
    case 3:
      return import();
    case 4:
      return select_or_delete();
    case 5:
      return change_layers();
    case 7:
      return choose_offer();
    case 8:
      return use_ring();
    case 9:
      return change_guides();
    case 10:
      return make_exact();
    case 6: {
      where_ += ", it is finished";
      const Result<void> done = session_.finish();
      if (!done) break_rule("finish: " + done.error().message);
      return;
    }
    default:
      return cancel();
  }
}

void Episode::undo_and_redo() {
  where_ += ", undo and redo";
  for (int k = dice_.pick(1, 4); k > 0 && !broken_; --k) {
    if (dice_.chance(0.6)) {
      command(UndoEvent{});
    } else {
      command(RedoEvent{});
    }
    ++totals_.undone;
  }
  if (dice_.chance(0.3) && session_.history().can_undo() && !session_.gesture_in_progress()) {
    const Document before = session_.document();
    command(UndoEvent{});
    command(RedoEvent{});
    if (!(session_.document() == before)) break_rule("undo and redo lead elsewhere");
  }
}

void Episode::cancel() {
  where_ += ", cancel";
  const std::uint64_t edits = edits_;
  const Document before = session_.document();
  apply(CancelEvent{});
  if (edits_ != edits || !(session_.document() == before)) break_rule("cancel changed something");
  if (session_.preview()) break_rule("cancel left a preview");
}

void Episode::import() {
  where_ += ", import";
  Dice other(dice_.seed());
  const Document document = random_document(other, {});
  std::vector<StrokePtr> strokes;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) strokes.push_back(document.find(id));
  }
  if (strokes.size() > 2) strokes.resize(2);
  ++touches_;  // the import is a separate undo step
  const Result<void> done = session_.import(now_ns_, {"random"}, strokes);
  if (!done) break_rule("import: " + done.error().message);
}

void Episode::select_or_delete() {
  const double k = dice_.between(0.0, 1.0);
  where_ += ", selects, deletes or duplicates";
  if (k < 0.5) return apply(SelectStrokes{SelectStrokes::What::kAll});
  if (k < 0.6) return apply(SelectStrokes{SelectStrokes::What::kInvert});
  if (k < 0.7) return apply(SelectStrokes{SelectStrokes::What::kNone});
  if (k < 0.75) return command(MoveEvent{{dice_.between(-9.0, 9.0), dice_.between(-9.0, 9.0)}});
  if (k < 0.8) {
    return command(OrderEvent{dice_.chance(0.5) ? OrderEvent::To::kFront : OrderEvent::To::kBack});
  }
  if (k < 0.9) return command(DeleteEvent{});
  if (k < 0.93) return command(AsDrawnEvent{});
  // Duplicating without a limit would only cost time.
  if (session_.document().stroke_count() < 60) command(DuplicateEvent{});
}

void Episode::change_layers() {
  LayerEvent event;
  event.what = static_cast<LayerEvent::Do>(dice_.pick(0, static_cast<int>(LayerEvent::Do::kMove)));
  if (event.what != LayerEvent::Do::kAdd) event.layer = dice_.any(session_.document().layers()).id;
  event.name = dice_.chance(0.5) ? "other" : "";
  event.index = static_cast<std::size_t>(dice_.pick(0, 4));
  where_ += ", layer " + std::to_string(static_cast<int>(event.what));
  const std::uint64_t edits = edits_;
  is_command_ = true;
  // An impossible change, such as hiding the last open layer, is refused and changes nothing.
  const Result<void> done = session_.apply({now_ns_, event});
  is_command_ = false;
  if (!done && edits_ != edits) break_rule("a layer event is refused and changes something");
  break_rule(check_selection(session_.document(), session_.selection()));
}

void Episode::change_edges() {
  where_ += ", edges";
  UseEdges edges;
  if (dice_.chance(0.7)) {
    const double x = dice_.between(-10.0, 60.0), y = dice_.between(-10.0, 60.0);
    edges.page = {x, y, x + dice_.between(0.1, 150.0), y + dice_.between(0.1, 150.0)};
  }
  edges.selection = dice_.chance(0.5);
  if (dice_.chance(0.3)) {
    std::vector<Point>& contour = edges.contours.emplace_back();
    for (int i = 0; i < 40; ++i) {
      contour.push_back({dice_.between(0.0, 100.0), dice_.between(0.0, 100.0)});
    }
  }
  apply(edges);
}

/// Opens a ring, moves the pen in it, and closes it. Nothing that happens in it may change the
/// document.
void Episode::use_ring() {
  where_ += ", ring";
  const Point middle{dice_.between(0.0, 100.0), dice_.between(0.0, 100.0)};
  const double angle = dice_.between(0.0, 6.3), size_mm = dice_.between(1.0, 40.0);
  const Vec up{size_mm * std::sin(angle), -size_mm * std::cos(angle)};
  const Vec right = dice_.chance(0.8) ? Vec{-up.y, up.x} : Vec{up.y, -up.x};
  apply(UseRing{true, middle, middle + up, middle + right});
  if (!session_.ring()) return;  // a gesture is in progress
  const std::uint64_t edits = edits_;
  bool touches = false;
  for (int i = dice_.pick(0, 30); i > 0 && !broken_; --i) {
    if (dice_.chance(0.2)) touches = !touches;
    const Vec off{dice_.between(-2.0, 2.0) * size_mm, dice_.between(-2.0, 2.0) * size_mm};
    PenSample sample;
    sample.time_ns = now_ns_ + 4'000'000;
    sample.position = {middle.x + off.x, middle.y + off.y, touches ? -0.5 : 2.0};
    if (dice_.chance(0.02)) sample.position.x = std::nan("");
    now_ns_ = sample.time_ns;
    if (!session_.sample(sample)) break_rule("a sample in a ring is refused");
    if (dice_.chance(0.3) && is_pen_position(sample.position)) check_state(sample);
  }
  if (edits_ != edits) break_rule("a ring changed the document");
  apply(UseRing{});
  if (session_.ring()) break_rule("a ring stays open");
}

void Episode::back_and_forth() {
  where_ = "at the end";
  const Result<void> done = session_.finish();
  if (!done) return break_rule("finish: " + done.error().message);
  const Document end = session_.document();
  const std::string end_bytes = bytes_of(end);
  std::size_t steps = 0;
  for (; session_.history().can_undo() && !broken_; ++steps) command(UndoEvent{});
  if (broken_) return;
  if (!(session_.document() == start_) || bytes_of(session_.document()) != bytes_of(start_)) {
    return break_rule("undo does not lead back to the start");
  }
  for (; steps > 0 && !broken_; --steps) command(RedoEvent{});
  if (broken_) return;
  if (!(session_.document() == end) || bytes_of(session_.document()) != end_bytes) {
    return break_rule("redo does not lead to the end");
  }
  for (const char c : end_bytes) {
    totals_.digest = (totals_.digest ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
}

}  // namespace felt::gestures
