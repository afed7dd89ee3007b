// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_contacts.h
/// Contacts of carrier and anvil, bounce by bounce, to the microsecond. A gap of at most merge_us is
/// chatter of the same contact, and is counted. Tests: tests/kat_firmware/parts_test.cpp
#ifndef KAT_CONTACTS_H
#define KAT_CONTACTS_H

#include <stdint.h>

namespace kat {

enum : uint8_t { kContactLimit = 12 };

struct Contact {
  uint32_t start_us;     ///< since release
  uint32_t duration_us;  ///< kNoValue while it is closed
  uint32_t chatter;      ///< gaps that were merged
};

class Contacts {
 public:
  Contacts() { clear(); }
  void clear();
  /// False for an edge that cannot be: closed while closed, open while open.
  bool edge(bool closed, uint32_t time_us, uint32_t merge_us);

  bool closed() const { return closed_; }
  uint32_t total() const { return total_; }        ///< all that began
  uint32_t finished() const { return finished_; }  ///< all that ended
  uint8_t kept() const { return kept_; }           ///< the first ones, kContactLimit at most
  const Contact& operator[](uint8_t i) const { return list_[i]; }
  void restore(uint8_t i, const Contact& contact) { list_[i] = contact; }
  void restore_counts(uint32_t total, uint32_t finished, uint8_t kept);

 private:
  Contact list_[kContactLimit];
  uint32_t total_, finished_;
  uint32_t opened_us_;
  uint8_t kept_;
  bool closed_;
};

}  // namespace kat

#endif
