#include "pixel_watch.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XShm.h>
#include <sys/ipc.h>
#include <sys/prctl.h>
#include <sys/shm.h>

#include <algorithm>
#include <chrono>

namespace felt::bench {
namespace {

constexpr unsigned kHeight = 5;
constexpr int kPaper = 150;                      // minimum brightness of paper, 0..255
constexpr int kInkDarker = 40;                   // minimum difference of ink from its paper
constexpr std::chrono::microseconds kPause{50};  // limits the load of the server

std::int64_t now_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct PixelWatch::Screen {
  Display* display = nullptr;
  Window root = 0;
  XShmSegmentInfo segment{};
  XImage* image = nullptr;

  bool open() {
    display = XOpenDisplay(nullptr);
    if (!display || !XShmQueryExtension(display)) return false;
    const int screen = DefaultScreen(display);
    root = RootWindow(display, screen);
    image = XShmCreateImage(display, DefaultVisual(display, screen),
                            static_cast<unsigned>(DefaultDepth(display, screen)), ZPixmap, nullptr,
                            &segment, 1, kHeight);
    if (!image) return false;
    const auto bytes = static_cast<std::size_t>(image->bytes_per_line) * kHeight;
    segment.shmid = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
    if (segment.shmid < 0) return false;
    image->data = segment.shmaddr = static_cast<char*>(shmat(segment.shmid, nullptr, 0));
    segment.readOnly = False;
    const bool attached = XShmAttach(display, &segment) != 0;
    XSync(display, False);
    shmctl(segment.shmid, IPC_RMID, nullptr);  // freed when the last process detaches it
    return attached;
  }

  /// Returns the green value of the darkest of the watched pixels, 0..255.
  int light(int x, int y) {
    XShmGetImage(display, root, image, x, y - static_cast<int>(kHeight / 2), AllPlanes);
    int smallest = 255;
    for (unsigned row = 0; row < kHeight; ++row) {
      const unsigned long pixel = XGetPixel(image, 0, static_cast<int>(row));
      smallest = std::min(smallest, static_cast<int>((pixel >> 8U) & 0xFFU));
    }
    return smallest;
  }

  ~Screen() {
    if (!display) return;
    if (segment.shmaddr) XShmDetach(display, &segment);
    if (image) {
      image->data = nullptr;
      XDestroyImage(image);
    }
    if (segment.shmaddr) shmdt(segment.shmaddr);
    XCloseDisplay(display);
  }
};

PixelWatch::PixelWatch() : screen_(std::make_unique<Screen>()), works_(screen_->open()) {
  if (works_) thread_ = std::jthread([this] { run(); });
}

PixelWatch::~PixelWatch() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

bool PixelWatch::arm(int x, int y) {
  x_ = x;
  y_ = y;
  seen_ns_ = 0;
  const std::uint64_t order = ++order_;
  while (taken_ != order) std::this_thread::sleep_for(kPause);
  return is_paper_;
}

double PixelWatch::look_ns() const noexcept {
  return static_cast<double>(looking_ns_) / static_cast<double>(looks_ + 1);
}

void PixelWatch::run() {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  int paper = 0;
  while (!stop_) {
    const std::uint64_t order = order_;
    if (taken_ != order) {
      paper = screen_->light(x_, y_);
      is_paper_ = paper >= kPaper;
      taken_ = order;
    }
    if (!is_paper_ || seen_ns_ != 0) {
      std::this_thread::sleep_for(4 * kPause);
      continue;
    }
    const std::int64_t before_ns = now_ns();
    const bool is_ink = screen_->light(x_, y_) <= paper - kInkDarker;
    const std::int64_t after_ns = now_ns();
    looking_ns_ += after_ns - before_ns;
    ++looks_;
    if (is_ink && order == order_) seen_ns_ = after_ns;
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace felt::bench
