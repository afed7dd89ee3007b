// SPDX-License-Identifier: GPL-3.0-or-later
/// \file frame.h
/// The only thing that goes from one program to the other: a frame of typed fields.
///
/// A frame is a header of 64 bytes, a text, and fields; each part is filled up to 8 bytes with zeros:
///   0 magic "PWDRLINK" | 8 uint32 0x01020304 | 12 uint16 version | 14 uint16 kind
///   16 uint64 bytes of the frame | 24 int64 step | 32 float64 time [s]
///   40 uint32 number of fields | 44 uint32 bytes of the text
///   48 uint64 XXH3 of all after the header | 56 uint64 XXH3 of the header's first 56 bytes
///   text, fields
/// and a field is 32 bytes, its name, its unit, its rows:
///   0 uint16 bytes of the name | 2 uint16 bytes of the unit | 4 uint8 type | 5 three zeros
///   8 uint32 shape rows | 12 uint32 shape columns | 16 uint64 rows | 24 uint64 bytes of the data
/// Numbers are in the sender's byte order; a reader with another order refuses the frame.
///
/// Decoding never trusts a number of the frame: any sequence of bytes gives either a FrameView that
/// lies within them or a BridgeError (bad_frame or wrong_version). Cost: one pass for the checksum.
/// Tests: tests/coupling/bridge/frame_test.cpp, tests/coupling/bridge/frame_fuzz_test.cpp
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/bridge/bridge_error.h"
#include "coupling/bridge/frame/bytes.h"
#include "coupling/bridge/frame/field.h"

namespace powderlink::bridge {

inline constexpr std::uint16_t protocol_version = 1;
inline constexpr std::size_t header_bytes = 64;

enum class MessageKind : std::uint16_t {
  greeting = 1,  ///< client to server on a socket; the text is the token
  accepted = 2,  ///< answer of the server
  hello = 3,     ///< start of a session; the text is JSON, see session.h
  fields = 4,    ///< one exchange
  bye = 5,       ///< orderly end
  error = 6      ///< the sender stops; the text is its message
};

/// What a reader accepts. Larger frames are refused before memory is taken for them.
struct FrameLimits {
  std::uint64_t frame_bytes = std::uint64_t{1} << 30;
  std::uint32_t text_bytes = std::uint32_t{1} << 20;
  std::uint32_t fields = 256;
  std::uint16_t name_bytes = 64;
  std::uint16_t unit_bytes = 32;
  std::uint32_t shape_extent = 64;
};

/// Throws bad_input when the name, unit or shape cannot be sent.
void check(const FieldSpec& spec, const FrameLimits& limits = {});

/// Writes a frame into a buffer, whose capacity is reused from frame to frame.
///   FrameWriter writer(buffer); writer.begin(...); writer.add(...); writer.finish();
class FrameWriter {
 public:
  explicit FrameWriter(Bytes& buffer, const FrameLimits& limits = {})
      : buffer_(buffer), limits_(limits) {}

  void begin(MessageKind kind, std::int64_t step, double time_s, std::string_view text = {});
  /// Copies the rows of a column. Throws bad_input when its type is not that of the spec.
  void add(const FieldSpec& spec, const ColumnView& column);
  /// Room for rows * spec.row_bytes() bytes, to be filled before the next call.
  std::byte* add(const FieldSpec& spec, std::size_t rows);
  /// Sets sizes and checksums; the buffer then holds the frame.
  void finish();

 private:
  Bytes& buffer_;
  FrameLimits limits_;
  std::uint32_t fields_ = 0;
};

/// A field inside a decoded frame; valid as long as the frame's bytes.
struct FieldSlice {
  std::string_view name;
  std::string_view unit;
  Shape shape;
  ElementType type = ElementType::float64;
  std::size_t rows = 0;
  ByteSpan data;

  bool is(const FieldSpec& spec) const {
    return name == spec.name && unit == spec.unit && shape == spec.shape && type == spec.type;
  }
  FieldSpec spec() const { return {std::string(name), std::string(unit), shape, type}; }

  /// Throws mismatch when T is not the field's type.
  template <class T>
  std::vector<T> values() const {
    if (element_type<T>() != type) {
      throw BridgeError(BridgeError::Kind::mismatch, "reading field " + std::string(name),
                        name_of(element_type<T>()), name_of(type), "read it as the type it has");
    }
    std::vector<T> copy(rows * shape.components());
    if (!copy.empty()) std::memcpy(copy.data(), data.data, data.size);
    return copy;
  }
};

struct FrameView {
  MessageKind kind = MessageKind::fields;
  std::int64_t step = 0;
  double time_s = 0.0;
  std::string_view text;
  std::vector<FieldSlice> fields;

  /// The field of that name, or null.
  const FieldSlice* find(std::string_view name) const;
};

/// Bytes of the whole frame, from its header: what a stream must read. Checks all the header.
std::uint64_t frame_bytes(ByteSpan header, const FrameLimits& limits = {});

/// Checks the whole frame; `view` is reused. After an exception the view is unspecified.
void decode(ByteSpan frame, FrameView& view, const FrameLimits& limits = {});

/// A frame without fields.
void encode_text(Bytes& buffer, MessageKind kind, std::string_view text);

}  // namespace powderlink::bridge
