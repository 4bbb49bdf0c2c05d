#include "felt/timelapse/animated_svg.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "felt/timelapse/testing/drawn_recording.h"

namespace felt::animated_svg_test {
namespace {

/// The shapes of a film, with the times at which they are shown.
struct FilmFile {
  pugi::xml_document xml;
  std::vector<pugi::xml_node> shapes;
};

void add_shapes(const pugi::xml_node& node, std::vector<pugi::xml_node>& shapes) {
  for (const pugi::xml_node& child : node.children()) {
    if (std::string_view(child.name()) == "g") add_shapes(child, shapes);
    if (std::string_view(child.name()) == "path") shapes.push_back(child);
  }
}

void read_film(FeltRecording recording, double seconds, FilmFile& file) {
  const TimelapseSource source{std::move(recording)};
  const FilmTiming timing(measure_recording(source.recording).drawing_ns, {seconds, 24, 1.0});
  const Result<std::string> text = animated_svg(source, timing, {{0.0, 0.0, 100.0, 70.0}});
  ASSERT_TRUE(text);
  const pugi::xml_parse_result parsed = file.xml.load_string(text->c_str());
  ASSERT_TRUE(parsed) << parsed.description();
  add_shapes(file.xml.child("svg"), file.shapes);
}

pugi::xml_node animation(const pugi::xml_node& shape, const char* attribute) {
  return shape.find_child_by_attribute("set", "attributeName", attribute);
}
double seconds_of(const pugi::xml_node& node, const char* name) {
  return std::strtod(node.attribute(name).value(), nullptr);  // ignores the unit
}

/// The times in which a shape has this value of `display`, from and to, in s.
std::vector<std::pair<double, double>> times_of(const pugi::xml_node& shape,
                                                std::string_view value) {
  std::vector<std::pair<double, double>> times;
  for (const pugi::xml_node& set : shape.children("set")) {
    if (set.attribute("attributeName").value() != std::string_view("display")) continue;
    EXPECT_EQ(set.attribute("to").value(), value);
    const double from = seconds_of(set, "begin");
    times.emplace_back(from, std::round(1e3 * (from + seconds_of(set, "dur"))) / 1e3);
  }
  return times;
}

TEST(AnimatedSvg, StrokesAppearAlongTheirPathOneAfterAnother) {
  testing::DrawnRecording made;
  for (int i = 0; i < 3; ++i) made.line({10.0, 10.0 + 20.0 * i}, {90.0, 10.0 + 20.0 * i}, 60);
  FilmFile film;
  read_film(made.take(), 10.0, film);
  ASSERT_EQ(film.shapes.size(), 3U);
  double end = 0.0;
  for (const pugi::xml_node& shape : film.shapes) {
    const pugi::xml_node mask = animation(shape, "mask");
    EXPECT_GE(seconds_of(mask, "begin"), end - 1e-9);
    EXPECT_GT(seconds_of(mask, "dur"), 1.5) << "each line takes about a third of 9 s";
    EXPECT_NEAR(seconds_of(animation(shape, "display"), "dur"), seconds_of(mask, "begin"), 1e-9)
        << "hidden until the pen begins";
    end = seconds_of(mask, "begin") + seconds_of(mask, "dur");
    const std::string id = mask.attribute("to").value();
    const pugi::xml_node line =
        film.xml.select_node(("//mask[@id='" + id.substr(5, id.size() - 6) + "']/path").c_str())
            .node();
    EXPECT_EQ(seconds_of(line.child("animate"), "begin"), seconds_of(mask, "begin"));
    EXPECT_EQ(seconds_of(line.child("animate"), "dur"), seconds_of(mask, "dur"));
    EXPECT_STREQ(shape.attribute("display").value(), "") << "seen without animations";
  }
  EXPECT_LE(end, 9.0) << "the last second is the hold";
}

TEST(AnimatedSvg, AStrokeThatChangesIsReplaced) {
  testing::DrawnRecording made;
  made.line({10.0, 30.0}, {90.0, 30.0}, 60, 0.0);
  made.event(SelectTool{"pull"});
  made.line({50.0, 30.0}, {50.0, 50.0}, 60, 0.0);
  FilmFile film;
  read_film(made.take(), 10.0, film);
  ASSERT_EQ(film.shapes.size(), 2U);
  const pugi::xml_node shown = animation(film.shapes[0], "display");
  EXPECT_STREQ(film.shapes[0].attribute("display").value(), "none") << "gone at the end";
  EXPECT_STREQ(shown.attribute("to").value(), "inline");
  const double replaced_s = seconds_of(shown, "begin") + seconds_of(shown, "dur");
  EXPECT_NEAR(seconds_of(animation(film.shapes[1], "display"), "dur"), replaced_s, 1e-9);
  EXPECT_FALSE(animation(film.shapes[1], "mask")) << "an edit does not draw";
}

TEST(AnimatedSvg, WhatIsUndoneDisappears) {
  testing::DrawnRecording made;
  made.line({10.0, 30.0}, {90.0, 30.0}, 60);
  made.event(UndoEvent{});
  made.line({10.0, 50.0}, {90.0, 50.0}, 60);
  FilmFile film;
  read_film(made.take(), 10.0, film);
  ASSERT_EQ(film.shapes.size(), 2U);
  int gone = 0;
  for (const auto& shape : film.shapes)
    gone += shape.attribute("display").value() == std::string_view("none");
  EXPECT_EQ(gone, 1);
}

TEST(AnimatedSvg, HiddenLayersHideTheirInk) {
  testing::DrawnRecording made;
  made.line({10.0, 30.0}, {90.0, 30.0}, 60);
  made.event(LayerEvent{.what = LayerEvent::Do::kAdd, .layer = {}});
  made.event(LayerEvent{.what = LayerEvent::Do::kHide, .layer = {1}});
  made.pause(1.0);
  made.event(LayerEvent{.what = LayerEvent::Do::kShow, .layer = {1}});
  FilmFile film;
  read_film(made.take(), 10.0, film);
  ASSERT_EQ(film.shapes.size(), 1U);
  EXPECT_STREQ(film.shapes[0].attribute("display").value(), "");
  EXPECT_EQ(times_of(film.shapes[0], "none").size(), 1U) << "drawn from the start, then hidden";
}

// Switching between layers under the onion skin.
TEST(AnimatedSvg, AShapeThatIsSeenAgainIsWrittenOnce) {
  constexpr std::array kLayers{LayerId{1}, LayerId{2}};
  testing::DrawnRecording made;
  made.line({10.0, 10.0}, {90.0, 10.0}, 30);
  made.event(LayerEvent{.what = LayerEvent::Do::kAdd, .layer = {}});
  made.event(UseView{{kLayers[0]}});
  made.line({10.0, 60.0}, {90.0, 60.0}, 30);
  made.pause(1.0);
  constexpr std::size_t kSwitches = 20;  // the last one is to the second layer
  for (std::size_t i = 0; i < kSwitches; ++i) {
    made.event(LayerEvent{.what = LayerEvent::Do::kUse, .layer = kLayers[i % 2]});
    made.event(UseView{{kLayers[1 - i % 2]}});
    made.pause(1.0);
  }
  FilmFile film;
  read_film(made.take(), 60.0, film);
  ASSERT_EQ(film.shapes.size(), 2U);
  const auto &first = film.shapes[0], &second = film.shapes[1];
  EXPECT_STREQ(first.attribute("display").value(), "none");
  EXPECT_STREQ(second.attribute("display").value(), "");
  const auto seen = times_of(first, "inline"), hidden = times_of(second, "none");
  ASSERT_EQ(seen.size(), 1 + kSwitches / 2);
  ASSERT_EQ(hidden.size(), 1 + kSwitches / 2);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_GT(seen[i].first, seen[i - 1].second);
    EXPECT_NEAR(seen[i].first, hidden[i].first, 0.2) << "one is seen while the other is hidden";
    EXPECT_NEAR(seen[i].second, hidden[i].second, 0.2);
  }
}

TEST(AnimatedSvg, LayersOutOfViewAreNotSeen) {
  testing::DrawnRecording made;
  made.line({10.0, 10.0}, {90.0, 10.0}, 30);
  made.event(LayerEvent{.what = LayerEvent::Do::kAdd, .layer = {}});
  made.event(UseView{{LayerId{1}}});
  made.line({10.0, 60.0}, {90.0, 60.0}, 30);
  made.event(UseView{});
  FilmFile film;
  read_film(made.take(), 10.0, film);
  ASSERT_EQ(film.shapes.size(), 2U);
  for (const auto& shape : film.shapes) EXPECT_STREQ(shape.attribute("display").value(), "");
  const auto first = times_of(film.shapes[0], "none"), second = times_of(film.shapes[1], "none");
  ASSERT_EQ(first.size(), 1U) << "out of view";
  ASSERT_EQ(second.size(), 1U) << "before it is drawn";
  EXPECT_LE(first[0].first, second[0].second);
  EXPECT_GT(first[0].second, second[0].second) << "the second line is drawn meanwhile";
}

TEST(AnimatedSvg, AnyRecordingGivesValidXml) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    FilmFile film;
    read_film(testing::random_recording(seed, 20), 5.0, film);
    for (const pugi::xml_node& shape : film.shapes) {
      for (const pugi::xml_node& set : shape.children("set")) {
        EXPECT_GT(seconds_of(set, "dur"), 0.0);
        EXPECT_LE(seconds_of(set, "begin") + seconds_of(set, "dur"), 5.0);
      }
    }
  }
}

TEST(AnimatedSvg, AnEmptyRecordingGivesAnEmptyPage) {
  FilmFile film;
  read_film({}, 1.0, film);
  EXPECT_TRUE(film.shapes.empty());
}

}  // namespace
}  // namespace felt::animated_svg_test
