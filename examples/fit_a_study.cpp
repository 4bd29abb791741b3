// Fits a study and prints the parameters with their intervals; report.html is beside the result.
#include <cstdio>
#include <string>

#include <fourpost/fit.h>
#include <fourpost/units.h>

namespace fp = fourpost::api;

int main(int, char** arguments) try {
  const fp::Study study(std::string(arguments[1]) + "/studies/starter/study.yaml");
  const fp::Result result = fp::Fit(study, arguments[2]);
  for (const fp::FittedParameter& p : result.parameters)
    std::printf("%-12s %s, 95 %% from %s to %s\n", p.name.c_str(), fp::InUnit(p.value, p.unit).c_str(),
                fp::InUnit(p.lower_95, p.unit).c_str(), fp::InUnit(p.upper_95, p.unit).c_str());
  return result.is_converged() ? 0 : 1;
} catch (const fp::Error& error) {
  for (const fp::Finding& finding : error.findings())
    std::fprintf(stderr, "%s:%d: %s\n", finding.file.c_str(), finding.line, finding.text.c_str());
  return 1;
}
