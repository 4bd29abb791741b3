#pragma once

#include <fourpost/response.h>

#include "vehicles/engine/engine.h"

namespace fourpost::api {

/// The library's own engine, and back.
fourpost::Engine OwnEngine(Engine engine);
Engine PublicEngine(fourpost::Engine engine);

}  // namespace fourpost::api
