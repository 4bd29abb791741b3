#pragma once

#include <string>

#include "identify/choice/choice_answer.h"

namespace fourpost {

// Sentences about a choice that the terminal and the page share; each ends with a stop.

/// A share in percent at two decimals: "-8.31".
std::string TwoDecimals(double share);
/// "-8.31 %"
std::string SharePercent(double share);
/// "-9.02 .. -7.51"
std::string IntervalPercent(const DrawSummary& summary);

/// What was compared: settings, roads, possible cars.
std::string ScopeWords(const ChoiceAnswer& answer);
/// What P(best) and regret contain, and what not; empty without a best one.
std::string DoubtWords(const ChoiceAnswer& answer);
/// What is chosen, and what it brings; or that nothing is.
std::string VerdictWords(const ChoiceAnswer& answer);
/// How many settings cannot be distinguished from the best; empty without a best one.
std::string IndistinctWords(const ChoiceAnswer& answer);
/// What a click away costs; empty without a best one.
std::string ClickWords(const ChoiceAnswer& answer);
/// Whose doubt decides; empty where none does.
std::string DecidingWords(const ChoiceAnswer& answer);
/// What to run on the rig next; empty where nothing would gain.
std::string RunWords(const ChoiceAnswer& answer);
/// How far engines differ, and how many settings are within that of the best; empty where none were compared.
std::string EngineWords(const ChoiceAnswer& answer);

}  // namespace fourpost
