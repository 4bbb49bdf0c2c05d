#pragma once

#include <QObject>
#include <QUndoStack>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "desktop/engine/studio.h"
#include "desktop/materials/own_materials.h"

namespace felt::desktop {

/// The editing model of one surface or medium: what the editor shows and changes.
///
/// Built-in materials are never changed: the first change makes a user-defined copy and selects it.
/// Each change goes to OwnMaterials immediately, and from there to forces, picture and sound of
/// every window; saving writes it to a file. Changes, renames, copies and deletions can be undone;
/// a drag of a slider is one step.
///
/// Materials of the open drawing are never changed either. If the drawing has a material with the
/// id of a user-defined one but other figures, the drawing's is used while it is open, and the
/// user's waits. A copy never gets an id that the drawing uses.
///
/// Each user-defined material has two slots of figures to compare, A and B; only the chosen one is
/// used. Until it is changed, the other slot has the original figures. Choosing a slot is not a
/// step of undo, but each step stores and restores both slots.
class MaterialDesk : public QObject {
  Q_OBJECT

 public:
  /// From now on only this object reports user-defined materials to the studio, which may have them
  /// already. Both arguments must outlive it.
  MaterialDesk(Studio& studio, OwnMaterials& own, QObject* parent = nullptr);

  [[nodiscard]] const MaterialKey& key() const noexcept { return key_; }
  /// Returns the present material.
  [[nodiscard]] AnyMaterial now() const;
  /// Returns the original that revert() restores: its file, otherwise what it was copied from.
  [[nodiscard]] AnyMaterial origin() const;
  [[nodiscard]] bool is_own() const { return own_of(key_) != nullptr; }
  /// Returns the user-defined material of this key. Null if there is none, or if the drawing
  /// brought other figures under this id, which take precedence.
  [[nodiscard]] const OwnMaterials::Entry* own_of(const MaterialKey& key) const;
  /// Returns true if it differs from its file, or has none.
  [[nodiscard]] bool is_changed() const;
  [[nodiscard]] OwnMaterials& own() noexcept { return own_; }

  /// Selects a material for editing, and for use: as the surface, or as the medium that draws.
  void select(const MaterialKey& key);
  /// Sets a figure by its field's id. Changes of one field with the same `run`, any number but 0,
  /// are one step of undo. Ignores values that the field does not allow.
  void set(std::string_view field, double value, std::uint64_t run = 0);
  /// Copies all figures of another material of the same kind.
  void take_figures(const AnyMaterial& from);
  /// Sets a user-defined relief of a surface; read_height_png reads one from a file.
  Result<void> take_relief(const HeightPicture& picture);
  /// Sets the friction of a medium on this surface; nothing: by the general rule again.
  void set_pair(const std::string& sheet, std::optional<double> friction);
  /// Restores origin().
  void revert();

  /// Saves a user-defined material; any other one is saved as a copy with its own name. Fails as
  /// OwnMaterials::save does; it then stays unsaved.
  Result<void> save();
  /// Saves a copy of the present material under this name, and selects it. Fails as save() does.
  Result<void> save_as(const QString& name);
  /// Renames it. Does nothing if it has that name already, or if `name` has no printable letter.
  void rename(const QString& name);
  /// Deletes a user-defined material and its file; undoing restores both. Does nothing for any
  /// other one. Fails as OwnMaterials::remove does; then it still exists, and there is no step.
  Result<void> remove();
  /// Adds a file's material as a user-defined one, not saved yet. It gets another id if its own is
  /// in use.
  Result<void> import_file(const QString& path);
  Result<void> export_file(const QString& path) const;

  /// Returns the slot in use of the selected material: 'A' or 'B'.
  [[nodiscard]] char slot() const { return compared_of(key_).chosen; }
  /// Switches to the other slot, for forces, picture and sound. Does nothing if it is not
  /// user-defined.
  void flip();
  /// Copies the figures of this slot to the other one: a step of undo. Does nothing if it is not
  /// user-defined.
  void copy_to_other();
  /// Returns true if both slots have the same figures.
  [[nodiscard]] bool slots_are_alike() const;

  /// Reports changes to the studio now, without the usual delay.
  void tell_now();

  [[nodiscard]] QUndoStack& steps() noexcept { return steps_; }

 Q_SIGNALS:
  /// Another material was selected.
  void selected();
  /// Its figures or its name changed, or whether it is saved.
  void changed();
  /// A file could not be written or deleted; says which, and why.
  void failed(const QString& why);

 private:
  class Step;
  /// The slots of one material.
  struct Compared {
    char chosen = 'A';
    std::optional<AnyMaterial> hidden;  ///< figures of the other slot; none: those of origin()

    friend bool operator==(const Compared&, const Compared&) = default;
  };
  /// Everything that a step restores.
  struct State {
    std::optional<AnyMaterial> material;  ///< none: it does not exist
    /// The content of its file before it was deleted; none: it had no file, or the step deletes
    /// nothing.
    std::optional<AnyMaterial> saved;
    Compared compared;
    MaterialKey selected;

    friend bool operator==(const State&, const State&) = default;
  };
  /// Whether a change to a state without the material deletes its file, too.
  enum class FileFate { kStays, kGoes };

  [[nodiscard]] State state() const;
  [[nodiscard]] State made_as(AnyMaterial material) const;
  void go(const State& from, const State& to, FileFate fate);
  void bring_back(const State& to);
  void push(State before, State after, const QString& words, std::string_view field = {},
            std::uint64_t run = 0);
  void tell_error(const Result<void>& done);

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
  OwnMaterials& own_;
  MaterialKey key_{true, "paper"};
  std::map<MaterialKey, AnyMaterial> origins_;  // of copies that have no file
  std::map<MaterialKey, Compared> compared_;
  // The user-defined materials that the studio received last.
  Materials told_ = Materials::built_in();
  bool is_withheld_ = false;  // not everything was reported, because the drawing has others of
                              // those ids
  QTimer tell_;               // active while the studio has not received a change
  QUndoStack steps_;
};

}  // namespace felt::desktop
