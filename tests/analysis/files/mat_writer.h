#pragma once

#include <matio.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// Writes variables as MATLAB would.
class MatWriter {
 public:
  MatWriter(const std::string& file, mat_ft version) : mat_(Mat_CreateVer(file.c_str(), nullptr, version)) {}
  ~MatWriter() { Mat_Close(mat_); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  static matvar_t* Column(const char* name, std::vector<double> values) {
    std::size_t dims[2] = {values.size(), 1};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, values.data(), 0);
  }

  static matvar_t* Text(const char* name, std::string text) {
    std::size_t dims[2] = {1, text.size()};
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, dims, text.data(), 0);
  }

  /// A row of characters each, filled up with blanks.
  static matvar_t* Rows(const char* name, const std::vector<std::string>& texts) {
    std::size_t longest = 0;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::size_t dims[2] = {texts.size(), longest};
    std::string characters;
    for (std::size_t column = 0; column < longest; ++column)
      for (const std::string& text : texts) characters += column < text.size() ? text[column] : ' ';
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, dims, characters.data(), 0);
  }

  static matvar_t* Cells(const char* name, const std::vector<std::string>& texts) {
    std::size_t dims[2] = {texts.size(), 1};
    matvar_t* cells = Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, dims, nullptr, 0);
    for (std::size_t i = 0; i < texts.size(); ++i) Mat_VarSetCell(cells, static_cast<int>(i), Text(nullptr, texts[i]));
    return cells;
  }

  static matvar_t* Struct(const char* name, const std::vector<std::pair<const char*, matvar_t*>>& fields) {
    std::vector<const char*> names;
    for (const auto& field : fields) names.push_back(field.first);
    std::size_t dims[2] = {1, 1};
    matvar_t* structure = Mat_VarCreateStruct(name, 2, dims, names.data(), static_cast<unsigned>(names.size()));
    for (const auto& [field, value] : fields) Mat_VarSetStructFieldByName(structure, field, 0, value);
    return structure;
  }

  void Add(matvar_t* variable) {
    Mat_VarWrite(mat_, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }

 private:
  mat_t* mat_;
};

}  // namespace fourpost
