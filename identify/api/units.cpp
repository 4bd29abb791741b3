#include <fourpost/units.h>

#include "analysis/text/units.h"
#include "analysis/text/unit_spelling.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"

namespace fourpost::api {

double ToSi(const std::string& quantity, const std::string& unit) {
  return Guarded([&] {
    const std::optional<Quantity> read = ParseQuantity(quantity);
    const std::optional<Unit> wanted = ParseUnit(unit);
    if (!wanted) Refuse(kUnitUnknown, {}, {unit, UnitHint(unit)});
    if (!read || read->unit.dimension != wanted->dimension) Refuse(kQuantityWrong, {}, {quantity, unit});
    return read->si;
  });
}

std::string InUnit(double si, const std::string& unit) {
  return Guarded([&] {
    if (!ParseUnit(unit)) Refuse(kUnitUnknown, {}, {unit, UnitHint(unit)});
    return FormatQuantity(si, unit);
  });
}

std::string SiUnitOf(const std::string& unit) {
  return Guarded([&] {
    const std::optional<Unit> read = ParseUnit(unit.empty() ? "1" : unit);
    if (!read) Refuse(kUnitUnknown, {}, {unit, UnitHint(unit)});
    return SiUnit(read->dimension);
  });
}

}  // namespace fourpost::api
