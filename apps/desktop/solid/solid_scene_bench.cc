#include "desktop/solid/solid_scene.h"

#include <benchmark/benchmark.h>

#include <QApplication>

#include "desktop/solid/testing/torus.h"

namespace felt::desktop {
namespace {

QApplication& application() {
  static int count = 1;
  static char name[] = "desktop_solid_bench";
  static char* arguments[] = {name, nullptr};
  static QApplication app(count, arguments);
  return app;
}

/// Turns a torus in a view of 600 x 600 pixels, on the display of this process: from the turn to
/// the picture in the window. The arguments are the number of triangles, and 1 with the wireframe.
/// The goal is 60 frames a second for 10^5 triangles with software OpenGL.
void turn_a_torus(benchmark::State& state) {
  application();
  SolidScene scene;
  scene.set_wireframe(state.range(1) ? WireframeChoice::kShow : WireframeChoice::kHide);
  scene.set_solid(testing::torus(static_cast<std::uint32_t>(state.range(0) / 200), 100));
  scene.resize(600, 600);
  scene.show();
  QApplication::processEvents();
  for (auto _ : state) {
    scene.turn(1.0, 0.3);
    scene.repaint();
    QApplication::processEvents();
  }
  state.SetLabel(scene.uses_opengl() ? "OpenGL" : "no OpenGL");
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(turn_a_torus)
    ->Args({100'000, 0})
    ->Args({20'000, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt::desktop
