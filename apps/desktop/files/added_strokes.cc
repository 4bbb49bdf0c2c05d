#include "desktop/files/added_strokes.h"

#include <QCoreApplication>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "desktop/files/lost_words.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/copied_ink.h"
#include "felt/formats/lost_objects.h"

namespace felt::desktop {
namespace {

/// Returns the names of the strokes of visible_ink(), in their order; empty for a stroke without.
std::vector<std::string> visible_names(const Drawing& drawing) {
  std::vector<std::string> names;
  for (const Layer& layer : drawing.document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      const auto named = drawing.names ? drawing.names->find(id) : StrokeNames::const_iterator();
      names.push_back(drawing.names && named != drawing.names->end() ? named->second : "");
    }
  }
  return names;
}

/// Gives the selected strokes, which were just added, these names. Returns the number of names that
/// they cannot have: a name is that of one stroke, and one like "s12" means another id.
std::size_t add_names(const Session& session, const std::vector<std::string>& added,
                      std::shared_ptr<const StrokeNames>& names) {
  auto all = names ? std::make_shared<StrokeNames>(*names) : std::make_shared<StrokeNames>();
  std::set<std::string> used;
  for (const auto& [id, name] : *all) {
    if (session.document().find(id)) used.insert(name);
  }
  std::size_t i = 0, lost = 0;
  for (const auto& [id, marks] : session.selection().strokes()) {
    if (i == added.size()) break;
    const std::string& name = added[i++];
    if (name.empty()) continue;
    if (stroke_id_of_name(name).value == 0 && used.insert(name).second) {
      all->insert_or_assign(id, name);
    } else {
      ++lost;
    }
  }
  if (all->size() > (names ? names->size() : 0)) names = std::move(all);
  return lost;
}

/// Reports what of a drawing add_drawing() does not add.
void note_left_out(const Drawing& drawing, std::size_t names, ImportReport& report) {
  // What lines without layers cannot hold, apart from what is added.
  LostObjects lost = lost_objects(drawing, FileFormat::kNdjson);
  lost.names = names;
  lost.pictures = 0;
  for (const Layer& layer : drawing.document.layers()) lost.pictures += layer.picture ? 1 : 0;
  for (const AddedWords& row : kAddedWords) {
    const QString what = QCoreApplication::translate("AddedStrokes", row.text);
    const std::size_t count = count_of(row, lost);
    if (count > 0) report.add(0, {}, what.arg(count).toStdString());
  }
}

}  // namespace

bool add_drawing(Studio& studio, const QString& from, const Drawing& added, Vec by_mm,
                 UsedNames used, std::shared_ptr<const StrokeNames>& names, ImportReport& report) {
  const VisibleInk ink = moved_ink(visible_ink(added.document), by_mm);
  for (const std::string& label : studio.add_media(added.materials, ink.strokes)) {
    const QString what = QCoreApplication::translate(
        "AddedStrokes", "“%1” differs here: the added strokes look as it does in this drawing");
    report.add(0, {}, what.arg(QString::fromStdString(label)).toStdString());
  }
  if (!studio.import(from, ink.strokes, ink.fills)) return false;
  const std::size_t lost = add_names(studio.session(), visible_names(added), names);
  note_left_out(added, used == UsedNames::kReported ? lost : 0, report);
  return true;
}

}  // namespace felt::desktop
