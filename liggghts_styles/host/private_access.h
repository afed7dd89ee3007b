// SPDX-License-Identifier: GPL-3.0-or-later
/// \file private_access.h
/// Reads a private data member of a class of LIGGGHTS.
///
/// The style tables are private, and LIGGGHTS has no call that adds to them. An explicit template
/// instantiation may name private members (C++17, [temp.explicit]/12), so it can hand out a pointer
/// to one: POWDERLINK_PRIVATE_MEMBER(Tag, Class, member, type) makes `object.*pointer_to(Tag())`
/// valid.
#pragma once

namespace powderlink::host {

template <class Tag, typename Tag::Pointer Member>
struct ExposeMember {
  friend typename Tag::Pointer pointer_to(Tag) { return Member; }
};

}  // namespace powderlink::host

/// To be used at global scope; TAG becomes powderlink::host::TAG.
#define POWDERLINK_PRIVATE_MEMBER(TAG, CLASS, MEMBER, ...) \
  namespace powderlink::host {                             \
  struct TAG {                                             \
    using Pointer = __VA_ARGS__ CLASS::*;                  \
    friend Pointer pointer_to(TAG);                        \
  };                                                       \
  template struct ExposeMember<TAG, &CLASS::MEMBER>;       \
  }
