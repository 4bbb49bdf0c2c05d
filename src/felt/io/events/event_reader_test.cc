#include "felt/io/events/event_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/testing/small_picture.h"

namespace felt::event_reader_test {
namespace {

using ::testing::HasSubstr;

/// The result of reading the first line of `text`.
struct Read {
  Event event;
  RawStroke stroke;
  ScriptLineKind kind = ScriptLineKind::kHeader;
  std::string error;
};

Read read_line(std::string_view text) {
  LineReader lines(read_text(text));
  LineBatch batch;
  Read read;
  if (!lines.fill(batch, 1).value_or(false)) {
    read.error = "no line";
    return read;
  }
  EventReader reader;
  const Result<ScriptLineKind> kind = reader.read(batch.line(0), read.event, read.stroke);
  if (kind) {
    read.kind = *kind;
  } else {
    read.error = kind.error().message;
  }
  return read;
}

Event event_of(std::string_view text) {
  const Read read = read_line(text);
  EXPECT_EQ(read.error, "") << text;
  EXPECT_EQ(read.kind, ScriptLineKind::kEvent) << text;
  return read.event;
}

std::string error_of(std::string_view text) {
  return read_line(text).error;
}

TEST(EventReader, ReadsEveryKind) {
  EXPECT_EQ(event_of(R"({"event":"tool","id":"pull","t_ms":1.5})"),
            (Event{1'500'000, SelectTool{"pull"}}));
  EXPECT_EQ(event_of(R"({"event":"option","id":"pull.radius_mm","value":20,"t_ms":0})"),
            (Event{0, SetOption{"pull.radius_mm", 20.0}}));
  EXPECT_EQ(event_of(R"({"event":"option","id":"a.b","value":true,"t_ms":0})"),
            (Event{0, SetOption{"a.b", true}}));
  EXPECT_EQ(event_of(R"({"event":"option","id":"a.b","value":"both","t_ms":0})"),
            (Event{0, SetOption{"a.b", std::string("both")}}));
  EXPECT_EQ(event_of(R"({"event":"pen","x":1,"y":-2.5,"z":0.25,"t_ms":2})"),
            (Event{2'000'000, PenEvent{{1, -2.5, 0.25}, {}, 0}}));
  EXPECT_EQ(event_of(R"({"event":"hand","x":1,"y":2,"z":-1,"pressure":0.5,"buttons":3,"t_ms":2})"),
            (Event{2'000'000, HandEvent{{1, 2, -1}, 0.5, 3}}));
  EXPECT_EQ(event_of(R"({"event":"undo","t_ms":3})"), (Event{3'000'000, UndoEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"redo","t_ms":3})"), (Event{3'000'000, RedoEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"cancel","t_ms":3})"), (Event{3'000'000, CancelEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"exact","t_ms":3})"), (Event{3'000'000, ExactEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"import","path":"a/b.ndjson","t_ms":3})"),
            (Event{3'000'000, ImportEvent{"a/b.ndjson"}}));
  EXPECT_EQ(event_of(R"({"event":"delete","t_ms":3})"), (Event{3'000'000, DeleteEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"as-drawn","t_ms":3})"), (Event{3'000'000, AsDrawnEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"duplicate","t_ms":3})"), (Event{3'000'000, DuplicateEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"move","t_ms":3,"dy":-2.5})"),
            (Event{3'000'000, MoveEvent{{0.0, -2.5}}}));
  EXPECT_EQ(event_of(R"({"event":"order","t_ms":3,"to":"front"})"),
            (Event{3'000'000, OrderEvent{OrderEvent::To::kFront}}));
  EXPECT_EQ(event_of(R"({"event":"restyle","medium":"chalk","t_ms":3})"),
            (Event{3'000'000, RestyleEvent{.medium = "chalk"}}));
  EXPECT_EQ(event_of(R"({"event":"restyle","opacity":0,"width":1.25,"t_ms":3})"),
            (Event{3'000'000, RestyleEvent{.opacity = 0.0, .width_factor = 1.25}}));
  EXPECT_EQ(event_of(R"({"event":"select","what":"invert","t_ms":3})"),
            (Event{3'000'000, SelectStrokes{SelectStrokes::What::kInvert}}));
}

TEST(EventReader, ReadsWhatIsDoneToLayers) {
  using Do = LayerEvent::Do;
  EXPECT_EQ(event_of(R"({"event":"layer","do":"add","t_ms":0})"), (Event{0, LayerEvent{}}));
  EXPECT_EQ(event_of(R"({"event":"layer","do":"add","id":7,"name":"Ideas","t_ms":0})"),
            (Event{0, LayerEvent{Do::kAdd, {}, "Ideas"}}))
      << "a new layer gets its own id";
  LayerEvent key;
  key.timing_of = {7};
  EXPECT_EQ(event_of(R"({"event":"layer","do":"add","timing_of":7,"t_ms":0})"), (Event{0, key}));
  EXPECT_EQ(event_of(R"({"event":"layer","do":"rename","id":2,"name":"b","t_ms":0})"),
            (Event{0, LayerEvent{Do::kRename, {2}, "b"}}));
  EXPECT_EQ(event_of(R"({"event":"layer","do":"hide","id":18446744073709551615,"name":"b",)"
                     R"("t_ms":0})"),
            (Event{0, LayerEvent{Do::kHide, {18446744073709551615U}, ""}}));
  EXPECT_EQ(event_of(R"({"event":"layer","do":"move","id":2,"index":3,"name":"b","t_ms":0})"),
            (Event{0, LayerEvent{Do::kMove, {2}, "", 3}}));
  EXPECT_EQ(event_of(R"({"event":"layer","do":"raise","id":2,"index":3,"t_ms":0})"),
            (Event{0, LayerEvent{Do::kRaise, {2}, ""}}));
  const std::pair<const char*, Do> kinds[] = {
      {"remove", Do::kRemove}, {"show", Do::kShow},   {"lock", Do::kLock}, {"unlock", Do::kUnlock},
      {"raise", Do::kRaise},   {"lower", Do::kLower}, {"use", Do::kUse}};
  for (const auto& [word, what] : kinds) {
    const std::string text =
        R"({"event":"layer","id":3,"t_ms":0,"do":")" + std::string(word) + "\"}";
    EXPECT_EQ(event_of(text), (Event{0, LayerEvent{what, {3}, ""}}));
  }
}

TEST(EventReader, ReadsDevices) {
  EXPECT_EQ(event_of(R"({"event":"device","t_ms":0})"), (Event{0, UseDevice{{}, 1}}));
  EXPECT_EQ(event_of(R"({"event":"device","t_ms":0,"defaults":3})"), (Event{0, UseDevice{{}, 3}}));
  EXPECT_EQ(error_of(R"({"event":"device","t_ms":0,"defaults":99})"),
            "defaults: 99 is from a newer version of Feltline");
  EXPECT_THAT(error_of(R"({"event":"device","t_ms":0,"defaults":0})"), HasSubstr("at least 1"));
  Capabilities can;
  can.sensed_axes = 2;
  can.max_force_n = 3.3;
  can.period_ns = 250'000;
  can.senses_pressure = true;
  EXPECT_EQ(
      event_of(R"({"event":"device","senses_pressure":true,"sensed_axes":2,"max_force_n":3.3,)"
               R"("period_ms":0.25,"t_ms":0})"),
      (Event{0, UseDevice{can, 1}}));
  EXPECT_EQ(event_of(R"({"event":"device","sheet_scale":1.5,"t_ms":0})"),
            event_of(R"({"event":"device","page_scale":1.5,"t_ms":0})"))
      << "the key of older recordings";
  EXPECT_EQ(error_of(R"({"event":"device","max_force_n":-1,"t_ms":0})"),
            "max_force_n: is negative");
  EXPECT_EQ(error_of(R"({"event":"device","period_ms":0,"t_ms":0})"),
            "period_ms: is not more than 0");
  EXPECT_THAT(error_of(R"({"event":"device","sensed_axes":2.5,"t_ms":0})"),
              HasSubstr("sensed_axes: 2.5 is not a whole number"));
  EXPECT_THAT(error_of(R"({"event":"device","delay_ticks":1001,"t_ms":0})"),
              HasSubstr("delay_ticks: 1001 is not a whole number"));
  EXPECT_THAT(error_of(R"({"event":"device","senses_pressure":1,"t_ms":0})"),
              HasSubstr("senses_pressure: "));
}

TEST(EventReader, SaysWhatIsWrongWithCommands) {
  EXPECT_EQ(error_of(R"({"event":"select","t_ms":0})"), "key \"what\" is missing");
  EXPECT_EQ(error_of(R"({"event":"select","what":"some","t_ms":0})"),
            "what: \"some\" is not one of all, none, invert");
  EXPECT_EQ(error_of(R"({"event":"layer","id":1,"t_ms":0})"), "key \"do\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"fly","id":1,"t_ms":0})"),
            "do: \"fly\" is not one of add, remove, rename, show, hide, lock, unlock, raise, "
            "lower, use, move, opacity, duplicate, merge, place, export, leave-out, blend, group, "
            "ungroup");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"hide","t_ms":0})"), "key \"id\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"rename","id":1,"t_ms":0})"),
            "key \"name\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"rename","id":1,"name":"","t_ms":0})"),
            "name: is empty");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"move","id":1,"t_ms":0})"),
            "key \"index\" is missing");
  for (const char* index : {"-1", "1.5", "\"1\"", "18446744073709551616", "null"}) {
    EXPECT_EQ(
        error_of(R"({"event":"layer","do":"move","id":1,"t_ms":0,"index":)" + std::string(index) +
                 "}"),
        "index: " + std::string(index) + " is not an index, which is a whole number, at least 0");
  }
  for (const char* id : {"0", "-1", "1.5", "\"1\"", "18446744073709551616", "null"}) {
    EXPECT_EQ(error_of(R"({"event":"layer","do":"hide","t_ms":0,"id":)" + std::string(id) + "}"),
              "id: " + std::string(id) + " is not a layer, which is a whole number, at least 1");
  }
}

TEST(EventReader, ReadsEdges) {
  EXPECT_EQ(event_of(R"({"event":"edges","t_ms":0})"), (Event{0, UseEdges{}}));
  EXPECT_EQ(event_of(R"({"event":"edges","page":[0,-1,210,297.5],"selection":true,"t_ms":0})"),
            (Event{0, UseEdges{{0, -1, 210, 297.5}, true}}));
  const auto error = [](const std::string& keys) {
    return error_of(R"({"event":"edges","t_ms":0,)" + keys + "}");
  };
  EXPECT_EQ(error(R"("page":[0,0,210])"), "page: has fewer than four numbers");
  EXPECT_EQ(error(R"("page":[0,0,-1,5])"), "page: is not a rectangle");
  EXPECT_NE(error(R"("page":[0,0,1,5,7])").find("only four numbers"), std::string::npos);
  EXPECT_EQ(error(R"("selection":1)"), "selection: 1 is not true or false");
  const auto contours = [](std::vector<std::vector<Point>> lines) {
    return Event{0, UseEdges{{}, false, std::move(lines)}};
  };
  EXPECT_EQ(event_of(R"({"event":"edges","contours":[[[1,2.5],[30,-4]],[]],"t_ms":0})"),
            contours({{{1, 2.5}, {30, -4}}, {}}));
  EXPECT_NE(error(R"("contours":[[1,2]])").find("contour"), std::string::npos);
  EXPECT_NE(error(R"("contours":[[[1]]])").find("a point has two numbers"), std::string::npos);
  std::string many = "[[0,0]";
  for (std::size_t i = 0; i < UseEdges::kMaxContourPoints; ++i) many += ",[0,0]";
  EXPECT_NE(error(R"("contours":[)" + many + "]]").find("at most 20000 points"), std::string::npos);
}

TEST(EventReader, ReadsRings) {
  EXPECT_EQ(event_of(R"({"event":"ring","t_ms":0})"), (Event{0, UseRing{}}));
  EXPECT_EQ(event_of(R"({"event":"ring","points":[[60,70],[60,54.5],[76,70]],"t_ms":0})"),
            (Event{0, UseRing{true, {60, 70}, {60, 54.5}, {76, 70}}}));
  EXPECT_EQ(error_of(R"({"event":"ring","points":[[60,70],[60,54.5]],"t_ms":0})"),
            "points: a ring has three, its middle, its top and its right");
}

TEST(EventReader, ReadsGuides) {
  const DrawingGuide ruler{DrawingGuideKind::kRuler, {20, 30.5}, 0.25};
  EXPECT_EQ(event_of(R"({"event":"guides","do":"add","kind":"ruler","x":20,"y":30.5,)"
                     R"("angle_rad":0.25,"t_ms":0})"),
            (Event{0, GuidesEvent{GuidesEvent::Do::kAdd, {}, ruler}}));
  EXPECT_EQ(event_of(R"({"event":"guides","do":"remove","id":7,"kind":"ruler","t_ms":0})"),
            (Event{0, GuidesEvent{GuidesEvent::Do::kRemove, {7}}}));
  EXPECT_EQ(event_of(R"({"event":"guide","kind":"none","t_ms":0})"), (Event{0, UseGuide{}}));
  EXPECT_EQ(event_of(R"({"event":"choose","what":"delete","t_ms":0})"),
            (Event{0, ChooseOffer{OfferKind::kDelete}}));
  EXPECT_EQ(
      event_of(
          R"({"event":"guide","kind":"groove","points":[[1,2],[3,4.5]],"closed":true,"t_ms":0})"),
      (Event{0, UseGuide{{GuideKind::kGroove, {{1, 2}, {3, 4.5}}, true, 1.0, {}}}}));
  EXPECT_EQ(event_of(R"({"times_ms":[0,9],"points":[[1,2],[3,4]],"strength":0.25,)"
                     R"("kind":"teacher","event":"guide","t_ms":0})"),
            (Event{0, UseGuide{{GuideKind::kTeacher, {{1, 2}, {3, 4}}, false, 0.25, {0, 9}}}}));
  const auto error = [](const std::string& keys) {
    return error_of(R"({"event":"guide","t_ms":0,)" + keys + "}");
  };
  EXPECT_EQ(error(R"("points":[])"), "key \"kind\" is missing");
  EXPECT_EQ(error(R"("kind":"wall")"),
            "kind: \"wall\" is not one of none, groove, as-needed, error-amplifying, teacher");
  EXPECT_EQ(error(R"("kind":"groove")"), "points: a guide has 2 to 20000 points, but there are 0");
  EXPECT_EQ(error(R"("kind":"groove","points":7)"), "points: 7 is not an array");
  EXPECT_EQ(error(R"("kind":"groove","points":[[0,0],[1]])"), "points[1]: a point has two numbers");
  EXPECT_EQ(error(R"("kind":"groove","points":[[0,0,0]])"),
            "points[0]: point[2]: a point has only two numbers");
  EXPECT_THAT(error(R"("kind":"groove","points":[[0,0],[1e10,0]])"),
              HasSubstr("points[1]: point[0]: "));
  EXPECT_EQ(error(R"("kind":"groove","points":[[0,0],[9,0]],"closed":1)"),
            "closed: 1 is not true or false");
  EXPECT_EQ(error(R"("kind":"groove","points":[[0,0],[9,0]],"strength":2)"),
            "strength: is not from 0 to 1");
  EXPECT_EQ(error(R"("kind":"teacher","points":[[0,0],[9,0]],"times_ms":[1,0])"),
            "times_ms[1]: is before the time of the previous point");
  EXPECT_THAT(error(R"("kind":"teacher","points":[[0,0],[9,0]],"times_ms":[1,1e10])"),
              HasSubstr("times_ms[1]: "));
  std::string many = "[0,0]";
  for (std::size_t i = 0; i < kMaxGuidePoints; ++i) many += ",[1,0]";
  EXPECT_EQ(error(R"("kind":"groove","points":[)" + many + "]"),
            "points[20000]: a guide has at most 20000 points");
}

TEST(EventReader, KeysInAnyOrderAndOthersIgnored) {
  EXPECT_EQ(event_of(R"( { "z":-1 , "note":{"a":[1,null]}, "t_ms":7, "y":2, "id":[], "x":1,)"
                     R"( "\u0065vent":"p\u0065n" } )"),
            (Event{7'000'000, PenEvent{{1, 2, -1}, {}, 0}}));
}

TEST(EventReader, APenMayTilt) {
  const auto pen = [](const std::string& tilt) {
    return R"({"event":"pen","x":1,"y":2,"z":-1,"t_ms":0,"tilt":)" + tilt + "}";
  };
  EXPECT_EQ(event_of(pen("32.5")), (Event{0, PenEvent{{1, 2, -1}, {}, 0, 32.5}}));
  EXPECT_EQ(event_of(pen("0")), (Event{0, PenEvent{{1, 2, -1}, {}, 0, 0.0}}));
  EXPECT_EQ(event_of(pen("90")), (Event{0, PenEvent{{1, 2, -1}, {}, 0, 90.0}}));
  EXPECT_EQ(event_of(pen("null")), (Event{0, PenEvent{{1, 2, -1}, {}, 0}}));
  EXPECT_EQ(event_of(R"({"event":"hand","x":1,"y":2,"z":-1,"tilt":45,"t_ms":0})"),
            (Event{0, HandEvent{{1, 2, -1}, {}, 0, 45.0}}));
  EXPECT_EQ(event_of(R"({"event":"pen","x":1,"y":2,"z":-1,"lean":32.5,"t_ms":0})"),
            (Event{0, PenEvent{{1, 2, -1}, {}, 0, 32.5}}))
      << "the key in older recordings";
  EXPECT_EQ(error_of(pen("-0.5")), "tilt: -0.5 is not an angle from 0 to 90 degrees");
  EXPECT_EQ(error_of(pen("90.001")), "tilt: 90.001 is not an angle from 0 to 90 degrees");
  EXPECT_EQ(error_of(pen("\"45\"")), "tilt: \"45\" is not a number");
  EXPECT_THAT(error_of(pen("1e99")), HasSubstr("tilt: 1e99 is malformed, or larger than"));
  EXPECT_THAT(error_of(pen("NaN")), HasSubstr("NaN"));
  EXPECT_EQ(error_of(pen("[45]")), "tilt: [ is not a number");
  EXPECT_EQ(error_of(pen("true")), "tilt: true is not a number");
}

TEST(EventReader, WithoutDepthPressureDecides) {
  EXPECT_EQ(event_of(R"({"event":"pen","x":1,"y":2,"pressure":0.5,"t_ms":0})"),
            (Event{0, PenEvent{{1, 2, 0}, 0.5, 0}}));
  EXPECT_EQ(error_of(R"({"event":"pen","x":1,"y":2,"t_ms":0})"),
            "key \"z\" is missing, and there is no pressure");
  EXPECT_EQ(error_of(R"({"event":"hand","x":1,"y":2,"pressure":null,"t_ms":0})"),
            "key \"z\" is missing, and there is no pressure");
}

TEST(EventReader, PressureIsLimitedToItsRangeAndRawPressureIsAnError) {
  for (const char* raw : {"512", "1.06", "-0.06"}) {
    EXPECT_EQ(error_of(R"({"event":"pen","x":1,"y":2,"z":0,"pressure":)" + std::string(raw) +
                       R"(,"t_ms":0})"),
              "pressure: is not between 0 and 1");
  }
  const Event above = event_of(R"({"event":"pen","x":1,"y":2,"z":0,"pressure":1.01,"t_ms":0})");
  EXPECT_EQ(std::get<PenEvent>(above.what).pressure, 1.0);
  const Event below = event_of(R"({"event":"pen","x":1,"y":2,"z":0,"pressure":-0.01,"t_ms":0})");
  EXPECT_EQ(std::get<PenEvent>(below.what).pressure, 0.0);
}

TEST(EventReader, ReadsTimingsAndEditsOfTheBody) {
  EXPECT_EQ(
      event_of(R"({"event":"timing","ids":[2],"between":0,"pairs":[[3,5],[0,7]],"t_ms":0})"),
      (Event{0, TimingEvent{.layers = {{2}}, .between = 0, .pairs = {{{{3}, {5}}, {{}, {7}}}}}}));
  EXPECT_EQ(event_of(R"({"event":"body","do":"add","kind":"cut","path":[[1,-2,0],[3,-4,0.5]],)"
                     R"("color":"#b02020","amount":1,"t_ms":0})"),
            (Event{0, BodyEvent{BodyEvent::Do::kAdd,
                                {},
                                {.kind = BodyEditKind::kCut,
                                 .path_mm = {{1, -2, 0}, {3, -4, 0.5}},
                                 .color = {0xb0, 0x20, 0x20, 255},
                                 .amount = 1}}}));
  EXPECT_EQ(event_of(R"({"event":"view","hidden":[3,1],"t_ms":0})"),
            (Event{0, UseView{{{3}, {1}}}}));
  EXPECT_EQ(event_of(R"({"event":"view","hidden":[],"t_ms":0})"), (Event{0, UseView{}}));
  EXPECT_THAT(error_of(R"({"event":"view","hidden":[0],"t_ms":0})"),
              HasSubstr("hidden[0]: 0 is not a layer"));
  const auto timing_error = [](const std::string& keys) {
    return error_of(R"({"event":"timing","t_ms":0,)" + keys + "}");
  };
  EXPECT_EQ(timing_error(R"("between":3)"), "key \"ids\" is missing");
  EXPECT_EQ(timing_error(R"("ids":[])"), "ids: there is no layer");
  EXPECT_EQ(timing_error(R"("ids":[1],"between":1001)"),
            "between: 1001 is not a whole number from 0 to 1000");
  EXPECT_EQ(timing_error(R"("ids":[1],"hold":0)"), "hold: 0 is not a whole number from 1 to 1000");
  EXPECT_EQ(timing_error(R"("ids":[1],"ease":[0,0,1])"), "ease: has fewer than four numbers");
  EXPECT_EQ(timing_error(R"("ids":[1],"ease":[0,0,1,1.5])"),
            "ease: the numbers must be from 0 to 1");
  EXPECT_EQ(timing_error(R"("ids":[1],"pairs":[[0,0]])"), "pairs: a pair has no stroke");
  EXPECT_EQ(timing_error(R"("ids":[1],"pairs":[[1,2],[1,3]])"), "pairs: a stroke is in two pairs");
  EXPECT_THAT(timing_error(R"("ids":[1],"pairs":[[1]])"), HasSubstr("a pair has two strokes"));
  const auto body_error = [](const std::string& keys) {
    return error_of(R"({"event":"body","t_ms":0,)" + keys + "}");
  };
  EXPECT_EQ(body_error(R"("do":"remove")"), "key \"id\" is missing");
  EXPECT_EQ(body_error(R"("do":"remove","id":0)"),
            "id: 0 is not an edit of the body, which is a whole number, at least 1");
  EXPECT_EQ(body_error(R"("do":"add")"), "key \"kind\" is missing");
  EXPECT_EQ(body_error(R"("do":"add","kind":"cut")"), "path: has too few points");
  EXPECT_EQ(body_error(R"("do":"add","kind":"paint","path":[[1,2,3]],"view":[0,0,2])"),
            "view: is not a unit vector");
  EXPECT_EQ(body_error(R"("do":"add","kind":"paint","path":[[1,2,3]],"profile":[[1,2,3]])"),
            "profile: only an extrusion has one");
}

TEST(EventReader, NamesTheKeyAndTheReason) {
  EXPECT_EQ(
      error_of(R"({"event":"fly","t_ms":0})"),
      "event: \"fly\" is not one of tool, option, pen, hand, undo, redo, cancel, as-drawn, "
      "exact, import, select, delete, duplicate, move, order, restyle, layer, picture, device, "
      "material, guide, choose, guides, edges, ring, timing, body, view, line");
  EXPECT_EQ(error_of(R"({"event":7,"t_ms":0})"), "event: 7 is not a string");
  EXPECT_EQ(error_of(R"({"event":"undo"})"), "key \"t_ms\" is missing");
  EXPECT_EQ(error_of(R"({"event":"undo","t_ms":null})"), "t_ms: null is not a number");
  EXPECT_EQ(error_of(R"({"event":"undo","t_ms":-1})"),
            "t_ms: is before 0, the start of the session");
  EXPECT_EQ(error_of(R"({"event":"undo","t_ms":1000000001})"),
            "t_ms: 1000000001 is malformed, or larger than 1e9");
  EXPECT_EQ(error_of(R"({"event":"undo","event":"undo","t_ms":0})"), "key \"event\" occurs twice");
  EXPECT_EQ(error_of(R"({"event":"undo","t_ms":0,"t_ms":0})"), "key \"t_ms\" occurs twice");
  EXPECT_EQ(error_of(R"({"event":"tool","t_ms":0})"), "key \"id\" is missing");
  EXPECT_EQ(error_of(R"({"event":"tool","id":1,"t_ms":0})"), "id: 1 is not a string");
  EXPECT_EQ(error_of(R"({"event":"tool","id":"","t_ms":0})"), "id: is empty");
  EXPECT_EQ(error_of(R"({"event":"option","id":"a.b","t_ms":0})"), "key \"value\" is missing");
  EXPECT_EQ(error_of(R"({"event":"option","id":"a.b","value":null,"t_ms":0})"),
            "value: null is not a number, a string, true or false");
  EXPECT_EQ(error_of(R"({"event":"option","id":"a.b","value":[1],"t_ms":0})"),
            "value: [ is not a number, a string, true or false");
  EXPECT_EQ(error_of(R"({"event":"pen","x":"1","y":2,"z":0,"t_ms":0})"),
            "x: \"1\" is not a number");
  EXPECT_EQ(error_of(R"({"event":"pen","x":NaN,"y":2,"z":0,"t_ms":0})"), "x: NaN is not a number");
  EXPECT_EQ(error_of(R"({"event":"pen","x":1,"y":2e9,"z":0,"t_ms":0})"),
            "y: 2e9 is malformed, or larger than 1e9");
  EXPECT_EQ(error_of(R"({"event":"pen","x":1,"z":0,"t_ms":0})"), "key \"y\" is missing");
  EXPECT_THAT(error_of(R"({"event":"pen","x":1,"y":2,"z":0,"buttons":-1,"t_ms":0})"),
              HasSubstr("buttons: -1 is not a whole number"));
  EXPECT_THAT(error_of(R"({"event":"pen","x":1,"y":2,"z":0,"buttons":4294967296,"t_ms":0})"),
              HasSubstr("buttons: 4294967296 is not a whole number"));
  EXPECT_EQ(error_of(R"({"event":"import","path":"a\u0000b","t_ms":0})"), "path: contains a NUL");
  EXPECT_THAT(error_of(R"({"event":"undo","t_ms":0,"note":tru})"),
              HasSubstr("note: tru is not a JSON value"));
}

TEST(EventReader, RefusesWhatIsNoJson) {
  for (const char* text :
       {"hello", "[1]", "{", R"({"event":"undo","t_ms":0)", R"({"event":"undo","t_ms":0}x)",
        R"({"event":"undo","t_ms":0,})", R"({"event":"undo" "t_ms":0})", R"({"event":"un)",
        R"({"event":"undo","t_ms":0,"note":tru})", R"({"event":"undo","t_ms":0,"note":1 2})"}) {
    EXPECT_NE(error_of(text), "") << text;
  }
}

TEST(EventReader, TellsStrokesAndHeaders) {
  const Read stroke = read_line(R"({"id":"s1","points":[[1,2],[3,4]]})");
  EXPECT_EQ(stroke.kind, ScriptLineKind::kStroke);
  EXPECT_EQ(stroke.stroke.id, "s1");
  EXPECT_EQ(stroke.stroke.samples.size(), 2U);
  EXPECT_EQ(read_line(R"({"feltline":1,"unit":"mm"})").kind, ScriptLineKind::kHeader);
  EXPECT_EQ(read_line(R"({"event":"undo","points":[[1,2]],"t_ms":0})").kind,
            ScriptLineKind::kEvent);
  EXPECT_EQ(error_of(R"({"points":[]})"), "points: is empty");
  EXPECT_EQ(error_of(R"({"x":1})"), "neither an event nor a stroke: key \"event\" is missing");
}

TEST(ReadEvents, SaysWhereATimeRunsBackwards) {
  const Result<std::vector<Event>> events =
      read_events("a.ndjson", read_text("{\"event\":\"undo\",\"t_ms\":5}\n\n"
                                        "{\"event\":\"undo\",\"t_ms\":5}\n"
                                        "{\"event\":\"undo\",\"t_ms\":4.5}\n"));
  ASSERT_FALSE(events);
  EXPECT_EQ(events.error().message,
            "a.ndjson:4: t_ms: 4.5 is before 5, the time of the previous event");
}

TEST(ReadEvents, StrokesAreNoEvents) {
  const Result<std::vector<Event>> events =
      read_events("a.ndjson", read_text("{\"feltline\":1}\n{\"points\":[[1,2]]}\n"));
  ASSERT_FALSE(events);
  EXPECT_EQ(events.error().message, "a.ndjson:2: found a stroke, but only events are allowed");
}

TEST(ReadScript, GivesLinesInOrderAndPlacesTheErrorsOfTheSink) {
  std::string seen;
  ScriptSink sink;
  sink.event = [&seen](const Event& event) -> Result<void> {
    seen += event.time_ns == 9'000'000 ? "!" : "e";
    if (event.time_ns == 9'000'000) return fail(ErrorCode::kNotFound, "no such tool");
    return {};
  };
  sink.stroke = [&seen](const RawStroke&) -> Result<void> {
    seen += "s";
    return {};
  };
  const Result<void> done =
      read_script("b",
                  read_text("{\"event\":\"undo\",\"t_ms\":5}\n{\"points\":[[1,2]]}\n"
                            "{\"event\":\"undo\",\"t_ms\":9}\n{\"event\":\"undo\",\"t_ms\":10}"),
                  sink);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "b:3: no such tool");
  EXPECT_EQ(seen, "es!");
}

TEST(ReadScript, HoldsAScriptOfAnyLengthALineAtATime) {
  // Reads 40 MiB that are never in memory together, because the source generates them while they
  // are read.
  constexpr int kEvents = 1'000'000;
  int made = 0, seen = 0;
  std::string left;
  const ReadBytes source = [&](std::span<char> into) -> Result<std::size_t> {
    while (left.size() < into.size() && made < kEvents) {
      left +=
          "{\"event\":\"pen\",\"x\":1,\"y\":2,\"z\":0,\"t_ms\":" + std::to_string(made++) + "}\n";
    }
    const std::size_t count = std::min(left.size(), into.size());
    std::copy_n(left.data(), count, into.data());
    left.erase(0, count);
    return count;
  };
  ScriptSink sink;
  sink.event = [&seen](const Event& event) -> Result<void> {
    if (event.time_ns != seen * std::int64_t{1'000'000}) return fail(ErrorCode::kInvalidData, "!");
    ++seen;
    return {};
  };
  const Result<void> done = read_script("c", source, sink);
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_EQ(seen, kEvents);
}

TEST(EventReader, ReadsPicturesAndTheirPlaces) {
  using Do = LayerEvent::Do;
  const std::string png(testing::kRedBluePng);
  EXPECT_EQ(
      event_of(
          R"({"event":"picture","t_ms":0,"name":"Photo","opacity":0.5,"matrix":[2,0,0,3,4,5],"png":")" +
          png + "\"}"),
      (Event{0, AddPicture{"Photo", testing::picture_data(), {2, 0, 0, 3, 4, 5}, 0.5}}));
  LayerEvent faded{Do::kOpacity, {3}};
  faded.opacity = 0.25;
  EXPECT_EQ(event_of(R"({"event":"layer","do":"opacity","id":3,"opacity":0.25,"t_ms":0})"),
            (Event{0, faded}));
  LayerEvent moved{Do::kPlace, {3}};
  moved.place = {1, 0, 0, 1, -7, 8};
  EXPECT_EQ(event_of(R"({"event":"layer","do":"place","id":3,"matrix":[1,0,0,1,-7,8],"t_ms":0})"),
            (Event{0, moved}));
}

TEST(EventReader, RefusesBadPictures) {
  const auto error = [](const std::string& keys) {
    return error_of(R"({"event":"picture","t_ms":0,"matrix":[1,0,0,1,0,0],)" + keys + "}");
  };
  EXPECT_EQ(error(R"("name":"a")"), "key \"png\" is missing");
  EXPECT_EQ(error(R"("png":"***")"), "png: is not base64");
  EXPECT_EQ(error(R"("png":"Zm9v")"), "png: the picture is not a PNG file");
  std::string cut(testing::kColorfulPng);
  cut.resize(80);
  EXPECT_THAT(error("\"png\":\"" + cut + "\""),
              ::testing::StartsWith("png: the PNG file is damaged"));
  EXPECT_EQ(error_of(R"({"event":"layer","do":"opacity","id":1,"t_ms":0})"),
            "key \"opacity\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"blend","id":1,"t_ms":0})"),
            "key \"mode\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"blend","id":1,"mode":"screen","t_ms":0})"),
            "mode: \"screen\" is not one of normal, multiply");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"group","id":1,"t_ms":0})"),
            "key \"ids\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"group","ids":[1,0],"t_ms":0})"),
            "ids[1]: 0 is not a layer, which is a whole number, at least 1");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"ungroup","id":1,"t_ms":0})"),
            "key \"group\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"hide","group":0,"t_ms":0})"),
            "key \"id\" is missing");
  EXPECT_EQ(error_of(R"({"event":"layer","do":"use","group":1,"t_ms":0})"),
            "key \"id\" is missing");
}

TEST(EventReader, ReadsBlendModesAndGroups) {
  using Do = LayerEvent::Do;
  LayerEvent blend{Do::kBlend, {2}};
  blend.mode = BlendMode::kMultiply;
  EXPECT_EQ(event_of(R"({"event":"layer","do":"blend","id":2,"mode":"multiply","t_ms":0})"),
            (Event{0, blend}));
  LayerEvent group{Do::kGroup, {}, "Cat"};
  group.layers = {{2}, {3}};
  EXPECT_EQ(event_of(R"({"event":"layer","do":"group","ids":[2,3],"name":"Cat","t_ms":0})"),
            (Event{0, group}));
  LayerEvent hide{Do::kHide, {}};
  hide.group = GroupId{4};
  EXPECT_EQ(event_of(R"({"event":"layer","do":"hide","group":4,"t_ms":0})"), (Event{0, hide}));
  LayerEvent out{Do::kMove, {2}, {}, 1};
  out.group = GroupId{};
  EXPECT_EQ(event_of(R"({"event":"layer","do":"move","id":2,"index":1,"group":0,"t_ms":0})"),
            (Event{0, out}));
  EXPECT_EQ(error_of(R"({"event":"layer","do":"place","id":1,"t_ms":0})"),
            "key \"matrix\" is missing");
  for (const char* matrix :
       {"[1,0,0,1,0]", "[1,0,0,1,0,0,0]", "[1,1,1,1,0,0]", "[1e5,0,0,1,0,0]"}) {
    EXPECT_THAT(error_of(R"({"event":"layer","do":"place","id":1,"t_ms":0,"matrix":)" +
                         std::string(matrix) + "}"),
                ::testing::StartsWith("matrix"))
        << matrix;
  }
}

}  // namespace
}  // namespace felt::event_reader_test
