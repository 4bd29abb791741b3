#pragma once

#include <string>

#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// What was tested, where, when and by whom, as a study states it for those who read its report; empty where it does
/// not.
struct StudyAbout {
  std::string car;
  std::string rig;
  std::string date;
  std::string operated_by;
};

/// What stands under 'about' of a study.
StudyAbout ReadStudyAbout(const StrictMap& study);

/// The same of a study's text, which has been read without fault before; nothing where it cannot be read.
StudyAbout StudyAboutOf(const std::string& study_text);

}  // namespace fourpost
