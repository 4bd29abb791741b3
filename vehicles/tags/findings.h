#pragma once

#include "analysis/text/finding.h"

// What can be wrong with the text of a vehicle file before and in its attributes. The first word of those about an
// attribute is `mass="2" of link 'body'`.
namespace fourpost {

inline const Finding kXmlFileTooLarge{"xml-file-too-large", Severity::kError, "the file is larger than {}",
                                      "remove what is not part of the vehicle"};
inline const Finding kXmlNul{"xml-nul", Severity::kError, "a NUL byte", "save the file as text in UTF-8"};
inline const Finding kXmlDocumentType{"xml-document-type", Severity::kError,
                                      "document types and entities are not supported", "write out what they stand for"};
inline const Finding kXmlStrayBracket{"xml-stray-bracket", Severity::kError, "not XML, '<' begins no tag here",
                                      "write &lt;"};
inline const Finding kXmlInstruction{"xml-instruction", Severity::kError, "not XML, '<' stands within <? ?>",
                                     "write &lt;, or end the instruction with ?> before it"};
inline const Finding kXmlOpenQuote{"xml-open-quote", Severity::kError, "not XML, the value that begins here holds '<'",
                                   "close its quote, or write &lt;"};
inline const Finding kXmlTags{"xml-too-many-tags", Severity::kError, "more than {} tags",
                              "remove what is not part of the vehicle"};
inline const Finding kXmlDepth{"xml-too-deep", Severity::kError, "tags are nested more than {} deep",
                               "remove levels that only group"};
inline const Finding kXmlAttributes{"xml-too-many-attributes", Severity::kError, "a tag with more than {} attributes",
                                    "remove those that fourpost does not know"};

inline const Finding kAttributeEmpty{"attribute-empty", Severity::kError, "{} is empty",
                                     "write its value, or remove it"};
inline const Finding kNameCharacters{"name-characters", Severity::kError, "{} is not a name",
                                     "use letters, digits, '_', '-' and '.' only"};
inline const Finding kNotAPlainNumber{"not-a-plain-number", Severity::kError, "{} is not a plain number",
                                      "write digits alone, such as 0.5"};
inline const Finding kNotAVector{"not-a-vector", Severity::kError, "{} is not a vector",
                                 "write three numbers, such as \"0 0 1\""};
inline const Finding kZeroDirection{"zero-direction", Severity::kError, "{} is a direction and must not be zero",
                                    "write one such as \"0 0 1\""};
inline const Finding kUnknownChoice{"unknown-choice", Severity::kError, "{} must be one of {}{}"};
inline const Finding kNumberNegative{"number-negative", Severity::kError, "{} must not be negative{}"};
inline const Finding kNumberNotPositive{"number-not-positive", Severity::kError, "{} must be above zero{}"};
inline const Finding kNumberTooSmall{"number-too-small", Severity::kError, "{} must be 1e-30 in SI units at least{}",
                                     "check its unit and its exponent"};
inline const Finding kNumberTooLarge{"number-too-large", Severity::kError, "{} must not exceed 1e30 in SI units{}",
                                     "check its unit and its exponent"};

}  // namespace fourpost
