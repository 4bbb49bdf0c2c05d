#include "desktop/help/examples.h"

#include <QCoreApplication>
#include <utility>

#include "desktop/engine/first_options.h"
#include "felt/devices/simulated/samples/drawings.h"
#include "felt/devices/simulated/writing_hand.h"
#include "felt/geometry/affine.h"
#include "felt/session/session.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/tools/medium_line.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kDoodles = 120;

/// Position of the cat in the middle of an A4 page. The other drawings start near the page's
/// corner.
constexpr Vec kCatPlace{95.0, 38.0};
constexpr Vec kTextPlace{34.0, 60.0};
constexpr Vec kPagePlace{60.0, 42.0};

struct Source {
  std::vector<Gesture> gestures;
  Vec place;
};

Source source_of(const QString& id) {
  if (id == QStringLiteral("cat")) return {cat_drawing(), kCatPlace};
  if (id == QStringLiteral("writing")) {
    Source source{{}, kTextPlace};
    const std::string_view lines[] = {"hello felt line", "the line on the felt",
                                      "is felt in the hole"};
    double y = 20.0;
    for (const std::string_view line : lines) {
      for (Gesture& gesture : cursive(line, {0.0, y}, 9.0)) source.gestures.push_back(gesture);
      y += 34.0;
    }
    return source;
  }
  if (id == QStringLiteral("exercises")) return {exercise_page(), kPagePlace};
  if (id == QStringLiteral("doodles")) return {random_gestures(11, kDoodles), {}};
  return {};
}

/// Returns the settings of the medium that a new user has in the hand, so that the first line on an
/// example looks like the lines of the example.
InkFitOptions first_ink() {
  const Medium* medium = find_medium(kFirstMedium);
  InkFitOptions ink;
  if (!medium) return ink;
  ink.width_map.min_mm = medium->line.min_mm;
  ink.width_map.max_mm = medium->line.max_mm;
  ink.width_map.gamma = medium->line.gamma;
  return drawn_with(*medium, std::move(ink));
}

}  // namespace

std::vector<Example> examples() {
  const auto say = [](const char* text) { return QCoreApplication::translate("Examples", text); };
  return {
      {QStringLiteral("cat"), say(QT_TRANSLATE_NOOP("Examples", "A cat"))},
      {QStringLiteral("writing"), say(QT_TRANSLATE_NOOP("Examples", "Handwriting"))},
      {QStringLiteral("exercises"), say(QT_TRANSLATE_NOOP("Examples", "A page of exercises"))},
      {QStringLiteral("doodles"), say(QT_TRANSLATE_NOOP("Examples", "Doodles"))},
  };
}

Document example_document(const QString& id) {
  const Source source = source_of(id);
  WritingHand hand({.seed = 3});
  InkFitter fitter(first_ink());
  std::vector<StrokePtr> strokes;
  for (const Gesture& gesture : source.gestures) {
    fitter.begin();
    for (const HandSample& sample : hand.draw(gesture)) {
      fitter.push({sample.position + source.place, sample.pressure, sample.time_ns});
    }
    fitter.end();
    fitter.refine();
    Result<Stroke> stroke = fitter.stroke();
    if (stroke) strokes.push_back(std::make_shared<const Stroke>(*std::move(stroke)));
  }
  return document_of(strokes);
}

}  // namespace felt::desktop
