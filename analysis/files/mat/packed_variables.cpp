#include "analysis/files/mat/packed_variables.h"

#include <cstring>

#include "analysis/files/mat/findings.h"

namespace fourpost {
namespace {

class Packer {
 public:
  std::string bytes;

  void Add(const std::vector<MatVariable>& variables) {
    Add(variables.size());
    for (const MatVariable& variable : variables) {
      Add(variable.name);
      Add(static_cast<std::uint64_t>(variable.kind));
      AddArray(variable.dims);
      AddArray(variable.numbers);
      Add(variable.rows);
      Add(variable.parts);
    }
  }

  void Add(const Found& fault) {
    Add(std::string(fault.kind->id()));
    Add(fault.words);
  }

 private:
  void Add(const std::vector<std::string>& texts) {
    Add(texts.size());
    for (const std::string& text : texts) Add(text);
  }
  void Add(std::uint64_t number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void Add(const std::string& text) {
    Add(text.size());
    bytes += text;
  }
  template <typename Number>
  void AddArray(const std::vector<Number>& numbers) {
    Add(numbers.size());
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  }
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  std::vector<MatVariable> TakeVariables() {
    std::vector<MatVariable> variables;
    for (std::uint64_t count = TakeNumber(); count > 0; --count) {
      MatVariable variable;
      variable.name = TakeText();
      variable.kind = static_cast<MatVariable::Kind>(TakeNumber());
      variable.dims = TakeArray<std::uint64_t>();
      variable.numbers = TakeArray<double>();
      variable.rows = TakeTexts();
      variable.parts = TakeVariables();
      variables.push_back(std::move(variable));
    }
    return variables;
  }

  MatFault TakeFault() {
    const std::string id = TakeText();
    return MatFault(*AllFindings().at(id), TakeTexts());
  }

 private:
  std::string_view Take(std::uint64_t count) {
    if (count > rest_.size()) throw MatFault(kMatCutShort);
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::uint64_t TakeNumber() {
    std::uint64_t number = 0;
    std::memcpy(&number, Take(sizeof number).data(), sizeof number);
    return number;
  }
  std::string TakeText() { return std::string(Take(TakeNumber())); }
  std::vector<std::string> TakeTexts() {
    std::vector<std::string> texts;
    for (std::uint64_t count = TakeNumber(); count > 0; --count) texts.push_back(TakeText());
    return texts;
  }
  template <typename Number>
  std::vector<Number> TakeArray() {
    const std::uint64_t count = TakeNumber();
    if (count > rest_.size() / sizeof(Number)) throw MatFault(kMatCutShort);
    std::vector<Number> numbers(count);
    const std::string_view bytes = Take(count * sizeof(Number));
    if (count > 0) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
  }

  std::string_view rest_;
};

}  // namespace

std::string Packed(const std::vector<MatVariable>& variables) {
  Packer packer;
  packer.Add(variables);
  return std::move(packer.bytes);
}

std::vector<MatVariable> Unpacked(std::string_view bytes) { return Unpacker(bytes).TakeVariables(); }

std::string Packed(const MatFault& fault) {
  Packer packer;
  packer.Add(fault.found());
  return std::move(packer.bytes);
}

MatFault UnpackedFault(std::string_view bytes) { return Unpacker(bytes).TakeFault(); }

}  // namespace fourpost
