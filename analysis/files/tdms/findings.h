#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a TDMS file.
namespace fourpost {

inline const Finding kTdmsSegment{"tdms-segment", Severity::kError, "damaged TDMS file, no segment begins at byte {}",
                                  "copy or save it again"};
inline const Finding kTdmsIndex{"tdms-index", Severity::kError, "this is the index of a TDMS file, without its data",
                                "name the file .tdms beside it"};
inline const Finding kTdmsLead{
    "tdms-lead-in", Severity::kError,
    "damaged TDMS file, the segment at byte {} says that its data begin at byte {} and end at {}",
    "copy or save it again"};
inline const Finding kTdmsDaqmx{"tdms-daqmx", Severity::kError,
                                "TDMS file holds raw data of DAQmx in '{}' (segment at byte {})",
                                "save it with scaled values, as LabVIEW and DIAdem do"};
inline const Finding kTdmsObject{"tdms-object", Severity::kError, "damaged TDMS file, {} at byte {}",
                                 "copy or save it again"};
inline const Finding kTdmsScale{"tdms-scale", Severity::kWarning, "channels with a scaling that is not read: {}",
                                "export them as scaled values if they matter"};
inline const Finding kTdmsCut{"tdms-last-chunk", Severity::kWarning,
                              "the last data of the segment at byte {} are incomplete; they are left out",
                              "copy the file again if it was complete"};

}  // namespace fourpost
