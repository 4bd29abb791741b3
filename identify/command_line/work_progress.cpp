#include "identify/command_line/work_progress.h"

#include <cstdio>

#include "identify/command_line/interrupt.h"

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
              }};
}

}  // namespace fourpost
