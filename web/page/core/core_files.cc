#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/formats/copied_ink.h"
#include "felt/io/events/event_writer.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/render/page_painter.h"
#include "felt/session/layer_edit.h"
#include "web/page/core/api_state.h"

namespace felt::page {

// --- Autosave: a drawing, the base, and the events of the session since then.

/// Appends an event to the records. An undo below the base, and an import, whose file is not
/// recorded, cannot be played again; then the next autosave() makes a new base.
void Core::record(const Event& event) {
  if (std::holds_alternative<ImportEvent>(event.what)) {
    needs_rebase_ = true;
    return;
  }
  append_event_line(written_, event);
  const bool moves = std::holds_alternative<UndoEvent>(event.what) ||
                     std::holds_alternative<RedoEvent>(event.what);
  const std::uint64_t position = studio.session().history().position();
  if (moves && (position < base_position_ || position_ < base_position_)) needs_rebase_ = true;
  position_ = position;
}

/// Makes the present drawing the base. The records begin with the events that set everything else.
void Core::rebase() {
  const Session& session = studio.session();
  base = base_of(studio);
  written_.clear();
  const std::int64_t now = studio.now_ns();
  append_event_line(written_, {now, UseDevice{session.device(), session.option_defaults()}});
  for (const std::string& id : session.option_ids()) {
    const Result<OptionValue> value = session.option(id);
    if (value) append_event_line(written_, {now, SetOption{id, *value}});
  }
  append_event_line(written_, {now, SelectTool{std::string(session.tool().info().id)}});
  const Layer* layer = session.document().layer(session.layer());
  if (layer && is_open(*layer)) {  // otherwise no layer is open
    append_event_line(written_, {now, LayerEvent{LayerEvent::Do::kUse, layer->id}});
  }
  base_position_ = position_ = session.history().position();
  replaces_ = true;
}

bool Core::autosave() {
  const Session& session = studio.session();
  constexpr std::size_t kLong = std::size_t{16} << 20;
  static std::size_t since_base = 0;
  // The first module cannot write a drawing; core.js keeps all its records.
  const bool is_new = !session.history().can_undo() && !session.history().can_redo();
  const bool can_rebase = is_full_module() || is_new;
  if ((needs_rebase_ || since_base > kLong) && can_rebase && !session.gesture_in_progress()) {
    rebase();
    since_base = 0;
    // A selection is not in the base, so that commands that use it could not be played again.
    needs_rebase_ = !session.selection().empty();
  }
  since_base += written_.size();
  recorded += std::exchange(written_, {});
  return std::exchange(replaces_, false);
}

Result<void> Core::restore(std::string_view base_bytes, std::string_view lines) {
  Drawing drawing;
  if (!base_bytes.empty()) {
    Result<Drawing> read = drawing_of_base(base_bytes);
    if (!read) return tl::unexpected(read.error());
    drawing = *std::move(read);
  }
  const std::string text(lines);
  std::vector<Event> events;
  ScriptSink sink;
  sink.event = [&events](const Event& event) -> Result<void> {
    events.push_back(event);
    return {};
  };
  // What was read before a damaged line, such as the last one of a crash, is restored.
  Result<void> done = read_script("autosave", read_text(text), sink);
  Result<void> played = studio.restore(drawing, events);
  begin_session(drawing);
  base_position_ = 0;
  if (done && played) {
    base = base_bytes;
    written_.clear();
    replaces_ = needs_rebase_ = false;
    studio.complete_options(events);
    return {};
  }
  needs_rebase_ = true;
  return done ? played : done;
}

// --- Files

/// Shows the document of the session that has just begun.
void Core::begin_session(const Drawing& drawing) {
  static_cast<void>(drawing);
  picture.open(studio.session().document());
  sound_input_.follow(studio.session());
  update_grain();
  set_ground();
  shows = has_edits_ = true;
}

namespace {

/// Reads the drawing of a file, and adds what was left out to `notices`.
Result<Drawing> named_drawing(std::string_view bytes, const std::string& name,
                              std::vector<std::string>& notices) {
  Result<Imported> read = read_drawing(bytes, name);
  if (!read) return fail(read.error().code, name + ": " + read.error().message);
  for (const ImportNotice& notice : read->report.notices()) notices.push_back(notice_text(notice));
  return std::move(read->drawing);
}

}  // namespace

Result<void> Core::open(std::string_view bytes, const std::string& name,
                        std::vector<std::string>& notices) {
  Result<Drawing> drawing = named_drawing(bytes, name, notices);
  if (!drawing) return tl::unexpected(drawing.error());
  if (!drawing->has_page) {
    const Page page = studio.page();
    drawing->page.width_mm = page.width_mm;
    drawing->page.height_mm = page.height_mm;
  }
  if (!studio.open(*drawing)) {
    notices.push_back("The surface “" + drawing->page.surface +
                      "” is not installed, so the previous surface is used.");
  }
  begin_session(*drawing);
  needs_rebase_ = true;
  return {};
}

Result<void> Core::add(std::string_view bytes, const std::string& name, Vec by_mm, bool is_middle,
                       std::vector<std::string>& notices) {
  const Result<Drawing> drawing = named_drawing(bytes, name, notices);
  if (!drawing) return tl::unexpected(drawing.error());
  shows = true;
  for (const std::string& label : studio.add_materials(drawing->materials)) {
    notices.push_back("“" + label +
                      "” differs here: the added strokes look as it does in this drawing");
  }
  for (std::string& text : losses_of_adding(*drawing)) notices.push_back(std::move(text));
  const Rect box = ink_bounds(drawing->document);
  if (is_middle && !box.empty()) {
    by_mm = by_mm - 0.5 * Vec{box.x0 + box.x1, box.y0 + box.y1};
  }
  const VisibleInk ink = moved_ink(visible_ink(drawing->document), by_mm);
  return studio.import(name, ink.strokes, ink.fills);
}

Result<std::string> Core::copied(bool is_whole, double dpi) {
  const Session& session = studio.session();
  const Selection& selection = session.selection();
  const Drawing drawing = copied_drawing(session, [&](StrokeId id) {
    return is_whole ? selection.is_whole(id) : selection.empty() || selection.find(id) != nullptr;
  });
  exported.reset();
  const Rect ink = ink_bounds(drawing.document);
  if (ink.empty()) return std::string();
  constexpr double kMarginMm = 1.0, kMaxPixels = 16e6;
  const double area_mm2 = (ink.width() + 2.0 * kMarginMm) * (ink.height() + 2.0 * kMarginMm);
  PageOptions options{.margin_mm = kMarginMm, .paper = {0, 0, 0, 0}, .grain = picture.grain()};
  options.dpi = std::min(dpi, 25.4 * std::sqrt(kMaxPixels / area_mm2));
  Result<Image> image = render_page(drawing.document, options, PictureChoice::kMarked);
  if (image) exported = *std::move(image);
  return svg_text(drawing, {.margin_mm = kMarginMm});
}

Result<std::string> Core::save(std::string_view format, std::vector<std::string>& losses) {
  const Drawing drawing = drawing_of(studio);
  losses = losses_of_writing(drawing, format);
  return write_drawing(drawing, format);
}

void Core::clear() {
  Drawing empty;
  empty.page = studio.page();
  studio.open(empty);
  begin_session(empty);
  needs_rebase_ = true;
}

Result<void> Core::replay(std::string_view script, const ReplayChoice& choice) {
  Result<Document> document = page::replay(script, choice);
  if (!document) return tl::unexpected(document.error());
  Drawing drawing;
  drawing.document = *std::move(document);
  drawing.page = studio.page();
  studio.open(drawing);
  begin_session(drawing);
  needs_rebase_ = true;
  return {};
}

}  // namespace felt::page
