#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a vehicle file. Most begin with the name of an element, "fp:spring 'coil'", or with an
// attribute, `mass="2" of link 'body'`.
namespace fourpost {

// XML and tags.

inline const Finding kXmlEmpty{"xml-empty", Severity::kError, "the file is empty",
                               "write a <robot>, as urdf/README.md shows"};
inline const Finding kXmlTagOpen{"xml-tag-open", Severity::kError,
                                 "not XML, the tag that begins here is not closed by its own end tag",
                                 "close it, or correct the misspelt end tag"};
inline const Finding kXmlAttribute{"xml-attribute", Severity::kError,
                                   "not XML, an attribute has no value in quotes or is given twice",
                                   "quote the value, and remove a repetition"};
inline const Finding kXmlComment{"xml-comment-open", Severity::kError, "not XML, a comment has no end",
                                 "end it with -->"};
inline const Finding kXmlUnreadable{"xml-unreadable", Severity::kError, "not XML ({})",
                                    "check that tags are closed and values are in quotes"};
inline const Finding kNotOneRobot{"not-one-robot", Severity::kError, "the file must hold exactly one <robot>",
                                  "keep one, and put each other vehicle into a file of its own"};
inline const Finding kNamespaceMissing{"namespace-missing", Severity::kError,
                                       "<robot> needs {}, since the file uses fp: tags"};
inline const Finding kNamespaceOther{"namespace-other", Severity::kError, "xmlns:fp is \"{}\", expected {}"};
inline const Finding kForeignPrefix{"foreign-prefix", Severity::kWarning,
                                    "{} is ignored, as is everything with the prefix '{}:'{}",
                                    "write what fourpost is to read as an fp: tag", Weight::kSlight};
inline const Finding kTagUnknown{"tag-unknown", Severity::kError, "unknown tag <{}>{}{}", "correct it, or remove it"};
inline const Finding kTagMissing{"tag-missing", Severity::kError, "{} needs a <{}>", "add it"};
inline const Finding kTagTwice{"tag-twice", Severity::kError, "{} has more than one <{}>", "keep one of them"};
inline const Finding kNotOneLaw{"not-one-law", Severity::kError, "{} needs exactly one of {}",
                                "keep one and remove the others"};
inline const Finding kTypeMissing{"type-missing", Severity::kError, "{} needs the attribute 'type'", "write one of {}"};
inline const Finding kTypeUnknown{"type-unknown", Severity::kError, "unknown type '{}' of {}{}", "correct it"};
inline const Finding kAttributeMissing{"attribute-missing", Severity::kError, "{} needs the attribute '{}'{}",
                                       "add it"};
inline const Finding kAttributeUnknown{"attribute-unknown", Severity::kError, "unknown attribute '{}' of {}{}",
                                       "correct it, or remove it"};
inline const Finding kAttributeFormer{"attribute-former", Severity::kWarning,
                                      "attribute '{}' of {} is the earlier spelling of '{}'", "rename it",
                                      Weight::kSlight};
inline const Finding kAttributeTwice{"attribute-twice", Severity::kError,
                                     "attribute '{}' of {} repeats '{}', its new spelling",
                                     "remove the earlier spelling"};
inline const Finding kNameTaken{"name-taken", Severity::kError, "{} is already defined in line {}",
                                "rename one of the two"};

// Numbers and parameters.

inline const Finding kNumberWithoutUnit{"number-without-unit", Severity::kError, "{} has no unit",
                                        "write {}, such as \"{}\"{}"};
inline const Finding kNumberOfOtherDimension{"number-of-other-dimension", Severity::kError, "{} is {}",
                                             "write {}, such as \"{}\"{}"};
inline const Finding kNumberUnknownUnit{"number-unknown-unit", Severity::kError, "{} has the unknown unit '{}'{}",
                                        "write {}"};
inline const Finding kNumberComma{"number-comma", Severity::kError, "{} has a comma", "write a point, as in {}"};
inline const Finding kNotAQuantity{"not-a-quantity", Severity::kError, "{} is not a number with a unit", "write {}"};
inline const Finding kWordMisspelt{"word-misspelt", Severity::kError, "{} is not a number with a unit{}"};
inline const Finding kParameterWithoutDollar{"parameter-without-dollar", Severity::kError, "{} is not a number",
                                             "write '$' before the name of a parameter"};
inline const Finding kReferenceSum{"reference-sum", Severity::kError, "{} is a sum, which is not supported",
                                   "write a number with a unit, or a parameter as in \"$k\", \"-$k\" or \"0.5*$k\""};
inline const Finding kReferenceProduct{
    "reference-product", Severity::kError, "{} combines parameters, which is not supported",
    "write a number with a unit, or a parameter as in \"$k\", \"-$k\" or \"0.5*$k\""};
inline const Finding kReferenceUnreadable{
    "reference-unreadable", Severity::kError, "{} cannot be read",
    "write a number with a unit, or a parameter as in \"$k\", \"-$k\" or \"0.5*$k\""};
inline const Finding kParameterUnknown{"parameter-unknown", Severity::kError,
                                       "{} refers to an unknown parameter '{}'{}",
                                       "correct the name, or add an <fp:parameter>"};
inline const Finding kParameterOfOtherDimension{"parameter-of-other-dimension", Severity::kError,
                                                "{} refers to {} (line {}), but {} is needed",
                                                "use another parameter, or correct its unit"};
inline const Finding kParameterName{"parameter-name", Severity::kError, "{} is not the name of a parameter",
                                    "use letters, digits and '_' only"};
inline const Finding kParameterUnused{"parameter-unused", Severity::kError, "fp:parameter '{}' is not used",
                                      "bind it or refer to it as \"${}\""};
inline const Finding kParameterMisused{"parameter-misused", Severity::kError,
                                       "fp:parameter '{}' is {}, but {} is needed where it is used, {}",
                                       "write one such as {}"};
inline const Finding kValueWithoutUnit{"value-without-unit", Severity::kError, "{} has no unit, but {} has",
                                       "write \"{}\""};
inline const Finding kValueOfOtherDimension{"value-of-other-dimension", Severity::kError, "{} is {}, but {}",
                                            "use a parameter of that dimension, or correct the unit of its value"};
inline const Finding kValueBelowLower{"value-below-lower", Severity::kError, "{} is below {}",
                                      "choose a value between the bounds"};
inline const Finding kValueAboveUpper{"value-above-upper", Severity::kError, "{} is above {}",
                                      "choose a value between the bounds"};
inline const Finding kBoundsIncomplete{"bounds-incomplete", Severity::kError,
                                       "{} has some, but not all of lower, upper and precision",
                                       "give all three, or none for a fixed parameter"};
inline const Finding kLikeIncomplete{"like-incomplete", Severity::kError, "{} has one of like and like_sd",
                                     "give both: the name of another parameter, and how far their ratio may be off"};
inline const Finding kLikeUnknown{"like-unknown", Severity::kError, "{} is no other parameter{}", ""};
inline const Finding kLikeEachOther{"like-each-other", Severity::kError,
                                    "{} states a ratio that '{}' states already, so it would count twice",
                                    "state it at one of the two"};
inline const Finding kLikeOfOtherDimension{"like-of-other-dimension", Severity::kError, "{} is {}, not {}",
                                           "name a parameter of the same kind"};
inline const Finding kLikeNotPositive{"like-not-positive", Severity::kError,
                                      "{} compares by a ratio, but '{}' may be zero or below",
                                      "give it a lower bound above zero, or remove like"};
inline const Finding kBoundsSwapped{"bounds-swapped", Severity::kError, "{} is above {}", "swap them"};
inline const Finding kPrecisionTooCoarse{"precision-too-coarse", Severity::kError, "{} exceeds upper - lower",
                                         "choose a smaller one; to fix the parameter, leave out all three"};
inline const Finding kPrecisionTooFine{"precision-too-fine", Severity::kError,
                                       "{} splits the range into more than 2^53 steps",
                                       "give the digits that matter, such as a thousandth of the range"};
inline const Finding kBindUnreadable{
    "bind-unreadable", Severity::kError, "{} is not a number of a link",
    "write link[NAME]/mass, link[NAME]/com/x (y, z) or link[NAME]/inertia/ixx (iyy, izz, ixy, ixz, iyz)"};
inline const Finding kBindLinkUnknown{"bind-link-unknown", Severity::kError, "{} has an unknown link '{}'{}",
                                      "correct the name, or add the link"};
inline const Finding kBindNumberUnknown{"bind-number-unknown", Severity::kError, "{} has an unknown number '{}'{}",
                                        "bind mass, com/x to com/z, or one of inertia/ixx to inertia/iyz"};
inline const Finding kBindNumberMissing{"bind-number-missing", Severity::kError, "{} finds no such number",
                                        "give it in the <inertial> of {}"};
inline const Finding kBindTurned{"bind-turned", Severity::kError,
                                 "{} is a moment about turned axes, which cannot follow a parameter",
                                 "write the <inertial> without rpy"};
inline const Finding kBindTwice{"bind-twice", Severity::kError, "{} is bound twice", "remove one of the two"};
inline const Finding kBindDimension{"bind-dimension", Severity::kError, "{} is {}, but the parameter is {}",
                                    "bind a number of the same dimension, or correct the unit"};
inline const Finding kBindValue{"bind-value", Severity::kError,
                                "{} is {} in the tree, but factor times the value of fp:parameter '{}' is {}",
                                "write \"{}\" in place of the number in the tree and remove the fp:bind, so that the "
                                "value is written once; or make "
                                "them equal"};
inline const Finding kTreeReferenceUnreadable{
    "tree-reference-unreadable", Severity::kError, "\"{}\" in {} cannot be read",
    "write a number in SI, or a parameter as in \"$m\", \"-$m\" or \"0.5*$m\", without blanks"};
inline const Finding kBindMirrored{"bind-mirrored", Severity::kError,
                                   "{} is a number that follows link '{}' by fp:mirror",
                                   "bind that one, or write link '{}' out"};

// Mirrors.

inline const Finding kMirrorCount{"mirror-count", Severity::kError, "more than {} <fp:mirror>",
                                  "write one for each pair of sides"};
inline const Finding kMirrorEnds{"mirror-ends", Severity::kError, "{} is the same as from",
                                 "write the ending of the other side"};
inline const Finding kMirrorTwice{"mirror-twice", Severity::kError, "{} repeats the mirror in line {}",
                                  "remove one of the two"};
inline const Finding kMirrorNothing{"mirror-nothing", Severity::kError, "{} is the end of no name{}",
                                    "write what the names of one side end with"};
inline const Finding kMirrorOfItself{"mirror-of-itself", Severity::kWarning,
                                     "{} is its own mirror image, so <fp:mirror> leaves it single",
                                     "let its name not end in '{}'"};

// Tree of links and joints.

inline const Finding kLinkNone{"link-none", Severity::kError, "the file has no link", "add one for each body"};
inline const Finding kGroundNone{"ground-none", Severity::kError,
                                 "there is no ground, since every link is the child of a joint",
                                 "remove the joint that has the ground as its child"};
inline const Finding kGroundSecond{"ground-second", Severity::kError,
                                   "{} is the child of no joint, as only the ground, '{}', may be",
                                   "add a joint to it"};
inline const Finding kGroundInertial{"ground-inertial", Severity::kError,
                                     "{} is the ground and must not have an <inertial>",
                                     "remove it, or add a link for the body"};
inline const Finding kJointLink{"joint-link-unknown", Severity::kError, "{} has the unknown {} link '{}'{}",
                                "correct the name, or add the link"};
inline const Finding kJointLimit{"joint-limit", Severity::kError, "{} is {} and has no limit, which URDF requires",
                                 "add <limit effort=\"0\" velocity=\"0\"/>{}"};
inline const Finding kJointTwoParents{"two-parents", Severity::kError, "link '{}' has two parents, {} and {}",
                                      "close a loop with fp:rod or fp:ball"};
inline const Finding kJointLoop{"joint-loop", Severity::kError,
                                "{} is part of a loop of joints that the ground does not carry",
                                "close loops by fp:rod or fp:ball instead"};
inline const Finding kJointCoordinates{"joint-coordinates", Severity::kError,
                                       "the joints have {} coordinates, more than {}",
                                       "leave out bodies, or fix joints that need not move"};
inline const Finding kUrdfdomError{"urdfdom-error", Severity::kError, "urdfdom: {}", "correct the tag that it names"};
inline const Finding kUrdfdomWarning{"urdfdom-warning", Severity::kWarning, "urdfdom: {}",
                                     "correct the tag that it names", Weight::kSlight};
inline const Finding kUrdfdomSilent{"urdfdom-silent", Severity::kError, "urdfdom cannot read the file",
                                    "compare the file with one of `urdf`, or report it with the file"};
inline const Finding kNameReadDifferently{"name-read-differently", Severity::kError,
                                          "{} has a name that XML parsers read differently",
                                          "use letters, digits, '_', '-' and '.' only"};

// Bodies and shapes.

inline const Finding kInertiaWithoutMass{"inertia-without-mass", Severity::kError, "link '{}' has inertia but no mass",
                                         "add <mass>, or remove the inertia"};
inline const Finding kInertiaTooLarge{"inertia-too-large", Severity::kError,
                                      "link '{}' has an inertia that is too large",
                                      "check its digits; URDF takes kg*m^2"};
inline const Finding kInertiaImpossible{"inertia-impossible", Severity::kError,
                                        "link '{}' has an impossible inertia, its principal moments are {}",
                                        "none may be below zero or exceed the sum of the other two"};
inline const Finding kInertiaImpossibleAtBounds{
    "inertia-impossible-at-bounds", Severity::kError,
    "link '{}' has an impossible inertia with {}, its principal moments are {}, and none may be below zero or exceed "
    "the sum of the other two",
    "bind another of its moments as well, or narrow the bounds"};
inline const Finding kMassTooSmall{"mass-too-small", Severity::kError,
                                   "the mass of link '{}' is {} kg, too small to compute with",
                                   "correct the unit, or remove the mass from a link that has none"};
inline const Finding kMassMissing{"mass-missing", Severity::kError,
                                  "joint '{}' moves link '{}', but neither it nor what it carries has a mass",
                                  "give a link an <inertial>, or fix the joint"};
inline const Finding kMeshAddress{"mesh-address", Severity::kError,
                                  "mesh '{}' is an address, such as package://, which is not supported",
                                  "write a path relative to the vehicle file"};
inline const Finding kMeshMissing{"mesh-missing", Severity::kWarning,
                                  "mesh '{}' is missing (no file {}), so pictures are without it", "correct its path"};
inline const Finding kMeshUnknown{"mesh-unknown", Severity::kError, "mesh '{}' cannot be looked for ({})",
                                  "correct its path, or allow reading its folder"};
inline const Finding kSolidLink{"solid-link-unknown", Severity::kError, "{} refers to the unknown link '{}'{}",
                                "correct the name, or add the link"};
inline const Finding kSolidTwice{"solid-twice", Severity::kError, "{} of link '{}' repeats that of line {}",
                                 "remove one of the two"};
inline const Finding kSolidGround{"solid-ground", Severity::kError, "{} of link '{}' would give the ground a mass",
                                  "remove it"};
inline const Finding kSolidInertial{"solid-inertial", Severity::kError,
                                    "{} of link '{}' contradicts the <inertial> of the link", "remove one of the two"};
inline const Finding kSolidNoVisual{"solid-no-visual", Severity::kError,
                                    "{} of link '{}' finds no <visual> whose shape would give the mass", "add one"};

// Elements.

inline const Finding kReferenceUnknown{"reference-unknown", Severity::kError, "{} refers to an unknown {} '{}'{}",
                                       "correct the name, or add what it refers to"};
inline const Finding kFrameNamedAsLink{"frame-named-as-link", Severity::kError, "{} has the name of a link",
                                       "rename one of the two"};
inline const Finding kLineOnOneLink{"line-on-one-link", Severity::kError,
                                    "{} has both ends on link '{}', so its length never changes",
                                    "name the other body in parent or child"};
inline const Finding kClosureOnOneLink{"closure-on-one-link", Severity::kError,
                                       "{} has both ends on link '{}', so it joins nothing",
                                       "name the other body in parent or child"};
inline const Finding kLineWithoutLength{"line-without-length", Severity::kError,
                                        "{} has no length, so it has no direction", "move an end, or give it an axis"};
inline const Finding kRodWithoutLength{"rod-without-length", Severity::kError,
                                       "{} has no length, so it has no direction", "move an end, or use fp:ball"};
inline const Finding kConstantFollows{"constant-follows-parameter", Severity::kError, "{} cannot follow a parameter",
                                      "write a number"};
inline const Finding kPreloadAndFreeLength{"preload-and-free-length", Severity::kError,
                                           "{} has a preload and a free_length", "give one of the two"};
inline const Finding kFreeLengthGuided{"free-length-guided", Severity::kError,
                                       "{} is guided by an axis, so its length is not that of a coil",
                                       "give its preload in place of free_length"};
inline const Finding kKneeNone{"knee-none", Severity::kError, "{} has no <knee>", "add one, or make it <linear>"};
inline const Finding kKneeOrder{"knee-order", Severity::kError, "{} does not lie beyond the knee before it",
                                "list the knees on either side of zero in the order in which the spring meets them, "
                                "over the whole range of parameters"};
inline const Finding kStopEmpty{"stop-empty", Severity::kError, "{} has no <bump> and no <rebound>", "add one or both"};
inline const Finding kTablePoints{"table-points", Severity::kError, "{} needs at least two <point>s",
                                  "add them as <point speed=\"...\" force=\"...\"/>"};
inline const Finding kTableSign{"table-sign", Severity::kError, "{} pushes on its own motion at every speed",
                                "change the sign of its forces or of its speeds; extension and tension are positive"};
inline const Finding kPointSign{"point-sign", Severity::kError, "the point at \"{}\" of {} pushes on its own motion",
                                "give force and speed the same sign, over the whole range of parameters"};
inline const Finding kPointOrder{"point-order", Severity::kError,
                                 "the point at \"{}\" of {} does not rise above the point before it",
                                 "give it more speed and more force, over the whole range of parameters"};
inline const Finding kCurveOneSided{"curve-one-sided", Severity::kError,
                                    "{} needs a <segment> in bump and one in rebound",
                                    "add them as <segment to=\"...\" rate=\"...\"/>, speeds in bump below zero"};
inline const Finding kSegmentOrder{"segment-order", Severity::kError,
                                   "the segment to \"{}\" of {} does not end above the one before it",
                                   "list segments by rising speed, bump first, over the whole range of parameters"};
inline const Finding kSegmentAtRest{"segment-at-rest", Severity::kError,
                                    "the segment of {} ends at rest, where both sides begin",
                                    "give it a speed below zero in bump, above zero in rebound"};
inline const Finding kSpringTablePoints{"spring-table-points", Severity::kError, "{} needs at least two <point>s",
                                        "add them as <point extension=\"...\" force=\"...\"/>"};
inline const Finding kSpringPointOrder{
    "spring-point-order", Severity::kError, "the point at \"{}\" of {} does not rise above the point before it",
    "give it more extension and more force, over the whole range of parameters; both are negative in bump"};
inline const Finding kSpringTablePlace{
    "spring-table-place", Severity::kWarning, "{} lies beyond the ends of the table, where the spring goes straight on",
    "give the extension, in the table, of the spring in the design pose: negative where it is pushed together"};
inline const Finding kTyreRateNone{"tyre-rate-none", Severity::kError, "{} has no vertical stiffness",
                                   "add stiffness=\"200 kN/m\", above zero with a progression, or a <table>"};
inline const Finding kTyreRateTwice{"tyre-rate-twice", Severity::kError, "{} has both {} and a <table>",
                                    "keep one of the two: the table gives the vertical force at any load"};
inline const Finding kTyreHeld{
    "tyre-held", Severity::kError, "{} has liftoff=\"false\", but its stiffness changes with the load",
    "remove liftoff=\"false\": a load-deflection curve is not defined for tension; or give it a constant stiffness"};
inline const Finding kTyreTablePoints{"tyre-table-points", Severity::kError, "{} needs at least two <point>s",
                                      "add them as <point deflection=\"...\" force=\"...\"/>"};
inline const Finding kTyrePointOrder{
    "tyre-point-order", Severity::kError, "the point at \"{}\" of {} does not rise above the point before it",
    "give it more deflection and more force, over the whole range of parameters; a tyre's force never falls"};
inline const Finding kFileMissing{"curve-file-missing", Severity::kError, "{} does not exist (no file {})",
                                  "correct the path, which starts at the folder of the vehicle file"};
inline const Finding kFileAndPoints{"file-and-points", Severity::kError, "{} has both a file and <point>s",
                                    "keep one of the two"};
inline const Finding kFileTags{"file-tags", Severity::kError,
                               "files give more than {} points and rates, up to this one",
                               "name shorter curves, or fewer of them"};
inline const Finding kScaleTwice{"scale-twice", Severity::kError, "{} and {} both follow a parameter",
                                 "write one of them as a number"};
inline const Finding kCurvePlaceGuided{
    "curve-place-guided", Severity::kError,
    "{} is guided by an axis, so the free length in its file does not say where on its curve it stands", "add `at`"};
inline const Finding kCurvePlace{
    "curve-place", Severity::kWarning,
    "{} is {} long in the design pose and {} free, at {} of a curve from {} to {}, beyond which it goes straight on",
    "check its ends and the free length in the file, or add `at`"};
inline const Finding kFrictionSpeedAndStiffness{
    "friction-speed-and-stiffness", Severity::kError,
    "the friction of {} has both 'speed' and 'stiffness', which belong to different laws",
    "keep 'stiffness' for friction that sticks before it slides, 'speed' for one that creeps"};
inline const Finding kFrictionStiffnessSeries{
    "friction-stiffness-series", Severity::kError,
    "the friction of {} has 'stiffness', but the damper has a series spring",
    "move the <friction> to another fp:damper between the same ends, with <linear rate=\"0 N*s/m\"/>"};
inline const Finding kSeriesWithoutRate{"series-without-rate", Severity::kError,
                                        "{} has a series spring, so its rates must be above zero"};
inline const Finding kSeriesSaturates{"series-saturates", Severity::kError,
                                      "{} has a series spring, whose force may pass the limit of a saturating law",
                                      "use <digressive>, or remove the series spring"};
inline const Finding kSeriesNotRising{"series-not-rising", Severity::kError,
                                      "{} has a series spring, so its force must rise with speed everywhere",
                                      "for a smooth law neither rate may be more than eleven times the other"};
inline const Finding kRodThickness{"rod-thickness", Severity::kError, "{} must be thinner than the piston, \"{}\"",
                                   "check both for their units"};
inline const Finding kGasPressure{"gas-pressure", Severity::kError, "{} must be above the cavitation pressure, \"{}\"",
                                  "raise it, or lower `cavitation`"};
inline const Finding kBushingResistsNothing{
    "bushing-resists-nothing", Severity::kError, "{} resists nothing",
    "give it a <translation>, a <rotation>, a <translation_damping> or a <rotation_damping>"};
inline const Finding kDrakeFramesApart{"drake-frames-apart", Severity::kWarning,
                                       "the frames of {} are {} and {} apart in the design pose",
                                       "Drake's bushing is loaded there, fp:bushing is not"};
inline const Finding kBarSamePoints{"bar-same-points", Severity::kError,
                                    "{} joins the same two points on the left and on the right, so it never acts",
                                    "give each side its own points"};
inline const Finding kWheelAxis{"wheel-axis", Severity::kError,
                                "fp:tyre '{}' has a radius, so its wheel turns about the y axis of link '{}', but that "
                                "does not point sideways",
                                "turn the link"};
inline const Finding kTyreTwoPosts{"tyre-two-posts", Severity::kError,
                                   "{} is under the tyre that fp:post '{}' moves already", "keep one post per tyre"};

}  // namespace fourpost
