#include "tests/peers/peer_methods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "tests/peers/findings.h"
#include "tests/peers/nlopt_search.h"
#include "tests/peers/pagmo_search.h"
#include "tests/peers/scipy_search.h"

namespace fourpost {
namespace {

struct Peer {
  std::string_view name;
  void (*minimise)(PeerObjective&, const PeerSettings&, std::uint32_t seed);
  /// As the library has them, where it has any.
  PeerSettings settings;
};

const std::vector<Peer>& Peers() {
  constexpr double kMost = 100000;
  // The fewest members are those that pagmo and scipy ask for.
  const auto with = [](double population, double fewest, PeerSettings own) {
    own.insert(own.begin(), {"population", population, fewest, kMost});
    own.push_back({"patience", 50, 0, kMost});
    own.push_back({"logarithmic", 0, 0, 1});
    return own;
  };
  static const std::vector<Peer> peers = {
      {"pagmo_de", MinimiseByPagmoDe,
       with(20, 5, {{"factor", 0.8, 0, 1}, {"crossover", 0.9, 0, 1}, {"variant", 2, 1, 10}})},
      {"pagmo_sade", MinimiseByPagmoSade, with(20, 7, {{"variant", 2, 1, 18}, {"adaptation", 1, 1, 2}})},
      {"pagmo_cmaes", MinimiseByPagmoCmaes, with(20, 5, {{"deviation", 0.5, 1e-6, 1}})},
      {"nlopt_crs2", MinimiseByNloptCrs2, with(50, 1, {})},
      {"nlopt_isres", MinimiseByNloptIsres, with(100, 1, {})},
      {"scipy_de", MinimiseByScipyDe,
       with(60, 5,
            {{"factor_lower", 0.5, 0, 2}, {"factor_upper", 1, 0, 2}, {"crossover", 0.7, 0, 1}, {"variant", 1, 1, 6}})}};
  return peers;
}

std::vector<std::string> Split(std::string_view text) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  return parts;
}

std::string Text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// "population=40"
void Change(PeerSettings& settings, const std::string& method, const std::string& change) {
  const std::size_t sign = change.find('=');
  const std::string name = change.substr(0, sign);
  std::vector<std::string> legal;
  for (const PeerSetting& setting : settings) legal.push_back(setting.name);
  const auto found = std::find(legal.begin(), legal.end(), name);
  if (found == legal.end())
    Refuse(kPeerSettingUnknown, Place::Option("--methods"), {method, name, DidYouMean(name, legal)});
  PeerSetting& setting = settings[static_cast<std::size_t>(found - legal.begin())];
  setting.value =
      sign == std::string::npos ? std::nan("") : ParseNumber(change.substr(sign + 1)).value_or(std::nan(""));
  if (!(setting.value >= setting.lower && setting.value <= setting.upper))
    Refuse(kPeerSettingOutOfRange, Place::Option("--methods"),
           {method, name, Text(setting.value), Text(setting.lower), Text(setting.upper)});
}

PeerRules RulesOf(const PeerSettings& settings) {
  const double patience = ValueOf(settings, "patience") * ValueOf(settings, "population");
  return {.patience = patience > 0 ? static_cast<std::int64_t>(patience) : std::numeric_limits<std::int64_t>::max(),
          .logarithmic = ValueOf(settings, "logarithmic") != 0};
}

SearchEnd RunPeer(const Peer& peer, const PeerSettings& settings, Archive& archive, std::uint64_t seed,
                  const StopRules& rules, const std::function<bool()>& stop) {
  rules.Validate();
  const PeerRules peer_rules = RulesOf(settings);
  PeerObjective objective(archive, rules, peer_rules, stop);
  for (std::int64_t start = 0; objective.end() == SearchEnd::kNotRun; ++start) {
    const std::int64_t before = objective.requests();
    objective.StartAnew();
    try {
      peer.minimise(objective, settings, static_cast<std::uint32_t>(Draws(seed, DrawPurpose::kStart, start, 1).Bits()));
    } catch (const PeerStop&) {
      continue;
    }
    if (objective.requests() == before) throw std::logic_error(std::string(peer.name) + " asked for nothing");
  }
  return objective.end();
}

}  // namespace

std::vector<std::string_view> PeerNames() {
  std::vector<std::string_view> names;
  for (const Peer& peer : Peers()) names.push_back(peer.name);
  return names;
}

ComparedMethod PeerMethod(std::string_view text) {
  const std::vector<std::string> parts = Split(text);
  const std::string name = parts.empty() ? "" : parts[0];
  const auto peer = std::find_if(Peers().begin(), Peers().end(), [&](const Peer& p) { return p.name == name; });
  if (peer == Peers().end()) Refuse(kPeerUnknown, Place::Option("--methods"), {name, DidYouMean(name, PeerNames())});
  PeerSettings settings = peer->settings;
  for (std::size_t i = 1; i < parts.size(); ++i) Change(settings, std::string(text), parts[i]);

  ForeignMethod foreign;
  for (const PeerSetting& setting : settings) foreign.settings.emplace_back(setting.name, Text(setting.value));
  foreign.run = [&peer = *peer, settings](Archive& archive, std::uint64_t seed, const StopRules& rules,
                                          const std::function<bool()>& stop) {
    return RunPeer(peer, settings, archive, seed, rules, stop);
  };
  return {.name = std::string(text), .foreign = std::move(foreign)};
}

std::vector<ComparedMethod> TakePeers(std::vector<std::string>& names, Diagnostics& diagnostics) {
  const auto is_peer = [](const std::string& name) {
    return name.starts_with("pagmo_") || name.starts_with("nlopt_") || name.starts_with("scipy_");
  };
  std::vector<ComparedMethod> methods;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!is_peer(name)) continue;
    if (!seen.insert(name).second) {
      diagnostics.Report(kPeerTwice, Place::Option("--methods"), {name});
      continue;
    }
    try {
      methods.push_back(PeerMethod(name));
    } catch (const FaultyInput& fault) {
      diagnostics.Add(fault.diagnostics());
    }
  }
  std::erase_if(names, is_peer);
  return methods;
}

}  // namespace fourpost
