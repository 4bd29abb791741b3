#include "vehicles/requests/reduced_json.h"

#include <utility>
#include <vector>

#include "analysis/files/json_text.h"
#include "vehicles/condensed/reduced_fields.h"
#include "vehicles/condensed/state_space.h"
#include "vehicles/requests/state_space_json.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Of a record, its fields.
class FieldWriter {
 public:
  explicit FieldWriter(const std::vector<Parameter>& parameters) : parameters_(parameters) {}

  template <typename T>
  void operator()(const char* name, const T& value) {
    json_[name] = JsonOf(value);
  }
  template <typename Enum>
  void Choice(const char* name, const Enum& value, const auto& names) {
    json_[name] = names.at(static_cast<std::size_t>(value));
  }
  OrderedJson Take() { return std::move(json_); }

 private:
  OrderedJson JsonOf(double number) const { return number; }
  OrderedJson JsonOf(int number) const { return number; }
  OrderedJson JsonOf(std::size_t number) const { return number; }
  OrderedJson JsonOf(bool is_set) const { return is_set; }
  OrderedJson JsonOf(const std::string& text) const { return text; }
  OrderedJson JsonOf(const Scalar& scalar) const {
    if (scalar.parameter < 0) return scalar.value;
    return {{"parameter", parameters_[static_cast<std::size_t>(scalar.parameter)].name}, {"factor", scalar.factor}};
  }
  OrderedJson JsonOf(const Eigen::Vector3d& vector) const { return {vector.x(), vector.y(), vector.z()}; }
  OrderedJson JsonOf(const Eigen::VectorXd& vector) const { return std::vector<double>(vector.begin(), vector.end()); }
  OrderedJson JsonOf(const Eigen::MatrixXd& matrix) const { return MatrixJson(matrix); }
  template <typename T, std::size_t n>
  OrderedJson JsonOf(const std::array<T, n>& list) const {
    return ListOf(list);
  }
  template <typename T>
  OrderedJson JsonOf(const std::vector<T>& list) const {
    return ListOf(list);
  }
  template <typename T>
  OrderedJson JsonOf(const std::optional<T>& value) const {
    return value ? JsonOf(*value) : OrderedJson();
  }
  template <typename Record>
  OrderedJson JsonOf(const Record& record) const {
    FieldWriter fields(parameters_);
    EachField(record, fields);
    return fields.Take();
  }
  template <typename List>
  OrderedJson ListOf(const List& list) const {
    OrderedJson json = OrderedJson::array();
    for (const auto& item : list) json.push_back(JsonOf(item));
    return json;
  }

  const std::vector<Parameter>& parameters_;
  OrderedJson json_ = OrderedJson::object();
};

}  // namespace

std::string ReducedJson(const ReducedVehicle& vehicle) {
  const ReducedData& data = vehicle.data();
  FieldWriter fields(data.parameters);
  EachField(data, fields);
  std::vector<double> values;
  for (const Parameter& parameter : data.parameters) values.push_back(parameter.value);
  OrderedJson json = fields.Take();
  json["state_space"] = StateSpaceJson(data.sensors, data.posts, StateSpace(vehicle.At(values)));
  return JsonText(json);
}

}  // namespace fourpost
