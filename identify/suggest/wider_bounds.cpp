#include "identify/suggest/wider_bounds.h"

#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "identify/suggest/vehicle_edit.h"
#include "vehicles/tags/tag.h"

namespace fourpost {

std::optional<std::string> WithWiderBounds(const std::string& vehicle, const std::vector<BoundReached>& reached) {
  constexpr double kFactor = 10;
  VehicleEdit edit(vehicle);
  bool is_wider = false;
  for (const BoundReached& one : reached) {
    const tinyxml2::XMLElement* element = edit.Find("fp:parameter", one.parameter);
    if (!element || !AttributeText(*element, "source").value_or("").starts_with("suggested: ")) continue;
    const auto bound = ParseQuantity(AttributeText(*element, one.bound.c_str()).value_or(""));
    if (!bound || bound->si == 0) continue;
    const bool is_outward = (bound->si > 0) == (one.bound == "upper");
    edit.Set(*element, one.bound,
             FormatQuantity(AtDigits(is_outward ? bound->si * kFactor : bound->si / kFactor, 4), bound->unit_text));
    is_wider = true;
  }
  return is_wider ? std::optional(edit.Text()) : std::nullopt;
}

}  // namespace fourpost
