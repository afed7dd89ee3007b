// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_contacts.h"

#include "kat_line.h"

namespace kat {

void Contacts::clear() {
  total_ = finished_ = opened_us_ = 0;
  kept_ = 0;
  closed_ = false;
}

bool Contacts::edge(bool closed, uint32_t time_us, uint32_t merge_us) {
  if (closed == closed_) return false;
  closed_ = closed;
  if (closed) {
    const bool same = total_ > 0 && time_us - opened_us_ <= merge_us;
    if (same) {
      --finished_;
      if (total_ == kept_) {
        ++list_[kept_ - 1].chatter;
        list_[kept_ - 1].duration_us = kNoValue;
      }
      return true;
    }
    ++total_;
    if (kept_ < kContactLimit) list_[kept_++] = {time_us, kNoValue, 0};
    return true;
  }
  ++finished_;
  opened_us_ = time_us;
  if (total_ == kept_) list_[kept_ - 1].duration_us = time_us - list_[kept_ - 1].start_us;
  return true;
}

void Contacts::restore_counts(uint32_t total, uint32_t finished, uint8_t kept) {
  total_ = total;
  finished_ = finished;
  kept_ = kept;
}

}  // namespace kat
