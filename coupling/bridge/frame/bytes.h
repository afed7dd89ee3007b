// SPDX-License-Identifier: GPL-3.0-or-later
/// \file bytes.h
/// Byte buffers that grow without being filled with zeros, and a view on bytes.
#pragma once

#include <cstddef>

#include <boost/container/vector.hpp>

namespace powderlink::bridge {

using Bytes = boost::container::vector<std::byte>;

/// New bytes are not set; capacity is kept when the buffer shrinks.
inline void resize(Bytes& bytes, std::size_t size) {
  bytes.resize(size, boost::container::default_init);
}

struct ByteSpan {
  const std::byte* data = nullptr;
  std::size_t size = 0;

  ByteSpan() = default;
  ByteSpan(const std::byte* first, std::size_t count) : data(first), size(count) {}
  ByteSpan(const Bytes& bytes) : data(bytes.data()), size(bytes.size()) {}
};

}  // namespace powderlink::bridge
