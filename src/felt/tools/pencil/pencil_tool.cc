#include "felt/tools/pencil/pencil_tool.h"

#include <cmath>
#include <utility>

#include "felt/tools/medium_line.h"
#include "felt/tools/pencil/pencil_force.h"

namespace felt {
namespace {

constexpr ToolInfo kPencilInfo{.id = "pencil",
                               .label = "Pencil",
                               .help = "Draws lines; pressing harder draws them broader.",
                               .shortcut = 'p',
                               .options = kPencilOptions};

/// True when the fitter could take it.
bool is_drawable(const PenSample& sample) {
  return is_finite(sample.position) && is_in_range(Point{sample.position.x, sample.position.y});
}

}  // namespace

std::unique_ptr<Tool> make_pencil() {
  return std::make_unique<PencilTool>();
}

PencilTool::PencilTool() : options_(kPencilOptions), settings_(pencil_settings(options_)) {
  gap_.reserve(Contact::kMaxGapSamples);
}

const ToolInfo& PencilTool::info() const noexcept {
  return kPencilInfo;
}

ToolResult PencilTool::sample(const PenSample& sample, const Scene& scene) {
  if (!is_drawable(sample)) return {};
  pen_point_ = on_sheet(sample.position);
  const Contact::Change change = contact_.update(sample);
  if (change == Contact::Change::kNone && !contact_.is_down()) waiting_ = false;
  if (change == Contact::Change::kTouched && !waiting_) begin(sample, scene);
  if (change == Contact::Change::kLifted) {
    waiting_ = false;
    if (drawing_) return end(scene);
  }
  if (drawing_) {
    add(sample, scene);
  } else if (!contact_.is_down()) {
    hover(sample, scene);
  }
  return {};
}

void PencilTool::hover(const PenSample& sample, const Scene& scene) {
  near_ = sample.position.z < (near_ ? kFarMm : kNearMm);
  snap_.hover(pen_point_, sample.time_ns, near_, settings_.snap, scene);
}

void PencilTool::begin(const PenSample& sample, const Scene& scene) {
  make_fitter(scene);
  fitter_->begin();
  wet_.begin(fitted_widths_);
  stabiliser_ = Stabiliser(settings_.stabiliser);
  stabiliser_.begin(pen_point_, sample.time_ns);
  color_ = scene.color;
  gap_.clear();

  snap_.begin(pen_point_, sample.time_ns, settings_.snap, scene);
  drawing_ = true;
}

/// The fitter keeps its buffers from line to line, and what it was made with.
void PencilTool::make_fitter(const Scene& scene) {
  const InkFitOptions ink = drawn_with(medium_of(scene, settings_.material), settings_.ink);
  if (fitter_ && fitted_widths_ == ink.width_map) return;
  fitter_ = std::make_unique<InkFitter>(ink);
  fitted_widths_ = ink.width_map;
}

void PencilTool::add(const PenSample& sample, const Scene& scene) {
  const Pressing pressing(scene.surface, scene.device);
  const InkSample ink{on_sheet(sample.position), pressing.of(sample), sample.time_ns,
                      sample.lean_deg};
  if (!in_contact(sample)) {
    gap_.push_back(ink);
    return;
  }
  for (const InkSample& between : gap_) add_ink(between);
  gap_.clear();
  add_ink(ink);
  pen_ = ink;
  snap_.update(pen_point_, sample.time_ns, settings_.snap, scene);
}

void PencilTool::add_ink(const InkSample& pen) {
  InkSample ink = pen;
  ink.position = stabiliser_.update(pen.position, *pen.time_ns);
  fitter_->push(ink);
  wet_.update(*fitter_, ink);
}

ToolResult PencilTool::end(const Scene& scene) {
  std::vector<Stabiliser::Step> rest;
  stabiliser_.finish(rest);
  for (const Stabiliser::Step& step : rest) {
    fitter_->push({step.nib, pen_.pressure, step.time_ns, pen_.lean_deg});
  }
  fitter_->end();
  if (settings_.refine && fitter_->samples().size() <= kMaxRefinedSamples) fitter_->refine();

  ToolResult result;
  if (const auto drawn = fitter_->stroke()) {
    StrokeData data = drawn->data();
    data.material = settings_.material;
    data.color = color_;
    // Still valid: neither material nor colour is part of an invariant.
    if (const auto ink = Stroke::create(std::move(data))) {
      result.commit = connect_ink(*ink, connections(scene), scene);
    }
  }
  std::optional<StrokeId> drawn_id;
  if (result.commit) {
    for (const StrokeChange& change : result.commit->changes) {
      if (change.after) drawn_id = change.id;
    }
  }
  stop();
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

void PencilTool::stop() {
  drawing_ = false;
  gap_.clear();
  snap_.end(std::nullopt);
  take_options();
}

void PencilTool::take_options() {
  if (!has_new_options_) return;
  has_new_options_ = false;
  settings_ = pencil_settings(options_);
  fitter_.reset();
}

ToolResult PencilTool::finish(const Scene& scene) {
  // The next sample may come from anywhere, at any time. In a gap the pen was lifted.
  waiting_ = waiting_ || (contact_.is_down() && gap_.empty());
  contact_ = {};
  if (drawing_) return end(scene);
  snap_.end(std::nullopt);
  near_ = false;
  return {};
}

void PencilTool::cancel() {
  waiting_ = contact_.is_down();
  stop();
}

std::optional<SnapTarget> PencilTool::attraction() const noexcept {
  return waiting_ ? std::nullopt : snap_.attraction();
}

ForceModel PencilTool::force(const Scene& scene) const {
  return make_pencil_force(settings_, scene, attraction());
}

void PencilTool::draw(Overlay& overlay) const {
  if (drawing_) {
    overlay.ink_color = color_;
    wet_.draw(*fitter_, overlay);
    if (settings_.stabiliser.kind != StabiliserKind::kOff) {
      overlay.lines.push_back({pen_point_, stabiliser_.nib(), Overlay::Role::kTether});
    }
  }
  if (waiting_ || !(drawing_ || near_)) return;
  const SnapOptions& snap = settings_.snap;
  if (const auto felt = attraction()) {
    overlay.rings.push_back({felt->point, snap.reach_mm, Overlay::Role::kReach});
  }
  if (!snaps(snap.mode)) return;
  for (const auto& target : {snap_.start_target(), snap_.target()}) {
    if (target) overlay.rings.push_back({target->point, snap.radius_mm, Overlay::Role::kSnap});
  }
}

Result<void> PencilTool::set_option(std::string_view id, const OptionValue& value) {
  auto result = options_.set(id, value);
  if (result) has_new_options_ = true;
  if (!drawing_) take_options();
  return result;
}

Result<OptionValue> PencilTool::option(std::string_view id) const {
  return options_.get(id);
}

}  // namespace felt
