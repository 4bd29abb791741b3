#include "identify/report/ride_terms.h"

#include <utility>

#include "analysis/report/html.h"

namespace fourpost {

std::string RideTermsHtml() {
  constexpr std::pair<const char*, const char*> kTerms[] = {
      {"a_w", "rms of the weighted acceleration in m/s^2, the measure of comfort of ISO 2631-1"},
      {"Wk", "weighting of ISO 2631-1 for vertical vibration of a seated person, most at 4 to 12.5 Hz"},
      {"Wd", "weighting of ISO 2631-1 for horizontal vibration, most below 2 Hz"},
      {"We", "weighting of ISO 2631-1 for rotation"},
      {"Wb", "weighting of ISO 2631-4 for vertical vibration in rail vehicles"},
      {"Wf", "weighting of ISO 2631-1 for motion sickness, below 0.5 Hz"},
      {"0.5-5 Hz", "primary ride: rms of the unweighted acceleration where the body moves on its springs"},
      {"5-25 Hz", "secondary ride: rms of the unweighted acceleration where wheels hop and parts shake"},
      {"MTVV",
       "maximum transient vibration value: the largest running rms over 1 s of the weighted acceleration; not "
       "known of spectra"},
      {"VDV",
       "vibration dose value, (integral of a_w(t)^4 dt)^(1/4): shocks count more than in the rms; of spectra "
       "that of a normal acceleration"},
      {"CPLV",
       "contact patch load variation: rms of a tyre's vertical force about its mean, over the static force; less "
       "is better grip"},
      {"off ground", "share of time in which a tyre has no contact"},
      {"sum of load variances",
       "sum of the squares of the load variations of the tyres: grip that falls off with load is "
       "lost in proportion to it"},
      {"ride height", "motion of the chassis above the road under the axle, the platform's variation"},
      {"power", "mean power that the dashpot turns into heat"},
      {"contact", "share of time in which a stop is touched"}};
  std::string list;
  for (const auto& [term, meaning] : kTerms)
    list += html::Element("dt", "", html::Escaped(term)) + html::Element("dd", "", html::Escaped(meaning)) + '\n';
  return html::Folded("What the terms mean", html::Element("dl", "terms", list));
}

}  // namespace fourpost
