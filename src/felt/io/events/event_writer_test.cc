#include "felt/io/events/event_writer.h"
#include "felt/document/testing/random_guides.h"
#include "felt/document/testing/small_picture.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <cstring>

#include "felt/io/events/event_reader.h"

namespace felt::event_writer_test {
namespace {

std::string line_of(const Event& event) {
  std::string line;
  append_event_line(line, event);
  return line;
}

TEST(EventWriter, WritesKeysInAFixedOrder) {
  EXPECT_EQ(line_of({0, SelectTool{"pull"}}), "{\"t_ms\":0,\"event\":\"tool\",\"id\":\"pull\"}\n");
  EXPECT_EQ(line_of({1, SetOption{"a.b", 0.1}}),
            "{\"t_ms\":1e-06,\"event\":\"option\",\"id\":\"a.b\",\"value\":0.1}\n");
  EXPECT_EQ(line_of({0, SetOption{"a.b", false}}),
            "{\"t_ms\":0,\"event\":\"option\",\"id\":\"a.b\",\"value\":false}\n");
  EXPECT_EQ(line_of({0, SetOption{"a.b", std::string("x\"")}}),
            "{\"t_ms\":0,\"event\":\"option\",\"id\":\"a.b\",\"value\":\"x\\\"\"}\n");
  EXPECT_EQ(line_of({2'500'000, PenEvent{{1, 2, -0.5}, 0.25, 1}}),
            "{\"t_ms\":2.5,\"event\":\"pen\",\"x\":1,\"y\":2,\"z\":-0.5,\"pressure\":0.25,"
            "\"buttons\":1}\n");
  EXPECT_EQ(line_of({0, HandEvent{{1, 2, 3}, {}, 0}}),
            "{\"t_ms\":0,\"event\":\"hand\",\"x\":1,\"y\":2,\"z\":3}\n");
  EXPECT_EQ(line_of({0, PenEvent{{1, 2, 3}, {}, 0, 32.5}}),
            "{\"t_ms\":0,\"event\":\"pen\",\"x\":1,\"y\":2,\"z\":3,\"tilt\":32.5}\n");
  EXPECT_EQ(line_of({0, PenEvent{{1, 2, 3}, {}, 300000}}),
            "{\"t_ms\":0,\"event\":\"pen\",\"x\":1,\"y\":2,\"z\":3,\"buttons\":300000}\n");
  EXPECT_EQ(line_of({0, HandEvent{{1, 2, 3}, 0.5, 1, 0.0}}),
            "{\"t_ms\":0,\"event\":\"hand\",\"x\":1,\"y\":2,\"z\":3,\"pressure\":0.5,\"buttons\":1,"
            "\"tilt\":0}\n");
  EXPECT_EQ(line_of({0, UndoEvent{}}), "{\"t_ms\":0,\"event\":\"undo\"}\n");
  EXPECT_EQ(line_of({0, RedoEvent{}}), "{\"t_ms\":0,\"event\":\"redo\"}\n");
  EXPECT_EQ(line_of({0, CancelEvent{}}), "{\"t_ms\":0,\"event\":\"cancel\"}\n");
  EXPECT_EQ(line_of({0, UseEdges{}}), "{\"t_ms\":0,\"event\":\"edges\"}\n");
  EXPECT_EQ(line_of({0, UseEdges{{0, 1, 2.5, 3}, true}}),
            "{\"t_ms\":0,\"event\":\"edges\",\"page\":[0,1,2.5,3],\"selection\":true}\n");
  EXPECT_EQ(line_of({0, UseRing{}}), "{\"t_ms\":0,\"event\":\"ring\"}\n");
  EXPECT_EQ(line_of({0, UseRing{true, {60, 70}, {60, 54.5}, {76, 70}}}),
            "{\"t_ms\":0,\"event\":\"ring\",\"points\":[[60,70],[60,54.5],[76,70]]}\n");
  EXPECT_EQ(line_of({0, TimingEvent{{{2}, {3}}, 8, 2, EaseCurve{0.42, 0, 1, 1}}}),
            "{\"t_ms\":0,\"event\":\"timing\",\"ids\":[2,3],\"between\":8,\"hold\":2,"
            "\"ease\":[0.42,0,1,1]}\n");
  EXPECT_EQ(line_of({0, TimingEvent{.layers = {{2}}, .pairs = {{{{3}, {5}}, {{4}, {}}}}}}),
            "{\"t_ms\":0,\"event\":\"timing\",\"ids\":[2],\"pairs\":[[3,5],[4,0]]}\n");
  EXPECT_EQ(line_of({0, BodyEvent{BodyEvent::Do::kRemove, {7}}}),
            "{\"t_ms\":0,\"event\":\"body\",\"do\":\"remove\",\"id\":7}\n");
  EXPECT_EQ(line_of({0, BodyEvent{BodyEvent::Do::kAdd,
                                  {},
                                  {BodyEditKind::kPaint, {{1, -2, 3}}, {}, {0, 1, 0}, 4}}}),
            "{\"t_ms\":0,\"event\":\"body\",\"do\":\"add\",\"kind\":\"paint\",\"path\":[[1,-2,3]],"
            "\"view\":[0,1,0],\"width_mm\":4}\n");
  EXPECT_EQ(line_of({0, ExactEvent{}}), "{\"t_ms\":0,\"event\":\"exact\"}\n");
  EXPECT_EQ(line_of({0, ImportEvent{"a.svg"}}),
            "{\"t_ms\":0,\"event\":\"import\",\"path\":\"a.svg\"}\n");
  EXPECT_EQ(line_of({0, ImportEvent{"a.svg", true}}),
            "{\"t_ms\":0,\"event\":\"import\",\"path\":\"a.svg\",\"select\":true}\n");
  EXPECT_EQ(line_of({0, SelectStrokes{SelectStrokes::What::kNone}}),
            "{\"t_ms\":0,\"event\":\"select\",\"what\":\"none\"}\n");
  EXPECT_EQ(line_of({0, DeleteEvent{}}), "{\"t_ms\":0,\"event\":\"delete\"}\n");
  EXPECT_EQ(line_of({0, AsDrawnEvent{}}), "{\"t_ms\":0,\"event\":\"as-drawn\"}\n");
  EXPECT_EQ(line_of({0, DuplicateEvent{}}), "{\"t_ms\":0,\"event\":\"duplicate\"}\n");
  EXPECT_EQ(line_of({0, MoveEvent{{1, -0.5}}}),
            "{\"t_ms\":0,\"event\":\"move\",\"dx\":1,\"dy\":-0.5}\n");
  EXPECT_EQ(line_of({0, OrderEvent{OrderEvent::To::kBack}}),
            "{\"t_ms\":0,\"event\":\"order\",\"to\":\"back\"}\n");
  EXPECT_EQ(line_of({0, RestyleEvent{"#b02020", "chalk"}}),
            "{\"t_ms\":0,\"event\":\"restyle\",\"color\":\"#b02020\",\"medium\":\"chalk\"}\n");
  EXPECT_EQ(line_of({0, RestyleEvent{.opacity = 0.5, .width_factor = 1.25}}),
            "{\"t_ms\":0,\"event\":\"restyle\",\"opacity\":0.5,\"width\":1.25}\n");
  EXPECT_EQ(line_of({0, LayerEvent{LayerEvent::Do::kAdd, {}, "Ideas"}}),
            "{\"t_ms\":0,\"event\":\"layer\",\"do\":\"add\",\"name\":\"Ideas\"}\n");
  EXPECT_EQ(
      line_of({0, UseDevice{}}),
      "{\"t_ms\":0,\"event\":\"device\",\"sensed_axes\":3,\"actuated_axes\":3,\"max_force_n\":0,"
      "\"continuous_force_n\":0,\"advised_force_n\":0,\"max_stiffness_n_per_m\":0,"
      "\"max_damping_n_s_per_m\":0,\"position_step_mm\":0,\"period_ms\":1,\"delay_ticks\":1,"
      "\"senses_pressure\":false,\"defaults\":" +
          std::to_string(kOptionDefaults) + "}\n");
  EXPECT_EQ(line_of({0, ChooseOffer{OfferKind::kCircle}}),
            "{\"t_ms\":0,\"event\":\"choose\",\"what\":\"circle\"}\n");
  EXPECT_EQ(line_of({0, UseGuide{}}), "{\"t_ms\":0,\"event\":\"guide\",\"kind\":\"none\"}\n");
  EXPECT_EQ(line_of({0, UseGuide{{GuideKind::kTeacher, {{1, 2}, {3.5, 4}}, false, 0.5, {0, 7}}}}),
            "{\"t_ms\":0,\"event\":\"guide\",\"kind\":\"teacher\",\"points\":[[1,2],[3.5,4]],"
            "\"strength\":0.5,\"times_ms\":[0,7]}\n");
  EXPECT_EQ(line_of({0, LayerEvent{LayerEvent::Do::kHide, {12}, ""}}),
            "{\"t_ms\":0,\"event\":\"layer\",\"do\":\"hide\",\"id\":12}\n");
}

/// Generates any number that a script may contain, many of them with all 17 digits.
rc::Gen<double> numbers() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) return 0.1;
    return std::fabs(number) <= 1e9 ? number : std::fmod(number, 1e9);
  });
}

rc::Gen<std::string> event_texts() {
  return rc::gen::map(
      rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
          "a", ".", "\"", "\\", "\n", "\x01", "\xC3\xA9", "\xF0\x9F\x96\x8B", "/"))),
      [](const std::vector<std::string>& parts) {
        std::string text;
        for (const std::string& part : parts) text += part;
        return text;
      });
}

OptionValue any_value() {
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 0) return *numbers();
  if (kind == 1) return *rc::gen::arbitrary<bool>();
  return *event_texts();
}

Vec3 any_place() {
  return {*numbers(), *numbers(), *numbers()};
}

std::optional<double> any_pressure() {
  if (!*rc::gen::arbitrary<bool>()) return {};
  return *rc::gen::inRange(0, 1 << 20) / 1048576.0;
}

std::optional<double> any_tilt() {
  if (!*rc::gen::arbitrary<bool>()) return {};
  return 90.0 * (*rc::gen::inRange(0, (1 << 20) + 1) / 1048576.0);
}

Affine any_picture_place() {
  const double x = std::fmod(*numbers(), 1e5), y = std::fmod(*numbers(), 1e5);
  return {*rc::gen::inRange(1, 1000) / 7.0, 0.1, -0.1, *rc::gen::inRange(1, 1000) / 3.0, x, y};
}

LayerEvent any_layer_event() {
  using Do = LayerEvent::Do;
  LayerEvent event{static_cast<Do>(*rc::gen::inRange(0, 20)), {}, {}};
  if (event.what == Do::kGroup) {
    event.layers = {{1}, {*rc::gen::positive<std::uint64_t>()}};
    return event;
  }
  const bool may_be_group = event.what == Do::kHide || event.what == Do::kMove;
  if (event.what == Do::kUngroup || (may_be_group && *rc::gen::arbitrary<bool>())) {
    event.group = GroupId{*rc::gen::positive<std::uint64_t>()};
    return event;
  }
  if (event.what == Do::kMove && *rc::gen::arbitrary<bool>()) event.group = GroupId{};
  if (event.what != Do::kAdd) event.layer.value = *rc::gen::positive<std::uint64_t>();
  if (event.what == Do::kAdd) event.timing_of.value = *rc::gen::inRange<std::uint64_t>(0, 3);
  const bool is_named = event.what == Do::kAdd ? *rc::gen::arbitrary<bool>() : false;
  if (is_named || event.what == Do::kRename) event.name = *event_texts();
  if (event.what == Do::kMove) event.index = *rc::gen::arbitrary<std::uint32_t>();
  if (event.what == Do::kOpacity) event.opacity = *rc::gen::inRange(0, 1001) / 1000.0;
  if (event.what == Do::kPlace) event.place = any_picture_place();
  if (event.what == Do::kBlend) event.mode = BlendMode::kMultiply;
  return event;
}

/// Generates any device, except for its workspace, which is not written.
UseDevice any_device() {
  const auto quantity = [] { return std::fabs(*numbers()); };
  Capabilities can;
  can.sensed_axes = *rc::gen::inRange(0, 8);
  can.actuated_axes = *rc::gen::inRange(0, 8);
  can.max_force_n = quantity();
  can.continuous_force_n = quantity();
  can.advised_force_n = quantity();
  can.max_stiffness_n_per_m = quantity();
  can.max_damping_n_s_per_m = quantity();
  can.position_step_mm = quantity();
  can.friction_n = quantity();
  can.mass_kg = quantity();
  can.period_ns = *rc::gen::inRange<std::int64_t>(1, 1'000'000'001);
  can.delay_ticks = *rc::gen::inRange(0, 8);
  can.senses_pressure = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) can.page_scale = 1.25;
  return {can, *rc::gen::inRange(1, kOptionDefaults + 1)};
}

/// Generates a guide that check_guide accepts.
GuideLine any_guide() {
  GuideLine line{.kind = static_cast<GuideKind>(*rc::gen::inRange(0, 5))};
  line.strength = *rc::gen::inRange(0, (1 << 20) + 1) / 1048576.0;
  if (line.kind == GuideKind::kNone) return line;
  const bool is_teacher = line.kind == GuideKind::kTeacher;
  line.is_closed = !is_teacher && *rc::gen::arbitrary<bool>();
  line.points = {{0.0, 0.0}, {1.5, 0.0}};
  for (int i = *rc::gen::inRange(0, 20); i > 0; --i) {
    line.points.push_back({std::fmod(*numbers(), 100.0), std::fmod(*numbers(), 100.0)});
  }
  for (std::size_t i = 0; is_teacher && i < line.points.size(); ++i) {
    line.times_ms.push_back(0.1 * static_cast<double>(i));
  }
  return line;
}

GuidesEvent any_guides_event() {
  using Do = GuidesEvent::Do;
  testing::RandomStroke random(*rc::gen::arbitrary<std::uint64_t>());
  GuidesEvent event{static_cast<Do>(*rc::gen::inRange(0, 7))};
  if (event.what == Do::kChange || event.what == Do::kRemove) {
    event.id = {*rc::gen::inRange<std::uint64_t>(1, 1ULL << 53)};
  }
  if (event.what == Do::kAdd || event.what == Do::kChange) {
    event.guide = testing::random_guide(random);
  }
  return event;
}

TimingEvent any_timing_event() {
  testing::RandomStroke random(*rc::gen::arbitrary<std::uint64_t>());
  const KeyTiming timing = testing::random_timing(random);
  TimingEvent event{{{1}, {*rc::gen::inRange<std::uint64_t>(2, 1ULL << 53)}}};
  if (*rc::gen::arbitrary<bool>()) event.between = timing.between;
  if (*rc::gen::arbitrary<bool>()) event.hold = timing.hold;
  if (*rc::gen::arbitrary<bool>()) event.ease = timing.ease;
  if (*rc::gen::arbitrary<bool>()) event.pairs = timing.pairs;
  return event;
}

BodyEvent any_body_event() {
  using Do = BodyEvent::Do;
  testing::RandomStroke random(*rc::gen::arbitrary<std::uint64_t>());
  BodyEvent event{static_cast<Do>(*rc::gen::inRange(0, 3))};
  if (event.what == Do::kRemove) event.id = {*rc::gen::inRange<std::uint64_t>(1, 1ULL << 53)};
  if (event.what == Do::kAdd) event.edit = testing::random_body_edit(random);
  return event;
}

Event any_event(std::int64_t time_ns) {
  Event event{time_ns, {}};
  switch (*rc::gen::inRange(0, 25)) {
    case 0:
      event.what = SelectTool{*event_texts()};
      break;
    case 1:
      event.what = SetOption{*event_texts(), any_value()};
      break;
    case 2:
      event.what =
          PenEvent{any_place(), any_pressure(), *rc::gen::arbitrary<std::uint32_t>(), any_tilt()};
      break;
    case 3:
      event.what =
          HandEvent{any_place(), any_pressure(), *rc::gen::arbitrary<std::uint32_t>(), any_tilt()};
      break;
    case 4:
      event.what = UndoEvent{};
      break;
    case 5:
      event.what = RedoEvent{};
      break;
    case 6:
      event.what = CancelEvent{};
      break;
    case 7:
      event.what = SelectStrokes{static_cast<SelectStrokes::What>(*rc::gen::inRange(0, 3))};
      break;
    case 8:
      event.what = DeleteEvent{};
      break;
    case 9:
      event.what = DuplicateEvent{};
      break;
    case 10:
      event.what = any_layer_event();
      break;
    case 11:
      event.what = any_device();
      break;
    case 12:
      event.what = MoveEvent{{*rc::gen::inRange(-10'000, 10'001) * 0.999, any_place().x * 1e-6}};
      break;
    case 13:
      event.what = OrderEvent{static_cast<OrderEvent::To>(*rc::gen::inRange(0, 2))};
      break;
    case 14:
      event.what = UseGuide{any_guide()};
      break;
    case 16:
      event.what = ChooseOffer{static_cast<OfferKind>(*rc::gen::inRange(0, 10))};
      break;
    case 17:
      event.what = any_guides_event();
      break;
    case 18:
      event.what = UseEdges{{0.1, -7.0, *rc::gen::inRange(1, 900) * 0.7, 8.5},
                            *rc::gen::arbitrary<bool>(),
                            {{{0.1, 2.0}, {30.0, *rc::gen::inRange(-9, 9) * 0.3}}, {}}};
      break;
    case 19:
      event.what = *rc::gen::arbitrary<bool>()
                       ? UseRing{}
                       : UseRing{true, {*numbers(), 1.0}, {0.1, *numbers()}, {*numbers(), 0.0}};
      break;
    case 20:
      event.what = any_timing_event();
      break;
    case 21:
      event.what = any_body_event();
      break;
    case 22:
      event.what = *rc::gen::arbitrary<bool>() ? UseView{} : UseView{{{1}, {7}}};
      break;
    case 23:
      event.what =
          AddLine{{{*numbers(), 1.0}, {0.1, *numbers()}}, *rc::gen::arbitrary<bool>(), *numbers()};
      break;
    case 15:
      event.what = AddPicture{*event_texts(), testing::picture_data(), any_picture_place(),
                              *rc::gen::inRange(0, 1001) / 1000.0};
      break;
    default:
      event.what = ImportEvent{*event_texts(), *rc::gen::arbitrary<bool>()};
  }
  return event;
}

// Recording and replaying depend on this: written events read back as the same events, bit for bit,
// and are written again as the same bytes.
RC_GTEST_PROP(EventRoundTrip, IsLossless, ()) {
  constexpr std::int64_t kLatestNs = 1'000'000'000'000'000;
  std::vector<std::int64_t> times = *rc::gen::container<std::vector<std::int64_t>>(
      rc::gen::inRange<std::int64_t>(0, kLatestNs + 1));
  std::sort(times.begin(), times.end());
  std::vector<Event> events;
  std::string text;
  for (const std::int64_t time_ns : times) {
    events.push_back(any_event(time_ns));
    append_event_line(text, events.back());
  }
  const Result<std::vector<Event>> read = read_events("script", read_text(text));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == events);
  std::string again;
  for (const Event& event : *read) append_event_line(again, event);
  RC_ASSERT(again == text);
}

}  // namespace
}  // namespace felt::event_writer_test
