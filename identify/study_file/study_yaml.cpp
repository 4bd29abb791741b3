#include "identify/study_file/study_yaml.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "identify/study_file/findings.h"

namespace fourpost {
namespace {

/// Keys, values, lists and mappings; the longest study that comes with fourpost has some hundred.
constexpr std::size_t kMostNodes = 5000;
/// Of a text; some hundred lines are some ten thousand.
constexpr std::size_t kLongestText = std::size_t{1} << 20;

/// Looks at a text before it is made into nodes.
class Inspector : public YAML::EventHandler {
 public:
  Inspector(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  bool good() const { return good_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 2) Fault(mark, kStudyTwoDocuments);
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { Begin(mark, "", anchor), End(); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto is_within = [&](const Open& open) { return open.anchor == anchor; };
    if (std::any_of(open_.begin(), open_.end(), is_within)) Fault(mark, kStudyAliasOfItself);
    Count(mark, nodes_of_[anchor]);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string&) override {
    Begin(mark, tag, anchor), End();
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Begin(mark, tag, anchor);
  }
  void OnSequenceEnd() override { End(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Begin(mark, tag, anchor);
  }
  void OnMapEnd() override { End(); }

 private:
  struct Open {
    YAML::anchor_t anchor;
    std::size_t nodes_before;
  };

  void Fault(const YAML::Mark& mark, const Finding& finding, const std::vector<std::string>& words = {}) {
    if (good_) diagnostics_.Report(finding, {file_, mark.line + 1}, words);
    good_ = false;
  }

  void Begin(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    // "?" of plain and "!" of quoted values stand for none.
    if (!tag.empty() && tag != "?" && tag != "!") Fault(mark, kStudyTag, {tag});
    open_.push_back({anchor, nodes_});
    Count(mark, 1);
  }

  void End() {
    nodes_of_[open_.back().anchor] = nodes_ - open_.back().nodes_before;
    open_.pop_back();
  }

  void Count(const YAML::Mark& mark, std::size_t nodes) {
    nodes_ += nodes;
    if (nodes_ <= kMostNodes) return;
    Fault(mark, kStudyTooManyValues, {std::to_string(kMostNodes)});
    // Aliases of aliases would else overflow.
    nodes_ = kMostNodes;
  }

  std::string file_;
  Diagnostics& diagnostics_;
  bool good_ = true;
  int documents_ = 0;
  std::size_t nodes_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> nodes_of_;
};

bool IsGood(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  if (text.size() > kLongestText) {
    diagnostics.Report(kStudyTooLong, {file});
    return false;
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Inspector inspector(file, diagnostics);
  while (inspector.good() && parser.HandleNextDocument(inspector)) {
  }
  return inspector.good();
}

}  // namespace

std::optional<YAML::Node> ReadYaml(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  try {
    if (IsGood(text, file, diagnostics)) return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    diagnostics.Report(kStudyNotYaml, {file, error.mark.is_null() ? 0 : error.mark.line + 1}, {error.msg});
  }
  return std::nullopt;
}

}  // namespace fourpost
