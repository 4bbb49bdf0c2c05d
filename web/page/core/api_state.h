#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/geometry/tilt.h"
#include "felt/io/events/event_reader.h"
#include "felt/render/image.h"
#include "felt/session/sound_input.h"
#include "felt/sound/rubbing_player.h"
#include "web/page/core/files.h"
#include "web/page/core/picture.h"
#include "web/page/core/studio.h"
#include "web/page/core/texts.h"

namespace felt::page {

/// Everything that a module of the page holds. core.d.ts describes what the functions do.
struct Core {
  /// What changed, as bits: ink, marks, state, edits.
  enum Changes : unsigned { kInk = 1, kMarks = 2, kState = 4, kEdits = 8, kRefusal = 16 };

  Core();

  [[nodiscard]] Point to_page(Vec css) const { return picture.view().to_mm(dpr * css); }
  void resize(double width, double height, double dpr);
  void set_view(double x_mm, double y_mm, double css_per_mm, double angle_deg, bool mirrored);
  void set_ground();
  void set_paper(bool is_set, unsigned rgb);
  void update_grain();
  void warm_up();
  /// Brings the picture and the marks up to date with the session.
  void show();
  std::size_t export_picture(double dpi, bool transparent);
  /// Returns the selected strokes as an SVG file and, in `exported`, as a picture, for the
  /// clipboard; all visible strokes if none is selected. `is_whole`: only those that are selected
  /// as a whole. Returns an empty text if there are none.
  Result<std::string> copied(bool is_whole, double dpi);

  Result<void> event(std::string_view json);
  /// Sets the medium of new lines with its widths, its pressure curve and, unless the user chose
  /// another one, its colour.
  Result<void> set_medium(const std::string& id);
  /// Sets the size of the tool in use.
  Result<void> set_size(double mm);
  void advance(std::int64_t time_ns);
  unsigned changes();

  std::size_t take_forces();
  std::size_t render_sound(std::size_t frames);

  /// Replaces the drawing by that of a file.
  Result<void> open(std::string_view bytes, const std::string& name,
                    std::vector<std::string>& notices);
  /// Adds the strokes of a file, moved by `by_mm`, or with their middle at that point if
  /// `is_middle`.
  Result<void> add(std::string_view bytes, const std::string& name, Vec by_mm, bool is_middle,
                   std::vector<std::string>& notices);
  /// Adds to `losses` what the drawing has and the file lacks.
  Result<std::string> save(std::string_view format, std::vector<std::string>& losses);
  void clear();
  /// Fills `recorded` and, if it replaces what was stored, `base`. Returns true if it does.
  bool autosave();
  void wants_rebase() noexcept { needs_rebase_ = true; }
  Result<void> restore(std::string_view base_bytes, std::string_view events);
  Result<void> replay(std::string_view script, const ReplayChoice& choice);

  std::vector<char> input;
  std::string reply;
  Studio studio;
  Picture picture;
  Overlay marks;
  double dpr = 1.0;
  double width = 800.0, height = 600.0;  // CSS pixels
  Rgba desk{200, 200, 204, 255};
  bool wants_grain = true, is_warm = false;
  bool shows = true;  // show() has work
  std::optional<Image> exported;
  std::string recorded, base;
  std::string saved;  // what the last save() ended with, as JSON
  std::vector<double> forces;

 private:
  void listen();
  void begin_session(const Drawing& drawing);
  void record(const Event& event);
  void rebase();

  Overlay overlay_;
  EventReader reader_;
  SoundInput sound_input_;
  RubbingPlayer sound_;
  RubbingPair pair_;
  bool sounds_ = false;
  bool replaces_ = true;                            // the next autosave() replaces what was stored
  bool needs_rebase_ = false;                       // the records alone do not give the drawing
  std::string written_;                             // events since the last autosave()
  std::uint64_t base_position_ = 0, position_ = 0;  // in the history
  bool has_edits_ = true, marks_changed_ = true;
  std::string last_state_;
};

Core& core();

}  // namespace felt::page
