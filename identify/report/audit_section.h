#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace fourpost {

/// What `audit` of a result says of the rig, as HTML: suspected faults with how sure they are, what each channel leaves
/// over of the rigid motion that all agree on, and from which size on a fault of it would be seen. Empty of a result
/// without an audit.
std::string AuditHtml(const nlohmann::json& result);

}  // namespace fourpost
