#include "felt/tools/pencil/pencil_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/recognise/shape_curve.h"
#include "felt/tools/medium_line.h"
#include "felt/tools/pencil/as_drawn.h"
#include "felt/tools/pencil/pencil_force.h"
#include "felt/tools/pressing.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kPencilUses = {
    {{.hint = "Draw; press harder for a broader line. End on a line’s end to join it.",
      .first_modifier = "straight line",
      .second_modifier = "straight, in steps of 15°",
      .size = "max_width_mm",
      .path = ToolPath::kFree}}};
constexpr std::array<std::string_view, 4> kPencilEdits = {"Draw", "As drawn", "Scratch out",
                                                          "Shape"};
constexpr std::array<ToolAct, 4> kPencilActs = {
    {{.name = "gestures",
      .title = "Gestures",
      .caption =
          "Hold the pen at the end of a line and press: the line becomes the shape. Scribble "
          "over lines, and you are asked whether to delete them.",
      .seconds = 12.0},
     {.name = "steady",
      .title = "Steady hand",
      .caption = "If your hand shakes, lines can be calm: the shaking is measured once and removed "
                 "while you draw.",
      .seconds = 8.0},
     {.name = "ring",
      .title = "Ring of tools",
      .caption = "Around the pen there are eight choices, each in its own direction: a well that "
                 "attracts the pen, with a ridge to the next one. Lift the pen to choose.",
      .seconds = 7.0},
     {.name = "guide",
      .title = "Guides",
      .caption =
          "A ruler, a compass or a perspective holds the pen gently, and lets go if you mean "
          "to leave it. One key makes a line along it exact.",
      .seconds = 9.0}}};
constexpr ToolInfo kPencilInfo{
    .id = "pencil",
    .label = "Pencil",
    .help = "Draws lines; pressing harder draws them broader.",
    .shortcut = 'p',
    .options = kPencilOptions,
    .kind = ToolKind::kDraws,
    .uses = kPencilUses,
    .edits = kPencilEdits,
    .act = {.title = "Draw",
            .caption = "Lines become smooth curves while you draw; press harder for a broader "
                       "line. Near its start, an outline closes by itself.",
            .seconds = 36.0},
    .more_acts = kPencilActs};

/// Returns the width that a mouse draws, 0 (thinnest) to 1 (broadest).
double share_of_mouse(const OptionValues& options) {
  const double gamma = std::max(0.1, options.number(PencilOption::Row::kGamma));
  return std::pow(std::clamp(options.number(PencilOption::Row::kMousePressure), 0.0, 1.0), gamma);
}

}  // namespace

std::unique_ptr<Tool> make_pencil() {
  return std::make_unique<PencilTool>();
}

PencilTool::PencilTool() : GestureTool(kPencilInfo), settings_(pencil_settings(options())) {}

ToolResult PencilTool::hover(const PenSample& sample, const Scene& scene) {
  pen_point_ = on_page(sample.position);
  hold_.update(sample);
  near_ = sample.position.z < (near_ ? kFarMm : kNearMm);
  snap_.hover(pen_point_, sample.time_ns, near_, settings_.snap, scene);
  return {};
}

ToolResult PencilTool::begin(const PenSample& sample, const Scene& scene) {
  pen_point_ = on_page(sample.position);
  make_fitter(scene);
  fitter_->begin();
  wet_.begin(fitted_);
  straight_.begin(pen_point_, fitted_.width_map);
  hold_.begin();
  width_steps_ = settings_.width_steps ? WidthSteps(fitted_.width_map) : WidthSteps();
  stabiliser_ = Stabiliser(settings_.stabiliser);
  stabiliser_.begin(pen_point_, sample.time_ns);
  begin_steady();
  landing_.begin(sample, Pressing(scene.surface, scene.device).is_felt());
  color_ = scene.color;
  snap_.begin(pen_point_, sample.time_ns, settings_.snap, scene);
  path_.begin();
  path_widths_ = WidthMap(fitted_.width_map);
  shapes_.begin(pen_point_, sample.time_ns);
  return move(sample, scene);
}

/// Makes a new fitter only if the widths have changed, so that all lines use the same buffers.
void PencilTool::make_fitter(const Scene& scene) {
  InkFitOptions ink = drawn_with(medium_of(scene, settings_.medium), settings_.ink);
  if (Pressing(scene.surface, scene.device).is_felt()) {
    ink.width.tolerance_mm = std::min(ink.width.tolerance_mm, scene.felt_width_tolerance_mm);
  }
  const bool is_same = fitter_ && fitted_.width_map == ink.width_map &&
                       fitted_.width.tolerance_mm == ink.width.tolerance_mm;
  if (is_same) return;
  fitter_ = std::make_unique<InkFitter>(ink);
  fitted_ = ink;
}

void PencilTool::begin_steady() {
  if (shake_ != settings_.steady) {
    shake_ = settings_.steady;
    steady_ = shake_ ? std::make_unique<SteadyLine>(*shake_) : nullptr;
  }
  if (steady_) steady_->begin();
}

void PencilTool::add_ink(const InkSample& ink) {
  const auto add = [this](const InkSample& sample) {
    fitter_->push(sample);
    wet_.update(*fitter_, sample);
  };
  if (!steady_) return add(ink);
  for (const InkSample& settled : steady_->push(ink)) add(settled);
}

void PencilTool::add_landed(std::span<const InkSample> ink) {
  for (const InkSample& sample : ink) add_ink(sample);
}

ToolResult PencilTool::move(const PenSample& sample, const Scene& scene) {
  pen_point_ = on_page(sample.position);
  if (shapes_.accepted()) return {};  // the line has become a shape
  const Pressing pressing(scene.surface, scene.device);
  pen_ = {pen_point_, width_steps_.held(pressing.of(sample)), sample.time_ns, sample.tilt_deg};
  InkSample ink = pen_;
  ink.position = stabiliser_.update(pen_point_, sample.time_ns);
  const bool landed = !landing_.is_landing();
  const std::span<const InkSample> known = landing_.push(ink, in_contact(sample));
  add_landed(known);
  if (landed || known.empty()) {
    straight_.push(pen_);
  } else {
    restart_straight(known);
  }
  hold_.update(sample);
  // A sample during a bounce draws ink but does not snap.
  const Point tip = steady_ ? steady_->tip() : pen_point_;
  if (in_contact(sample)) snap_.update(tip, sample.time_ns, settings_.snap, scene);
  if (!settings_.gestures.any()) return {};
  path_.push(ink.position, landing_.is_landing() ? path_widths_.push(pen_) : wet_.ink());
  if (settings_.gestures.shapes && !hold_.is_meant()) {
    shapes_.update(pen_point_, pen_.pressure, sample.time_ns, path_.points());
  }
  return {};
}

/// Returns the straight line. Its ends are on the targets in `to`, except that a line in steps
/// keeps its direction and has no target at its end. Removes targets that the line does not meet.
std::optional<Stroke> PencilTool::straight_line(InkConnections& to) const {
  Point from = straight_.start(), end = straight_.pen();
  to.closes = false;
  if (to.start || to.start_meets) from = snap_.start_target()->point;
  if (hold_.has_second()) {
    to.end.reset();
    to.end_meets.reset();
    end = straight_.pen_in_steps() + (from - straight_.start());
  }
  if (to.end || to.end_meets) end = snap_.target()->point;
  return straight_.stroke(from, end, fitted_);
}

/// Draws the straight line again with pressures without the impact of the landing.
void PencilTool::restart_straight(std::span<const InkSample> samples) {
  straight_.begin(straight_.start(), fitted_.width_map);
  for (const InkSample& sample : samples) straight_.push(sample);
}

std::optional<Stroke> PencilTool::free_line() {
  std::vector<Stabiliser::Step> rest;
  stabiliser_.finish(rest);
  for (const Stabiliser::Step& step : rest) {
    const InkSample ink{step.nib, pen_.pressure, step.time_ns, pen_.tilt_deg};
    if (steady_) {
      steady_->push(ink);
    } else {
      fitter_->push(ink);
    }
  }
  return steady_ ? line_of(steady_->smoothed()) : fitted_line();
}

std::optional<Stroke> PencilTool::fitted_line() {
  fitter_->end();
  if (settings_.refine && fitter_->samples().size() <= kMaxRefinedSamples) fitter_->refine();

  Result<Stroke> drawn = fitter_->stroke();
  if (!drawn) return std::nullopt;
  return *std::move(drawn);
}

template <class Samples>
std::optional<Stroke> PencilTool::line_of(const Samples& samples) {
  fitter_->begin();
  for (const InkSample& sample : samples) fitter_->push(sample);
  return fitted_line();
}

std::optional<Edit> PencilTool::edit_of(const std::optional<Stroke>& drawn,
                                        const InkConnections& to, const Scene& scene) const {
  if (!drawn) return std::nullopt;
  StrokeData data = drawn->data();
  data.medium = settings_.medium;
  data.color = color_;
  // The stroke is still valid, because no invariant involves medium or colour.
  const auto ink = Stroke::create(std::move(data));
  if (!ink) return std::nullopt;
  return connect_ink(*ink, to, scene);
}

std::optional<Stroke> PencilTool::shape_ink(const ShapeGuess& shape) const {
  StrokeData data = shape_curve(shape);
  const InkWidth ink = path_.usual_ink();
  const double width_mm = std::max(ink.width_mm, kMinWidthMm);
  const double tone = fitted_.width_map.tone ? ink.tone : tone_of_width(width_mm);
  const double end = static_cast<double>(data.points.size() / 3);
  data.widths = {{0.0, width_mm, tone}, {end, width_mm, tone}};
  data.medium = settings_.medium;
  data.color = color_;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

std::optional<Offer> PencilTool::shape_offer(const Edit& ink, const Scene& scene) const {
  Offer offer;
  offer.at = pen_point_;
  std::optional<std::size_t> accepted;
  for (std::size_t i = 0; i < shapes_.shapes().size(); ++i) {
    const std::optional<Stroke> stroke = shape_ink(shapes_.shapes()[i]);
    if (!stroke) continue;
    EditBuilder builder(scene.document);
    builder.add(scene.layer, std::make_shared<const Stroke>(*stroke));
    if (shapes_.accepted() == i) accepted = offer.choices.size();
    offer.choices.push_back(
        {offer_of(shapes_.shapes()[i].form), 0, std::move(builder).build("Shape"), std::nullopt});
  }
  if (offer.choices.empty()) return std::nullopt;
  offer.chosen = accepted.value_or(offer.choices.size());
  offer.choices.push_back({OfferKind::kInk, 0, ink, std::nullopt});
  return offer;
}

/// Adds what the line may also mean, and applies what was chosen while the pen was down.
void PencilTool::add_offer(ToolResult& result, const Scene& scene) const {
  if (!result.commit || !settings_.gestures.any() || hold_.is_meant()) return;
  result.offer = shapes_.shapes().empty()
                     ? line_meanings(path_.points(), *result.commit, settings_.gestures, scene)
                     : shape_offer(*result.commit, scene);
  if (!result.offer) return;
  result.commit = result.offer->choices[result.offer->chosen].edit;
  result.as_drawn.reset();  // it fits only the line itself
}

ToolResult PencilTool::end(const Scene& scene) {
  ToolResult result;
  InkConnections to = connections(scene);
  std::optional<Stroke> drawn;
  const std::span<const InkSample> landed = landing_.end();
  if (!landed.empty()) restart_straight(landed);
  add_landed(landed);
  if (hold_.is_meant()) drawn = straight_line(to);
  const bool is_free = !drawn;
  if (is_free) drawn = free_line();
  result.commit = edit_of(drawn, to, scene);
  if (result.commit && steady_ && is_free) {
    const std::optional<Edit> raw = edit_of(line_of(steady_->raw()), to, scene);
    if (raw) result.as_drawn = replaced_line(*result.commit, *raw);
  }
  add_offer(result, scene);
  std::optional<StrokeId> drawn_id;
  if (result.commit) {
    for (const StrokeChange& change : result.commit->changes) {
      if (change.after) drawn_id = change.id;
    }
  }
  snap_.end(drawn_id);
  return result;
}

InkConnections PencilTool::connections(const Scene& scene) const {
  InkConnections to{.keep_separate = settings_.keep_separate};
  if (!snaps(settings_.snap.mode)) return to;
  const auto& start = snap_.start_target();
  const auto& end = snap_.target();
  if (start && is_still_there(*start, scene.document)) {
    if (start->on_curve) {
      to.start_meets = start->point;
    } else {
      to.start = start->tip;
    }
  }
  if (end && is_still_there(*end, scene.document)) {
    to.closes = end->is_own_start();
    if (end->on_curve) {
      to.end_meets = end->point;
    } else if (!to.closes) {
      to.end = end->tip;
    }
  }
  return to;
}

std::optional<OfferView> PencilTool::offered() const {
  if (!in_gesture() || shapes_.shapes().empty()) return std::nullopt;
  OfferView view{pen_point_, {}, shapes_.accepted().value_or(shapes_.shapes().size())};
  for (const ShapeGuess& shape : shapes_.shapes()) view.rows.push_back({offer_of(shape.form), 0});
  view.rows.push_back({OfferKind::kInk, 0});
  return view;
}

void PencilTool::choose(OfferKind kind) {
  if (in_gesture()) shapes_.accept(kind);
}

void PencilTool::drop() {
  hold_.reset();
  snap_.end(std::nullopt);
}

void PencilTool::stop_hovering() {
  hold_.reset();
  snap_.end(std::nullopt);
  near_ = false;
}

void PencilTool::take_options(const OptionValues& options) {
  settings_ = pencil_settings(options);
  fitter_.reset();
}

double PencilTool::retrace_n() const {
  return settings_.retrace_n * weak_share(settings_.strength);
}

std::optional<SnapTarget> PencilTool::attraction() const noexcept {
  return is_waiting() ? std::nullopt : snap_.attraction();
}

ForceModel PencilTool::force(const Scene& scene) const {
  const auto held_at = in_gesture() ? shapes_.holds_at() : std::nullopt;
  const PenPace pace = snap_.rests() ? PenPace::kRests : PenPace::kPasses;
  return make_pencil_force(settings_, scene, attraction(), held_at, pace);
}

void PencilTool::draw_shapes(Overlay& overlay) const {
  const auto& shapes = shapes_.shapes();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes_.accepted() && shapes_.accepted() != i) continue;
    const std::optional<Stroke> stroke = shape_ink(shapes[i]);
    if (!stroke) continue;
    const int end = stroke->segment_count();
    if (!shapes_.accepted()) {
      // The best shape stands out, because it is the one that pressing takes.
      add_span(overlay, *stroke, 0.0, end, i == 0 ? Overlay::Role::kSnap : Overlay::Role::kGuide);
      continue;
    }
    const WidthKnot knot = stroke->widths().front();
    for (int s = 0; s < end; ++s) {
      overlay.ink.push_back(
          {stroke->segment(s), knot.width_mm, knot.width_mm, knot.tone, knot.tone});
    }
  }
}

/// Draws the samples that are not yet in the fitter.
void PencilTool::draw_ahead(Overlay& overlay) const {
  std::vector<InkSample> ahead = landing_.held();
  if (steady_) {
    const auto held = steady_->held();
    ahead.insert(ahead.begin(), held.begin(), held.end());
  }
  wet_.draw_ahead(ahead, overlay);
}

void PencilTool::draw(Overlay& overlay) const {
  if (in_gesture()) {
    overlay.ink_color = color_;
    if (hold_.is_meant()) {
      straight_.draw(straight_.start(),
                     hold_.has_second() ? straight_.pen_in_steps() : straight_.pen(), overlay);
    } else if (!shapes_.accepted()) {
      wet_.draw(*fitter_, overlay);
      draw_ahead(overlay);
      if (settings_.stabiliser.kind != StabiliserKind::kOff) {
        overlay.lines.push_back({pen_point_, stabiliser_.nib(), Overlay::Role::kTether});
      }
    }
  }
  if (in_gesture()) draw_shapes(overlay);
  if (is_waiting() || !(in_gesture() || near_) || (in_gesture() && !shapes_.shapes().empty()))
    return;
  const SnapOptions& snap = settings_.snap;
  if (const auto felt = attraction()) {
    overlay.rings.push_back({felt->point, snap.reach_mm, Overlay::Role::kReach});
  }
  if (!snaps(snap.mode)) return;
  for (const auto& target : {snap_.start_target(), snap_.target()}) {
    if (target) overlay.rings.push_back({target->point, snap.radius_mm, Overlay::Role::kSnap});
  }
}

std::optional<ToolSize> PencilTool::size() const {
  const double thin = options().number(PencilOption::Row::kMinWidth);
  const double broad = std::max(thin, options().number(PencilOption::Row::kMaxWidth));
  const double mm = thin + (broad - thin) * share_of_mouse(options());
  const OptionSpec& spec = kPencilOptions[PencilOption::Row::kMaxWidth];
  // The size covers half of the range, so that the broadest line can scale with it. The options
  // themselves may be set beyond that.
  return ToolSize{mm, std::min(spec.min, mm), std::max(0.5 * spec.max, mm)};
}

std::vector<std::pair<std::string_view, double>> PencilTool::options_for_size(double mm) const {
  const std::optional<ToolSize> now = size();
  const double wanted = std::clamp(mm, now->min_mm, now->max_mm);
  const OptionSpec& smallest = kPencilOptions[PencilOption::Row::kMinWidth];
  const OptionSpec& largest = kPencilOptions[PencilOption::Row::kMaxWidth];
  const double share = share_of_mouse(options());
  const double thin = std::clamp(options().number(PencilOption::Row::kMinWidth) * wanted / now->mm,
                                 smallest.min, std::min(wanted, smallest.max));
  const double broad = share > 0.0
                           ? thin + (wanted - thin) / share
                           : options().number(PencilOption::Row::kMaxWidth) * wanted / now->mm;
  return {{smallest.id, thin},
          {largest.id, std::clamp(broad, std::max(thin, largest.min), largest.max)}};
}

}  // namespace felt
