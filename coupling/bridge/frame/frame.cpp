// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/frame/frame.h"

#include <cmath>
#include <type_traits>

#include "coupling/bridge/frame/checksum.h"

namespace powderlink::bridge {

namespace {

constexpr char magic[8] = {'P', 'W', 'D', 'R', 'L', 'I', 'N', 'K'};
constexpr std::uint32_t own_byte_order = 0x01020304;
constexpr std::uint32_t other_byte_order = 0x04030201;
constexpr std::size_t field_header_bytes = 32;

enum HeaderOffset : std::size_t {
  at_byte_order = 8,
  at_version = 12,
  at_kind = 14,
  at_frame_bytes = 16,
  at_step = 24,
  at_time = 32,
  at_fields = 40,
  at_text_bytes = 44,
  at_payload_checksum = 48,
  at_header_checksum = 56
};

template <class T>
void put(std::byte* at, T value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(at, &value, sizeof value);
}

template <class T>
T get(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 7) / 8 * 8; }

const char* text_of(const std::byte* at) { return reinterpret_cast<const char*>(at); }

BridgeError bad_frame(const std::string& what, const std::string& given,
                      const std::string& allowed) {
  return {BridgeError::Kind::bad_frame, "frame: " + what, given, allowed,
          "the bytes were damaged on the way or are not from powderlink: "
          "see that both programs are whole and nothing else uses this address, "
          "then start both again"};
}

bool name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == ':' || c == '-';
}

bool valid_name(std::string_view name) {
  for (const char c : name) {
    if (!name_character(c)) return false;
  }
  return !name.empty();
}

bool valid_unit(std::string_view unit) {
  for (const char c : unit) {
    if (c < ' ' || c > '~') return false;
  }
  return !unit.empty();
}

bool valid_type(std::uint8_t type) {
  return type >= static_cast<std::uint8_t>(ElementType::float64) &&
         type <= static_cast<std::uint8_t>(ElementType::int32);
}

bool valid_kind(std::uint16_t kind) {
  return kind >= static_cast<std::uint16_t>(MessageKind::greeting) &&
         kind <= static_cast<std::uint16_t>(MessageKind::error);
}

std::string up_to(std::uint64_t most, const char* of) {
  return "at most " + std::to_string(most) + " " + of;
}

/// Reads one field at `offset` and moves behind it.
FieldSlice read_field(ByteSpan frame, std::size_t& offset, const FrameLimits& limits) {
  const auto left = [&] { return frame.size - offset; };
  if (left() < field_header_bytes) {
    throw bad_frame("header of a field", std::to_string(left()) + " bytes left",
                    std::to_string(field_header_bytes) + " bytes");
  }
  const std::byte* at = frame.data + offset;
  const auto name_bytes = get<std::uint16_t>(at);
  const auto unit_bytes = get<std::uint16_t>(at + 2);
  const auto type = get<std::uint8_t>(at + 4);
  FieldSlice field;
  field.shape = {get<std::uint32_t>(at + 8), get<std::uint32_t>(at + 12)};
  const auto rows = get<std::uint64_t>(at + 16);
  const auto data_bytes = get<std::uint64_t>(at + 24);
  if (name_bytes > limits.name_bytes || unit_bytes > limits.unit_bytes) {
    throw bad_frame("bytes of a field's name and unit",
                    std::to_string(name_bytes) + " and " + std::to_string(unit_bytes),
                    up_to(limits.name_bytes, "and ") + std::to_string(limits.unit_bytes));
  }
  if (!valid_type(type)) {
    throw bad_frame("element type", std::to_string(type), "1 float64, 2 int64, 3 int32");
  }
  for (std::size_t i = 5; i < 8; ++i) {
    if (at[i] != std::byte{0}) {
      throw bad_frame("reserved byte", std::to_string(get<std::uint8_t>(at + i)), "0");
    }
  }
  field.type = static_cast<ElementType>(type);
  for (const std::uint32_t extent : {field.shape.rows, field.shape.columns}) {
    if (extent < 1 || extent > limits.shape_extent) {
      throw bad_frame("shape", std::to_string(extent),
                      "1 to " + std::to_string(limits.shape_extent) + " in each direction");
    }
  }
  offset += field_header_bytes;
  const std::uint64_t names = padded(std::uint64_t{name_bytes} + unit_bytes);
  if (left() < names) {
    throw bad_frame("name and unit of a field", std::to_string(left()) + " bytes left",
                    std::to_string(names) + " bytes");
  }
  field.name = {text_of(frame.data + offset), name_bytes};
  field.unit = {text_of(frame.data + offset) + name_bytes, unit_bytes};
  if (!valid_name(field.name) || !valid_unit(field.unit)) {
    throw bad_frame("name or unit of a field", "characters that are not allowed",
                    "letters, digits and _ . : - (unit: any printable), not empty");
  }
  offset += static_cast<std::size_t>(names);
  const std::uint64_t row_bytes = field.shape.components() * bytes_of(field.type);
  // Divided, not multiplied: a product of hostile numbers may overflow.
  if (rows > left() / row_bytes || data_bytes != rows * row_bytes || padded(data_bytes) > left()) {
    throw bad_frame("rows of field " + std::string(field.name),
                    std::to_string(rows) + " rows, " + std::to_string(data_bytes) + " bytes",
                    "rows of " + std::to_string(row_bytes) + " bytes, " + std::to_string(left()) +
                        " bytes left");
  }
  field.rows = static_cast<std::size_t>(rows);
  field.data = {frame.data + offset, static_cast<std::size_t>(data_bytes)};
  offset += static_cast<std::size_t>(padded(data_bytes));
  return field;
}

std::byte* grow(Bytes& buffer, std::uint64_t bytes, const FrameLimits& limits) {
  const std::size_t before = buffer.size();
  const std::uint64_t room = padded(bytes);
  if (room > limits.frame_bytes || before > limits.frame_bytes - room) {
    throw BridgeError(BridgeError::Kind::bad_input, "writing a frame: size",
                      std::to_string(before) + " + " + std::to_string(room) + " bytes",
                      up_to(limits.frame_bytes, "bytes"),
                      "use more ranks, so that each one sends less");
  }
  resize(buffer, before + static_cast<std::size_t>(room));
  std::byte* at = buffer.data() + before;
  for (std::uint64_t i = bytes; i < room; ++i) at[i] = std::byte{0};
  return at;
}

}  // namespace

void check(const FieldSpec& spec, const FrameLimits& limits) {
  const auto refuse = [&](const std::string& what, const std::string& given,
                          const std::string& allowed) {
    throw BridgeError(BridgeError::Kind::bad_input, "field '" + spec.name + "': " + what, given,
                      allowed, "mend the list of exchanged fields");
  };
  if (!valid_name(spec.name) || spec.name.size() > limits.name_bytes) {
    refuse("name", "'" + spec.name + "'",
           "1 to " + std::to_string(limits.name_bytes) + " letters, digits and _ . : -");
  }
  if (!valid_unit(spec.unit) || spec.unit.size() > limits.unit_bytes) {
    refuse("unit", "'" + spec.unit + "'",
           "1 to " + std::to_string(limits.unit_bytes) +
               " printable characters, e.g. m/s, or 1 for none");
  }
  for (const std::uint32_t extent : {spec.shape.rows, spec.shape.columns}) {
    if (extent < 1 || extent > limits.shape_extent) {
      refuse("shape", std::to_string(extent), "1 to " + std::to_string(limits.shape_extent));
    }
  }
  if (!valid_type(static_cast<std::uint8_t>(spec.type))) {
    refuse("element type", std::to_string(static_cast<int>(spec.type)), "float64, int64, int32");
  }
}

void FrameWriter::begin(MessageKind kind, std::int64_t step, double time_s, std::string_view text) {
  if (!std::isfinite(time_s)) {
    throw BridgeError(BridgeError::Kind::bad_input, "writing a frame: time", "not a finite number",
                      "seconds since the start", "see why the time went wrong");
  }
  text = text.substr(0, limits_.text_bytes);
  fields_ = 0;
  resize(buffer_, header_bytes);
  std::byte* at = buffer_.data();
  std::memcpy(at, magic, sizeof magic);
  put(at + at_byte_order, own_byte_order);
  put(at + at_version, protocol_version);
  put(at + at_kind, static_cast<std::uint16_t>(kind));
  put(at + at_step, step);
  put(at + at_time, time_s);
  put(at + at_text_bytes, static_cast<std::uint32_t>(text.size()));
  std::byte* room = grow(buffer_, text.size(), limits_);
  if (!text.empty()) std::memcpy(room, text.data(), text.size());
}

std::byte* FrameWriter::add(const FieldSpec& spec, std::size_t rows) {
  check(spec, limits_);
  if (fields_ == limits_.fields || rows > limits_.frame_bytes / spec.row_bytes()) {
    throw BridgeError(
        BridgeError::Kind::bad_input, "writing a frame: field " + spec.name,
        std::to_string(rows) + " rows as field " + std::to_string(fields_ + 1),
        up_to(limits_.fields, "fields and ") + std::to_string(limits_.frame_bytes) + " bytes",
        "use more ranks, so that each one sends less");
  }
  ++fields_;
  const std::uint64_t data_bytes = std::uint64_t{rows} * spec.row_bytes();
  std::byte* at = grow(buffer_, field_header_bytes + spec.name.size() + spec.unit.size(), limits_);
  put(at, static_cast<std::uint16_t>(spec.name.size()));
  put(at + 2, static_cast<std::uint16_t>(spec.unit.size()));
  put(at + 4, static_cast<std::uint32_t>(0));
  put(at + 4, static_cast<std::uint8_t>(spec.type));
  put(at + 8, spec.shape.rows);
  put(at + 12, spec.shape.columns);
  put(at + 16, std::uint64_t{rows});
  put(at + 24, data_bytes);
  std::memcpy(at + field_header_bytes, spec.name.data(), spec.name.size());
  std::memcpy(at + field_header_bytes + spec.name.size(), spec.unit.data(), spec.unit.size());
  return grow(buffer_, data_bytes, limits_);
}

void FrameWriter::add(const FieldSpec& spec, const ColumnView& column) {
  if (column.type() != spec.type) {
    throw BridgeError(BridgeError::Kind::bad_input, "field '" + spec.name + "': element type",
                      name_of(column.type()), name_of(spec.type),
                      "give the column in the type of the field");
  }
  std::byte* room = add(spec, column.rows());
  if (column.rows() > 0) std::memcpy(room, column.data(), column.rows() * spec.row_bytes());
}

void FrameWriter::finish() {
  std::byte* at = buffer_.data();
  put(at + at_frame_bytes, std::uint64_t{buffer_.size()});
  put(at + at_fields, fields_);
  put(at + at_payload_checksum, checksum(at + header_bytes, buffer_.size() - header_bytes));
  put(at + at_header_checksum, checksum(at, at_header_checksum));
}

const FieldSlice* FrameView::find(std::string_view name) const {
  for (const FieldSlice& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::uint64_t frame_bytes(ByteSpan header, const FrameLimits& limits) {
  if (header.size < header_bytes) {
    throw bad_frame("header", std::to_string(header.size) + " bytes",
                    std::to_string(header_bytes) + " bytes");
  }
  const std::byte* at = header.data;
  if (std::memcmp(at, magic, sizeof magic) != 0) {
    throw bad_frame("magic", "other bytes", "PWDRLINK");
  }
  const auto byte_order = get<std::uint32_t>(at + at_byte_order);
  if (byte_order != own_byte_order) {
    throw bad_frame(
        "byte order",
        byte_order == other_byte_order ? "that of another kind of processor" : "neither order",
        "that of this processor");
  }
  const auto version = get<std::uint16_t>(at + at_version);
  if (version != protocol_version) {
    throw BridgeError(BridgeError::Kind::wrong_version, "frame: protocol version",
                      std::to_string(version), std::to_string(protocol_version),
                      "build both programs from the same release of powderlink");
  }
  if (get<std::uint64_t>(at + at_header_checksum) != checksum(at, at_header_checksum)) {
    throw bad_frame("checksum of the header", "another one", "that of the header's bytes");
  }
  const auto kind = get<std::uint16_t>(at + at_kind);
  if (!valid_kind(kind)) throw bad_frame("message kind", std::to_string(kind), "1 to 6");
  if (!std::isfinite(get<double>(at + at_time))) {
    throw bad_frame("time", "not a finite number", "seconds since the start");
  }
  const auto fields = get<std::uint32_t>(at + at_fields);
  if (fields > limits.fields) {
    throw bad_frame("number of fields", std::to_string(fields), up_to(limits.fields, "fields"));
  }
  const auto text_bytes = get<std::uint32_t>(at + at_text_bytes);
  if (text_bytes > limits.text_bytes) {
    throw bad_frame("text", std::to_string(text_bytes) + " bytes",
                    up_to(limits.text_bytes, "bytes"));
  }
  const auto bytes = get<std::uint64_t>(at + at_frame_bytes);
  const std::uint64_t least =
      header_bytes + padded(text_bytes) + std::uint64_t{fields} * field_header_bytes;
  if (bytes < least || bytes > limits.frame_bytes) {
    throw bad_frame("size", std::to_string(bytes) + " bytes",
                    std::to_string(least) + " to " + std::to_string(limits.frame_bytes) + " bytes");
  }
  return bytes;
}

void decode(ByteSpan frame, FrameView& view, const FrameLimits& limits) {
  const std::uint64_t bytes = frame_bytes(frame, limits);
  if (bytes != frame.size) {
    throw bad_frame("size", std::to_string(frame.size) + " bytes",
                    std::to_string(bytes) + " bytes, as its header says");
  }
  const std::byte* at = frame.data;
  if (get<std::uint64_t>(at + at_payload_checksum) !=
      checksum(at + header_bytes, frame.size - header_bytes)) {
    throw bad_frame("checksum", "another one", "that of the frame's bytes");
  }
  view.kind = static_cast<MessageKind>(get<std::uint16_t>(at + at_kind));
  view.step = get<std::int64_t>(at + at_step);
  view.time_s = get<double>(at + at_time);
  const auto text_bytes = get<std::uint32_t>(at + at_text_bytes);
  view.text = {text_of(at + header_bytes), text_bytes};
  view.fields.clear();
  std::size_t offset = header_bytes + static_cast<std::size_t>(padded(text_bytes));
  for (auto fields = get<std::uint32_t>(at + at_fields); fields > 0; --fields) {
    const FieldSlice field = read_field(frame, offset, limits);
    if (view.find(field.name)) {
      throw bad_frame("field " + std::string(field.name), "twice", "every field once");
    }
    view.fields.push_back(field);
  }
  if (offset != frame.size) {
    throw bad_frame("end", std::to_string(frame.size - offset) + " bytes after the last field",
                    "nothing");
  }
}

void encode_text(Bytes& buffer, MessageKind kind, std::string_view text) {
  FrameWriter writer(buffer);
  writer.begin(kind, 0, 0.0, text);
  writer.finish();
}

}  // namespace powderlink::bridge
