#pragma once

#include <string>

#include "identify/choice/choice_answer.h"

namespace fourpost {

/// The change of all objectives together over two knobs, the others at the best setting: the two that change it the
/// most from there. Empty without a best setting, or with one knob.
std::string SettingsSvg(const ChoiceAnswer& answer);

/// Changes of both objectives, a dot per setting, with their front. Empty with one objective, or without a best
/// setting.
std::string FrontSvg(const ChoiceAnswer& answer);

/// Root power spectral densities of the chassis' accelerations and the tyres' loads of the best setting beside the
/// present one. Empty without a best setting, or where the two are one.
std::string SpectraSvg(const ChoiceAnswer& answer);

}  // namespace fourpost
