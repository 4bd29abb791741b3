#include "identify/study/study_context.h"

#include <cctype>
#include <string>

#include "analysis/files/sha256.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

/// Without comments, and with one blank for every run of blank space.
std::string Condensed(std::string_view xml) {
  std::string condensed;
  while (!xml.empty()) {
    if (xml.starts_with("<!--")) {
      const std::size_t end = xml.find("-->");
      xml.remove_prefix(end == std::string_view::npos ? xml.size() : end + 3);
      continue;
    }
    const bool is_blank = std::isspace(static_cast<unsigned char>(xml.front())) != 0;
    if (!is_blank || (!condensed.empty() && condensed.back() != ' ')) condensed += is_blank ? ' ' : xml.front();
    xml.remove_prefix(1);
  }
  return condensed;
}

void Add(Sha256& digest, const Scalar& scalar) {
  digest.Add(scalar.value);
  digest.Add(scalar.parameter);
  digest.Add(scalar.factor);
}

std::string DigestOf(const Vehicle& vehicle) {
  Sha256 digest;
  digest.Add(Condensed(vehicle.text));
  for (const FileContent& content : vehicle.contents) {
    digest.Add(content.xml);
    digest.Add(content.at.value_or(0));
  }
  for (const Link& link : vehicle.links) {
    Add(digest, link.mass);
    for (const Scalar& component : link.com) Add(digest, component);
    for (const Scalar& component : link.inertia) Add(digest, component);
  }
  return digest.Hex();
}

std::string VersionDigest() {
  Sha256 digest;
  for (const auto& [name, version] : Versions()) {
    digest.Add(name);
    digest.Add(version);
  }
  digest.Add(BuildId());
  return digest.Hex();
}

}  // namespace

EvaluationContext ContextOf(const LoadedStudy& study) {
  Sha256 data;
  Sha256 settings;
  for (const std::size_t index : study.free) settings.Add(study.vehicle.parameters[index].name);
  for (const Experiment& experiment : study.study.experiments) experiment.AddTo(data, settings);
  settings.Add(study.study.search.deadline_s);
  // Held parameters keep them.
  for (const StudyStart& start : study.study.start) settings.Add(start.parameter + "=" + start.value);
  for (const std::string& value : study.set) settings.Add(value);
  return {
      .vehicle = DigestOf(study.vehicle), .data = data.Hex(), .settings = settings.Hex(), .version = VersionDigest()};
}

EvaluationContext ContextOfProblem(std::string_view name, double deadline_s) {
  Sha256 problem;
  problem.Add(name);
  Sha256 settings;
  settings.Add(deadline_s);
  return {.vehicle = problem.Hex(), .data = Sha256().Hex(), .settings = settings.Hex(), .version = VersionDigest()};
}

}  // namespace fourpost
