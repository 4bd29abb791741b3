#include "vehicles/engine/engine.h"

namespace fourpost {

const char* EngineName(Engine engine) {
  switch (engine) {
    case Engine::kAuto: return "auto";
    case Engine::kReduced: return "reduced";
    case Engine::kFull: return "full";
    case Engine::kTimeIntegration: return "time";
  }
  return "";
}

std::optional<Engine> EngineNamed(std::string_view name) {
  if (name == "march") return Engine::kTimeIntegration;
  if (name == "linearised" || name == "condensed") return Engine::kReduced;
  for (const Engine engine : {Engine::kAuto, Engine::kReduced, Engine::kFull, Engine::kTimeIntegration})
    if (name == EngineName(engine)) return engine;
  return std::nullopt;
}

}  // namespace fourpost
