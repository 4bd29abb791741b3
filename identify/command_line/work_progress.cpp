#include "identify/command_line/work_progress.h"

#include <cstdio>

#include "identify/command_line/interrupt.h"

namespace fourpost {

WorkHooks WorkProgress::Hooks() {
  return {.show =
              [this](const std::string& text) {
                if (!line_) line_.emplace();
                line_->Show(text);
              },
          .stop = Interrupted,
          .note =
              [this](const std::string& text) {
                End();
                std::fprintf(stderr, "%s\n", text.c_str());
              }};
}

}  // namespace fourpost
