#pragma once

#include "analysis/text/finding.h"

// What is wrong with the JSON files of a vehicle of Project Chrono, or not taken from them.
namespace fourpost {

inline const Finding kChronoNoJson{"chrono-no-json", Severity::kError, "not JSON: {}", "correct this place"};
inline const Finding kChronoTooLarge{"chrono-too-large", Severity::kError, "the file is larger than {}",
                                     "name a vehicle's JSON file"};
inline const Finding kChronoFileMissing{
    "chrono-file-missing", Severity::kError, "{} = \"{}\" is in none of the folders above this file",
    "keep the files as Chrono has them, paths starting at its folder data or data/vehicle"};
inline const Finding kChronoMissing{"chrono-missing", Severity::kError, "{} lacks \"{}\"", "add it, {}"};
inline const Finding kChronoValue{"chrono-value", Severity::kError, "{} is not {}", "correct it"};
inline const Finding kChronoTooMany{"chrono-too-many", Severity::kError, "{} has {} entries, more than {}",
                                    "remove those that are no part of a car"};
inline const Finding kChronoRange{"chrono-range", Severity::kError, "{} is {}, outside {}",
                                  "correct it; Chrono takes kg and m"};
inline const Finding kChronoNoVehicle{"chrono-no-vehicle", Severity::kError, "not a wheeled vehicle of Chrono, {}",
                                      "name the file with \"Axles\""};
inline const Finding kChronoAxles{"chrono-axles", Severity::kError, "the vehicle has {} axles",
                                  "only vehicles of two axles are read; remove the others"};
inline const Finding kChronoAxleOrder{
    "chrono-axle-order", Severity::kError,
    "the wheels of the first axle are centred at x = {}, those of the second at x = {}, which is not half a metre "
    "behind",
    "list the front axle first in \"Axles\", and check its \"Suspension Location\"; Chrono's x points forward"};
inline const Finding kChronoTemplate{"chrono-template", Severity::kError, "the suspension template \"{}\" is not read",
                                     "those read are {}"};
inline const Finding kChronoMass{"chrono-mass", Severity::kError, "{} is {}, which no body has",
                                 "correct it; Chrono takes kg and m"};
inline const Finding kChronoLaw{
    "chrono-law", Severity::kError, "{} states no law of force",
    "add \"Spring Coefficient\" or \"Spring Curve Data\" to a spring, \"Damping Coefficient\", "
    "\"Damping Curve Data\" or \"Map Data\" to a shock"};
inline const Finding kChronoMap{"chrono-map", Severity::kWarning,
                                "the force of {} depends on its length as well; taken at {}",
                                "where it moves far from there, its law is another one"};
inline const Finding kChronoSecondLaw{"chrono-second-law", Severity::kWarning, "{} of {} is not read",
                                      "add an fp:damper between the spring's ends"};
inline const Finding kChronoStopClosed{"chrono-stop-closed", Severity::kWarning,
                                       "{} is {} long in the pose that is written, beyond its stop at {}",
                                       "the vehicle is written with that stop just touching"};
inline const Finding kChronoStrutApart{"chrono-strut-apart", Severity::kWarning,
                                       "the ends of the coil of {} lie up to {} from those of the strut",
                                       "it is written along the strut"};
inline const Finding kChronoGuide{"chrono-guide", Severity::kWarning,
                                  "{} has no links in Chrono: the axle moves along and turns about fixed axes of the "
                                  "chassis",
                                  "it is written in the same way; put links in their place if you know them"};
inline const Finding kChronoNoTyre{"chrono-no-tyre", Severity::kWarning,
                                   "no tyre file: radius {}, mass {} and rate are guesses",
                                   "add --tyre FILE, a tyre's JSON file, or two for front and rear"};
inline const Finding kChronoTyreRate{"chrono-tyre-rate", Severity::kWarning,
                                     "the file states no vertical stiffness nor a bearing capacity",
                                     "the vehicle is written with an estimate, correct kt_front and kt_rear"};
inline const Finding kChronoNotSettled{"chrono-not-settled", Severity::kWarning,
                                       "Chrono's free lengths do not let the car come to rest: {}",
                                       "the vehicle is written at rest as drawn; preloads differ from Chrono's"};

}  // namespace fourpost
