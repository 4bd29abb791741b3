#include "identify/command_line/post_option.h"

#include "identify/command_line/findings.h"

namespace fourpost {
namespace {

void AddPost(const std::string& text, std::vector<PostChannel>& posts, Diagnostics& faults) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    faults.Report(kPostChannelMalformed, Place::Option("--post"), {text});
  else posts.push_back({text.substr(0, sign), text.substr(sign + 1)});
}

}  // namespace

CLI::Option* AddPostOption(CLI::App& app, std::vector<PostChannel>& posts, Diagnostics& faults,
                           const std::string& without) {
  return app
      .add_option_function<std::vector<std::string>>(
          "--post",
          [&posts, &faults](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) AddPost(text, posts, faults);
          },
          "Channel of a post's displacement and the post's name, CHANNEL=FL; once for each post (default: " + without +
              ")")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace fourpost
