#include "identify/command_line/work_progress.h"

#include <cstdio>

#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"

namespace fourpost {

WorkHooks WorkProgress::Hooks() {
  return {.show =
              [this](const std::string& text) {
                if (line_) return line_->Show(text);
                line_.emplace(start_);
                line_->ShowNext(text);
              },
          .stop = Interrupted,
          .note =
              [this](const std::string& text) {
                End();
                std::fprintf(stderr, "%s\n", text.c_str());
              },
          .find = [this](const Diagnostics& findings) { Tell(findings); }};
}

void WorkProgress::Tell(const Diagnostics& findings) {
  Diagnostics news;
  for (const Diagnostic& item : findings.items())
    if (told_.insert(Format(item)).second) news.Add(item);
  if (news.items().empty()) return;
  End();
  fourpost::Tell(news);
}

}  // namespace fourpost
