#include <cmath>
#include <utility>

#include "identify/experiments/audited_vehicle.h"
#include "identify/experiments/four_post/four_post.h"

namespace fourpost {

void FourPost::AddRecordings(AuditedVehicle& audited) const {
  for (const MeasuredRun& run : RunsInBand()) {
    AuditedRun added = audited.Blank(run.name, run.excitation.frequency_Hz);
    for (std::size_t p = 0; p < run.excitation.shape.size(); ++p)
      added.posts.row(static_cast<Eigen::Index>(p)).setConstant(run.excitation.shape[p]);
    for (const MeasuredChannel& channel : run.channels) {
      // Its members contradict each other, which is a finding of its own.
      if (channel.has_opposed_members) continue;
      for (std::size_t f = 0; f < channel.response.size(); ++f)
        audited.Put(added, channel.sensor, f, channel.response[f],
                    std::hypot(channel.radial_sd[f], channel.tangential_sd[f]) / std::sqrt(2.0));
    }
    audited.Add(std::move(added), run.excitation.amplitude_m);
  }
}

}  // namespace fourpost
