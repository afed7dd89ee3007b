// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/files/sha1.h"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace powderlink {

std::string sha1(const std::string& text) {
  boost::uuids::detail::sha1 hash;
  hash.process_bytes(text.data(), text.size());
  boost::uuids::detail::sha1::digest_type digest;
  hash.get_digest(digest);
  return fmt::format("{:08x}{:08x}{:08x}{:08x}{:08x}", digest[0], digest[1], digest[2], digest[3],
                     digest[4]);
}

}  // namespace powderlink
