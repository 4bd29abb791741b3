#pragma once

#include "analysis/text/finding.h"

// Why a vehicle has no design pose at rest.
namespace fourpost {

inline const Finding kNothingMoves{
    "nothing-moves", Severity::kError, "nothing can move",
    "give the vehicle a joint that is not fixed, or loop closures that leave some freedom"};

inline const Finding kUnheldBushing{"unheld-bushing", Severity::kError, "no static equilibrium, nothing holds {}",
                                    "write preload=\"equilibrium\" in {}"};
inline const Finding kUnheldDrakeBushing{"unheld-drake-bushing", Severity::kError,
                                         "no static equilibrium, nothing holds {}",
                                         "write an fp:bushing with preload=\"equilibrium\" in place of Drake's, {}"};
inline const Finding kUnheldDamper{
    "unheld-damper", Severity::kError, "no static equilibrium, nothing holds {}",
    "add an fp:spring beside {}, as a damper carries nothing at rest; a study with `bench` "
    "needs none"};
inline const Finding kUnheldStop{"unheld-stop", Severity::kError, "no static equilibrium, nothing holds {}",
                                 "add an fp:spring beside {}, as a stop carries nothing at rest"};
inline const Finding kUnheld{"unheld", Severity::kError, "no static equilibrium, nothing holds {}",
                             "add the fp:rod, fp:ball or joint that guides it, or a spring, tyre or bushing with "
                             "preload=\"equilibrium\" that carries it"};

inline const Finding kPreloadUnbalanced{
    "preload-unbalanced", Severity::kError, "no static equilibrium, the preload of {}, {}, is not balanced{}",
    "correct it or write preload=\"equilibrium\"; `fourpost settle` shows where it comes to rest"};
inline const Finding kFreeLengthFollows{
    "free-length-over-bounds", Severity::kError,
    "no static equilibrium, the preload of {} by its free length, {}, is not balanced{}, and no one length balances it "
    "over the bounds of fp:parameter '{}'",
    "remove free_length, so that the spring carries what rests on it"};
inline const Finding kFreeLengthWrong{
    "free-length-unbalanced", Severity::kError,
    "no static equilibrium, the preload of {} by its free length, {}, is not balanced{}",
    "write free_length=\"{}\", leave a spring or tyre that acts beside it to equilibrium, or let `fourpost settle` "
    "move "
    "the vehicle to rest"};
inline const Finding kFreeLengthUnbalanced{
    "free-length-without-balance", Severity::kError,
    "no static equilibrium, the preload of {} by its free length, {}, is not balanced{}",
    "correct that length, leave a spring or tyre that acts beside it to equilibrium, or let `fourpost settle` move the "
    "vehicle to rest"};
inline const Finding kEquilibriumAtOneValue{
    "equilibrium-at-one-value", Severity::kError,
    "static equilibrium only at one value of fp:parameter '{}', {} follows it, but no spring, tyre or bushing with "
    "preload=\"equilibrium\" compensates that",
    "add one, or remove the parameter's bounds"};

}  // namespace fourpost
