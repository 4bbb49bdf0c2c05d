// The functions of Studio for the materials, and for the page, because the page names its surface.
#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "desktop/engine/studio.h"
#include "desktop/engine/usual_color.h"

namespace felt::desktop {
namespace {

bool is_same_one(const AnyMaterial& a, const AnyMaterial& b) {
  return a.index() == b.index() && id_of(a) == id_of(b);
}

/// Returns the material of the same kind and id, or nullopt.
std::optional<AnyMaterial> find_in(const Materials& materials, const AnyMaterial& like) {
  if (std::holds_alternative<SurfaceMaterial>(like)) {
    const SurfaceMaterial* surface = materials.find_surface(id_of(like));
    return surface ? std::optional<AnyMaterial>(*surface) : std::nullopt;
  }
  const Medium* medium = materials.find_medium(id_of(like));
  return medium ? std::optional<AnyMaterial>(*medium) : std::nullopt;
}

/// Returns true if the material is not one of Feltline's own: the user made it, or it came with
/// the drawing.
bool is_own(const std::optional<AnyMaterial>& material) {
  return material && find_in(Materials::built_in(), *material) != material;
}

/// Returns the paper colour of a page whose surface changed. `before` is null if it is unknown.
Rgba paper_on(const SurfaceMaterial& now, Rgba paper, const SurfaceMaterial* before) {
  const auto was = before ? std::optional(before->color_rgb) : std::nullopt;
  return usual_color(paper, was, now.color_rgb, Page{}.paper);
}

}  // namespace

/// A material that the user changed takes precedence over one that came with the drawing.
void Studio::set_user_materials(const Materials& known) {
  const Materials before = std::exchange(options_.materials, known);
  for (const AnyMaterial& own : not_built_in(known)) {
    if (find_in(before, own) == own) continue;
    std::erase_if(of_drawing_, [&](const AnyMaterial& other) { return is_same_one(own, other); });
    const std::optional<AnyMaterial> old = find_in(session_->materials(), own);
    if (old == own || !apply(UseMaterial{write_material(own)})) continue;
    if (is_drawn_with(own)) set_modified(true);
    update_paper(old, own);
  }
  gather_materials();
  Q_EMIT materials_changed();
}

/// Updates the paper after the colour of the page's surface changed.
void Studio::update_paper(const std::optional<AnyMaterial>& before, const AnyMaterial& now) {
  const auto* old = before ? std::get_if<SurfaceMaterial>(&*before) : nullptr;
  const auto* surface = std::get_if<SurfaceMaterial>(&now);
  if (!old || !surface || surface->id != page_.surface || old->color_rgb == surface->color_rgb)
    return;
  const Rgba paper = paper_on(*surface, page_.paper, old);
  if (std::exchange(page_.paper, paper) != paper) Q_EMIT page_changed();
}

/// Returns true if other figures of the material would make the drawing look or feel different.
bool Studio::is_drawn_with(const AnyMaterial& material) const {
  const Document& document = session_->document();
  if (document.stroke_count() == 0) return false;  // an empty drawing cannot change
  if (std::holds_alternative<SurfaceMaterial>(material)) {
    return session_->surface().id == id_of(material);
  }
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (document.find(id)->medium() == id_of(material)) return true;
    }
  }
  return false;
}

/// Applies the material to the session and adds it to the materials that can be chosen.
void Studio::add_material(const std::string& text) {
  Result<AnyMaterial> material = read_material(text);
  if (!material || find_in(options_.materials, *material) == *material) return;
  std::erase_if(of_drawing_, [&](const AnyMaterial& old) { return is_same_one(old, *material); });
  of_drawing_.push_back(*std::move(material));
  gather_materials();
  Q_EMIT materials_changed();
}

void Studio::add_materials_of_drawing(std::span<const std::string> texts) {
  QStringList others;
  for (const std::string& text : texts) {
    Result<AnyMaterial> material = read_material(text);
    const std::optional<AnyMaterial> known =
        material ? find_in(session_->materials(), *material) : std::nullopt;
    if (known && known == *material) continue;
    const Result<void> done = session_->apply({event_time_ns(), UseMaterial{text}});
    if (!done) {
      Q_EMIT refused(QString::fromStdString(done.error().message));
      continue;
    }
    if (is_own(known)) others.push_back(QString::fromStdString(label_of(*known)));
    of_drawing_.push_back(*std::move(material));
  }
  gather_materials();
  if (others.isEmpty()) return;
  Q_EMIT refused(tr("This drawing has its own values for: %1. Your materials are unchanged.")
                     .arg(others.join(QStringLiteral(", "))));
}

std::vector<std::string> Studio::add_media(std::span<const std::string> texts,
                                           std::span<const StrokePtr> strokes) {
  std::set<std::string_view> named;
  for (const StrokePtr& stroke : strokes) named.insert(stroke->medium());
  drain();
  std::set<std::string> others;
  bool is_news = false;
  for (const std::string& text : texts) {
    Result<AnyMaterial> material = read_material(text);
    if (!material || !std::holds_alternative<Medium>(*material)) continue;
    if (!named.contains(id_of(*material))) continue;
    if (const std::optional<AnyMaterial> known = find_in(session_->materials(), *material)) {
      if (known != *material) others.insert(label_of(*material));
      continue;
    }
    if (!session_->apply({event_time_ns(), UseMaterial{text}})) continue;
    of_drawing_.push_back(*std::move(material));
    is_news = true;
  }
  if (is_news) {
    gather_materials();
    Q_EMIT materials_changed();
  }
  return {others.begin(), others.end()};
}

void Studio::gather_materials() {
  materials_ = options_.materials;
  for (const AnyMaterial& brought : of_drawing_) put(materials_, brought);
}

void Studio::set_page(const Page& page) {
  if (page == page_) return;
  drain();
  const bool has_other_surface = apply_page(page);
  publish();
  set_modified(true);
  if (has_other_surface) Q_EMIT option_changed(QLatin1String(kSurfaceOptionId));
  Q_EMIT page_changed();
}

/// Sets the page, and sets the session's surface to the surface that the page names. Returns true
/// if the surface changed.
bool Studio::apply_page(const Page& page) {
  page_ = page;
  const OptionValue wanted(page_.surface);
  if (page_.surface.empty() || session_->option(kSurfaceOptionId).value_or(wanted) == wanted) {
    return false;
  }
  if (session_->apply({event_time_ns(), SetOption{kSurfaceOptionId, wanted}})) return true;
  const auto id = QString::fromStdString(page_.surface);
  Q_EMIT refused(tr("The surface “%1” is not installed, so the previous surface is used.").arg(id));
  return false;
}

/// Changes the colour of new ink if it is the usual one of the medium on the old paper, and the
/// usual one on the new paper is another.
void Studio::update_ink(Rgba before, Rgba now) {
  const Medium* medium = session_->materials().find_medium(drawing_medium(*session_));
  if (!medium) return;
  const Rgba ink = session_->ink_color();
  const Rgba wanted = with_rgb(ink, ink_color_on(medium->color_rgb, rgb_of(now)));
  if (ink != with_rgb(ink, ink_color_on(medium->color_rgb, rgb_of(before))) || ink == wanted)
    return;
  if (session_->apply({event_time_ns(), SetOption{"ink.color", color_to_text(wanted)}})) {
    Q_EMIT option_changed(QStringLiteral("ink.color"));
  }
}

/// Stores the surface that the user has chosen, and its colour, in the page.
void Studio::set_surface_of_page() {
  const SurfaceMaterial& surface = session_->surface();
  const std::string before = std::exchange(page_.surface, surface.id);
  if (before == page_.surface) return;
  const Rgba paper = paper_on(surface, page_.paper, session_->materials().find_surface(before));
  update_ink(page_.paper, paper);
  const bool has_other_paper = std::exchange(page_.paper, paper) != paper;
  const bool is_other = !before.empty() || has_other_paper;
  if (is_other && session_->document().stroke_count() > 0) set_modified(true);
  Q_EMIT page_changed();
}

}  // namespace felt::desktop
