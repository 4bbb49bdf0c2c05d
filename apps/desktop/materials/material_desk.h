#pragma once

#include <QObject>
#include <QUndoStack>
#include <cstdint>
#include <map>
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
/// Two slots, A and B, hold figures of a material to compare; only the chosen one counts. Until it
/// is changed, the other one holds what the material was before.
class MaterialDesk : public QObject {
  Q_OBJECT

 public:
  MaterialDesk(Studio& studio, OwnMaterials& own, QObject* parent = nullptr);

  [[nodiscard]] const MaterialKey& key() const noexcept { return key_; }
  /// As it is now.
  [[nodiscard]] AnyMaterial now() const;
  /// What "as it was" means for it: its file, else what it was copied from.
  [[nodiscard]] AnyMaterial origin() const;
  [[nodiscard]] bool is_own() const { return own_.find(key_) != nullptr; }
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

  /// Saves one's own; a built-in one needs a name of its own first.
  Result<void> save();
  /// A copy of what is now, with this name, saved; and works on that.
  Result<void> save_as(const QString& name);
  void rename(const QString& name);
  /// Takes one's own away, its file too; undoing brings both back.
  void remove();
  /// Takes a file's material up as one's own, not saved yet. Where there is one of its id already,
  /// it gets another.
  Result<void> import_file(const QString& path);
  Result<void> export_file(const QString& path) const;

  /// 'A' or 'B': whose figures count.
  [[nodiscard]] char slot() const noexcept { return slot_; }
  /// The other slot counts, for hand, eye and ear at once.
  void flip();
  /// The other slot gets the figures of this one.
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
  struct State {
    std::optional<AnyMaterial> material;
    MaterialKey selected;
    char slot = 'A';
  };

  void go(const std::optional<AnyMaterial>& from, const State& to, bool with_file);
  void push(State before, State after, const QString& words, std::string_view field = {},
            std::uint64_t run = 0);
  void tell_error(const Result<void>& done);

  void change(AnyMaterial to, const QString& words, std::string_view field = {},
              std::uint64_t run = 0);
  void change_own(AnyMaterial to, const QString& words, std::string_view field, std::uint64_t run);
  void take_in_hand();
  [[nodiscard]] AnyMaterial other() const;

  Studio& studio_;
  OwnMaterials& own_;
  MaterialKey key_{true, "paper"};
  std::map<MaterialKey, AnyMaterial> origins_;  // of copies that have no file
  std::map<MaterialKey, AnyMaterial> others_;   // what the other slot holds
  char slot_ = 'A';
  QTimer tell_;  // runs while the studio has not heard of a change
  QUndoStack steps_;
};

}  // namespace felt::desktop
