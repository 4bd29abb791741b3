#include "identify/command_line/watch_page.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <utility>

#include "analysis/charts/svg_chart.h"
#include "analysis/files/output_folder.h"
#include "analysis/report/html.h"
#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/output_file.h"

namespace fourpost {
namespace {

constexpr double kSecondsBetween = 2;

/// `next`: what a refresh loads, after `wait_s`; empty: no refresh.
std::string Page(const std::string& study, const std::string& next, double wait_s, const std::string& body) {
  const std::string refresh =
      next.empty() ? "" : "<meta http-equiv=\"refresh\" content=\"" + Rounded(wait_s, 2) + "; url=" + next + "\">\n";
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n" + refresh + "<title>Fit of " +
         html::Escaped(study) +
         "</title>\n<style>body{font:15px/1.4 system-ui,sans-serif;margin:2em auto;max-width:50em;padding:0 1em}"
         "table{border-collapse:collapse;margin:1em 0}td,th{padding:.15em .8em;text-align:left}"
         ".n{text-align:right;font-variant-numeric:tabular-nums}img{max-width:100%}"
         "</style></head>\n<body><h1>Fit of " +
         html::Escaped(study) + "</h1>\n" + body + "</body></html>\n";
}

/// Values of the best point so far and where they stand between their bounds.
std::string Values(const FitProgress& progress) {
  if (!progress.best || !progress.lattice || progress.best->size() == 0) return "";
  std::vector<std::vector<html::Cell>> rows;
  for (std::size_t i = 0; i < progress.lattice->size(); ++i) {
    const LatticeAxis& axis = progress.lattice->axes()[i];
    const double value = (*progress.best)[static_cast<Eigen::Index>(i)];
    const double share = 100 * (value - axis.lower) / (axis.upper - axis.lower);
    rows.push_back({html::TextCell(axis.name), html::NumberCell(Rounded(value, 5)),
                    html::NumberCell(Rounded(axis.lower, 5)),
                    html::Cell{"<meter min=\"0\" max=\"100\" value=\"" + Rounded(share, 4) + "\">" + Rounded(share, 2) +
                                   " %</meter>",
                               ""},
                    html::NumberCell(Rounded(axis.upper, 5))});
  }
  return "<h2>Best values so far</h2>\n" +
         html::Table({"parameter", "value, SI", "lower bound", "between the bounds", "upper bound"}, rows);
}

}  // namespace

WatchPage::WatchPage(std::filesystem::path folder, std::string study)
    : file_(std::move(folder) / kWatchPage), study_(std::move(study)) {
  ReplaceFile(file_, Page(study_, kWatchPage, kSecondsBetween, "<p>The fit begins ...</p>\n"));
}

WatchPage::~WatchPage() {
  try {
    if (!has_ended_) End("", "without results, for the reason that the terminal shows");
  } catch (const std::exception&) {
    // Out of memory, at worst.
  }
}

void WatchPage::Write(const std::string& next, double wait_s, const std::function<std::string()>& body) const {
  try {
    ReplaceFile(file_, Page(study_, next, wait_s, body()));
  } catch (const std::exception&) {
    // No page is worth a fit; the writers of results report a disk that is full.
  }
}

void WatchPage::Begin() {
  cost_.clear();
  cost_s_.clear();
}

double WatchPage::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void WatchPage::Note(const FitProgress& progress) {
  if (stages_.empty() || stages_.back().name != progress.stage)
    stages_.push_back({.name = std::string(progress.stage), .began_s = seconds()});
  stages_.back().evaluations = progress.in_stage;
  if (!std::isfinite(progress.best_cost) || (!cost_.empty() && progress.best_cost >= cost_.back())) return;
  cost_.push_back(progress.best_cost);
  cost_s_.push_back(seconds());
}

std::string WatchPage::Stages() const {
  std::vector<std::vector<html::Cell>> rows;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const double end = i + 1 < stages_.size() ? stages_[i + 1].began_s : seconds();
    rows.push_back({html::TextCell(stages_[i].name), html::NumberCell(std::to_string(stages_[i].evaluations)),
                    html::NumberCell(Rounded(end - stages_[i].began_s, 3))});
  }
  return html::Table({"stage", "evaluations", "seconds"}, rows);
}

/// Steps of the best cost; empty before there are two.
std::string WatchPage::Chart() const {
  if (cost_.size() < 2 || cost_.back() <= 0 || !(cost_.front() > cost_.back())) return "";
  SvgSeries series{.style = {.label = "best cost", .color = "#0072B2"}};
  for (std::size_t i = 0; i < cost_.size(); ++i) {
    if (i > 0) {
      series.x.push_back(cost_s_[i]);
      series.y.push_back(cost_[i - 1]);
    }
    series.x.push_back(cost_s_[i]);
    series.y.push_back(cost_[i]);
  }
  series.x.push_back(seconds());
  series.y.push_back(cost_.back());
  SvgPanel panel{.x = LinearAxis(0, std::max(1.0, seconds()), 8), .y = LogAxis(cost_.back(), cost_.front())};
  panel.series.push_back(std::move(series));
  SvgSheet sheet{.panel_width = 620, .panel_height = 220, .x_label = "time, s"};
  sheet.columns = {"best cost"};
  sheet.rows.push_back({.panels = {std::move(panel)}});
  return html::Picture(SvgText(sheet), "Best cost over time: " + Rounded(cost_.front(), 4) + " at first, " +
                                           Rounded(cost_.back(), 4) + " now");
}

void WatchPage::Show(const FitProgress& progress) {
  Note(progress);
  if (Clock::now() - written_ < std::chrono::duration<double>(kSecondsBetween)) return;
  written_ = Clock::now();
  const std::string best = std::isfinite(progress.best_cost) ? ", best cost " + Rounded(progress.best_cost, 5) : "";
  Write(kWatchPage, kSecondsBetween, [&] {
    return "<p>" + html::Escaped(std::string(progress.stage)) + ": " + std::to_string(progress.paid) +
           " evaluations in " + Rounded(seconds(), 3) + " s" + best + ".</p>\n" + Chart() + Stages() + Values(progress);
  });
}

void WatchPage::End(const std::string& report, const std::string& how) {
  has_ended_ = true;
  const std::string link = report.empty() ? "" : " <a href=\"" + html::Escaped(report) + "\">Its report</a>";
  Write(report, 0,
        [&] { return "<p>The fit ended: " + html::Escaped(how) + "." + link + "</p>\n" + Chart() + Stages(); });
}

}  // namespace fourpost
