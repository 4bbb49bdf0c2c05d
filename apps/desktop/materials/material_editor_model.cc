#include "desktop/materials/material_editor_model.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "desktop/engine/tool_texts.h"
#include "desktop/engine/usual_color.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/materials/media_picker.h"
#include "felt/base/atomic_file.h"
#include "felt/io/picture/png.h"
#include "felt/material/custom_relief.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_library.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

template <class Field>
bool set_field(const Field* field, auto& material, double value) {
  if (!field || !field->allows(value)) return false;
  field->set(material, value);
  return true;
}

bool set_in(AnyMaterial& material, std::string_view field, double value) {
  auto* surface = std::get_if<SurfaceMaterial>(&material);
  if (surface) return set_field(find_surface_field(field), *surface, value);
  return set_field(find_medium_field(field), std::get<Medium>(material), value);
}

/// Adjusts the figures that depend on `field`, so that the material stays valid for the file.
void make_fit(AnyMaterial& material, std::string_view field) {
  constexpr double kFirstGrainMm = 1.0;
  if (auto* medium = std::get_if<Medium>(&material)) {
    MediumLine& line = medium->line;
    if (field == "line.min_mm") line.max_mm = std::max(line.max_mm, line.min_mm);
    if (field == "line.max_mm") line.min_mm = std::min(line.min_mm, line.max_mm);
  } else if (auto* surface = std::get_if<SurfaceMaterial>(&material)) {
    if (surface->grain_um > 0.0 && !(surface->grain_mm > 0.0)) surface->grain_mm = kFirstGrainMm;
  }
}

bool lacks_picture(const AnyMaterial& material) {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface && surface->grain_character == HeightCharacter::kPicture && !surface->picture;
}

QString label_of_field(const AnyMaterial& material, std::string_view field) {
  if (std::holds_alternative<SurfaceMaterial>(material)) {
    const SurfaceField* row = find_surface_field(field);
    return row ? translated(row->label) : QString();
  }
  const MediumField* row = find_medium_field(field);
  return row ? translated(row->label) : QString();
}

/// Returns `figures` with the id and name of `names`.
AnyMaterial with_names_of(AnyMaterial figures, const AnyMaterial& names) {
  std::visit(
      [&](auto& of) {
        of.id = id_of(names);
        of.label = label_of(names);
      },
      figures);
  return figures;
}

constexpr int kReportMs = 100;  // interval of the events while the user drags a slider

}  // namespace

/// A step of undo, from one state of a material to another. If the material does not exist in the
/// first or second state, the step adds or removes it.
class MaterialEditorModel::Step final : public QUndoCommand {
 public:
  Step(MaterialEditorModel& model, const QString& words, State before, State after)
      : QUndoCommand(words), model_(model), before_(std::move(before)), after_(std::move(after)) {}

  /// Sets the field and the run. Consecutive steps of the same field and run are merged into one.
  void set_run(std::string_view field, std::uint64_t run) {
    field_ = field;
    run_ = run;
  }
  /// Marks the step as one that deletes a material and its file.
  void set_deletes() { fate_ = FileFate::kGoes; }

  [[nodiscard]] int id() const override { return 1; }
  void redo() override { model_.go(before_, after_, fate_); }
  void undo() override { model_.go(after_, before_, FileFate::kStays); }

  bool mergeWith(const QUndoCommand* later) override {
    const auto* next = static_cast<const Step*>(later);
    if (run_ == 0 || next->run_ != run_ || next->field_ != field_) return false;
    if (next->after_.selected != after_.selected) return false;
    if (next->after_.compared.chosen != after_.compared.chosen) return false;
    after_ = next->after_;
    setObsolete(before_.material && before_ == after_);
    return true;
  }

 private:
  MaterialEditorModel& model_;
  State before_, after_;
  std::string field_;
  std::uint64_t run_ = 0;
  FileFate fate_ = FileFate::kStays;
};

MaterialEditorModel::MaterialEditorModel(Studio& studio, UserMaterials& own, QObject* parent)
    : QObject(parent), studio_(studio), own_(own) {
  key_.id = studio_.session().surface().id;
  for (const UserMaterials::Entry* entry : own_.all()) {
    const std::optional<AnyMaterial> here = find_in(studio_.materials(), key_of(entry->now));
    if (here == entry->now) felt::put(reported_, entry->now);
  }
  report_.setSingleShot(true);
  report_.setInterval(kReportMs);
  connect(&report_, &QTimer::timeout, this, &MaterialEditorModel::report_now);
  connect(&own_, &UserMaterials::changed, this, [this](const MaterialKey& key) {
    if (!report_.isActive()) report_.start();
    if (key == key_) Q_EMIT changed();
  });
  connect(&studio_, &Studio::opened, this, &MaterialEditorModel::follow_drawing);
}

void MaterialEditorModel::report_now() {
  report_.stop();
  const Medium* before = studio_.materials().find_medium(drawing_medium(studio_.session()));
  const Medium medium = before ? *before : Medium{};
  Materials known = Materials::built_in();
  is_withheld_ = false;
  for (const UserMaterials::Entry* entry : own_.all()) {
    const MaterialKey key = key_of(entry->now);
    if (own_of(key)) {
      felt::put(known, entry->now);
      continue;
    }
    // The user's material would take precedence over the drawing's, so it is not passed on.
    is_withheld_ = true;
    if (std::optional<AnyMaterial> old = find_in(reported_, key)) felt::put(known, *std::move(old));
  }
  reported_ = known;
  studio_.set_user_materials(known);
  // The tool copied the widths of the medium when the medium was selected, so they must be updated
  // if the medium's widths have changed. If new ink has the medium's colour, it gets the colour
  // that the user has just chosen in the editor.
  const Medium* after = studio_.materials().find_medium(drawing_medium(studio_.session()));
  if (!before || !after) return;
  const Rgba ink = studio_.session().ink_color();
  const Rgba own = usual_color({}, {}, medium.color_rgb, {});
  const Rgba wanted = usual_color(ink, medium.color_rgb, after->color_rgb, own);
  if (after->line != medium.line) take_medium(studio_, after->id);
  if (wanted != ink) studio_.apply(SetOption{kInkColorId, color_to_text(wanted)});
}

MaterialEditorModel::~MaterialEditorModel() {
  steps_.blockSignals(true);  // its destructor removes the steps, and would report that
}

/// Updates the selection and the list of user-defined materials after another drawing was opened. A
/// user-defined material can be used only if the drawing has no other material with its id, so a
/// new drawing may change which ones are in use.
void MaterialEditorModel::follow_drawing() {
  if (is_withheld_) report_now();
  if (!own_of(key_) && !find_in(studio_.materials(), key_)) {
    key_ = {true, studio_.session().surface().id};
    Q_EMIT selected();
  }
  Q_EMIT changed();
}

const UserMaterials::Entry* MaterialEditorModel::own_of(const MaterialKey& key) const {
  const UserMaterials::Entry* entry = own_.find(key);
  if (!entry) return nullptr;
  const std::optional<AnyMaterial> here = find_in(studio_.materials(), key);
  // If the studio's material is the one that this object passed last, it is user-defined, even if
  // the user has changed it since then.
  const bool is_of_drawing = here && *here != entry->now && here != find_in(reported_, key);
  return is_of_drawing ? nullptr : entry;
}

/// Changes a material from one state to another, and selects it.
void MaterialEditorModel::go(const State& from, const State& to, FileFate fate) {
  if (to.material) {
    bring_back(to);
  } else if (from.material) {
    const MaterialKey key = key_of(*from.material);
    const UserMaterials::Entry* entry = own_.find(key);
    // If the step created a copy that was saved afterwards, undoing the step keeps the copy and its
    // file.
    if (entry && (fate == FileFate::kGoes || !entry->saved)) report_error(own_.remove(key));
    if (!own_.find(key)) compared_.erase(key);
  }
  select(to.selected);
  Q_EMIT changed();
}

void MaterialEditorModel::bring_back(const State& to) {
  const MaterialKey key = key_of(*to.material);
  compared_.insert_or_assign(key, to.compared);
  if (to.saved && !own_.find(key)) {
    // The file gets its old content first. Then the unsaved changes are restored, and are still
    // unsaved.
    own_.put(*to.saved);
    report_error(own_.save(key));
  }
  own_.put(*to.material);
}

void MaterialEditorModel::report_error(const Result<void>& done) {
  if (!done) Q_EMIT failed(QString::fromStdString(done.error().message));
}

AnyMaterial MaterialEditorModel::now() const {
  if (const UserMaterials::Entry* entry = own_of(key_)) return entry->now;
  if (std::optional<AnyMaterial> known = find_in(studio_.materials(), key_)) return *known;
  return key_.is_surface ? AnyMaterial(surface_materials().front()) : AnyMaterial(media().front());
}

AnyMaterial MaterialEditorModel::origin() const {
  const UserMaterials::Entry* entry = own_of(key_);
  if (!entry) return now();
  if (entry->saved) return *entry->saved;
  const auto at = origins_.find(key_);
  return at == origins_.end() ? entry->now : with_names_of(at->second, entry->now);
}

bool MaterialEditorModel::is_changed() const {
  const UserMaterials::Entry* entry = own_of(key_);
  return entry && entry->is_changed();
}

void MaterialEditorModel::select(const MaterialKey& key) {
  const bool is_other = key != key_;
  key_ = key;
  take_in_hand();
  if (is_other) Q_EMIT selected();
}

/// Makes the selected material the surface or the medium in use, so that the user feels it.
void MaterialEditorModel::take_in_hand() {
  if (!find_in(studio_.materials(), key_)) report_now();
  if (key_.is_surface) {
    choose_material(studio_, QString::fromStdString(key_.id));
  } else if (drawing_medium(studio_.session()) != key_.id) {
    take_medium(studio_, key_.id);
  }
}

void MaterialEditorModel::set(std::string_view field, double value, std::uint64_t run) {
  AnyMaterial to = now();
  if (!set_in(to, field, value) || to == now() || lacks_picture(to)) return;
  make_fit(to, field);
  change(std::move(to), label_of_field(now(), field), field, run);
}

void MaterialEditorModel::take_figures(const AnyMaterial& from) {
  if (key_of(from).is_surface != key_.is_surface) return;
  change(with_names_of(from, now()), tr("Values of %1").arg(name_of(from)));
}

Result<void> MaterialEditorModel::take_relief(const HeightPicture& picture) {
  AnyMaterial to = now();
  auto* surface = std::get_if<SurfaceMaterial>(&to);
  if (!surface) return {};
  Result<std::shared_ptr<const HeightField>> relief = custom_relief(picture);
  if (!relief) return tl::unexpected(relief.error());
  const bool was_smooth = !(surface->grain_um > 0.0);
  surface->picture = *std::move(relief);
  surface->grain_character = HeightCharacter::kPicture;
  if (!(surface->grain_mm > 0.0)) surface->grain_mm = 1.0;
  if (was_smooth) surface->grain_um = 10.0;
  change(std::move(to), tr("Relief of a picture"));
  return {};
}

void MaterialEditorModel::set_pair(const std::string& surface, std::optional<double> friction) {
  AnyMaterial to = now();
  auto* medium = std::get_if<Medium>(&to);
  if (!medium) return;
  std::erase_if(medium->pairs, [&](const PairFriction& pair) { return pair.surface == surface; });
  if (friction && *friction >= 0.0 && *friction <= kMaxFriction &&
      medium->pairs.size() < kMaxPairs) {
    medium->pairs.push_back({surface, *friction});
  }
  if (to != now()) change(std::move(to), tr("Friction of a pair"));
}

void MaterialEditorModel::set_shape(const std::string& shape) {
  AnyMaterial to = now();
  auto* medium = std::get_if<Medium>(&to);
  if (!medium || !read_style_shape(shape)) return;
  medium->style.shape = shape;
  if (to != now()) change(std::move(to), tr("Shape of the style"));
}

void MaterialEditorModel::revert() {
  const AnyMaterial was = origin();
  if (was != now()) change(was, tr("Revert"));
}

/// Returns the state of the selected material. Requires that it is user-defined.
MaterialEditorModel::State MaterialEditorModel::state() const {
  return {now(), std::nullopt, {slot(), other()}, key_};
}

/// Returns the state of a material that a step adds and selects.
MaterialEditorModel::State MaterialEditorModel::made_as(AnyMaterial material) const {
  const MaterialKey key = key_of(material);
  return {std::move(material), std::nullopt, {}, key};
}

/// Returns true if the id is in use: built-in, user-defined, in the drawing, or in the session,
/// because strokes of the session may refer to it. Another material with this id would change
/// existing drawings.
bool MaterialEditorModel::is_taken(const std::string& id) const {
  const auto has = [&id](const Materials& known) {
    return known.find_surface(id) != nullptr || known.find_medium(id) != nullptr;
  };
  return own_.is_taken(id) || has(studio_.materials()) || has(studio_.session().materials());
}

std::string MaterialEditorModel::free_id(const QString& name) const {
  return id_for(name, key_.is_surface ? "surface" : "medium",
                [this](const std::string& id) { return is_taken(id); });
}

/// Returns the default name of a copy of the selected material.
QString MaterialEditorModel::copy_name() const {
  const QString name = name_of(now());
  return is_built_in(key_) ? tr("%1 (custom)").arg(name) : tr("Copy of %1").arg(name);
}

void MaterialEditorModel::change(AnyMaterial to, const QString& words, std::string_view field,
                                 std::uint64_t run) {
  if (is_own()) {
    change_own(std::move(to), words, field, run);
    return;
  }
  const AnyMaterial from = now();
  const QString name = copy_name();
  const std::string id = free_id(name);
  State after = made_as(renamed(std::move(to), id, name));
  after.compared.hidden = renamed(from, id, name);
  origins_.insert_or_assign(after.selected, from);
  push({std::nullopt, std::nullopt, {}, key_}, std::move(after), words, field, run);
}

void MaterialEditorModel::push(State before, State after, const QString& words,
                               std::string_view field, std::uint64_t run) {
  auto step = std::make_unique<Step>(*this, words, std::move(before), std::move(after));
  step->set_run(field, run);
  steps_.push(step.release());
}

void MaterialEditorModel::change_own(AnyMaterial to, const QString& words, std::string_view field,
                                     std::uint64_t run) {
  const State before = state();
  if (to == *before.material) return;
  State after = before;
  after.material = std::move(to);
  push(before, std::move(after), words, field, run);
}

Result<void> MaterialEditorModel::save() {
  if (!is_own()) return save_as(copy_name());
  if (Result<void> saved = own_.save(key_); !saved) return saved;
  origins_.erase(key_);
  return {};
}

Result<void> MaterialEditorModel::save_as(const QString& name) {
  const AnyMaterial made = renamed(now(), free_id(name), name);
  push({std::nullopt, std::nullopt, {}, key_}, made_as(made), tr("Save as %1").arg(name));
  return own_.save(key_);
}

void MaterialEditorModel::rename(const QString& name) {
  if (!is_own() || label_for(name).isEmpty()) return;
  const AnyMaterial to = renamed(now(), key_.id, name);
  if (name_of(to) == name_of(now())) return;
  const bool was_saved = !is_changed();
  change_own(to, tr("Rename"), {}, 0);
  // If the material had no other unsaved changes, the new name is saved immediately.
  if (was_saved) report_error(own_.save(key_));
}

Result<void> MaterialEditorModel::remove() {
  const UserMaterials::Entry* entry = own_of(key_);
  if (!entry) return {};
  State before = state();
  before.saved = entry->saved;
  const MaterialKey next{key_.is_surface, key_.is_surface ? "paper" : "pencil"};
  const QString words = tr("Delete %1").arg(name_of(entry->now));
  // The file is deleted first, because nothing is to be undone if that fails.
  if (Result<void> gone = own_.remove(key_); !gone) return gone;
  auto step = std::make_unique<Step>(*this, words, std::move(before),
                                     State{std::nullopt, std::nullopt, {}, next});
  step->set_deletes();
  steps_.push(step.release());
  return {};
}

Result<void> MaterialEditorModel::import_file(const QString& path) {
  Result<AnyMaterial> read = read_material_file(path.toStdString(), read_height_png);
  if (!read) return tl::unexpected(read.error());
  AnyMaterial made = *std::move(read);
  const QString name = name_of(made);
  const std::string id = free_id(QString::fromStdString(id_of(made)));
  made = renamed(std::move(made), id, name);
  push({std::nullopt, std::nullopt, {}, key_}, made_as(made), tr("Import %1").arg(name));
  return {};
}

Result<void> MaterialEditorModel::export_file(const QString& path) const {
  return save_file(path.toStdString(), write_material(now()));
}

MaterialEditorModel::Compared MaterialEditorModel::compared_of(const MaterialKey& key) const {
  const auto at = compared_.find(key);
  return at == compared_.end() ? Compared{} : at->second;
}

AnyMaterial MaterialEditorModel::other() const {
  const Compared both = compared_of(key_);
  return both.hidden ? with_names_of(*both.hidden, now()) : origin();
}

bool MaterialEditorModel::slots_are_alike() const {
  return other() == now();
}

/// Choosing a slot is not a step of undo, because the user loses no figures.
void MaterialEditorModel::flip() {
  if (!is_own()) return;
  const AnyMaterial hidden = other();
  compared_.insert_or_assign(key_, Compared{slot() == 'A' ? 'B' : 'A', now()});
  own_.put(hidden);
  report_now();
  Q_EMIT changed();
}

void MaterialEditorModel::copy_to_other() {
  if (!is_own() || slots_are_alike()) return;
  const State before = state();
  State after = before;
  after.compared.hidden = before.material;
  const QChar from = QLatin1Char(slot()), to = QLatin1Char(slot() == 'A' ? 'B' : 'A');
  push(before, std::move(after), tr("Copy %1 to %2").arg(from).arg(to));
}

}  // namespace felt::desktop
