// Counts what other people's optimisers, and ours, need on the problem of a study: `fourpost compare` with more
// methods.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "identify/comparison/comparison_json.h"
#include "identify/study/study_methods.h"
#include "identify/study/study_problem.h"
#include "tests/peers/peer_methods.h"

namespace {

using namespace fourpost;

std::vector<ComparedMethod> MethodsNamed(const Study& study, std::vector<std::string> names, const Problem& problem) {
  Diagnostics diagnostics;
  std::vector<ComparedMethod> methods = TakePeers(names, diagnostics);
  for (ComparedMethod& ours : MethodsOf(study, names, problem, diagnostics)) methods.push_back(std::move(ours));
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return methods;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Counts what methods need on the problem of a study; prints JSON");
  std::string file;
  std::vector<std::string> names;
  ComparisonOptions options{.runs = 20, .threads = 0};
  app.add_option("study", file)->required();
  app.add_option("--methods", names, "pagmo_de:population=40, ..., dvhde")->delimiter(',')->required();
  app.add_option("--runs", options.runs);
  app.add_option("--seed", options.seed);
  app.add_option("--threads", options.threads);
  app.add_option("--evaluations", options.rules.max_evaluations);
  CLI11_PARSE(app, argc, argv);
  try {
    const Study study = ReadStudyOrThrow(file);
    StudyProblem loaded;
    LoadProblem(study, loaded);
    options.rules.target_cost = loaded.target_cost;
    options.rules.max_generations = study.search.generations;
    const Comparison comparison = Compare(*loaded.problem, MethodsNamed(study, names, *loaded.problem), options);
    std::fputs(ComparisonJson(comparison, file, options.seed, /*time=*/true).c_str(), stdout);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
