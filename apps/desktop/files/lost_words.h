#pragma once

#include <cstddef>

#include "felt/formats/lost_objects.h"

#ifndef QT_TRANSLATE_NOOP  // the page for browsers has these sentences without Qt
#define QT_TRANSLATE_NOOP(context, text) text
#endif

namespace felt::desktop {

/// A sentence about a number of objects, with %1 for the number.
struct LostWords {
  std::size_t LostObjects::*count;
  const char* text;
};

/// What a written file lacks; the translations are those of NoticeBar.
inline constexpr LostWords kLostWords[] = {
    {&LostObjects::fills, QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                                            "Left out, because the format has no fills: %1.")},
    {&LostObjects::pictures,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Left out, because the format has no pictures to draw over: %1.")},
    {&LostObjects::blends,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar", "Blend modes that became normal: %1.")},
    {&LostObjects::groups,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar", "Groups of layers that were dissolved: %1.")},
    {&LostObjects::timings,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Left out, because the format has no timings of key drawings: %1.")},
    {&LostObjects::body_edits,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Left out, because the format has no edits of the body: %1.")},
    {&LostObjects::guides, QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                                             "Left out, because the format has no guides: %1.")},
    {&LostObjects::symmetries,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Left out, because the format has no symmetry groups: %1.")},
    {&LostObjects::opacities,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Layers or groups whose opacity became that of each line: %1.")},
    {&LostObjects::layers, QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                                             "Left out, because the format has no layers: %1.")},
    {&LostObjects::locks,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar", "Locked layers that became unlocked: %1.")},
    {&LostObjects::hidden_strokes,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Lines of hidden layers that were left out: %1.")},
    {&LostObjects::shown_strokes,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Lines of hidden layers that became visible: %1.")},
    {&LostObjects::sharp_ends,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Lines whose flat ends and pointed corners became round: %1.")},
    {&LostObjects::names,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar", "Names of lines that became numbers: %1.")},
    {&LostObjects::media,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar", "Lines whose medium became a plain pen: %1.")},
    {&LostObjects::materials,
     QT_TRANSLATE_NOOP("felt::desktop::NoticeBar",
                       "Left out, because the format has no custom materials: %1.")},
};

/// What adding a drawing to another one leaves out of it: LostObjects for lines without layers,
/// with the sum of the members of a row.
struct AddedWords {
  std::size_t LostObjects::*counts[4];
  const char* text;
};

/// The translations are those of AddedStrokes.
inline constexpr AddedWords kAddedWords[] = {
    {{&LostObjects::pictures},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Pictures of this file were not added: %1. Open the file to see them.")},
    {{&LostObjects::hidden_strokes},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Lines of hidden layers that were not added: %1. Open the file to see "
                       "them.")},
    {{&LostObjects::layers},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Layers whose lines were added to the current layer, without the name of "
                       "their own: %1")},
    {{&LostObjects::opacities, &LostObjects::blends},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Opacities and blend modes of layers that were left out: %1")},
    {{&LostObjects::guides, &LostObjects::symmetries, &LostObjects::timings,
      &LostObjects::body_edits},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Guides, symmetry groups, timings and edits of the body that were not "
                       "added: %1. Open the file to see them.")},
    {{&LostObjects::names},
     QT_TRANSLATE_NOOP("AddedStrokes",
                       "Names of lines that were left out, because lines of this drawing have "
                       "them: %1")},
};

/// Returns the number for %1.
constexpr std::size_t count_of(const AddedWords& row, const LostObjects& lost) {
  std::size_t count = 0;
  for (const auto member : row.counts) count += member ? lost.*member : 0;
  return count;
}

}  // namespace felt::desktop
