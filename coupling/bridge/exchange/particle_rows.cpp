// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/exchange/particle_rows.h"

#include <cstring>

namespace powderlink::bridge {

namespace {

using Kind = BridgeError::Kind;

/// Ascending and without gaps, so that one copy does it.
bool contiguous(RowList rows) {
  return rows.count > 0 && rows.first[rows.count - 1] - rows.first[0] == rows.count - 1;
}

/// Copies of a size that the compiler knows are several times faster.
template <std::size_t Size>
void gather_fixed(std::byte* to, const std::byte* from, RowList rows) {
  for (std::size_t i = 0; i < rows.count; ++i) {
    std::memcpy(to + i * Size, from + rows.first[i] * Size, Size);
  }
}

template <std::size_t Size>
void scatter_fixed(std::byte* to, const std::byte* from, RowList rows) {
  for (std::size_t i = 0; i < rows.count; ++i) {
    std::memcpy(to + rows.first[i] * Size, from + i * Size, Size);
  }
}

template <class Column>
void check_any_columns(const std::vector<Column>& columns, const std::vector<FieldSpec>& specs,
                       std::size_t rows) {
  if (columns.size() != specs.size()) {
    throw BridgeError(Kind::bad_input, "particle exchange: columns", std::to_string(columns.size()),
                      std::to_string(specs.size()), "give one column per field of the plan");
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].type() != specs[i].type || columns[i].rows() != rows) {
      throw BridgeError(
          Kind::bad_input, "particle exchange: column of " + describe(specs[i]),
          std::to_string(columns[i].rows()) + " rows of " + name_of(columns[i].type()),
          std::to_string(rows) + " rows of " + name_of(specs[i].type),
          "keep number and order of particles between send and receive");
    }
  }
}

}  // namespace

void Routing::build(const std::vector<int>& destination, int ranks) {
  rows_ = destination.size();
  const auto lists = static_cast<std::size_t>(ranks);
  first_.assign(lists + 1, 0);
  for (const int rank : destination) {
    if (rank >= ranks) {
      throw BridgeError(Kind::mismatch, "particle exchange: solver rank of a particle",
                        std::to_string(rank),
                        "0 to " + std::to_string(ranks - 1) + ", or negative for none",
                        "see how the owner of a cell is found");
    }
    if (rank >= 0) ++first_[static_cast<std::size_t>(rank) + 1];
  }
  for (std::size_t r = 0; r < lists; ++r) first_[r + 1] += first_[r];
  index_.resize(first_[lists]);
  for (std::size_t i = 0; i < rows_; ++i) {
    if (destination[i] >= 0) index_[first_[static_cast<std::size_t>(destination[i])]++] = i;
  }
  // Filling moved each start to its end, which is the start of the next list.
  for (std::size_t r = lists; r > 0; --r) first_[r] = first_[r - 1];
  first_[0] = 0;
}

void Routing::build_kept(const std::vector<int>& destination) {
  rows_ = destination.size();
  index_.clear();
  for (std::size_t i = 0; i < rows_; ++i) {
    if (destination[i] >= 0) index_.push_back(i);
  }
  first_.resize(2);
  first_[0] = 0;
  first_[1] = index_.size();
}

void gather_rows(std::byte* to, const void* from, std::size_t row_bytes, RowList rows) {
  if (rows.count == 0) return;
  const auto* source = static_cast<const std::byte*>(from);
  if (contiguous(rows)) {
    std::memcpy(to, source + rows.first[0] * row_bytes, rows.count * row_bytes);
  } else if (row_bytes == 8) {
    gather_fixed<8>(to, source, rows);
  } else if (row_bytes == 24) {
    gather_fixed<24>(to, source, rows);
  } else if (row_bytes == 4) {
    gather_fixed<4>(to, source, rows);
  } else {
    for (std::size_t i = 0; i < rows.count; ++i) {
      std::memcpy(to + i * row_bytes, source + rows.first[i] * row_bytes, row_bytes);
    }
  }
}

void scatter_rows(void* to, const std::byte* from, std::size_t row_bytes, RowList rows) {
  if (rows.count == 0) return;
  auto* target = static_cast<std::byte*>(to);
  if (contiguous(rows)) {
    std::memcpy(target + rows.first[0] * row_bytes, from, rows.count * row_bytes);
  } else if (row_bytes == 8) {
    scatter_fixed<8>(target, from, rows);
  } else if (row_bytes == 24) {
    scatter_fixed<24>(target, from, rows);
  } else if (row_bytes == 4) {
    scatter_fixed<4>(target, from, rows);
  } else {
    for (std::size_t i = 0; i < rows.count; ++i) {
      std::memcpy(target + rows.first[i] * row_bytes, from + i * row_bytes, row_bytes);
    }
  }
}

void check_columns(const std::vector<ColumnView>& columns, const std::vector<FieldSpec>& specs,
                   std::size_t rows) {
  check_any_columns(columns, specs, rows);
}

void check_columns(const std::vector<MutableColumnView>& columns,
                   const std::vector<FieldSpec>& specs, std::size_t rows) {
  check_any_columns(columns, specs, rows);
}

void check_plan(const ExchangePlan& plan) {
  for (const auto* list : {&plan.to_solver, &plan.to_dem}) {
    if (list->empty()) {
      throw BridgeError(Kind::bad_input, "particle exchange: plan", "no field in one direction",
                        "one field or more each way", "add a field to the plan");
    }
    for (const FieldSpec& spec : *list) check(spec);
  }
}

void check_fields(const FrameView& frame, const std::vector<FieldSpec>& specs, std::size_t rows,
                  const std::string& from) {
  if (frame.kind == MessageKind::error) {
    throw BridgeError(Kind::peer_failed, std::string(frame.text));
  }
  if (frame.kind != MessageKind::fields || frame.fields.size() != specs.size()) {
    throw BridgeError(Kind::mismatch, "particle exchange with " + from,
                      std::to_string(frame.fields.size()) + " fields",
                      std::to_string(specs.size()) + " fields",
                      "give both programs the same list of fields");
  }
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const FieldSlice& field = frame.fields[i];
    if (!field.is(specs[i]) || field.rows != rows) {
      throw BridgeError(Kind::mismatch, "particle exchange with " + from,
                        std::to_string(field.rows) + " rows of " + describe(field.spec()),
                        std::to_string(rows) + " rows of " + describe(specs[i]),
                        "give both programs the same list of fields "
                        "and keep the particles between send and receive");
    }
  }
}

void check_step(std::int64_t given, std::int64_t expected, const std::string& from) {
  if (given == expected) return;
  throw BridgeError(Kind::mismatch, "particle exchange with " + from + ": step",
                    std::to_string(given), std::to_string(expected),
                    "see that both programs exchange after the same steps");
}

void encode_rows(Bytes& into, std::int64_t step, double time_s, const std::vector<FieldSpec>& specs,
                 const std::vector<ColumnView>& columns, RowList rows) {
  FrameWriter writer(into);
  writer.begin(MessageKind::fields, step, time_s);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    gather_rows(writer.add(specs[i], rows.count), columns[i].data(), specs[i].row_bytes(), rows);
  }
  writer.finish();
}

void store_rows(const FrameView& frame, ParticleTable& table, std::size_t first) {
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    const ByteSpan data = frame.fields[i].data;
    if (data.size == 0) continue;
    auto* to = static_cast<std::byte*>(table.fields[i].data());
    std::memcpy(to + first * table.fields[i].spec().row_bytes(), data.data, data.size);
  }
}

}  // namespace powderlink::bridge
