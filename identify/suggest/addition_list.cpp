#include "identify/suggest/addition_list.h"

#include <algorithm>
#include <map>
#include <string>

#include "identify/suggest/addition_source.h"

namespace fourpost {

std::vector<Addition> AllAdditions(const LoadedStudy& study, const std::vector<double>& values) {
  const AdditionSource source(study.vehicle, values);
  std::vector<Addition> additions;
  AddMountAdditions(source, additions);
  AddFrictionAdditions(source, additions);
  AddDamperAdditions(source, additions);
  AddSpringAdditions(source, additions);
  const Experiments& experiments = study.study.experiments;
  if (std::none_of(experiments.begin(), experiments.end(),
                   [](const Experiment& one) { return one.IsOfSteadyMotions(); }))
    AddHysteresisAdditions(source, additions);
  AddTyreAdditions(source, additions);
  AddBushAdditions(source, additions);
  AddBodyAdditions(source, additions);
  AddGuideAdditions(source, additions);
  AddSideAdditions(source, additions);
  AddHeldAdditions(source, study.free, additions);
  AddChannelAdditions(source, study.study.text, additions);
  std::map<std::string, int> seen;
  for (Addition& addition : additions) addition.variant = seen[addition.Key()]++;
  return additions;
}

}  // namespace fourpost
