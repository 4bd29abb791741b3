#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/choice/choice.h"

namespace fourpost {

/// Rates the settings of a table, and names the best one where one is admitted: rows of the choice, its front, clicks,
/// what decides and what to test next, with findings. `request` has a row of draws or more, those of the table;
/// `errors`: see EngineErrors(), times the objectives. Throws FaultyInput where the present setting has no
/// answer.
void RateSettings(const ChoiceRequest& request, const SettingTable& table, const std::vector<Eigen::MatrixXd>& errors,
                  Choice& choice);

}  // namespace fourpost
