#include "identify/draft/draft_statements.h"

#include <algorithm>

#include "analysis/measured_response/findings.h"
#include "analysis/text/diagnostics.h"
#include "analysis/text/named.h"
#include "analysis/text/nearest.h"
#include "identify/experiments/four_post/findings.h"

namespace fourpost {

void CheckStatedPosts(const DraftStatements& stated, const Vehicle& vehicle) {
  Diagnostics findings;
  const std::vector<std::string> posts = NamesOf(vehicle.posts);
  for (const PostChannel& post : stated.posts)
    if (std::find(posts.begin(), posts.end(), post.post) == posts.end())
      findings.Report(kSinePostUnknown, Place::Option("--post"), {post.post, DidYouMeanOrAll(post.post, posts)});
  if (findings.HasErrors()) throw FaultyInput(findings);
}

void CheckStatements(const DraftStatements& stated, const std::vector<std::string>& channels) {
  Diagnostics findings;
  for (const StatedUnit& unit : stated.units)
    if (std::none_of(channels.begin(), channels.end(), [&](const std::string& name) { return unit.Names(name); }))
      findings.Report(kResponseUnitOfNone, Place::Option("--unit"),
                      {unit.channel, DidYouMeanOrAll(unit.channel, channels)});
  for (const PostChannel& post : stated.posts)
    if (std::find(channels.begin(), channels.end(), post.channel) == channels.end())
      findings.Report(kResponsePostMissing, Place::Option("--post"),
                      {post.channel, post.post, DidYouMeanOrAll(post.channel, channels)});
  if (findings.HasErrors()) throw FaultyInput(findings);
}

}  // namespace fourpost
