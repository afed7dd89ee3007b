// SPDX-License-Identifier: GPL-3.0-or-later
/// \file field.h
/// A field: a named, typed table with one row of components per particle (or per anything else).
/// Tests: tests/coupling/bridge/frame_test.cpp
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace powderlink::bridge {

enum class ElementType : std::uint8_t { float64 = 1, int64 = 2, int32 = 3 };

/// Components of one row: {1,1} scalar, {3,1} vector, {3,3} tensor (row by row).
struct Shape {
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;

  std::size_t components() const { return std::size_t{rows} * columns; }
  bool operator==(const Shape& other) const {
    return rows == other.rows && columns == other.columns;
  }
};

inline constexpr Shape scalar{1, 1};
inline constexpr Shape vector3{3, 1};
inline constexpr Shape tensor3x3{3, 3};

inline std::size_t bytes_of(ElementType type) { return type == ElementType::int32 ? 4 : 8; }

inline const char* name_of(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return "float64";
    case ElementType::int64:
      return "int64";
    case ElementType::int32:
      return "int32";
  }
  return "unknown";
}

template <class T>
constexpr ElementType element_type() {
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::int64_t> ||
                    std::is_same_v<T, std::int32_t>,
                "fields hold double, int64_t or int32_t");
  if (std::is_same_v<T, double>) return ElementType::float64;
  return std::is_same_v<T, std::int64_t> ? ElementType::int64 : ElementType::int32;
}

/// What both programs must agree on. The unit is SI as text ("m/s"), "1" for none.
struct FieldSpec {
  std::string name;
  std::string unit;
  Shape shape;
  ElementType type = ElementType::float64;

  std::size_t row_bytes() const { return shape.components() * bytes_of(type); }
  bool operator==(const FieldSpec& other) const {
    return name == other.name && unit == other.unit && shape == other.shape && type == other.type;
  }
};

/// E.g. "velocity [m/s] float64 3x1".
inline std::string describe(const FieldSpec& spec) {
  return spec.name + " [" + spec.unit + "] " + name_of(spec.type) + " " +
         std::to_string(spec.shape.rows) + "x" + std::to_string(spec.shape.columns);
}

/// Rows to read, in memory of the caller; nothing is copied.
class ColumnView {
 public:
  template <class T>
  ColumnView(const T* first, std::size_t rows)
      : data_(first), rows_(rows), type_(element_type<T>()) {}

  const void* data() const { return data_; }
  std::size_t rows() const { return rows_; }
  ElementType type() const { return type_; }

 private:
  const void* data_;
  std::size_t rows_;
  ElementType type_;
};

/// Rows to fill, in memory of the caller.
class MutableColumnView {
 public:
  template <class T>
  MutableColumnView(T* first, std::size_t rows)
      : data_(first), rows_(rows), type_(element_type<T>()) {}

  void* data() const { return data_; }
  std::size_t rows() const { return rows_; }
  ElementType type() const { return type_; }

 private:
  void* data_;
  std::size_t rows_;
  ElementType type_;
};

/// A field with its own memory.
class Field {
 public:
  explicit Field(FieldSpec spec) : spec_(std::move(spec)) {
    if (spec_.type == ElementType::int64) values_.emplace<std::vector<std::int64_t>>();
    if (spec_.type == ElementType::int32) values_.emplace<std::vector<std::int32_t>>();
  }

  const FieldSpec& spec() const { return spec_; }
  std::size_t rows() const { return rows_; }

  /// Keeps capacity and the rows that stay.
  void resize(std::size_t rows) {
    rows_ = rows;
    std::visit([&](auto& values) { values.resize(rows * spec_.shape.components()); }, values_);
  }

  /// Component c of row i is values<T>()[i * components + c]. T must be the field's type.
  template <class T>
  std::vector<T>& values() {
    return std::get<std::vector<T>>(values_);
  }
  template <class T>
  const std::vector<T>& values() const {
    return std::get<std::vector<T>>(values_);
  }

  void* data() {
    return std::visit([](auto& values) -> void* { return values.data(); }, values_);
  }
  ColumnView view() const {
    return std::visit([&](const auto& values) { return ColumnView(values.data(), rows_); },
                      values_);
  }

 private:
  FieldSpec spec_;
  std::size_t rows_ = 0;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>> values_;
};

}  // namespace powderlink::bridge
