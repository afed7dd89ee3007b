// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/session.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

namespace powderlink::bridge {

namespace {

using nlohmann::json;
using Kind = BridgeError::Kind;

json to_json(const std::vector<FieldSpec>& fields) {
  json list = json::array();
  for (const FieldSpec& field : fields) {
    list.push_back({{"name", field.name},
                    {"unit", field.unit},
                    {"type", name_of(field.type)},
                    {"shape", {field.shape.rows, field.shape.columns}}});
  }
  return list;
}

ElementType type_from_name(const std::string& name) {
  for (const auto type : {ElementType::float64, ElementType::int64, ElementType::int32}) {
    if (name == name_of(type)) return type;
  }
  throw BridgeError(Kind::bad_frame, "hello: element type", "'" + name + "'",
                    "float64, int64, int32", "build both programs from the same release");
}

std::vector<FieldSpec> fields_from_json(const json& list) {
  std::vector<FieldSpec> fields;
  for (const json& entry : list) {
    FieldSpec field;
    field.name = entry.at("name").get<std::string>();
    field.unit = entry.at("unit").get<std::string>();
    field.type = type_from_name(entry.at("type").get<std::string>());
    field.shape = {entry.at("shape").at(0).get<std::uint32_t>(),
                   entry.at("shape").at(1).get<std::uint32_t>()};
    check(field);
    fields.push_back(field);
  }
  return fields;
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(9);
  text << value;
  return text.str();
}

const FieldSpec* find(const std::vector<FieldSpec>& fields, std::string_view name) {
  for (const FieldSpec& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::string list_of(const std::vector<FieldSpec>& fields) {
  std::string text;
  for (const FieldSpec& field : fields) text += (text.empty() ? "" : ", ") + describe(field);
  return text.empty() ? "none" : text;
}

BridgeError no_fit(const std::string& what, const std::string& given, const std::string& allowed,
                   const std::string& to_do) {
  return {Kind::mismatch, "coupling " + what, given, allowed, to_do};
}

void check_needs(const Hello& reader, const Hello& writer) {
  for (const FieldSpec& need : reader.needs) {
    const FieldSpec* offer = find(writer.offers, need.name);
    if (!offer) {
      throw no_fit("field " + need.name,
                   reader.role + " needs it, " + writer.role + " does not know it",
                   "fields of " + writer.role + ": " + list_of(writer.offers),
                   "correct the name in the input of " + reader.role + ", or switch the model " +
                       "that needs the field off");
    }
    if (!(*offer == need)) {
      throw no_fit("field " + need.name,
                   reader.role + " needs " + describe(need) + ", " + writer.role + " offers " +
                       describe(*offer),
                   "the same unit, type and shape on both sides",
                   "use the same units in both programs, and programs of the same release");
    }
  }
}

/// Both start at the same moment: a hundredth of an interval, as checkpoints are at exchanges only,
/// and what six digits of a time's text may lose.
void check_clock(const Hello& reader, const Hello& writer) {
  const Clock& mine = reader.clock;
  if (!mine.continues) return;
  const double interval_s = std::max(reader.exchange_interval_s, writer.exchange_interval_s);
  const double rounding_s = 1e-6 * std::max(std::abs(mine.time_s), std::abs(writer.clock.time_s));
  const double expected_s = mine.time_s - mine.ahead_s;
  if (std::abs(writer.clock.time_s - expected_s) <=
      std::min(0.01 * interval_s + rounding_s, 0.49 * interval_s)) {
    return;
  }
  throw no_fit("states at the start",
               reader.role + " goes on from its checkpoint of " + number(mine.time_s) + " s, " +
                   writer.role + " starts at " + number(writer.clock.time_s) + " s",
               writer.role + " at " + number(expected_s) + " s, as when that checkpoint was made",
               "start both from a pair of checkpoints: powderlink restart CASE --prepare; or " +
                   reader.role + " without its checkpoint, as a new coupled run");
}

void check_own(const Hello& hello) {
  const auto refuse = [](const std::string& what, const std::string& given,
                         const std::string& allowed) {
    throw BridgeError(Kind::bad_input, "hello: " + what, given, allowed,
                      "correct the options of the coupling");
  };
  constexpr std::size_t longest = 128;
  if (hello.role.empty() || hello.role.size() > longest) {
    refuse("role", "'" + hello.role + "'", "1 to 128 characters, e.g. dem");
  }
  if (hello.case_name.empty() || hello.case_name.size() > longest) {
    refuse("case name", "'" + hello.case_name + "'", "1 to 128 characters");
  }
  if (hello.ranks < 1) refuse("ranks", std::to_string(hello.ranks), "1 or more");
  if (!(hello.exchange_interval_s >= 0.0 && std::isfinite(hello.exchange_interval_s))) {
    refuse("exchange interval", number(hello.exchange_interval_s) + " s", "0 s or more");
  }
  if (!std::isfinite(hello.clock.time_s) || !std::isfinite(hello.clock.ahead_s)) {
    refuse("clock", number(hello.clock.time_s) + " s, " + number(hello.clock.ahead_s) + " s ahead",
           "finite times");
  }
  for (const auto* list : {&hello.offers, &hello.needs}) {
    for (const FieldSpec& field : *list) {
      check(field);
      if (std::count_if(list->begin(), list->end(),
                        [&](const FieldSpec& other) { return other.name == field.name; }) > 1) {
        refuse("field " + field.name, "twice", "every field once");
      }
    }
  }
}

/// A text of the other program, safe to print: nothing that could steer a terminal.
std::string printable(std::string_view text) {
  std::string safe(text.substr(0, 4096));
  for (char& c : safe) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  }
  return safe;
}

}  // namespace

std::string to_text(const Hello& hello) {
  const json text = {{"role", hello.role},
                     {"case", hello.case_name},
                     {"ranks", hello.ranks},
                     {"exchange_interval_s", hello.exchange_interval_s},
                     {"time_s", hello.clock.time_s},
                     {"continues", hello.clock.continues},
                     {"ahead_s", hello.clock.ahead_s},
                     {"offers", to_json(hello.offers)},
                     {"needs", to_json(hello.needs)}};
  return text.dump(-1, ' ', true, json::error_handler_t::replace);
}

Hello hello_from_text(std::string_view text) {
  try {
    const json parsed = json::parse(text);
    Hello hello;
    hello.role = parsed.at("role").get<std::string>();
    hello.case_name = parsed.at("case").get<std::string>();
    hello.ranks = parsed.at("ranks").get<int>();
    hello.exchange_interval_s = parsed.at("exchange_interval_s").get<double>();
    hello.clock.time_s = parsed.at("time_s").get<double>();
    hello.clock.continues = parsed.at("continues").get<bool>();
    hello.clock.ahead_s = parsed.at("ahead_s").get<double>();
    hello.offers = fields_from_json(parsed.at("offers"));
    hello.needs = fields_from_json(parsed.at("needs"));
    check_own(hello);
    return hello;
  } catch (const json::exception& e) {
    throw BridgeError(
        Kind::bad_frame, "hello of the other program", e.what(),
        "role, case, ranks, exchange_interval_s, time_s, continues, ahead_s, offers, needs",
        "build both programs from the same release of powderlink");
  } catch (const BridgeError& e) {
    throw BridgeError(Kind::bad_frame, std::string("hello of the other program: ") + e.what());
  }
}

void check_fit(const Hello& one, const Hello& other) {
  if (one.role == other.role) {
    throw no_fit("roles", "both programs are '" + one.role + "'", "one of each",
                 "start one DEM and one solver");
  }
  const bool in_order = one.role < other.role;
  const Hello& a = in_order ? one : other;
  const Hello& b = in_order ? other : one;
  if (a.case_name != b.case_name) {
    throw no_fit("case name",
                 a.role + " runs '" + a.case_name + "', " + b.role + " runs '" + b.case_name + "'",
                 "the same name on both sides",
                 "start both programs in the same case, or correct the name in one of the inputs");
  }
  const double longer = std::max(a.exchange_interval_s, b.exchange_interval_s);
  if (a.exchange_interval_s > 0.0 && b.exchange_interval_s > 0.0 &&
      std::abs(a.exchange_interval_s - b.exchange_interval_s) > 1e-9 * longer) {
    throw no_fit("interval between exchanges",
                 a.role + ": " + number(a.exchange_interval_s) + " s, " + b.role + ": " +
                     number(b.exchange_interval_s) + " s",
                 "the same interval on both sides",
                 "make time step times steps between exchanges equal in both inputs");
  }
  check_needs(a, b);
  check_needs(b, a);
  check_clock(a, b);
  check_clock(b, a);
}

Session::Session(std::unique_ptr<Transport> transport, Hello mine, double timeout_s)
    : transport_(std::move(transport)), mine_(std::move(mine)), timeout_s_(timeout_s) {
  const Deadline deadline(timeout_s_);
  check_own(mine_);
  encode_text(outgoing_, MessageKind::hello, to_text(mine_));
  try {
    transport_->send(outgoing_, deadline);
    const FrameView& answer = receive_any(deadline);
    if (answer.kind != MessageKind::hello) {
      throw BridgeError(Kind::bad_frame, "handshake with " + transport_->peer(),
                        "a message that is not a hello", "a hello first",
                        "start both programs again; one of them is in the middle of a run");
    }
    peer_ = hello_from_text(answer.text);
    check_fit(mine_, peer_);
  } catch (const BridgeError&) {
    transport_->close();
    throw;
  }
}

Session::~Session() {
  if (open_) fail(mine_.role + " ended without saying goodbye");
}

std::string Session::peer_name() const {
  return (peer_.role.empty() ? "the other program" : peer_.role) + " (" + transport_->peer() + ")";
}

void Session::throw_peer_error(const FrameView& frame) const {
  throw BridgeError(Kind::peer_failed, "run of " + peer_name(),
                    "its error: " + printable(frame.text), "two programs that run",
                    "cure the error of the other program, then start both");
}

const FrameView& Session::receive_any(const Deadline& deadline) {
  try {
    transport_->receive(incoming_, deadline);
    decode(incoming_, view_);
  } catch (const BridgeError& e) {
    fail(e.what());
    throw;
  }
  if (view_.kind == MessageKind::error) {
    peer_failed_ = true;
    throw_peer_error(view_);
  }
  return view_;
}

void Session::send_checked(Bytes& frame) {
  try {
    transport_->send(frame, Deadline(timeout_s_));
  } catch (const BridgeError& e) {
    if (e.kind() != Kind::peer_lost) throw;
    // The last words of the other side say more than the broken line.
    try {
      while (true) receive_any(Deadline(0.0));
    } catch (const BridgeError& last_words) {
      if (last_words.kind() == Kind::peer_failed) throw;
    }
    throw;
  }
}

void Session::send_frame(Bytes& frame) { send_checked(frame); }

const FrameView& Session::receive_frame() {
  const FrameView& frame = receive_any(Deadline(timeout_s_));
  if (frame.kind == MessageKind::bye) {
    peer_finished_ = true;
    throw lost(peer_name(), "it finished its run");
  }
  if (frame.kind != MessageKind::fields) {
    throw BridgeError(Kind::bad_frame, "message from " + peer_name(), "not fields", "fields",
                      "build both programs from the same release of powderlink");
  }
  return frame;
}

void Session::finish() {
  if (!open_) return;
  encode_text(outgoing_, MessageKind::bye, {});
  send_checked(outgoing_);
  const Deadline deadline(timeout_s_);
  // What the other side sent before it saw this goodbye is of no use to anyone now.
  while (!peer_finished_ && receive_any(deadline).kind != MessageKind::bye) {
  }
  open_ = false;
  transport_->close();
}

void Session::fail(const std::string& why) noexcept {
  if (!open_) return;
  open_ = false;
  if (peer_failed_) {  // it waits for nothing but this
    transport_->close();
    return;
  }
  try {
    constexpr double patience_s = 0.5;
    encode_text(outgoing_, MessageKind::error, why);
    transport_->send(outgoing_, Deadline(patience_s));
    transport_->close_after_error();
  } catch (const std::exception&) {  // the other side is gone: nobody is left to be told
    transport_->close();
  }
}

}  // namespace powderlink::bridge
