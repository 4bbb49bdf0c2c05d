#include "desktop/materials/material_desk.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "desktop/feel/feel_actions.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_texts.h"
#include "felt/base/atomic_file.h"
#include "felt/io/png.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_library.h"
#include "felt/material/own_relief.h"

namespace felt::desktop {
namespace {

template <class Field>
bool set_field(const Field* field, auto& material, double value) {
  if (!field || !field->allows(value)) return false;
  field->set(material, value);
  return true;
}

bool set_in(AnyMaterial& material, std::string_view field, double value) {
  auto* sheet = std::get_if<SurfaceMaterial>(&material);
  if (sheet) return set_field(find_sheet_field(field), *sheet, value);
  return set_field(find_medium_field(field), std::get<Medium>(material), value);
}

/// What a file wants of figures together: the other one of a pair follows.
void make_fit(AnyMaterial& material, std::string_view field) {
  constexpr double kFirstGrainMm = 1.0;
  if (auto* medium = std::get_if<Medium>(&material)) {
    MediumLine& line = medium->line;
    if (field == "line.min_mm") line.max_mm = std::max(line.max_mm, line.min_mm);
    if (field == "line.max_mm") line.min_mm = std::min(line.min_mm, line.max_mm);
  } else if (auto* sheet = std::get_if<SurfaceMaterial>(&material)) {
    if (sheet->grain_um > 0.0 && !(sheet->grain_mm > 0.0)) sheet->grain_mm = kFirstGrainMm;
  }
}

bool lacks_picture(const AnyMaterial& material) {
  const auto* sheet = std::get_if<SurfaceMaterial>(&material);
  return sheet && sheet->grain_character == HeightCharacter::kPicture && !sheet->picture;
}

QString label_of_field(const AnyMaterial& material, std::string_view field) {
  if (std::holds_alternative<SurfaceMaterial>(material)) {
    const SheetField* row = find_sheet_field(field);
    return row ? translated(row->label) : QString();
  }
  const MediumField* row = find_medium_field(field);
  return row ? translated(row->label) : QString();
}

/// The figures of one, the names of the other.
AnyMaterial with_names_of(AnyMaterial figures, const AnyMaterial& names) {
  std::visit(
      [&](auto& of) {
        of.id = id_of(names);
        of.label = label_of(names);
      },
      figures);
  return figures;
}

constexpr int kTellMs = 100;  // between two events while a slider is dragged

}  // namespace

/// From one state of one material to another; one that is not there before or after is made or
/// taken away.
class MaterialDesk::Step final : public QUndoCommand {
 public:
  Step(MaterialDesk& desk, const QString& words, State before, State after)
      : QUndoCommand(words), desk_(desk), before_(std::move(before)), after_(std::move(after)) {}

  /// Steps of one field in one run become one.
  void set_run(std::string_view field, std::uint64_t run) {
    field_ = field;
    run_ = run;
  }
  /// It takes a material away, which had a file.
  void set_had_file() { had_file_ = true; }

  [[nodiscard]] int id() const override { return 1; }
  void redo() override { desk_.go(before_.material, after_, had_file_); }
  void undo() override { desk_.go(after_.material, before_, had_file_); }

  bool mergeWith(const QUndoCommand* later) override {
    const auto* next = static_cast<const Step*>(later);
    if (run_ == 0 || next->run_ != run_ || next->field_ != field_) return false;
    if (next->after_.selected != after_.selected) return false;
    after_ = next->after_;
    setObsolete(before_.material && after_.material && *before_.material == *after_.material);
    return true;
  }

 private:
  MaterialDesk& desk_;
  State before_, after_;
  std::string field_;
  std::uint64_t run_ = 0;
  bool had_file_ = false;
};

MaterialDesk::MaterialDesk(Studio& studio, OwnMaterials& own, QObject* parent)
    : QObject(parent), studio_(studio), own_(own) {
  key_.id = studio_.session().sheet().material().id;
  tell_.setSingleShot(true);
  tell_.setInterval(kTellMs);
  connect(&tell_, &QTimer::timeout, this, &MaterialDesk::tell_now);
  connect(&own_, &OwnMaterials::changed, this, [this](const MaterialKey& key) {
    if (!tell_.isActive()) tell_.start();
    if (key == key_) Q_EMIT changed();
  });
}

void MaterialDesk::tell_now() {
  tell_.stop();
  const Medium* before = studio_.materials().find_medium(medium_in_hand(studio_));
  const MediumLine line = before ? before->line : MediumLine{};
  studio_.know(own_.known());
  // The pencil took over the widths of its medium when that was taken in hand; so it does now.
  const Medium* after = studio_.materials().find_medium(medium_in_hand(studio_));
  if (before && after && after->line != line) take_medium(studio_, after->id);
}

/// From one state of one material to another, which is selected then.
void MaterialDesk::go(const std::optional<AnyMaterial>& from, const State& to, bool with_file) {
  if (slot_ != to.slot && is_own()) others_.insert_or_assign(key_, now());
  slot_ = to.slot;
  if (to.material) {
    own_.put(*to.material);
    if (with_file) tell_error(own_.save(key_of(*to.material)));
  } else if (from) {
    const MaterialKey key = key_of(*from);
    const OwnMaterials::Entry* entry = own_.find(key);
    // A copy that was saved since stays: undoing its making takes no file away.
    if (entry && (with_file || !entry->saved)) tell_error(own_.remove(key));
  }
  select(to.selected);
  Q_EMIT changed();
}

void MaterialDesk::tell_error(const Result<void>& done) {
  if (!done) Q_EMIT failed(QString::fromStdString(done.error().message));
}

AnyMaterial MaterialDesk::now() const {
  if (const OwnMaterials::Entry* entry = own_.find(key_)) return entry->now;
  if (std::optional<AnyMaterial> known = find_in(studio_.materials(), key_)) return *known;
  return key_.is_sheet ? AnyMaterial(surface_materials().front()) : AnyMaterial(media().front());
}

AnyMaterial MaterialDesk::origin() const {
  const OwnMaterials::Entry* entry = own_.find(key_);
  if (!entry) return now();
  if (entry->saved) return *entry->saved;
  const auto at = origins_.find(key_);
  return at == origins_.end() ? entry->now : with_names_of(at->second, entry->now);
}

bool MaterialDesk::is_changed() const {
  const OwnMaterials::Entry* entry = own_.find(key_);
  return entry && entry->is_changed();
}

void MaterialDesk::select(const MaterialKey& key) {
  const bool is_other = key != key_;
  key_ = key;
  take_in_hand();
  if (is_other) Q_EMIT selected();
}

/// What is worked on is what is felt.
void MaterialDesk::take_in_hand() {
  if (!find_in(studio_.materials(), key_)) tell_now();
  if (key_.is_sheet) {
    choose_material(studio_, QString::fromStdString(key_.id));
  } else if (medium_in_hand(studio_) != key_.id) {
    take_medium(studio_, key_.id);
  }
}

void MaterialDesk::set(std::string_view field, double value, std::uint64_t run) {
  AnyMaterial to = now();
  if (!set_in(to, field, value) || to == now() || lacks_picture(to)) return;
  make_fit(to, field);
  change(std::move(to), label_of_field(now(), field), field, run);
}

void MaterialDesk::take_figures(const AnyMaterial& from) {
  if (key_of(from).is_sheet != key_.is_sheet) return;
  change(with_names_of(from, now()), tr("Figures of %1").arg(name_of(from)));
}

Result<void> MaterialDesk::take_relief(const HeightPicture& picture) {
  AnyMaterial to = now();
  auto* sheet = std::get_if<SurfaceMaterial>(&to);
  if (!sheet) return {};
  Result<std::shared_ptr<const HeightField>> relief = own_relief(picture);
  if (!relief) return tl::unexpected(relief.error());
  const bool was_smooth = !(sheet->grain_um > 0.0);
  sheet->picture = *std::move(relief);
  sheet->grain_character = HeightCharacter::kPicture;
  if (!(sheet->grain_mm > 0.0)) sheet->grain_mm = 1.0;
  if (was_smooth) sheet->grain_um = 10.0;
  change(std::move(to), tr("Relief of a picture"));
  return {};
}

void MaterialDesk::set_pair(const std::string& sheet, std::optional<double> friction) {
  AnyMaterial to = now();
  auto* medium = std::get_if<Medium>(&to);
  if (!medium) return;
  std::erase_if(medium->pairs, [&](const PairFriction& pair) { return pair.surface == sheet; });
  if (friction && *friction >= 0.0 && *friction <= kMaxFriction &&
      medium->pairs.size() < kMaxPairs) {
    medium->pairs.push_back({sheet, *friction});
  }
  if (to != now()) change(std::move(to), tr("Friction of a pair"));
}

void MaterialDesk::revert() {
  const AnyMaterial was = origin();
  if (was != now()) change(was, tr("Revert"));
}

void MaterialDesk::change(AnyMaterial to, const QString& words, std::string_view field,
                          std::uint64_t run) {
  if (is_own()) {
    change_own(std::move(to), words, field, run);
    return;
  }
  const AnyMaterial from = now();
  const QString name = tr("%1, my own").arg(name_of(from));
  const std::string id = id_for(name, key_.is_sheet ? "sheet" : "medium",
                                [this](const std::string& taken) { return own_.is_taken(taken); });
  const AnyMaterial made = renamed(std::move(to), id, name);
  origins_.insert_or_assign(key_of(made), from);
  others_.insert_or_assign(key_of(made), renamed(from, id, name));
  push({std::nullopt, key_, slot_}, {made, key_of(made), slot_}, words, field, run);
}

void MaterialDesk::push(State before, State after, const QString& words, std::string_view field,
                        std::uint64_t run) {
  auto step = std::make_unique<Step>(*this, words, std::move(before), std::move(after));
  step->set_run(field, run);
  steps_.push(step.release());
}

void MaterialDesk::change_own(AnyMaterial to, const QString& words, std::string_view field,
                              std::uint64_t run) {
  const AnyMaterial from = now();
  if (to == from) return;
  others_.try_emplace(key_, origin());
  push({from, key_, slot_}, {std::move(to), key_, slot_}, words, field, run);
}

Result<void> MaterialDesk::save() {
  if (!is_own()) return save_as(tr("%1, my own").arg(name_of(now())));
  if (Result<void> saved = own_.save(key_); !saved) return saved;
  origins_.erase(key_);
  return {};
}

Result<void> MaterialDesk::save_as(const QString& name) {
  const AnyMaterial from = now();
  const std::string id = id_for(name, key_.is_sheet ? "sheet" : "medium",
                                [this](const std::string& taken) { return own_.is_taken(taken); });
  const AnyMaterial made = renamed(from, id, name);
  push({std::nullopt, key_, slot_}, {made, key_of(made), slot_}, tr("Save as %1").arg(name));
  return own_.save(key_);
}

void MaterialDesk::rename(const QString& name) {
  if (!is_own() || name.simplified().isEmpty()) return;
  const bool was_saved = !is_changed();
  change_own(renamed(now(), key_.id, name), tr("Rename"), {}, 0);
  // Nothing else waits to be saved: the name is no more than a name.
  if (was_saved) static_cast<void>(own_.save(key_));
}

void MaterialDesk::remove() {
  const OwnMaterials::Entry* entry = own_.find(key_);
  if (!entry) return;
  const MaterialKey next{key_.is_sheet, key_.is_sheet ? "paper" : "pencil"};
  auto step =
      std::make_unique<Step>(*this, tr("Delete %1").arg(name_of(entry->now)),
                             State{entry->now, key_, slot_}, State{std::nullopt, next, slot_});
  if (entry->saved) step->set_had_file();
  steps_.push(step.release());
}

Result<void> MaterialDesk::import_file(const QString& path) {
  Result<AnyMaterial> read = read_material_file(path.toStdString(), read_height_png);
  if (!read) return tl::unexpected(read.error());
  AnyMaterial made = *std::move(read);
  const QString name = name_of(made);
  const std::string id = id_for(QString::fromStdString(id_of(made)), id_of(made),
                                [this](const std::string& taken) { return own_.is_taken(taken); });
  made = renamed(std::move(made), id, name);
  push({std::nullopt, key_, slot_}, {made, key_of(made), slot_}, tr("Import %1").arg(name));
  return {};
}

Result<void> MaterialDesk::export_file(const QString& path) const {
  return save_file(path.toStdString(), write_material(now()));
}

AnyMaterial MaterialDesk::other() const {
  const auto at = others_.find(key_);
  return at == others_.end() ? origin() : with_names_of(at->second, now());
}

bool MaterialDesk::slots_are_alike() const {
  return other() == now();
}

/// No step of undo: nothing that a person made is lost by it.
void MaterialDesk::flip() {
  slot_ = slot_ == 'A' ? 'B' : 'A';
  if (is_own()) {
    const AnyMaterial shown = now(), hidden = other();
    others_.insert_or_assign(key_, shown);
    own_.put(hidden);
    tell_now();
  }
  Q_EMIT changed();
}

void MaterialDesk::copy_to_other() {
  others_.insert_or_assign(key_, now());
  Q_EMIT changed();
}

}  // namespace felt::desktop
