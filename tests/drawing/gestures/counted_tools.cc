#include "tests/drawing/gestures/counted_tools.h"

#include <utility>

namespace felt::gestures {
namespace {

/// A tool that counts the contacts of another tool, and otherwise is that tool.
class CountedTool final : public Tool {
 public:
  CountedTool(std::unique_ptr<Tool> tool, std::uint64_t& touches)
      : tool_(std::move(tool)), touches_(touches) {}

  [[nodiscard]] const ToolInfo& info() const noexcept override { return tool_->info(); }
  ToolResult sample(const PenSample& sample, Contact::Change contact, const Scene& scene) override {
    if (contact == Contact::Change::kTouched) ++touches_;
    return tool_->sample(sample, contact, scene);
  }
  ToolResult finish(const Scene& scene) override { return tool_->finish(scene); }
  [[nodiscard]] std::optional<OfferView> offered() const override { return tool_->offered(); }
  void choose(OfferKind kind) override { tool_->choose(kind); }
  void cancel() override { tool_->cancel(); }
  [[nodiscard]] ForceModel force(const Scene& scene) const override { return tool_->force(scene); }
  void draw(Overlay& overlay) const override { tool_->draw(overlay); }
  Result<void> set_option(std::string_view id, const OptionValue& value) override {
    return tool_->set_option(id, value);
  }
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const override {
    return tool_->option(id);
  }
  [[nodiscard]] const Reading* reading() const override { return tool_->reading(); }
  [[nodiscard]] std::optional<ToolSize> size() const override { return tool_->size(); }
  [[nodiscard]] std::vector<std::pair<std::string_view, double>> options_for_size(
      double mm) const override {
    return tool_->options_for_size(mm);
  }

 private:
  std::unique_ptr<Tool> tool_;
  std::uint64_t& touches_;
};

}  // namespace

std::vector<std::unique_ptr<Tool>> make_counted_tools(std::uint64_t& touches) {
  std::vector<std::unique_ptr<Tool>> tools = make_tools();
  for (auto& tool : tools) tool = std::make_unique<CountedTool>(std::move(tool), touches);
  return tools;
}

}  // namespace felt::gestures
