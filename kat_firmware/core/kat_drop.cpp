// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_drop.h"

#include "kat_text.h"

namespace kat {

namespace {

enum Kind : uint8_t { kHead, kGeometry, kBeam, kImpact, kContact, kEnd, kKinds };

const char* const kWords[kKinds] = {"drop", "geometry", "beam", "impact", "contact", "end"};

/// The numbers of the lines that hold nothing else; written and read from this one list.
struct Field {
  Kind kind;
  const char* key;
  uint32_t Drop::*value;
};

const Field kFields[] = {
    {kGeometry, "carrier_um", &Drop::carrier_um},
    {kGeometry, "beam_um", &Drop::beam_um},
    {kGeometry, "latency_us", &Drop::latency_us},
    {kBeam, "enter_us", &Drop::enter_us},
    {kBeam, "leave_us", &Drop::leave_us},
    {kImpact, "touch_us", &Drop::touch_us},
    {kImpact, "vibration_us", &Drop::vibration_us},
    {kImpact, "velocity_um_s", &Drop::velocity_um_s},
    {kImpact, "switches", &Drop::switches},
    {kImpact, "peak_mg", &Drop::peak_mg},
};

}  // namespace

LineWriter drop_line(const Drop& drop, uint8_t i) {
  const uint8_t end = static_cast<uint8_t>(drop.lines() - 1);
  const uint8_t kind = i == end ? uint8_t(kEnd) : i < kContact ? i : uint8_t(kContact);
  LineWriter line(kWords[kind]);
  line.number("n", drop.number);
  if (kind == kHead) {
    line.text("fault", code_name(drop.fault)).text("state", state_name(drop.state));
  } else if (kind == kContact) {
    const Contact& contact = drop.contacts[static_cast<uint8_t>(i - kContact)];
    line.number("i", static_cast<uint32_t>(i - kContact) + 1U)
        .number("start_us", contact.start_us)
        .number("duration_us", contact.duration_us)
        .number("chatter", contact.chatter);
  } else if (kind == kEnd) {
    line.number("contacts", drop.contacts.total())
        .number("finished", drop.contacts.finished())
        .number("lines", end);
  } else {
    for (const Field& field : kFields) {
      if (field.kind == kind) line.number(field.key, drop.*field.value);
    }
  }
  return line;
}

DropReader::Result DropReader::take(const Line& line) {
  uint8_t kind = 0;
  while (kind < kKinds && !same_text(kWords[kind], line.word())) ++kind;
  if (kind == kKinds) return Result::other;
  if (kind == kHead) {
    drop_ = Drop();
    next_ = contacts_ = 0;
  }
  const bool in_order = kind < kContact ? kind == next_ : next_ >= kContact;
  if (!in_order || !read(line, kind)) {
    next_ = 0;
    return Result::broken;
  }
  if (kind != kEnd) {
    ++next_;
    return Result::more;
  }
  next_ = 0;
  return Result::whole;
}

bool DropReader::read(const Line& line, uint8_t kind) {
  uint32_t number = 0;
  if (!line.number("n", number)) return false;
  if (kind == kHead) {
    drop_.number = number;
    return read_head(line);
  }
  if (number != drop_.number) return false;
  if (kind == kContact) return read_contact(line);
  if (kind == kEnd) return read_end(line);
  for (const Field& field : kFields) {
    if (field.kind == kind && !line.number(field.key, drop_.*field.value)) return false;
  }
  return true;
}

bool DropReader::read_head(const Line& line) {
  const char* fault = line.find("fault");
  const char* state = line.find("state");
  if (fault == nullptr || state == nullptr) return false;
  drop_.fault = find_code(fault);
  drop_.state = find_state(state);
  return drop_.fault != Code::count && drop_.state != State::count;
}

bool DropReader::read_contact(const Line& line) {
  uint32_t i = 0;
  Contact contact = {0, 0, 0};
  const bool whole = line.number("i", i) && line.number("start_us", contact.start_us) &&
                     line.number("duration_us", contact.duration_us) &&
                     line.number("chatter", contact.chatter);
  if (!whole || i != contacts_ + 1U || contacts_ == kContactLimit) return false;
  drop_.contacts.restore(contacts_++, contact);
  return true;
}

bool DropReader::read_end(const Line& line) {
  uint32_t total = 0, finished = 0, lines = 0;
  const bool whole = line.number("contacts", total) && line.number("finished", finished) &&
                     line.number("lines", lines);
  if (!whole || lines != next_) return false;
  if (total < contacts_ || finished > total) return false;
  drop_.contacts.restore_counts(total, finished, contacts_);
  return true;
}

}  // namespace kat
