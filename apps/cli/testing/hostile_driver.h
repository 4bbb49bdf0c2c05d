#pragma once

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "felt/driver/driver.h"

namespace felt::cli {

/// A driver for tests. It finds the devices that the test specifies, or misbehaves like the worst
/// vendor libraries.
class HostileDriver final : public Driver {
 public:
  enum class Manner { kWell, kCrashes, kHangs, kExits, kThrows, kPrints };

  explicit HostileDriver(std::string name, Manner manner = Manner::kWell)
      : name_(std::move(name)), label_("Maker of " + name_), manner_(manner) {}

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] std::string_view label() const noexcept override { return label_; }
  std::vector<DeviceDescriptor> find() override {
    switch (manner_) {
      case Manner::kCrashes:
        std::fputs("about to fall over\n", stderr);
        std::signal(SIGSEGV, SIG_DFL);  // not the sanitizer's
        std::raise(SIGSEGV);
        break;
      case Manner::kHangs:
        for (;;) pause();
      case Manner::kExits:
        std::fputs("symbol lookup error: undefined symbol: hdBeginFrame\n", stderr);
        _exit(127);
      case Manner::kThrows:
        throw std::runtime_error("something in C++");
      case Manner::kPrints:
        std::puts("Welcome to our library, version 3");
        std::fflush(stdout);
        break;
      case Manner::kWell:
        break;
    }
    return devices;
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions&) override {
    return fail(ErrorCode::kUnsupported, device.id + ": is for show");
  }
  std::vector<Finding> diagnose(const SystemView&) override { return findings; }

  std::vector<DeviceDescriptor> devices;
  std::vector<Finding> findings;

 private:
  std::string name_, label_;
  Manner manner_;
};

}  // namespace felt::cli
