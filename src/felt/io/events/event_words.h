#pragma once

/// The words in event lines that stand for enumerators, in the order of the enumerators. Private to
/// this layer.

#include <array>
#include <string_view>

#include "felt/session/event.h"

namespace felt::json {

inline constexpr std::array<std::string_view, 3> kSelectionWords = {"all", "none", "invert"};

inline constexpr std::array<std::string_view, 2> kOrderWords = {"front", "back"};

inline constexpr std::array<std::string_view, 20> kLayerWords = {
    "add",   "remove", "rename",    "show",  "hide",    "lock",      "unlock",
    "raise", "lower",  "use",       "move",  "opacity", "duplicate", "merge",
    "place", "export", "leave-out", "blend", "group",   "ungroup"};

inline constexpr std::array<std::string_view, 5> kGuideWords = {"none", "groove", "as-needed",
                                                                "error-amplifying", "teacher"};

inline constexpr std::array<std::string_view, 7> kGuidesWords = {
    "add", "change", "remove", "clear", "show", "hide", "unlink"};

inline constexpr std::array<std::string_view, 3> kBodyWords = {"add", "remove", "clear"};

constexpr std::string_view word_of(SelectStrokes::What what) {
  return kSelectionWords[static_cast<std::size_t>(what)];
}
constexpr std::string_view word_of(OrderEvent::To to) {
  return kOrderWords[static_cast<std::size_t>(to)];
}
constexpr std::string_view word_of(LayerEvent::Do what) {
  return kLayerWords[static_cast<std::size_t>(what)];
}
constexpr std::string_view word_of(OfferKind kind) {
  return kOfferKinds[static_cast<std::size_t>(kind)];
}
constexpr std::string_view word_of(GuideKind kind) {
  return kGuideWords[static_cast<std::size_t>(kind)];
}

constexpr std::string_view word_of(GuidesEvent::Do what) {
  return kGuidesWords[static_cast<std::size_t>(what)];
}

constexpr std::string_view word_of(BodyEvent::Do what) {
  return kBodyWords[static_cast<std::size_t>(what)];
}

static_assert(word_of(BodyEvent::Do::kClear) == "clear");
static_assert(word_of(GuidesEvent::Do::kUnlink) == "unlink");
static_assert(word_of(SelectStrokes::What::kInvert) == "invert");
static_assert(word_of(OrderEvent::To::kBack) == "back");
static_assert(word_of(LayerEvent::Do::kUngroup) == "ungroup");
static_assert(word_of(GuideKind::kTeacher) == "teacher");
static_assert(word_of(OfferKind::kPolygon) == "polygon");

}  // namespace felt::json
