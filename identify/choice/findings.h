#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a file of settings, and what a choice needs a word about.
namespace fourpost {

// Tables of positions.

inline const Finding kPositionsUnit{"positions-unit", Severity::kError, "column '{}' has the unknown unit '{}'{}",
                                    "write one such as N*s/m in the second line"};
inline const Finding kPositionsNumber{"positions-number", Severity::kError, "column '{}' has no number here",
                                      "give every position a number"};
inline const Finding kPositionsFew{"positions-few", Severity::kError,
                                   "a table of positions needs a column of positions, another one, and two rows",
                                   "write `position,rate`, their units, and a row for each position"};
inline const Finding kPositionsTwice{"positions-twice", Severity::kError, "position '{}' is given twice",
                                     "remove one of the two rows"};
inline const Finding kPositionsNoControl{"positions-no-control", Severity::kError,
                                         "the fitted study states no settings that its parameters follow",
                                         "fit a study with 'control' and two settings or more, or name a table"};

// Knobs.

inline const Finding kKnobsNone{"knobs-none", Severity::kError, "'knobs' must map names to what can be set",
                                "write `knobs:` and below it `front: {sets: k_front, values: [40 kN/m, 44 kN/m]}`"};
inline const Finding kKnobSource{"knob-source", Severity::kError,
                                 "knob '{}' must have one of 'table', 'bench', 'values' and 'range', and has {}"};
inline const Finding kKnobSetsNothing{"knob-sets-nothing", Severity::kError,
                                      "'sets' of knob '{}' must name parameters of the vehicle",
                                      "write `sets: k_front`, `sets: [k_FL, k_FR]`, or with 'table' and 'bench' "
                                      "`sets: {c_front_bump: bump}`"};
inline const Finding kKnobParameter{"knob-parameter", Severity::kError,
                                    "knob '{}': the vehicle has no parameter '{}'{}"};
inline const Finding kKnobParameterTwice{"knob-parameter-twice", Severity::kError,
                                         "knob '{}' sets '{}', which another knob sets as well",
                                         "remove it from one of the two"};
inline const Finding kKnobFactor{"knob-factor", Severity::kError, "knob '{}': '{}' is not a factor for '{}'",
                                 "write a number above zero, such as 1"};
inline const Finding kKnobColumn{"knob-column", Severity::kError, "knob '{}': the table has no column '{}'{}"};
inline const Finding kKnobUnit{"knob-unit", Severity::kError, "knob '{}': {} is not a {}, as '{}' is",
                               "write it with a unit such as {}"};
inline const Finding kKnobRange{
    "knob-range", Severity::kError,
    "knob '{}': 'range' needs 'from', a larger 'to', and a 'step' that makes 2 to 1000 positions",
    "write `range: {from: 40 kN/m, to: 60 kN/m, step: 2 kN/m}`"};
inline const Finding kKnobPositions{"knob-positions", Severity::kError,
                                    "knob '{}': 'positions' must be a list, or {from: 1, to: 20, step: 1}"};
inline const Finding kKnobFew{"knob-few", Severity::kError, "knob '{}' has fewer than two positions",
                              "give it another one, or remove the knob"};
inline const Finding kKnobPositionTwice{"knob-position-twice", Severity::kError,
                                        "knob '{}' has the position '{}' twice", "remove one of the two"};
inline const Finding kKnobOutside{"knob-outside", Severity::kError, "knob '{}': position '{}' is outside its table, {}",
                                  "choose one within, or measure it and add a row"};
inline const Finding kKnobNow{"knob-now", Severity::kError, "knob '{}' has no position '{}' for 'now'{}"};
inline const Finding kKnobChange{"knob-change", Severity::kError, "'change' of knob '{}' is '{}'{}",
                                 "write ratio, difference or absolute"};
inline const Finding kKnobChangeWithoutNow{"knob-change-without-now", Severity::kError,
                                           "knob '{}' changes by {} but does not state where the fitted car stands",
                                           "add `now:` with that position"};
inline const Finding kKnobSign{"knob-sign", Severity::kError,
                               "knob '{}': position '{}' makes '{}' {}, on the other side of zero than the car's {}",
                               "check the position, its factor and 'change'"};

// Roads, objectives and limits.

inline const Finding kRoadsNone{"roads-none", Severity::kError, "'roads' must be a list of roads",
                                "write lines such as `- {class: B, speed: 80 km/h}`"};
inline const Finding kRoadClass{"road-class", Severity::kError, "no road of ISO 8608 is of class '{}'{}"};
inline const Finding kRoadTwice{"road-twice", Severity::kError, "the road '{}' is there twice",
                                "give one of them another `name`, or remove it"};
inline const Finding kMetricUnknown{"metric-unknown", Severity::kError, "no metric of this vehicle is called '{}'{}"};
inline const Finding kObjectiveNoCost{"objective-no-cost", Severity::kError, "less of '{}' is not better",
                                      "name it under 'limits'"};
inline const Finding kObjectiveWeight{"objective-weight", Severity::kError,
                                      "the weight of '{}' is '{}', not a number above zero"};
inline const Finding kObjectiveTwice{"objective-twice", Severity::kError, "'{}' is an objective twice",
                                     "remove one of the two"};
inline const Finding kObjectivesNone{"objectives-none", Severity::kError, "'objectives' names no metric",
                                     "name one or two, or remove it: comfort and grip are the usual ones"};
inline const Finding kObjectivesMany{"objectives-many", Severity::kError,
                                     "more than two objectives leave most settings undominated",
                                     "keep the two that matter most, and name the others under 'limits'"};
inline const Finding kLimitsNotMapped{"limits-not-mapped", Severity::kError,
                                      "'limits' must map metrics to their limits",
                                      "write lines such as `travel_front: {most: 60 mm}`"};
inline const Finding kLimitEmpty{"limit-empty", Severity::kError, "the limit of '{}' states nothing",
                                 "write {most: ...} or {least: ...}"};
inline const Finding kLimitReversed{"limit-reversed", Severity::kError,
                                    "the limit of '{}' is at most less than at least", "exchange the two"};
inline const Finding kLimitUnit{"limit-unit", Severity::kError, "{} must be {}"};
inline const Finding kSettingsShare{"settings-share", Severity::kError, "{} must be a share above 0 % and up to 100 %",
                                    "write it in percent, such as 2 %"};

// What is chosen.

inline const Finding kCarWithoutPosts{"car-without-posts", Severity::kError,
                                      "the vehicle has no fp:post, so no road moves it", "add one under each tyre",
                                      Weight::kGrave};
inline const Finding kChoiceWithoutDoubt{
    "choice-without-doubt", Severity::kWarning,
    "a vehicle file without a fit has no standard deviations: one car is rated, and "
    "nothing is said of how sure the choice is",
    "fit the vehicle, and name the folder of the fit"};
inline const Finding kChoiceBenchDoubtOnly{
    "choice-bench-doubt-only", Severity::kWarning,
    "a vehicle file without a fit has no standard deviations: the doubt is that of the benched laws alone",
    "fit the vehicle, and name the folder of the fit"};
inline const Finding kBenchWithoutDoubt{
    "bench-without-doubt", Severity::kWarning,
    "the bench fit '{}' has no covariance: its laws count as exact, so P(best) is too high and the regret too low",
    "fit the bench again with this version"};
inline const Finding kRoadBeyondBand{"road-beyond-band", Severity::kWarning,
                                     "{} of the mean square of '{}' lie beyond the fitted band up to {} Hz",
                                     "fit a wider band, or narrow 'band' of the settings"};
inline const Finding kRoadBeyondSpeeds{"road-beyond-speeds", Severity::kWarning,
                                       "on {} of {} roads the damper '{}' is faster than any recording of the fit ({} "
                                       "m/s) for more than 5 % of time, up to {} "
                                       "m/s on '{}'",
                                       "fit recordings of larger amplitudes, or measure the damper on a bench"};
inline const Finding kPresentWithoutRide{
    "present-without-ride", Severity::kError, "the car at its present setting has no response to roads ({})",
    "choose smoother roads, or see `fourpost check` of its vehicle file", Weight::kGrave};
inline const Finding kDrawsLeftOut{
    "draws-left-out", Severity::kWarning,
    "{} of {} possible cars have no response at the present setting ({}) and are left out",
    "narrow the bounds of parameters, or measure more"};
inline const Finding kSettingsWithoutRide{"settings-without-ride", Severity::kWarning,
                                          "{} of {} settings have no response in at least one possible car and are not "
                                          "chosen; the first is {} ({})",
                                          "check the positions there"};
inline const Finding kLimitUnattainable{"limit-unattainable", Severity::kWarning,
                                        "no setting meets the limit {} (with a certainty of {})",
                                        "relax the limit, or add positions", Weight::kGrave};
inline const Finding kLimitsContradict{"limits-contradict", Severity::kWarning,
                                       "no setting meets all limits at once with a certainty of {}: {} does with {}, "
                                       "held back by '{}'",
                                       "relax that limit or 'certainty', or add positions", Weight::kGrave};
inline const Finding kKnobIdle{"knob-idle", Severity::kWarning,
                               "knob '{}' changes no objective and no limit, so its best position is arbitrary",
                               "check 'sets', or remove the knob"};
inline const Finding kBestAtEnd{"best-at-end", Severity::kWarning,
                                "the best setting is at the end of knob '{}' (position {})",
                                "add positions beyond it if the car can have them", Weight::kSlight};
inline const Finding kEnginesDisagree{"engines-disagree", Severity::kWarning,
                                      "for {} of {} settings '{}' changes otherwise by {} than by spectra, by more "
                                      "than {}; the worst is {}, {} by spectra and "
                                      "{} by them",
                                      "trust the latter; changes, P(best) and regret follow time histories, more surely "
                                      "with a larger 'shortlist'"};
inline const Finding kBestNotCompared{
    "best-not-compared", Severity::kWarning,
    "the best setting, {}, was not compared with time histories: each round of comparisons made another one the best",
    "raise 'shortlist'"};
inline const Finding kObjectiveZero{"objective-zero", Severity::kError,
                                    "'{}' is zero at the present setting, so no change of it can be stated",
                                    "choose another objective, or rougher roads", Weight::kGrave};
inline const Finding kEngineOrder{"engine-order", Severity::kWarning,
                                  "{} prefer another setting than the best and those indistinct from it: {} ({})",
                                  "raise 'shortlist', and test both on the rig", Weight::kGrave};
inline const Finding kEngineWithoutRide{"engine-without-ride", Severity::kWarning,
                                        "{} have no answer for a setting ({})", "check it by `fourpost simulate`"};

}  // namespace fourpost
