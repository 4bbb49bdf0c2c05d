#pragma once

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWidget>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_actions.h"
#include "desktop/files/testing/scripted_dialogs.h"
#include "felt/material/material_file.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop {

/// A medium that Feltline does not ship.
inline Medium soft_chalk(double friction) {
  Medium medium = *find_medium("charcoal");
  medium.id = "soft-chalk";
  medium.label = "Soft chalk";
  medium.friction = friction;
  return medium;
}

/// A fixture: a window with a studio on a virtual clock and scripted dialogs.
struct StudioFixture {
  StudioFixture() : StudioFixture(StudioOptions{.live = false}) {}
  explicit StudioFixture(StudioOptions options) : studio(std::move(options)) {
    auto scripted = std::make_unique<ScriptedDialogs>();
    person = scripted.get();
    files = new FileActions(studio, actions, &window, std::move(scripted));
  }

  /// Adds `count` random strokes, as one step of undo.
  void draw(std::uint64_t seed, int count = 3) {
    std::vector<StrokePtr> strokes;
    for (int i = 0; i < count; ++i) {
      strokes.push_back(std::make_shared<const Stroke>(
          felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i))));
    }
    studio.import(QStringLiteral("test"), strokes);
  }
  /// Adds two squares of four lines each with a fill in each, and a fill without lines. If the
  /// drawing was empty, the lines have the ids 1 to 8. The second square is selected.
  void draw_filled_squares() {
    for (const double left : {10.0, 60.0}) {
      std::vector<StrokePtr> strokes;
      std::vector<FillPtr> fills;
      const std::vector<Point> corners{
          {left, 10}, {left + 30, 10}, {left + 30, 40}, {left, 40}, {left, 10}};
      FillLoop loop{{corners[0]}, {}};
      for (std::size_t i = 0; i < 4; ++i) {
        strokes.push_back(std::make_shared<const Stroke>(
            felt::testing::straight_stroke(corners[i], corners[i + 1], 1.0, 1.0)));
        loop.points.insert(loop.points.end(), {corners[i], corners[i + 1], corners[i + 1]});
        loop.pieces.push_back({StrokeId{i + 1}, 0.0, 1.0});
      }
      fills.push_back(std::make_shared<const Fill>(Fill{{loop}, {200, 40, 0, 255}, 0.0}));
      loop.pieces.clear();
      if (left == 10.0) {
        fills.push_back(std::make_shared<const Fill>(Fill{{loop}, {0, 40, 200, 255}, 0.0}));
      }
      studio.import(QStringLiteral("test"), strokes, fills);
    }
  }
  /// Saves for the first time, under this name.
  void save_as(const char* name) {
    person->next = at(name);
    ASSERT_TRUE(files->save());
    files->finish_writing();
  }
  /// Adds one stroke of that medium, which may be unknown.
  void draw_with(const std::string& medium) {
    StrokeData data = felt::testing::straight_stroke({10, 10}, {90, 40}, 2.0, 3.0).data();
    data.medium = medium;
    studio.import(
        QStringLiteral("test"),
        std::vector{std::make_shared<const Stroke>(Stroke::create(std::move(data)).value())});
  }
  /// Returns the texts of the materials that a file of the drawing would contain now.
  [[nodiscard]] std::vector<std::string> texts() const { return files->drawing().materials; }
  [[nodiscard]] QString at(const char* name) const {
    return folder.filePath(QString::fromUtf8(name));
  }
  [[nodiscard]] const Document& document() const { return studio.session().document(); }

  QTemporaryDir folder;
  Studio studio;
  QWidget window;
  Actions actions{&window};
  ScriptedDialogs* person = nullptr;
  FileActions* files = nullptr;
};

}  // namespace felt::desktop
