#pragma once

#include "analysis/text/finding.h"

// What is wrong with hard points of suspensions, and with the choice of their kinds.
namespace fourpost {

inline const Finding kSuspensionMalformed{"suspension-malformed", Severity::kError, "'{}' is not AXLE=KIND",
                                          "write e.g. front=macpherson,rear=twist_beam"};
inline const Finding kSuspensionAxle{"suspension-axle", Severity::kError, "no axle is called '{}'",
                                     "the axles are front and rear"};
inline const Finding kSuspensionKindUnknown{"suspension-kind-unknown", Severity::kError,
                                            "there is no suspension '{}'{}", "docs/suspensions.md describes each kind"};
inline const Finding kSuspensionTwice{"suspension-twice", Severity::kError, "two suspensions for the {} axle",
                                      "keep one"};
inline const Finding kSuspensionMissing{"suspension-missing", Severity::kError, "no suspension for the {} axle",
                                        "add {}=KIND"};

inline const Finding kAxleLoadMalformed{"axle-load-malformed", Severity::kError, "'{}' is not AXLE=MASS",
                                        "write e.g. front=760kg,rear=640kg, the mass on both tyres of each axle"};
inline const Finding kAxleLoadMissing{"axle-load-missing", Severity::kError, "no load for the {} axle",
                                      "add {}=MASS, the mass on both of its tyres"};
inline const Finding kAxleLoadTwice{"axle-load-twice", Severity::kError, "two loads for the {} axle", "keep one"};
inline const Finding kAxleLoadsTooSmall{"axle-loads-too-small", Severity::kError,
                                        "these loads leave {} for the body, beside the wheels and axles",
                                        "give the mass on both tyres of each axle"};

inline const Finding kPointsWithoutHeader{
    "points-without-header", Severity::kError, "no header names the columns",
    "begin with axle,point,x [mm],y [mm],z [mm]; run without --points for a file to edit"};
inline const Finding kPointsColumnMissing{"points-column-missing", Severity::kError, "there is no column '{}'",
                                          "the header needs axle,point,x [mm],y [mm],z [mm]"};
inline const Finding kPointsColumnUnknown{"points-column-unknown", Severity::kError, "column '{}' is unknown{}",
                                          "the columns are axle, point, x, y, z, on, note"};
inline const Finding kPointsColumnTwice{"points-column-twice", Severity::kError, "column '{}' stands twice",
                                        "keep one"};
inline const Finding kPointsUnit{"points-unit", Severity::kError, "column '{}' has no unit of length",
                                 "write the unit in brackets, e.g. '{} [mm]' or '{} [m]'"};
inline const Finding kPointsCells{"points-cells", Severity::kError, "{} cells in a row of {} columns",
                                  "add what is missing; a note with a comma needs quotes"};
inline const Finding kPointsNumber{"points-number", Severity::kError, "'{}' is not a number, in column '{}'",
                                   "write digits, e.g. -12.5"};
inline const Finding kPointsEmpty{"points-empty", Severity::kError, "the file has no points",
                                  "run without --points for a file to edit"};

inline const Finding kPointUnknown{"point-unknown", Severity::kError, "{} has no point '{}'{}",
                                   "correct the name, or remove the row"};
inline const Finding kPointTwice{"point-twice", Severity::kError, "the {} axle's '{}' stands in line {} already",
                                 "keep one; the other side is a mirror image and is not listed"};
inline const Finding kPointMissing{"point-missing", Severity::kError, "the {} axle, {}, lacks '{}' ({})",
                                   "add the row {},{},X,Y,Z"};
inline const Finding kPointPartnerMissing{"point-partner-missing", Severity::kError,
                                          "the {} axle has '{}' but not '{}', which goes with it",
                                          "add the other one, or remove both"};
inline const Finding kPointSide{"point-side", Severity::kError, "the {} axle's '{}' lies at y = {}: {}",
                                "list the points of the left side, y to the left; for a drawing with y to the right "
                                "write -y in the header"};
inline const Finding kPointFar{"point-far", Severity::kError, "the {} axle's '{}' lies {} from the origin",
                               "check the unit in the header, and the number"};
inline const Finding kWheelAxisInboard{"wheel-axis-inboard", Severity::kError,
                                       "the {} axle's 'wheel_axis' lies {} further in than the wheel's centre",
                                       "give a point of the wheel's axis on its outer side"};
inline const Finding kContactBeside{
    "contact-beside", Severity::kWarning,
    "the {} axle's 'contact' lies {} off the wheel's plane; only its height is used",
    "turn the wheel by 'wheel_axis', a point of its axis further out, or correct the point"};
inline const Finding kPointCarrier{"point-carrier", Severity::kError, "'{}' cannot stand on '{}' of {}{}",
                                   "write a part of that suspension, or leave the cell empty"};
inline const Finding kLinkWithoutLength{"link-without-length", Severity::kError,
                                        "the {} axle's '{}' and '{}' are {} apart, so what joins them has no length",
                                        "correct one of them"};
inline const Finding kArmWithoutLength{"arm-without-length", Severity::kError,
                                       "the {} axle's '{}' lies {} from the axis through '{}' and '{}'",
                                       "correct one of them"};
inline const Finding kLinksParallel{
    "links-parallel", Severity::kError,
    "the {} axle's links run within {} of straight ahead in plan, so none holds it sideways",
    "correct the points, or choose four_link_panhard"};
inline const Finding kTyreSize{"tyre-size", Severity::kError,
                               "the {} wheel's centre stands {} above its contact with the ground",
                               "check the unit in the header ({}), and both points"};
inline const Finding kAxleOrder{
    "axle-order", Severity::kError,
    "the front wheel's centre is at x = {} and the rear one's at x = {}, which is not half a metre "
    "behind",
    "x points forward; for a drawing with x to the rear write -x in the header"};
inline const Finding kGroundSlopes{"ground-slopes", Severity::kWarning,
                                   "the front and the rear contact point differ in height by {}",
                                   "the vehicle is written on level ground, turned by {}; correct the points if "
                                   "the drawing is level"};
inline const Finding kStrutIdle{"strut-idle", Severity::kWarning, "the {} axle's {} moves {} per travel of the wheel",
                                "check its ends; its rate was chosen as for 0.3"};
inline const Finding kSuspensionDoesNotWork{"suspension-does-not-work", Severity::kError,
                                            "these points make no suspension that moves: {}",
                                            "compare the points with those of docs/suspensions.md"};

}  // namespace fourpost
