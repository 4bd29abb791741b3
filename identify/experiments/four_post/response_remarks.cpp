#include "identify/experiments/four_post/response_remarks.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

bool IsForce(const ComparedChannel& channel) { return channel.unit == "N" || channel.unit == "kN"; }

bool HasMean(const ComparedChannel& channel) {
  return std::any_of(channel.mean_measured.begin(), channel.mean_measured.end(),
                     [](double mean) { return std::isfinite(mean); });
}

}  // namespace

ReportRemarks ResponseRemarks(const std::vector<ComparedChannel>& channels) {
  ReportRemarks remarks;
  if (channels.empty()) return remarks;
  remarks.measures_force = std::any_of(channels.begin(), channels.end(), IsForce);
  remarks.where_open =
      "Measure a force, static corner loads or the wheel pans: accelerations alone do not determine the common scale "
      "of masses, rates and damping.";
  if (std::none_of(channels.begin(), channels.end(), HasMean))
    remarks.further.emplace_back(
        "Record the mean offset of the struts as well as gain and phase: it separates bump from rebound damping.");
  return remarks;
}

}  // namespace fourpost
