#include "vehicles/condensed/reduced_bytes.h"

#include "vehicles/condensed/field_bytes.h"
#include "vehicles/condensed/reduced_fields.h"

namespace fourpost {
namespace {

/// Changes whenever the fields do.
constexpr std::string_view kFormat = "fourpost reduced vehicle 4\n";

}  // namespace

std::string BytesOf(const ReducedData& data) {
  ByteWriter writer;
  writer.Put(kFormat);
  writer("", data);
  return writer.Take();
}

ReducedData ReducedDataOf(std::string_view bytes) {
  ByteReader reader(bytes);
  if (bytes.size() < kFormat.size() || reader.Next(kFormat.size()) != kFormat) ByteReader::Refuse();
  ReducedData data;
  reader("", data);
  if (!reader.AtEnd()) ByteReader::Refuse();
  return data;
}

}  // namespace fourpost
