#pragma once

#include "analysis/text/finding.h"

// What can be wrong with tables of a kinematics and compliance rig.
namespace fourpost {

// The study.

inline const Finding kKinematicsEmpty{"kinematics-empty", Severity::kError,
                                      "{} must be a list of tables with at least one entry",
                                      "name one as `- file: heave.csv`, or remove 'kinematics'"};
inline const Finding kKinematicsNotFitted{"kinematics-not-fitted", Severity::kError,
                                          "all tables of {} are for validation", "leave `use` out of one to fit it"};
inline const Finding kKinematicNameTwice{"kinematics-name-twice", Severity::kError,
                                         "two tables of 'kinematics' have the name '{}'", "rename one with 'name'"};
inline const Finding kKinematicUse{"kinematics-use", Severity::kError, "{} must be 'fit' or 'validation'"};
inline const Finding kKinematicCase{"kinematics-case", Severity::kError, "{} must be 'together' or 'opposed'"};
inline const Finding kKinematicPositionTwice{"kinematics-position-twice", Severity::kError,
                                             "{} cannot be given beside '{}'",
                                             "keep the one that the curves are measured over"};
inline const Finding kKinematicNoiseNotMapped{
    "kinematics-noise-not-mapped", Severity::kError,
    "'noise' must map the quantities to fit to the standard deviation of one measurement",
    "write, for example, noise: {camber: 0.02 deg, toe: 0.01 deg}"};
inline const Finding kKinematicQuantityUnknown{"kinematics-quantity-unknown", Severity::kError,
                                               "a rig measures no '{}'{}", "correct the name"};
inline const Finding kKinematicAngleUnit{"kinematics-angle-unit", Severity::kError,
                                         "the noise of '{}' is '{}', which is no angle",
                                         "write it in deg or rad, such as 0.02 deg"};
inline const Finding kKinematicOffset{"kinematics-offset", Severity::kError,
                                      "'offset' must be 'free' or a list of quantities",
                                      "write `offset: free`, or [camber, toe]"};
inline const Finding kKinematicOffsetOfNone{"kinematics-offset-of-none", Severity::kError,
                                            "'offset' names '{}', which 'noise' does not",
                                            "name it in both, or in none"};

// The vehicle.

inline const Finding kKinematicAxleUnknown{"kinematics-axle-unknown", Severity::kError,
                                           "the vehicle has no axle '{}'{}", "correct the name"};
inline const Finding kKinematicAxleOpen{"kinematics-axle-open", Severity::kError,
                                        "which of the axles {} was measured is not stated", "add 'axle'"};
inline const Finding kKinematicMotionOpen{"kinematics-motion-open", Severity::kError,
                                          "how the wheels moved or were loaded is not stated",
                                          "add 'motion': heave, roll, a wheel, lateral, braking, driving or aligning"};
inline const Finding kKinematicMotionUnknown{
    "kinematics-motion-unknown", Severity::kError, "axle '{}' has no motion or load '{}'{}",
    "state heave, roll, one of its wheels, lateral, braking, driving or aligning"};
inline const Finding kKinematicWheelUnknown{"kinematics-wheel-unknown", Severity::kError,
                                            "axle '{}' has no wheel '{}'{}", "correct the name"};
inline const Finding kKinematicNotReached{
    "kinematics-not-reached", Severity::kError, "axle '{}' cannot reach {} = {} ('{}')",
    "correct its points if the car travels as far, else cut the table, and check unit and sign of the travel"};
inline const Finding kKinematicRigid{"kinematics-rigid", Severity::kError,
                                     "'{}' is a compliance table, but the linkage of axle '{}' is rigid",
                                     "put an fp:bushing where it has rubber, or remove the table"};
inline const Finding kKinematicNotOfVehicle{"kinematics-not-of-vehicle", Severity::kError,
                                            "axle '{}' has no {} in {}, which '{}' measures",
                                            "remove it from 'noise', or name another axle or motion"};

// Tables.

inline const Finding kKinematicPositionMissing{"kinematics-position-missing", Severity::kError, "no column '{}'",
                                               "name the column in the study, as `{}: {channel: NAME, unit: {}}`"};
inline const Finding kKinematicPer{"kinematics-per", Severity::kError, "'per' is '{}', which is no {}",
                                   "write a number with its unit, such as 1 {}"};
inline const Finding kKinematicRowsSkipped{"kinematics-rows-skipped", Severity::kWarning,
                                           "{} rows of '{}' are not used, the first in {}: {}",
                                           "complete them, or remove them from the table"};
inline const Finding kKinematicQuantityMissing{
    "kinematics-quantity-missing", Severity::kError, "no numeric column for '{}' in '{}'",
    "map one by 'channels', as {}: NAME, or remove it from 'noise'; the columns are {}"};
inline const Finding kKinematicColumnUnit{"kinematics-column-unit", Severity::kError,
                                          "column '{}' has {}, and {} is needed",
                                          "state it in the study, as {channel: {}, unit: {}}"};
inline const Finding kKinematicChannelMissing{"kinematics-channel-missing", Severity::kError,
                                              "'{}' has no column '{}'{}", "correct the name"};
inline const Finding kKinematicWheelOpen{"kinematics-wheel-open", Severity::kError,
                                         "column '{}' does not say of which {} it is",
                                         "map it by 'channels', as {}_left: {}"};
inline const Finding kKinematicWheelEmpty{"kinematics-wheel-empty", Severity::kError,
                                          "'{}' has a number, but the row names no wheel",
                                          "write the wheel, or leave the number out"};
inline const Finding kKinematicNumber{"kinematics-number", Severity::kError, "'{}' is '{}', which is no number",
                                      "correct it, or leave the field empty"};
inline const Finding kKinematicRowsMissing{"kinematics-rows-missing", Severity::kError,
                                           "'{}' has no rows of axle '{}' and motion '{}'",
                                           "correct 'axle' or 'motion'"};
inline const Finding kKinematicOnePoint{"kinematics-one-point", Severity::kError,
                                        "{} of {} has one point, which a free offset would explain whatever it is",
                                        "measure more, or take the offset out of the study"};

// Before and after a fit.

inline const Finding kKinematicOpposite{"kinematics-opposite", Severity::kWarning,
                                        "{} of {} in '{}' changes against the model: a sign, or points far off",
                                        "check the rig's sign convention, and turn it by `sign: -1` in 'channels'"};
inline const Finding kKinematicConstantOff{
    "kinematics-constant-off", Severity::kWarning,
    "{} of {} in '{}' differs from the model by {} throughout, {} times its noise",
    "if that is static alignment or the rig's zero, write offset: [{}]; else give the wheel its static angles"};

}  // namespace fourpost
