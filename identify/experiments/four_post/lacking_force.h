#pragma once

#include <vector>

#include "identify/audit/audit_subject.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/subject.h"
#include "identify/missing_force/force_record.h"

namespace fourpost {

/// The force that the vehicle, at these values of its parameters, lacks in the motion that was measured. The motion
/// follows from the sensors that see motion alone, by their places, each weighed by its noise (see AuditEquations);
/// harmonics beyond the first are those of the model. Frequencies at which an element has no periodic force are left
/// out. `audited`: these runs, as FourPost::AddRecordings makes them. The same for
/// any number of threads.
ForceRecord LackingForce(const Subject& subject, const std::vector<double>& values,
                         const std::vector<MeasuredRun>& runs, const AuditSubject& audited, int threads);

}  // namespace fourpost
