#include "identify/command_line/unit_option.h"

#include <string>

#include "analysis/files/recorded_unit.h"
#include "identify/command_line/findings.h"

namespace fourpost {
namespace {

/// "post_FL=mm"; names of channels may have a sign of their own.
void AddUnit(const std::string& text, std::vector<StatedUnit>& units, Diagnostics& faults) {
  const std::size_t sign = text.rfind('=');
  const std::string unit = sign == std::string::npos ? "" : text.substr(sign + 1);
  if (sign == std::string::npos || sign == 0 || !ParseRecordedUnit(unit))
    faults.Report(kChannelUnitMalformed, Place::Option("--unit"), {text, RecordedUnitHint(unit)});
  else units.push_back({text.substr(0, sign), unit});
}

}  // namespace

CLI::Option* AddUnitOption(CLI::App& app, std::vector<StatedUnit>& units, Diagnostics& faults) {
  return app
      .add_option_function<std::vector<std::string>>(
          "--unit",
          [&units, &faults](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) AddUnit(text, units, faults);
          },
          "Unit of a channel in place of what the file has, CHANNEL=mm; * in the name is any text, as in 'post_*=mm'; "
          "once for each")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace fourpost
