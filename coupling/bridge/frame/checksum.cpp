// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/frame/checksum.h"

#define XXH_INLINE_ALL
// The AVX-512 intrinsics of GCC 12 warn about themselves; AVX2 is as fast on data from memory.
#if defined(__AVX2__)
#define XXH_VECTOR 2
#endif
#include <xxhash.h>

namespace powderlink::bridge {

std::uint64_t checksum(const std::byte* data, std::size_t bytes) {
  return XXH3_64bits(data, bytes);
}

}  // namespace powderlink::bridge
