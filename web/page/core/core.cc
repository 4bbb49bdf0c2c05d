#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "desktop/engine/usual_color.h"
#include "felt/io/events/event_writer.h"
#include "felt/material/relief.h"
#include "felt/render/page_painter.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"
#include "felt/tools/guide_picture.h"
#include "web/page/core/api_state.h"

namespace felt::page {
namespace {

constexpr std::size_t kForceNumbers = 7;
constexpr std::size_t kMaxForces = 2000 * kForceNumbers;

Rgba rgb(unsigned value) {
  return {static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
          static_cast<std::uint8_t>(value), 255};
}

double opacity_of(const Session& session) {
  const Layer* layer = session.document().layer(session.layer());
  return layer ? layer->opacity * (layer->group ? layer->group->opacity : 1.0) : 1.0;
}

}  // namespace

Core::Core() : sound_input_(studio.session()) {
  picture.resize(800, 600);
  picture.open(studio.session().document());
  set_ground();
  listen();
  rebase();
}

void Core::listen() {
  studio.on_edit = [this](const Edit* edit) {
    has_edits_ = shows = true;
    if (edit) picture.apply(*edit);
  };
  studio.on_event = [this](const Event& event) { record(event); };
  studio.on_sample = [this](const PenSample& pen) {
    shows = true;
    if (!is_full_module() || !sounds_) return;
    sound_.push(sound_input_.sample(pen));
    if (!(sound_input_.pair() == pair_)) sound_.set_pair(pair_ = sound_input_.pair());
  };
  studio.on_tick = [this](const TickReport& tick) {
    if (forces.size() >= 2 * kMaxForces) {
      forces.erase(forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(kMaxForces));
    }
    const double ms = 1e-6 * static_cast<double>(studio.now_ns());
    for (const double n :
         {ms, tick.asked.x, tick.asked.y, tick.asked.z, tick.sent.x, tick.sent.y, tick.sent.z}) {
      forces.push_back(n);
    }
  };
}

// --- The picture

void Core::resize(double css_width, double css_height, double new_dpr) {
  dpr = std::clamp(new_dpr, 0.1, 10.0);
  width = css_width;
  height = css_height;
  picture.resize(static_cast<int>(std::lround(width * dpr)),
                 static_cast<int>(std::lround(height * dpr)));
  marks_changed_ = true;
}

void Core::set_view(double x_mm, double y_mm, double css_per_mm, double angle_deg, bool mirrored) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const Vec turn = angle == 0.0 ? Vec{1.0, 0.0} : Vec{std::cos(angle), std::sin(angle)};
  picture.set_view({{x_mm, y_mm}, css_per_mm * dpr, turn, mirrored});
  marks_changed_ = true;
}

void Core::set_ground() {
  picture.set_ground(studio.page(), desk);
}

void Core::set_paper(bool is_set, unsigned value) {
  Page page = studio.page();
  page.paper = rgb(is_set ? value : studio.session().surface().color_rgb);
  studio.set_page(page);
  has_edits_ = needs_rebase_ = true;  // the page is in the base only
  set_ground();
}

void Core::update_grain() {
  const Session& session = studio.session();
  if (!is_full_module()) return;
  picture.set_grain(wants_grain && is_warm
                        ? Grain(surface_grain(session.surface()), session.materials())
                        : Grain::solid(session.materials()));
}

void Core::warm_up() {
  if (std::exchange(is_warm, true)) return;
  update_grain();
  studio.begin_forces();
}

void Core::show() {
  if (!std::exchange(shows, false)) return;
  const Session& session = studio.session();
  const std::optional<Edit>& preview = session.preview_with_fills();
  picture.show(preview);
  session.draw(overlay_);
  if (studio.has_force()) session.draw_guide_spring(overlay_);
  picture.show_wet(overlay_, drawing_medium(session), opacity_of(session));
  marks.clear();
  if (is_full_module()) {
    add_guide_pictures(marks, session.document(), preview ? &*preview : nullptr,
                       studio.page().area());
  }
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(marks.rings, overlay_.rings);
  append(marks.lines, overlay_.lines);
  append(marks.spans, overlay_.spans);
  append(marks.outlines, overlay_.outlines);
  append(marks.dots, overlay_.dots);
  append(marks.labels, overlay_.labels);
  marks_changed_ = true;
}

std::size_t Core::export_picture(double dpi, bool transparent) {
  PageOptions options;
  options.dpi = std::clamp(dpi, 10.0, 1200.0);
  options.area = studio.page().area();
  options.paper = transparent ? Rgba{0, 0, 0, 0} : studio.page().paper;
  options.grain = picture.grain();
  Result<Image> image = render_page(studio.session().document(), options, PictureChoice::kMarked);
  exported.reset();
  if (!image) return 0;
  exported = *std::move(image);
  return exported->bytes().size();
}

// --- Events

Result<void> Core::event(std::string_view json) {
  // The reader needs the time of the line; the studio sets that of the event.
  std::string line(json);
  const std::size_t brace = line.find('{');
  if (brace != std::string::npos && line.find("\"t_ms\"") == std::string::npos) {
    line.insert(brace + 1, "\"t_ms\":0,");
  }
  std::optional<Event> event;
  ScriptSink sink;
  sink.event = [&event](const Event& read) -> Result<void> {
    event = read;
    return {};
  };
  if (Result<void> read = read_script("event", read_text(line), sink); !read) return read;
  if (!event) return fail(ErrorCode::kInvalidArgument, "is not an event");
  const bool is_of_look = std::holds_alternative<SetOption>(event->what) ||
                          std::holds_alternative<UseMaterial>(event->what);
  Result<void> done = studio.apply(std::move(event->what));
  shows = true;
  if (is_of_look) {
    update_grain();
    set_ground();
  }
  return done;
}

Result<void> Core::set_medium(const std::string& id) {
  const Session& session = studio.session();
  const Medium* medium = session.materials().find_medium(id);
  if (!medium || !medium->draws) return fail(ErrorCode::kNotFound, "no medium " + id);
  const Medium* before = session.materials().find_medium(drawing_medium(session));
  const Rgba ink = desktop::usual_color(
      session.ink_color(), before ? std::optional(before->color_rgb) : std::nullopt,
      ink_color_on(medium->color_rgb, session.surface().color_rgb), Rgba{});
  const std::vector<SetOption> options = options_for_medium(session, *medium);
  Result<void> done;
  for (const SetOption& option : options) {
    if (done) done = studio.apply(option);
  }
  if (done) done = studio.apply(SetOption{"ink.color", color_to_text(ink)});
  shows = true;
  return done;
}

Result<void> Core::set_size(double mm) {
  const Tool& tool = studio.session().tool();
  const std::string prefix = std::string(tool.info().id) + ".";
  Result<void> done;
  for (const auto& [id, value] : tool.options_for_size(mm)) {
    if (done) done = studio.apply(SetOption{prefix + std::string(id), value});
  }
  shows = true;
  return done;
}

void Core::advance(std::int64_t time_ns) {
  const bool was_playing = studio.is_playing();
  studio.end_frame(time_ns);
  if (was_playing) {
    update_grain();
    set_ground();
  }
}

unsigned Core::changes() {
  show();
  unsigned bits = 0;
  if (picture.is_stale()) bits |= kInk;
  if (std::exchange(marks_changed_, false)) bits |= kMarks;
  if (std::exchange(has_edits_, false)) bits |= kEdits;
  if (studio.has_refusal()) bits |= kRefusal;
  std::string state = state_text(studio);
  if (state != last_state_) {
    bits |= kState;
    last_state_ = std::move(state);
  }
  return bits;
}

// --- Forces and sound

/// Moves the numbers of the ticks to the reply.
std::size_t Core::take_forces() {
  if (forces.size() > kMaxForces) {
    forces.erase(forces.begin(), forces.end() - static_cast<std::ptrdiff_t>(kMaxForces));
  }
  reply.assign(reinterpret_cast<const char*>(forces.data()), forces.size() * sizeof(double));
  forces.clear();
  return reply.size();
}

std::size_t Core::render_sound(std::size_t frames) {
  if (!std::exchange(sounds_, true)) warm_up();
  std::vector<float> block(std::min<std::size_t>(frames, 48000));
  sound_.keep_up(0.030);
  sound_.render(block);
  if (sound_.is_silent()) block.clear();
  reply.assign(reinterpret_cast<const char*>(block.data()), block.size() * sizeof(float));
  return reply.size();
}

}  // namespace felt::page
