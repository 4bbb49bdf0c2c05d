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

/// The sheet or medium that a person works on: what the editor shows and changes.
///
/// What Feltline brings is never changed: the first change makes a copy, one's own, and takes that
/// in hand. Each change is at once in OwnMaterials, and so in the hand, in the picture and in the
/// ear of every window; it is in a file when it is saved. Changes, names, copies and removals can
/// all be undone; a drag of a slider is one step.
///
/// What the open drawing brought is never changed either: where it has a material of the id of
/// one's own with other figures, the drawing's are felt and shown as long as it is open, and one's
/// own wait. No copy gets an id that the drawing knows.
///
/// Each material of one's own has two slots, A and B, of figures to compare; only the chosen one
/// counts. Until it is changed, the other one holds what the material was before. Which one counts
/// is no step by itself, but each step knows both, and brings both back.
class MaterialDesk : public QObject {
  Q_OBJECT

 public:
  /// The studio hears of one's own by this desk alone, from now on; it may know them already. Both
  /// must outlive it.
  MaterialDesk(Studio& studio, OwnMaterials& own, QObject* parent = nullptr);

  [[nodiscard]] const MaterialKey& key() const noexcept { return key_; }
  /// As it is now.
  [[nodiscard]] AnyMaterial now() const;
  /// What "as it was" means for it: its file, else what it was copied from.
  [[nodiscard]] AnyMaterial origin() const;
  [[nodiscard]] bool is_own() const { return own_of(key_) != nullptr; }
  /// One's own of this key. Null where there is none, or where the drawing brought other figures
  /// under this id, which go before one's own.
  [[nodiscard]] const OwnMaterials::Entry* own_of(const MaterialKey& key) const;
  /// It is not as its file has it, or has none.
  [[nodiscard]] bool is_changed() const;
  [[nodiscard]] OwnMaterials& own() noexcept { return own_; }

  /// Takes it to work on, and in hand: the sheet that is drawn on, the medium that is drawn with.
  void select(const MaterialKey& key);
  /// A figure by its field's id. Changes of one field in one run, which is any number but 0, are
  /// one step of undo. What the field does not allow is not taken.
  void set(std::string_view field, double value, std::uint64_t run = 0);
  /// All figures of another one of its kind.
  void take_figures(const AnyMaterial& from);
  /// A relief of one's own for a sheet; read_height_png has it of a file.
  Result<void> take_relief(const HeightPicture& picture);
  /// The friction of a medium on this sheet; nothing: by the rule again.
  void set_pair(const std::string& sheet, std::optional<double> friction);
  /// As it was (origin).
  void revert();

  /// Saves one's own; any other one is saved as a copy, with a name of its own. Error: what
  /// OwnMaterials::save says; it stays unsaved.
  Result<void> save();
  /// A copy of what is now, with this name, saved; and works on that. Error: likewise.
  Result<void> save_as(const QString& name);
  /// Nothing where it has that name already, or `name` has no letter that can be shown.
  void rename(const QString& name);
  /// Takes one's own away, its file too; undoing brings both back. Nothing for any other one.
  /// Error: what OwnMaterials::remove says; then it is still there, and there is no step.
  Result<void> remove();
  /// Takes a file's material up as one's own, not saved yet. Where there is one of its id already,
  /// it gets another.
  Result<void> import_file(const QString& path);
  Result<void> export_file(const QString& path) const;

  /// 'A' or 'B': whose figures count, of the one that is worked on.
  [[nodiscard]] char slot() const { return compared_of(key_).chosen; }
  /// The other slot counts, for hand, eye and ear at once. Nothing for one that is not one's own.
  void flip();
  /// The other slot gets the figures of this one: a step. Nothing for one that is not one's own.
  void copy_to_other();
  /// Both have the same figures.
  [[nodiscard]] bool slots_are_alike() const;

  /// The studio hears of changes now, not in a moment.
  void tell_now();

  [[nodiscard]] QUndoStack& steps() noexcept { return steps_; }

 Q_SIGNALS:
  /// Another one is worked on.
  void selected();
  /// Its figures, its name, or whether it is saved.
  void changed();
  /// A file could not be written or taken away; says which, and why.
  void failed(const QString& why);

 private:
  class Step;
  /// Of one material.
  struct Compared {
    char chosen = 'A';
    std::optional<AnyMaterial> hidden;  ///< figures of the other one; none: those of origin()

    friend bool operator==(const Compared&, const Compared&) = default;
  };
  /// All that a step brings back.
  struct State {
    std::optional<AnyMaterial> material;  ///< none: it is not there
    /// What its file had when it was deleted; none: it had no file, or the step deletes nothing.
    std::optional<AnyMaterial> saved;
    Compared compared;
    MaterialKey selected;

    friend bool operator==(const State&, const State&) = default;
  };
  /// Whether going to a state without the material takes away its file, too.
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
  // What the studio heard last of one's own.
  Materials told_ = Materials::built_in();
  bool is_withheld_ = false;  // it was not told all, for the drawing has others of those ids
  QTimer tell_;               // runs while the studio has not heard of a change
  QUndoStack steps_;
};

}  // namespace felt::desktop
