#include "vehicles/ride_metrics/ride_bytes.h"

#include "vehicles/condensed/field_bytes.h"
#include "vehicles/ride_metrics/ride_fields.h"

namespace fourpost {

std::string BytesOf(const RideInstruments& instruments) {
  ByteWriter writer;
  writer("", instruments);
  return writer.Take();
}

RideInstruments RideInstrumentsOf(std::string_view bytes) {
  ByteReader reader(bytes);
  RideInstruments instruments;
  reader("", instruments);
  if (!reader.AtEnd()) ByteReader::Refuse();
  return instruments;
}

}  // namespace fourpost
