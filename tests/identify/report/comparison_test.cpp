// Several runs side by side: what is compared, what is said, and what is drawn.
#include <cmath>

#include <gmock/gmock.h>

#include "identify/report/comparison_curves.h"
#include "identify/report/comparison_page.h"
#include "identify/report/comparison_tables.h"
#include "identify/report/comparison_verdict.h"
#include "identify/report/findings.h"
#include "identify/study/experiment_kinds.h"
#include "identify/uncertainty/findings.h"
#include "tests/findings.h"

namespace fourpost::comparison_test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// A fit of stepped sines, of so many parameters.
Json Result(const std::string& study, double fitted, double predicted, int parameters = 1) {
  Json json = Json::parse(R"({
    "termination": "converged", "vehicle": "car", "residuals": 100, "cost": 12.5, "misfit": 1.2, "band_Hz": [1, 12],
    "recordings": [{"name": "bounce"}], "refine": {"loss": "huber", "scale": 1.345}, "evaluations": {"paid": 321},
    "starts": {"agreeing": 4, "refined": 5}, "identifiability": {}, "parameters": []})");
  json["study"] = study + ".yaml";
  for (int i = 0; i < parameters; ++i)
    json["parameters"].push_back({{"name", "p" + std::to_string(i)},
                                  {"unit", "kg"},
                                  {"value", 10.0},
                                  {"lower", 1.0},
                                  {"upper", 20.0},
                                  {"sd", 0.5},
                                  {"interval_95", {9.0, 11.0}},
                                  {"at_bound", false}});
  json["channels"] = {{{"name", "a_FL"}, {"rms_dB", 1}, {"nmse_percent", fitted - 0.5}},
                      {{"name", "a_FR"}, {"rms_dB", 1}, {"nmse_percent", fitted + 0.5}}};
  json["validation"] = {{{"recording", "sweep"}, {"name", "a_FL"}, {"nmse_percent", predicted}}};
  return json;
}

using Folder = std::pair<std::string, RunContents>;

Folder FolderOf(const std::string& name, const Json& result, std::map<std::string, std::string> files = {}) {
  files["result.json"] = result.dump();
  return {name, {.files = std::move(files)}};
}

std::vector<ComparedRun> Runs(const std::vector<Json>& results) {
  std::vector<Folder> folders;
  for (const Json& result : results) folders.push_back(FolderOf("run/" + std::to_string(folders.size()), result));
  return ComparedRuns(std::move(folders), AllExperimentReports());
}

TEST(ComparedRun, GroupsChannelsByAllButTheirPlace) {
  EXPECT_EQ(GroupOf("a_axle_FL"), "a_axle");
  EXPECT_EQ(GroupOf("a_axle_rear"), "a_axle");
  EXPECT_EQ(GroupOf("a_cross_member"), "a_cross_member");
  EXPECT_EQ(GroupOf("force"), "force");
  EXPECT_EQ(GroupOf("_FL"), "_FL");
  const std::vector<ComparedRun> runs = Runs({Result("one", 3, 5)});
  EXPECT_EQ(runs[0].fitted, (std::map<ChannelGroup, double>{{{"", "a"}, 3}}));
  EXPECT_EQ(runs[0].predicted, (std::map<ChannelGroup, double>{{{"sweep", "a"}, 5}}));
}

TEST(ComparedRun, KnowsWhichCostsCompare) {
  Json other = Result("other", 3, 5);
  other["residuals"] = 99;
  Json loss = Result("loss", 3, 5);
  loss["refine"]["scale"] = 2;
  const std::vector<ComparedRun> runs = Runs({Result("one", 3, 5), other, Result("two", 9, 9), loss});
  EXPECT_EQ(runs[0].data, 0u);
  EXPECT_EQ(runs[1].data, 1u);
  EXPECT_EQ(runs[2].data, 0u);
  EXPECT_EQ(runs[3].data, 2u);
}

std::vector<std::size_t> LettersOf(const std::vector<std::pair<Json, std::string>>& results_and_studies) {
  std::vector<Folder> folders;
  for (const auto& [result, study] : results_and_studies) {
    std::map<std::string, std::string> files;
    if (!study.empty()) files["study.yaml"] = study;
    folders.push_back(FolderOf("run", result, files));
  }
  std::vector<std::size_t> letters;
  for (const ComparedRun& run : ComparedRuns(std::move(folders), AllExperimentReports())) letters.push_back(run.data);
  return letters;
}

TEST(ComparedRun, KnowsRecordingsByTheirBytes) {
  const auto fitted = [](const std::string& name, const std::string& digest) {
    Json json = Result("one", 3, 5);
    json["fitted_files"] = {{{"name", name}, {"sha256", digest}}};
    return json;
  };
  EXPECT_EQ(LettersOf({{fitted("a.csv", "12"), ""},
                       {fitted("a.csv", "34"), ""},
                       {fitted("b.csv", "12"), ""},
                       {Result("old", 3, 5), ""}}),
            (std::vector<std::size_t>{0, 1, 0, 2}));
  Json load = Result("load", 3, 5);
  load["static_loads"] = {{{"tyre", "t"}, {"measured_N", 4000}, {"sd_N", 20}, {"modelled_N", 3990}}};
  Json answered = load;
  answered["static_loads"][0]["modelled_N"] = 4010;
  Json other = load;
  other["static_loads"][0]["sd_N"] = 30;
  EXPECT_EQ(LettersOf({{load, ""}, {answered, ""}, {other, ""}}), (std::vector<std::size_t>{0, 0, 1}));
}

TEST(ComparedRun, KnowsWhatWeighsResiduals) {
  const Json result = Result("one", 3, 5);
  const std::string study =
      "vehicle: a.urdf\nrecordings: [{name: bounce, file: b.csv, posts: heave}]\nchannels: {a: a}\n"
      "histories: [{name: sweep, use: validation, file: s.csv}]\n"
      "model_error: {gain_dB: 1, phase: 5 deg}\nsearch: {seed: 1}\n";
  const auto with = [&](const std::string& text, const std::string& other) {
    std::string changed = study;
    changed.replace(changed.find(text), text.size(), other);
    return changed;
  };
  const std::vector<std::string> same = {with("a.urdf", "b.urdf # another model"), with("seed: 1", "seed: 2"),
                                         with("b.csv", "../c.csv"), with("s.csv", "t.csv"),
                                         with("gain_dB: 1, phase: 5 deg", "phase: 5 deg, gain_dB: 1")};
  for (const std::string& changed : same)
    EXPECT_EQ(LettersOf({{result, study}, {result, changed}}), (std::vector<std::size_t>{0, 0})) << changed;
  const std::vector<std::string> others = {with("gain_dB: 1", "gain_dB: 2"),
                                           with("heave", "pitch"),
                                           with("a: a", "a: {sum: [a, b]}"),
                                           with("use: validation", "noise: {a: 1 m}"),
                                           "no: [yaml",
                                           ""};
  for (const std::string& changed : others)
    EXPECT_EQ(LettersOf({{result, study}, {result, changed}}), (std::vector<std::size_t>{0, 1})) << changed;
  const std::string bench = "bench: {model_error: 0.05, validation: [a.csv]}";
  EXPECT_EQ(
      LettersOf(
          {{result, bench}, {result, "bench: {model_error: 0.05, damper: d}"}, {result, "bench: {model_error: 0.1}"}}),
      (std::vector<std::size_t>{0, 0, 1}));
}

TEST(ComparedRun, HasANameOfItsOwn) {
  const std::vector<ComparedRun> runs = Runs({Result("one", 3, 5), Result("two", 3, 5), Result("one", 3, 5)});
  EXPECT_EQ(runs[0].name, "one (0)");
  EXPECT_EQ(runs[1].name, "two");
  EXPECT_EQ(runs[2].name, "one (2)");
}

TEST(ComparedRun, IsNamedByItsPathWhereTheFoldersAreNamedAlike) {
  const std::vector<ComparedRun> runs = ComparedRuns(
      {FolderOf("a/run", Result("one", 3, 5)), FolderOf("b/run/", Result("one", 3, 5))}, AllExperimentReports());
  EXPECT_EQ(runs[0].name, "one (a/run)");
  EXPECT_EQ(runs[1].name, "one (b/run/)");
}

TEST(ComparisonVerdict, SaysWhichFitsAndWhichForetellsBest) {
  const std::string text = VerdictHtml(Runs({Result("rich", 1, 8, 5), Result("plain", 2, 4, 2)}), std::nullopt);
  EXPECT_THAT(text,
              AllOf(HasSubstr("class=\"verdict good\""),
                    HasSubstr("<strong>rich</strong> fits best: 1.00 % mean NMSE over the one group of channels"),
                    HasSubstr("next plain with 2.00 %"), HasSubstr("<strong>plain</strong> predicts best: 4.00 %"),
                    HasSubstr("plain: lowest prediction error of all models, 4 %")));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("BIC")), Not(HasSubstr("same data"))));
}

TEST(ComparisonVerdict, TakesTheSimplerOfTwoThatForetellAlike) {
  EXPECT_THAT(VerdictHtml(Runs({Result("rich", 1, 4, 5), Result("plain", 2, 4.2, 2)}), std::nullopt),
              HasSubstr("plain: fewest parameters of the models within 10 %"));
}

TEST(ComparisonVerdict, SaysWhatCannotBeCompared) {
  Json other = Result("other", 3, 5);
  other["channels"][0]["name"] = "b";
  other["channels"].erase(1);
  other.erase("validation");
  EXPECT_THAT(VerdictHtml(Runs({Result("one", 3, 5), other}), std::nullopt),
              AllOf(HasSubstr("cannot be ranked by fit"), HasSubstr("cannot be ranked by prediction"),
                    HasSubstr("not all fitted to the same data"), HasSubstr("class=\"verdict open\""),
                    Not(HasSubstr("Recommended"))));
}

// sd 0.5 each: 4 apart are 4 / (0.5 sqrt 2) = 5.66 deviations; intervals that touch contradict nothing.
TEST(ComparisonVerdict, NamesParametersWhoseIntervalsDoNotMeet) {
  Json other = Result("sweep", 3, 5, 2);
  other["parameters"][0]["value"] = 14.0;
  other["parameters"][0]["interval_95"] = {13.0, 15.0};
  other["parameters"][1]["value"] = 11.5;
  other["parameters"][1]["interval_95"] = {10.5, 12.5};
  EXPECT_THAT(VerdictHtml(Runs({Result("sines", 3, 5, 2), other}), std::nullopt),
              AllOf(HasSubstr("p0 (10.0 and 14.0 kg, 5.7 standard deviations)"), Not(HasSubstr("p1"))));
  EXPECT_THAT(VerdictHtml(Runs({Result("one", 3, 5), Result("two", 3, 5)}), std::nullopt),
              Not(HasSubstr("standard deviations")));
}

// Roll is harder than bounce: who fits it as well does not fit worse.
TEST(ComparisonVerdict, ComparesByTheStepsThatAllRunsSaw) {
  Json planar = Result("planar", 1, 5);
  planar["recordings"] = {{{"name", "bounce"}, {"nmse_percent", 2}}};
  Json whole = Result("whole", 9, 5);
  whole["recordings"] = {{{"name", "bounce"}, {"nmse_percent", 1}}, {{"name", "roll"}, {"nmse_percent", 30}}};
  const std::vector<ComparedRun> runs = Runs({planar, whole});
  EXPECT_THAT(VerdictHtml(runs, std::nullopt),
              HasSubstr("<strong>whole</strong> fits best: 1.00 % mean NMSE over the one recording that all runs have, "
                        "next planar with 2.00 %"));
  EXPECT_THAT(ErrorTableHtml(runs, &ComparedRun::recordings, "stepped sines"),
              HasSubstr("<td>roll</td><td><code>1 to 12 Hz</code></td>"));
  whole["band_Hz"] = {0.5, 30};
  EXPECT_THAT(VerdictHtml(Runs({planar, whole}), std::nullopt), HasSubstr("cannot be ranked by fit"));
}

TEST(ComparisonVerdict, TakesTheRankingOfDampers) {
  ModelRanking ranking{.models = {}, .reason = "a <reason>"};
  ranking.warnings.Report(kRankedUnexplained, {}, {"model9"});
  EXPECT_THAT(VerdictHtml(Runs({Result("one", 3, 5), Result("two", 4, 6)}), ranking),
              AllOf(HasSubstr("a &lt;reason&gt;"), HasSubstr("model9")));
}

TEST(ComparisonTables, HaveARowPerRunAndAColumnPerRun) {
  Json other = Result("other", 4, 6, 2);
  other["parameters"][0]["at_bound"] = true;
  other["residuals"] = 99;
  const std::vector<ComparedRun> runs = Runs({Result("one", 3, 5), other});
  EXPECT_THAT(RunTableHtml(runs),
              AllOf(HasSubstr("<b>one</b>"), HasSubstr("4 of 5"), HasSubstr("<td class=\"n\">321</td>"),
                    HasSubstr("<td>A</td>"), HasSubstr("<td>B</td>"), HasSubstr("AICc and BIC are shown of dampers")));
  // None stands out: what differs beyond chance is said of pairs.
  EXPECT_THAT(ErrorTableHtml(runs, &ComparedRun::fitted, "stepped sines"),
              HasSubstr("<td class=\"n\">3.00</td><td class=\"n\">4.00</td>"));
  EXPECT_THAT(ErrorTableHtml(runs, &ComparedRun::predicted, "stepped sines"),
              HasSubstr("<td>sweep</td><td><code>a</code></td>"));
  const std::string parameters = ParametersSideBySideHtml(runs);
  EXPECT_THAT(parameters,
              AllOf(HasSubstr("<th scope=\"col\" class=\"n\">one</th><th scope=\"col\" class=\"n\">other</th>"),
                    HasSubstr("<b>10.00</b><br><small>9.00 \u2026 11.00</small>"), HasSubstr("at its bound"),
                    // The first run has no second parameter.
                    HasSubstr("<code>p1</code></td><td>kg</td><td class=\"n\"></td><td class=\"n\"><b>")));
}

TEST(ComparisonTables, HaveCriteriaWhereOneRunTellsThem) {
  Json bench = Result("bench", 3, 5);
  bench["criteria"] = {{"aicc", -1234.5}, {"bic", nullptr}};
  EXPECT_THAT(RunTableHtml(Runs({bench, Result("one", 3, 5)})),
              AllOf(HasSubstr("AICc</th>"), HasSubstr("\u22121234.50"), Not(HasSubstr("shown of dampers"))));
}

std::string History(double measured, double modelled, const std::string& name = "a") {
  return "recording,time," + name + "_measured," + name + "_modelled\n,s,m,m\nsweep,0," + std::to_string(measured) +
         "," + std::to_string(modelled) + "\nsweep,0.1,2,3\n";
}

nlohmann::ordered_json Curves(std::vector<Folder> folders) {
  const std::vector<ComparedRun> runs = ComparedRuns(std::move(folders), AllExperimentReports());
  return ComparisonJson(runs, CurvesOf(runs, AllExperimentReports()));
}

TEST(ComparisonCurves, OverlaysWhatRunsShare) {
  Json fitted = Result("two", 3, 5);
  for (Json& channel : fitted["channels"]) channel["recording"] = "sweep";
  std::vector<Folder> folders;
  folders.push_back(FolderOf("0", Result("one", 3, 5), {{"validation.csv", History(1, 1.5)}}));
  folders.push_back(FolderOf("1", fitted, {{"history.csv", History(1, 1.7)}}));
  // Measured otherwise, and another channel.
  folders.push_back(FolderOf("2", Result("three", 3, 5), {{"history.csv", History(1.1, 1.7)}}));
  folders.push_back(FolderOf("3", Result("four", 3, 5), {{"history.csv", History(1, 1.7, "b")}}));
  const auto curves = Curves(std::move(folders));
  EXPECT_EQ(curves["runs"].dump(), R"(["one","two","three","four"])");
  ASSERT_EQ(curves["histories"].size(), 1u);
  const auto& channel = curves["histories"][0];
  EXPECT_EQ(channel["measured"].dump(), "[1,2]");
  EXPECT_EQ(channel["unit"], "m");
  EXPECT_EQ(channel["runs"].dump(),
            R"([{"run":0,"fitted":false,"values":[1.5,3]},{"run":1,"fitted":true,"values":[1.7,3]}])");
}

// An eighth of 80 s would be more than the 2 s that a page shows row by row.
TEST(ComparisonCurves, KeepEveryRowWhereMostHappens) {
  constexpr int kRows = 8000;
  constexpr int kPeak = 4000;
  std::string text = "recording,time,a_measured,a_modelled\n,s,m,m\n";
  for (int i = 0; i < kRows; ++i)
    text += "sweep," + std::to_string(0.01 * i) + ',' + (i == kPeak ? "9" : std::to_string(i % 3)) + ",1\n";
  const auto curves = Curves({FolderOf("0", Result("one", 3, 5), {{"history.csv", text}}),
                              FolderOf("1", Result("two", 3, 5), {{"history.csv", text}})});
  ASSERT_EQ(curves["histories"].size(), 1u);
  const auto& channel = curves["histories"][0];
  EXPECT_EQ(channel["busiest"].dump(), "[39,41]");
  int inside = 0;
  for (const auto& time : channel["time"])
    if (time >= 39 && time <= 41) ++inside;
  EXPECT_EQ(inside, 201);
  EXPECT_LT(channel["time"].size(), 3300u);
}

TEST(ComparisonCurves, TellTheBandOfEachRun) {
  Json over_time = Result("two", 3, 5);
  over_time["band_Hz"] = {0, 0};
  const auto curves = Curves({FolderOf("0", Result("one", 3, 5)), FolderOf("1", over_time)});
  EXPECT_EQ(curves["bands"].dump(), "[[1,12],null]");
}

TEST(ComparisonCurves, OverlaysResponsesAndDampers) {
  const auto response = [](double modelled) {
    return "recording,channel,unit,frequency_Hz,in_band,gain_measured,gain_modelled,phase_measured_deg,phase_modelled_"
           "deg\n"
           "bounce,a,1,2,1,1.5," +
           std::to_string(modelled) + ",10,20\n";
  };
  const auto bench = [](double modelled) {
    return "recording,time_s,displacement_m,speed_mps,measured_N,modelled_N\n1 Hz,0,0,1,100," +
           std::to_string(modelled) + "\n";
  };
  std::vector<Folder> folders;
  for (const double modelled : {1.25, 2.5})
    folders.push_back(FolderOf("x", Result("x" + std::to_string(modelled), 3, 5),
                               {{"response.csv", response(modelled)}, {"bench.csv", bench(modelled)}}));
  const auto curves = Curves(std::move(folders));
  ASSERT_EQ(curves["responses"].size(), 1u);
  EXPECT_EQ(curves["responses"][0]["runs"].dump(),
            R"([{"run":0,"gain":[1.25],"phase":[20]},{"run":1,"gain":[2.5],"phase":[20]}])");
  ASSERT_EQ(curves["bench"].size(), 1u);
  EXPECT_EQ(curves["bench"][0]["runs"].dump(),
            R"([{"run":0,"fitted":false,"values":[1.25]},{"run":1,"fitted":false,"values":[2.5]}])");
  EXPECT_EQ(curves["bench"][0]["columns"].size(), 4u);
}

TEST(ComparisonPage, EscapesNamesAndRefusesWhatIsNoFit) {
  const std::string hostile = "</script><b>";
  std::vector<Folder> folders = {FolderOf(hostile, Result(hostile, 3, 5)), FolderOf("b", Result(hostile, 3, 5))};
  EXPECT_THAT(ComparisonPage(folders, AllExperimentReports()),
              AllOf(HasSubstr("<h1>2 fits compared</h1>"), HasSubstr("script&gt;&lt;b&gt;"), Not(HasSubstr("<b></b>")),
                    Not(HasSubstr("</script><b>"))));
  EXPECT_THAT(ComparisonPage(folders, AllExperimentReports()),
              ContainsRegex("<footer>Made by fourpost [0-9.]+ on [0-9]{4}-[0-9]{2}-[0-9]{2} of the fits "));
  folders[1] = FolderOf("b", Json{{"a", 1}});
  EXPECT_THAT([&] { ComparisonPage(folders, AllExperimentReports()); }, Refuses(kResultNotOfFit, 0));
}

}  // namespace
}  // namespace fourpost::comparison_test
