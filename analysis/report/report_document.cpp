#include "analysis/report/report_document.h"

#include "analysis/files/sha256.h"
#include "analysis/report/html.h"
#include "analysis/report/report_bundle.h"

namespace fourpost {
namespace {

/// As it stands between its tags.
const std::string& Script() {
  static const std::string script = "\n" + std::string(kReportScript);
  return script;
}

/// What a browser computes of the script before it runs it (Content Security Policy Level 3, section 2.3.1).
const std::string& ScriptHash() {
  static const std::string hash = [] {
    Sha256 digest;
    digest.AddBytes(Script());
    return "'sha256-" + digest.Base64() + "'";
  }();
  return hash;
}

/// Inert text that a script unpacks.
std::string Packed(const std::string& type, const std::string& id, std::string_view base64) {
  return "<script type=\"" + type + "+base64\" id=\"" + id + "\">" + std::string(base64) + "</script>\n";
}

/// Nothing may be fetched and no other script runs, whatever a name in the data says.
std::string Policy(const ReportPrograms& programs) {
  std::string scripts = ScriptHash();
  if (programs.draws_vehicle) scripts += " 'sha256-" + std::string(kReportStageSha256) + "'";
  if (!programs.live.empty()) scripts += " 'wasm-unsafe-eval'";
  return "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src " + scripts +
         "; style-src 'unsafe-inline'; img-src data: blob:\">\n";
}

}  // namespace

std::string ReportDocument(const std::string& title, const std::string& body, const std::string& data_json,
                           const ReportPrograms& programs) {
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      Policy(programs) + "<meta name=\"color-scheme\" content=\"light dark\">\n";
  page += "<title>" + html::Escaped(title) + "</title>\n<style>\n";
  page += kReportStyle;
  page += "</style>\n</head>\n<body>\n" + body;
  if (!programs.live.empty()) page += Packed("application/wasm", "program", programs.live);
  if (programs.draws_vehicle) page += Packed("text/javascript", "stage", kReportStage);
  page +=
      "<script type=\"application/json\" id=\"data\">" + html::ScriptJson(data_json) + "</script>\n<script>" + Script();
  return page + "</script>\n</body>\n</html>\n";
}

}  // namespace fourpost
