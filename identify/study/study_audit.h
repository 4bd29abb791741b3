#pragma once

#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/audit/audit.h"
#include "identify/study/loaded_study.h"

namespace fourpost {

/// What the recordings of a study say of the rig that made them, see AuditRig(). Nothing without stepped sines or
/// time histories. Throws
/// FaultyInput when the vehicle cannot be assembled.
std::optional<Audit> AuditStudy(const LoadedStudy& study);

/// Of what an audit takes as stated: the motion of the posts.
bool ContradictsAnAudit(const Diagnostic& finding);

/// Which condition of an audit a study without one does not meet, and what to do; `findings`: those of the checks.
std::string NoAuditText(const LoadedStudy& study, const Diagnostics& findings);

/// One finding for each suspicion, at the channel's line of the study; what is certain (a sign, an exchange, a unit
/// that nothing else explains) as `certain`.
void ReportAudit(const LoadedStudy& study, const Audit& audit, Severity certain, Diagnostics& diagnostics);

}  // namespace fourpost
