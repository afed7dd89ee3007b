// SPDX-License-Identifier: GPL-3.0-or-later
/// \file sample_frames.h
/// Frames with random fields, the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "coupling/bridge/frame/frame.h"

namespace powderlink::test {

using Generator = std::mt19937_64;

inline std::size_t below(Generator& random, std::size_t end) { return random() % end; }

inline bridge::Field random_field(Generator& random, const std::string& name, std::size_t rows) {
  using bridge::ElementType;
  const bridge::Shape shapes[] = {bridge::scalar, bridge::vector3, bridge::tensor3x3, {2, 5}};
  const ElementType types[] = {ElementType::float64, ElementType::int64, ElementType::int32};
  const char* units[] = {"m", "m/s", "1", "kg/(m s^2)"};
  bridge::Field field(
      {name, units[below(random, 4)], shapes[below(random, 4)], types[below(random, 3)]});
  field.resize(rows);
  const std::size_t bytes = rows * field.spec().row_bytes();
  auto* to = static_cast<std::byte*>(field.data());
  for (std::size_t i = 0; i < bytes; ++i) to[i] = static_cast<std::byte>(random() & 0xff);
  return field;
}

inline std::vector<bridge::Field> random_fields(Generator& random, std::size_t most_rows) {
  std::vector<bridge::Field> fields;
  const std::size_t count = below(random, 6);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "field_" + std::to_string(i) + std::string(below(random, 20), 'x');
    fields.push_back(random_field(random, name, below(random, most_rows + 1)));
  }
  return fields;
}

inline void encode(bridge::Bytes& into, const std::vector<bridge::Field>& fields,
                   std::int64_t step = 7, double time_s = 0.125, const std::string& text = {},
                   bridge::MessageKind kind = bridge::MessageKind::fields) {
  bridge::FrameWriter writer(into);
  writer.begin(kind, step, time_s, text);
  for (const bridge::Field& field : fields) writer.add(field.spec(), field.view());
  writer.finish();
}

/// Two fields of different types: every part of the format is in it.
inline bridge::Bytes small_frame() {
  bridge::Field velocity({"velocity", "m/s", bridge::vector3, bridge::ElementType::float64});
  velocity.resize(2);
  velocity.values<double>() = {1.0, 2.0, 3.0, -4.0, -5.0, -6.0};
  bridge::Field type({"type", "1", bridge::scalar, bridge::ElementType::int32});
  type.resize(3);
  type.values<std::int32_t>() = {1, 2, 3};
  bridge::Bytes frame;
  encode(frame, {velocity, type}, 42, 1e-3, "note");
  return frame;
}

}  // namespace powderlink::test
