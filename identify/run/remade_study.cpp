#include "identify/run/remade_study.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "analysis/files/output_folder.h"
#include "identify/study/loaded_study.h"
#include "identify/suggest/addition_list.h"
#include "identify/suggest/applied_suggestion.h"
#include "identify/suggest/suggestions.h"

namespace fourpost {
namespace {

class Remaker {
 public:
  Remaker(const RemakeRequest& request, const std::filesystem::path& folder)
      : request_(request), folder_(folder), values_(request.values) {}

  bool Run() {
    Diagnostics findings;
    std::optional<LoadedStudy> study = LoadStudy(request_.study, findings, request_.set);
    if (!study) throw FaultyInput(findings);
    for (const GrowthAddition& addition : request_.additions) {
      if (!Make(*study, addition)) {
        RemoveFiles();
        return false;
      }
      study = LoadSoundStudy(folder_ / "study.yaml");
    }
    return !request_.additions.empty();
  }

 private:
  bool Make(const LoadedStudy& study, const GrowthAddition& wanted) {
    Eigen::VectorXd free(static_cast<Eigen::Index>(study.free.size()));
    std::vector<double> all = study.vehicle.ParameterValues();
    for (std::size_t i = 0; i < study.free.size(); ++i) {
      double& value = all[study.free[i]];
      const auto known = values_.find(study.vehicle.parameters[study.free[i]].name);
      if (known != values_.end()) value = known->second;
      free[static_cast<Eigen::Index>(i)] = value;
    }
    std::vector<Addition> offered = AllAdditions(study, all);
    const std::optional<std::size_t> place = PlaceOf(wanted, offered);
    if (!place) return false;
    SuggestedAddition made{.addition = std::move(offered[*place]), .amount = wanted.amount, .others = free};
    SetValues(wanted, made);
    Write(Apply(study, made, folder_));
    return true;
  }

  /// Its parameters may have other names than before.
  void SetValues(const GrowthAddition& wanted, SuggestedAddition& made) {
    if (!made.addition.values) return;
    made.values = made.addition.values(made.amount);
    for (std::size_t i = 0; i < std::min(made.values.size(), wanted.parameters.size()); ++i)
      if (const auto known = request_.values.find(wanted.parameters[i]); known != request_.values.end())
        made.values[i] = known->second;
    for (std::size_t i = 0; i < made.values.size(); ++i) values_[made.addition.parameters[i]] = made.values[i];
  }

  void Write(const AppliedSuggestion& applied) const {
    OutputFolder output(folder_, "", "study.yaml");
    output.Add("vehicle.urdf", applied.vehicle);
    output.Add("study.yaml", applied.study);
    output.Commit();
  }

  void RemoveFiles() const {
    std::error_code ignored;
    for (const char* name : {"study.yaml", "vehicle.urdf"}) std::filesystem::remove(folder_ / name, ignored);
    std::filesystem::remove(folder_, ignored);
  }

  const RemakeRequest& request_;
  const std::filesystem::path& folder_;
  std::map<std::string, double> values_;
};

}  // namespace

std::optional<std::size_t> PlaceOf(const GrowthAddition& wanted, const std::vector<Addition>& offered) {
  std::optional<std::size_t> best;
  int most = -1;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    const Addition& one = offered[i];
    if (one.mechanism != wanted.mechanism || one.elements != wanted.elements) continue;
    const int alike = (one.words == wanted.words ? 2 : 0) + (one.variant == wanted.variant ? 1 : 0);
    if (alike <= most) continue;
    most = alike;
    best = i;
  }
  return best;
}

bool RemakeStudy(const RemakeRequest& request, const std::filesystem::path& folder) {
  return Remaker(request, folder).Run();
}

}  // namespace fourpost
