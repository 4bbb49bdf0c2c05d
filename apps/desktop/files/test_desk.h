#pragma once

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWidget>
#include <memory>
#include <utility>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_actions.h"
#include "desktop/files/scripted_dialogs.h"
#include "felt/stroke/random_stroke.h"

namespace felt::desktop {

/// A window with a studio on a virtual clock and a person who answers by script, for tests.
struct TestDesk {
  TestDesk() : TestDesk(StudioOptions{.live = false}) {}
  explicit TestDesk(StudioOptions options) : studio(std::move(options)) {
    auto scripted = std::make_unique<ScriptedDialogs>();
    person = scripted.get();
    files = new FileActions(studio, actions, &window, std::move(scripted));
  }

  /// `count` random strokes, as one step.
  void draw(std::uint64_t seed, int count = 3) {
    Sketch sketch;
    for (int i = 0; i < count; ++i) {
      sketch.push_back(
          {"s", felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i))});
    }
    studio.import(QStringLiteral("test"), sketch);
  }
  [[nodiscard]] QString at(const char* name) const {
    return folder.filePath(QString::fromUtf8(name));
  }
  void journal_flush() const { files->journal()->flush(); }
  [[nodiscard]] const Document& document() const { return studio.session().document(); }

  QTemporaryDir folder;
  Studio studio;
  QWidget window;
  Actions actions{&window};
  ScriptedDialogs* person = nullptr;
  FileActions* files = nullptr;
};

}  // namespace felt::desktop
