#pragma once

#include <QObject>
#include <QUndoStack>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "desktop/engine/studio.h"
#include "desktop/materials/user_materials.h"

namespace felt::desktop {

/// The editing model of one surface or medium, which the editor shows and changes.
///
/// Built-in materials never change: the first change makes a user-defined copy and selects it. Each
/// change is stored in UserMaterials immediately, so that forces, picture and sound of every window
/// use it; saving also writes it to a file. Changes, renames, copies and deletions can be undone; a
/// drag of a slider is one step.
///
/// Materials that came with the open drawing do not change, either. If such a material has the id
/// of a user-defined material but other figures (values), the drawing's material is used while the
/// drawing is open. A copy never gets an id that the drawing uses.
///
/// To compare figures, each user-defined material has two sets of them, slot A and slot B. Only the
/// chosen slot is used. The other slot contains the original figures until it is changed. Choosing
/// a slot is not a step of undo, but each step stores and restores both slots.
class MaterialEditorModel : public QObject {
  Q_OBJECT

 public:
  /// From now on, only this object may pass user-defined materials to the studio. The studio may
  /// already have them. After `studio` or `own` (the user-defined materials) is gone, only the
  /// destructor of this object may be called.
  MaterialEditorModel(Studio& studio, UserMaterials& own, QObject* parent = nullptr);
  /// Emits nothing: the studio may be gone if a window takes both along.
  ~MaterialEditorModel() override;

  [[nodiscard]] const MaterialKey& key() const noexcept { return key_; }
  /// Returns the selected material with its present figures.
  [[nodiscard]] AnyMaterial now() const;
  /// Returns the original that revert() restores: the content of the material's file or, if it has
  /// no file, the material of which it is a copy.
  [[nodiscard]] AnyMaterial origin() const;
  [[nodiscard]] bool is_own() const { return own_of(key_) != nullptr; }
  /// Returns the user-defined material of this key. Returns null if none exists, or if the drawing
  /// has a material with this id and other figures, which takes precedence.
  [[nodiscard]] const UserMaterials::Entry* own_of(const MaterialKey& key) const;
  /// Returns true if the selected material differs from its file, or has no file.
  [[nodiscard]] bool is_changed() const;
  [[nodiscard]] UserMaterials& own() noexcept { return own_; }

  /// Selects a material for editing and for use: as the surface, or as the medium of new lines.
  void select(const MaterialKey& key);
  /// Sets a figure by the id of its field. Consecutive changes of one field with the same `run`
  /// (not 0) are one step of undo. Ignores values that the field does not allow.
  void set(std::string_view field, double value, std::uint64_t run = 0);
  /// Copies all figures of another material of the same kind.
  void take_figures(const AnyMaterial& from);
  /// Sets a user-defined relief of a surface. To read the picture from a file, use
  /// read_height_png.
  Result<void> take_relief(const HeightPicture& picture);
  /// Sets the friction of the selected medium on `surface`. Nullopt restores the default: the
  /// product of the medium's and the surface's friction.
  void set_pair(const std::string& surface, std::optional<double> friction);
  /// Sets the shape of the selected medium's style. Ignores a text that is no shape.
  void set_shape(const std::string& shape);
  /// Restores origin().
  void revert();

  /// Saves the selected material if it is user-defined; otherwise saves a copy of it under a new
  /// name. Fails as UserMaterials::save does; then the material stays unsaved.
  Result<void> save();
  /// Saves a copy of the present material under this name, and selects it. Fails as save() does.
  Result<void> save_as(const QString& name);
  /// Renames the material, and saves the new name if the material had no unsaved changes. Does
  /// nothing if the material is not user-defined, if it already has that name, or if `name` has no
  /// printable letter.
  void rename(const QString& name);
  /// Deletes a user-defined material and its file; undo restores both. Does nothing if the material
  /// is not user-defined. Fails as UserMaterials::remove does; then the material still exists, and
  /// undo has no additional step.
  Result<void> remove();
  /// Adds the material in a file as an unsaved user-defined material. The material gets another id
  /// if the id in the file is already in use.
  Result<void> import_file(const QString& path);
  Result<void> export_file(const QString& path) const;

  /// Returns the chosen slot of the selected material: 'A' or 'B'.
  [[nodiscard]] char slot() const { return compared_of(key_).chosen; }
  /// Chooses the other slot, so that forces, picture and sound use the figures of that slot. Does
  /// nothing if the material is not user-defined.
  void flip();
  /// Copies the figures of the chosen slot to the other slot, as a step of undo. Does nothing if
  /// the material is not user-defined.
  void copy_to_other();
  /// Returns true if both slots have the same figures.
  [[nodiscard]] bool slots_are_alike() const;

  /// Passes changes to the studio now, without the usual delay.
  void report_now();

  [[nodiscard]] QUndoStack& steps() noexcept { return steps_; }

 Q_SIGNALS:
  /// Emitted when another material was selected.
  void selected();
  /// Emitted when the figures, the name or the saved state of the material changed.
  void changed();
  /// Emitted when a file could not be written or deleted. `why` names the file and the reason.
  void failed(const QString& why);

 private:
  class Step;
  /// The slots of one material.
  struct Compared {
    char chosen = 'A';
    std::optional<AnyMaterial> hidden;  ///< figures of the slot that is not chosen; nullopt means
                                        ///< the figures of origin()

    friend bool operator==(const Compared&, const Compared&) = default;
  };
  /// Everything that a step of undo restores.
  struct State {
    std::optional<AnyMaterial> material;  ///< nullopt if the material does not exist
    /// The content of the file before it was deleted. Nullopt if the material had no file, or if
    /// the step deletes nothing.
    std::optional<AnyMaterial> saved;
    Compared compared;
    MaterialKey selected;

    friend bool operator==(const State&, const State&) = default;
  };
  /// Whether the material's file is deleted when a step of undo removes the material.
  enum class FileFate { kStays, kGoes };

  [[nodiscard]] State state() const;
  [[nodiscard]] State made_as(AnyMaterial material) const;
  void go(const State& from, const State& to, FileFate fate);
  void bring_back(const State& to);
  void push(State before, State after, const QString& words, std::string_view field = {},
            std::uint64_t run = 0);
  void report_error(const Result<void>& done);

  void change(AnyMaterial to, const QString& words, std::string_view field = {},
              std::uint64_t run = 0);
  void change_own(AnyMaterial to, const QString& words, std::string_view field, std::uint64_t run);
  void follow_drawing();
  void take_in_hand();
  [[nodiscard]] bool is_taken(const std::string& id) const;
  [[nodiscard]] std::string free_id(const QString& name) const;
  [[nodiscard]] QString copy_name() const;
  [[nodiscard]] AnyMaterial other() const;
  [[nodiscard]] Compared compared_of(const MaterialKey& key) const;

  Studio& studio_;
  UserMaterials& own_;
  MaterialKey key_{true, "paper"};
  std::map<MaterialKey, AnyMaterial> origins_;  // originals of copies that have no file
  std::map<MaterialKey, Compared> compared_;
  // The user-defined materials that were last passed to the studio.
  Materials reported_ = Materials::built_in();
  bool is_withheld_ = false;  // some materials were not passed to the studio, because the drawing
                              // has other materials with their ids
  QTimer report_;             // active until the last change is passed to the studio
  QUndoStack steps_;
};

}  // namespace felt::desktop
