// SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_rows.h
/// Rows of particles sorted by destination, gathered into frames and scattered back; inner part of
/// the particle exchanges.
/// Tests: tests/coupling/bridge/mpi_test.cpp
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coupling/bridge/exchange/particle_exchange.h"
#include "coupling/bridge/frame/field.h"
#include "coupling/bridge/frame/frame.h"

namespace powderlink::bridge {

/// Some rows, ascending.
struct RowList {
  const std::size_t* first = nullptr;
  std::size_t count = 0;
};

/// Which rows go to which rank; rows with a negative destination go nowhere. O(rows + ranks).
class Routing {
 public:
  /// Throws mismatch when a destination is not below `ranks`.
  void build(const std::vector<int>& destination, int ranks);
  /// All rows that go anywhere, as one list for rank 0.
  void build_kept(const std::vector<int>& destination);

  RowList rows_for(int rank) const {
    const auto r = static_cast<std::size_t>(rank);
    return {index_.data() + first_[r], first_[r + 1] - first_[r]};
  }
  /// Rows that were given, and those of them that go anywhere.
  std::size_t rows() const { return rows_; }
  std::size_t kept() const { return index_.size(); }

 private:
  std::size_t rows_ = 0;
  std::vector<std::size_t> first_ = {0, 0};  ///< where the list of each rank starts in index_
  std::vector<std::size_t> index_;
};

void gather_rows(std::byte* to, const void* from, std::size_t row_bytes, RowList rows);
void scatter_rows(void* to, const std::byte* from, std::size_t row_bytes, RowList rows);

/// Throw bad_input when the columns are not those of the plan.
void check_columns(const std::vector<ColumnView>& columns, const std::vector<FieldSpec>& specs,
                   std::size_t rows);
void check_columns(const std::vector<MutableColumnView>& columns,
                   const std::vector<FieldSpec>& specs, std::size_t rows);
/// Throws bad_input for a field that cannot be sent.
void check_plan(const ExchangePlan& plan);

/// Throws peer_failed when the frame is the error of another rank, mismatch when its fields are not
/// those of the plan, in order and with `rows` rows each.
void check_fields(const FrameView& frame, const std::vector<FieldSpec>& specs, std::size_t rows,
                  const std::string& from);
/// Throws mismatch.
void check_step(std::int64_t given, std::int64_t expected, const std::string& from);

inline std::size_t rows_of(const FrameView& frame) {
  return frame.fields.empty() ? 0 : frame.fields.front().rows;
}

/// A whole frame with the listed rows of each column.
void encode_rows(Bytes& into, std::int64_t step, double time_s, const std::vector<FieldSpec>& specs,
                 const std::vector<ColumnView>& columns, RowList rows);
/// Copies all rows of the frame behind row `first` of the table.
void store_rows(const FrameView& frame, ParticleTable& table, std::size_t first);

}  // namespace powderlink::bridge
