// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/link/coupling_link.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "coupling/bridge/transport/mpi_transport.h"

namespace powderlink::bridge {

// Not anonymous: members of DemLink and SolverLink have types from here.
namespace link_parts {

using Kind = BridgeError::Kind;

const FieldSpec state_word{"dem_state", "1", scalar, ElementType::int32};
const FieldSpec command_word{"solver_command", "1", scalar, ElementType::int32};
const FieldSpec checkpoint_word{"solver_checkpoint", "1", scalar, ElementType::int32};
const FieldSpec next_word{"solver_checkpoint_next", "1", scalar, ElementType::int32};

const FieldSpec map_origin{"rank_map_origin", "m", vector3};
const FieldSpec map_spacing{"rank_map_spacing", "m", vector3};
const FieldSpec map_voxels{"rank_map_voxels", "1", vector3, ElementType::int32};
const FieldSpec map_rank{"rank_map_rank", "1", scalar, ElementType::int32};

enum class DemState : std::int32_t { going_on = 0, finished = 1 };

/// Collective: the bytes of rank 0 to all ranks.
void share_bytes(MPI_Comm local, void* data, std::size_t bytes, double timeout_s) {
  if (bytes == 0) return;
  // On the heap: after a timeout MPI may still write into it.
  auto* copy =
      new std::vector<char>(static_cast<const char*>(data), static_cast<const char*>(data) + bytes);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(copy->data(), static_cast<int>(bytes), MPI_BYTE, 0, local, &request);
  wait_for(request, Deadline(1.1 * timeout_s + 1.0), "rank 0 of this program");
  std::memcpy(data, copy->data(), bytes);
  delete copy;
}

void share_text(MPI_Comm local, std::string& text, double timeout_s) {
  std::uint64_t size = text.size();
  share_bytes(local, &size, sizeof size, timeout_s);
  text.resize(size);
  share_bytes(local, text.data(), text.size(), timeout_s);
}

/// A field of a control message; throws bad_frame when it is not there as expected.
template <class T>
std::vector<T> values_of(const FrameView& frame, const FieldSpec& spec) {
  const FieldSlice* field = frame.find(spec.name);
  if (!field || !field->is(spec)) {
    throw BridgeError(Kind::bad_frame, "message of the other program", "no " + describe(spec),
                      "the order of messages of coupling_link.h",
                      "build both programs from the same release of powderlink");
  }
  return field->values<T>();
}

template <class T>
T word_of(const FrameView& frame, const FieldSpec& spec) {
  const std::vector<T> values = values_of<T>(frame, spec);
  return values.size() == 1 ? values.front() : T{-1};
}

void check_map(const RankMap& map, int solver_ranks) {
  const auto refuse = [](const std::string& what, const std::string& given,
                         const std::string& allowed) {
    throw BridgeError(Kind::mismatch, "rank map of the solver: " + what, given, allowed,
                      "check that the solver's mesh has a finite, three-dimensional bounding box");
  };
  std::size_t voxels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (map.voxels[axis] < 1) refuse("voxels", std::to_string(map.voxels[axis]), "1 or more");
    if (!std::isfinite(map.origin_m[axis]) || !std::isfinite(map.spacing_m[axis]) ||
        !(map.spacing_m[axis] > 0.0)) {
      refuse("spacing", std::to_string(map.spacing_m[axis]) + " m", "above 0 m, finite");
    }
    voxels *= static_cast<std::size_t>(map.voxels[axis]);
  }
  if (map.rank.size() != voxels) {
    refuse("entries", std::to_string(map.rank.size()), std::to_string(voxels));
  }
  for (const std::int32_t rank : map.rank) {
    if (rank < -1 || rank >= solver_ranks) {
      refuse("rank", std::to_string(rank), "-1 to " + std::to_string(solver_ranks - 1));
    }
  }
}

class Line;
/// Of this process, for say_last_words(), which may be called at its very end.
std::vector<Line*>& lines() {
  static auto* all = new std::vector<Line*>;
  return *all;
}

/// What both sides of a link have in common.
class Line {
 public:
  Line(MPI_Comm local, const LinkOptions& options, Hello hello)
      : local_(local), options_(options), hello_(std::move(hello)) {
    MPI_Comm_rank(local_, &rank_);
    on_first_rank(local_, timeout_s(),
                  [&] { session_ = std::make_unique<Session>(open(), hello_, timeout_s()); });
    std::string text = session_ ? to_text(session_->peer()) : std::string();
    share_text(local_, text, timeout_s());
    peer_ = hello_from_text(text);
    lines().push_back(this);
  }
  ~Line() { lines().erase(std::remove(lines().begin(), lines().end(), this), lines().end()); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  double timeout_s() const { return options_.timeout_s; }
  bool over_mpi() const { return options_.route == LinkOptions::Route::mpi; }
  const MpiWorld& world() const { return options_.world; }
  MPI_Comm local() const { return local_; }
  Session* session() { return session_.get(); }
  const Hello& mine() const { return hello_; }
  const Hello& peer() const { return peer_; }
  bool open_still() const { return open_; }

  /// Collective: rank 0 acts; its error goes to the other program and is thrown on every rank.
  template <class Action>
  void first_rank(Action&& action) {
    require_open();
    try {
      on_first_rank(local_, timeout_s(), std::forward<Action>(action));
    } catch (const BridgeError& e) {
      fail(e.what());
      throw;
    }
  }

  /// Collective: all ranks act; the error of any is thrown on every rank.
  template <class Action>
  void all_ranks(Action&& action) {
    require_open();
    std::optional<BridgeError> mine;
    try {
      action();
    } catch (const BridgeError& e) {
      mine = e;
    }
    try {
      agree(mine);
    } catch (const BridgeError& e) {
      fail(e.what());
      throw;
    }
  }

  template <class Value>
  void share(Value& value) {
    share_bytes(local_, &value, sizeof value, timeout_s());
  }
  void share(std::string& text) { share_text(local_, text, timeout_s()); }

  /// Rank 0: sends words as a frame of their own.
  void say(const std::vector<std::pair<FieldSpec, std::int32_t>>& words) {
    FrameWriter writer(outgoing_);
    writer.begin(MessageKind::fields, 0, 0.0);
    for (const auto& [spec, value] : words) writer.add(spec, ColumnView(&value, 1));
    writer.finish();
    session_->send_frame(outgoing_);
  }

  /// Collective: both sides know that it is over.
  void say_goodbye() {
    first_rank([&] { session_->finish(); });
    open_ = false;
  }

  void fail(const std::string& why) noexcept {
    open_ = false;
    if (session_) session_->fail(why);
  }

  /// fail() of a rank that may be the only one to know.
  void cry(const std::string& why) noexcept {
    if (!open_) return;
    if (session_ || !over_mpi()) {
      fail(why);
      return;
    }
    open_ = false;
    try {
      encode_text(outgoing_, MessageKind::error, why);
      MpiTransport::cry(options_.world, outgoing_);
    } catch (const std::exception&) {  // this program ends in any case
    }
  }

 private:
  void require_open() const {
    if (open_) return;
    throw BridgeError(Kind::bad_input, "link to the other program", "closed", "an open link",
                      "exchange nothing after the end of the coupling");
  }

  std::unique_ptr<Transport> open() const {
    if (over_mpi()) {
      if (!holds_other_program(options_.world)) {
        throw BridgeError(Kind::bad_input, "coupling by mpi", "a job that holds this program alone",
                          "one mpirun with both programs, separated by ' : '",
                          "start both in one mpirun, or choose transport socket");
      }
      return std::make_unique<MpiTransport>(options_.world);
    }
    SocketOptions socket = options_.socket;
    socket.timeout_s = timeout_s();
    return options_.listens ? listen_on_socket(socket) : connect_to_socket(socket);
  }

  /// The error of the lowest rank that has one goes to all.
  void agree(const std::optional<BridgeError>& mine) {
    int ranks = 1;
    MPI_Comm_size(local_, &ranks);
    struct Lowest {
      int mine, all;
    };
    auto* lowest = new Lowest{mine ? rank_ : ranks, ranks};
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&lowest->mine, &lowest->all, 1, MPI_INT, MPI_MIN, local_, &request);
    // Another rank may be at its first wait when this one is at its last.
    wait_for(request, Deadline(2.0 * timeout_s() + 1.0), "the other ranks of this program");
    const int root = lowest->all;
    delete lowest;
    if (root == ranks) return;
    bool failed = mine.has_value();
    Kind kind = mine ? mine->kind() : Kind::bad_input;
    std::string text = mine ? mine->what() : "";
    share_outcome(local_, root, failed, kind, text, timeout_s());
    throw BridgeError(kind, text);
  }

  MPI_Comm local_;
  LinkOptions options_;
  Hello hello_;
  Hello peer_;
  int rank_ = 0;
  bool open_ = true;
  std::unique_ptr<Session> session_;  ///< on rank 0
  Bytes outgoing_;
};

void send_map(Line& line, const RankMap& map) {
  line.first_rank([&] {
    check_map(map, line.mine().ranks);
    Bytes frame;
    FrameWriter writer(frame);
    writer.begin(MessageKind::fields, 0, 0.0);
    writer.add(map_origin, ColumnView(map.origin_m.data(), 1));
    writer.add(map_spacing, ColumnView(map.spacing_m.data(), 1));
    writer.add(map_voxels, ColumnView(map.voxels.data(), 1));
    writer.add(map_rank, ColumnView(map.rank.data(), map.rank.size()));
    writer.finish();
    line.session()->send_frame(frame);
  });
}

RankMap receive_map(Line& line) {
  RankMap map;
  line.first_rank([&] {
    const FrameView& frame = line.session()->receive_frame();
    const auto origin = values_of<double>(frame, map_origin);
    const auto spacing = values_of<double>(frame, map_spacing);
    const auto voxels = values_of<std::int32_t>(frame, map_voxels);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      map.origin_m[axis] = axis < origin.size() ? origin[axis] : std::nan("");
      map.spacing_m[axis] = axis < spacing.size() ? spacing[axis] : std::nan("");
      map.voxels[axis] = axis < voxels.size() ? voxels[axis] : 0;
    }
    map.rank = values_of<std::int32_t>(frame, map_rank);
    check_map(map, line.peer().ranks);
  });
  line.share(map.origin_m);
  line.share(map.spacing_m);
  line.share(map.voxels);
  std::uint64_t entries = map.rank.size();
  line.share(entries);
  map.rank.resize(entries);
  share_bytes(line.local(), map.rank.data(), entries * sizeof(std::int32_t), line.timeout_s());
  return map;
}

void check_known(const Hello& solver, const std::vector<FieldSpec>& known) {
  for (const FieldSpec& offer : solver.offers) {
    if (std::find(known.begin(), known.end(), offer) != known.end()) continue;
    std::string list;
    for (const FieldSpec& spec : known) list += (list.empty() ? "" : ", ") + describe(spec);
    throw BridgeError(Kind::mismatch, "coupling field " + offer.name,
                      solver.role + " sends " + describe(offer) + ", dem does not know it", list,
                      "switch the force law that makes the field off, "
                      "or use programs of the same release");
  }
}

}  // namespace link_parts
using namespace link_parts;

void say_last_words(const std::string& why) noexcept {
  for (Line* line : lines()) line->cry(why);
}

int RankMap::rank_of(const double* position_m) const {
  std::array<std::size_t, 3> index{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double voxel = std::floor((position_m[axis] - origin_m[axis]) / spacing_m[axis]);
    const double last = voxels[axis] - 1.0;
    // Not std::clamp: a position that is not a number goes to the first voxel.
    index[axis] = voxel > 0.0 ? static_cast<std::size_t>(std::min(voxel, last)) : 0;
  }
  const auto nx = static_cast<std::size_t>(voxels[0]);
  const auto ny = static_cast<std::size_t>(voxels[1]);
  return std::max(0, rank[(index[2] * ny + index[1]) * nx + index[0]]);
}

struct DemLink::Parts {
  Parts(MPI_Comm local, const LinkOptions& options, Hello hello)
      : line(local, options, std::move(hello)) {}

  Line line;
  ExchangePlan plan;
  RankMap map;
  std::unique_ptr<DemExchange> exchange;
};

DemLink::DemLink(MPI_Comm local, const LinkOptions& options, Hello hello,
                 std::vector<FieldSpec> known)
    : parts_(std::make_unique<Parts>(local, options, std::move(hello))) {
  Line& line = parts_->line;
  line.first_rank([&] { check_known(line.peer(), known); });
  parts_->map = receive_map(line);
  parts_->plan = {line.peer().needs, line.peer().offers, options.timeout_s};
  parts_->exchange = line.over_mpi()
                         ? dem_exchange_over_mpi(line.world(), parts_->plan)
                         : dem_exchange_over_session(local, line.session(), parts_->plan);
}

DemLink::~DemLink() = default;

const ExchangePlan& DemLink::plan() const { return parts_->plan; }
const RankMap& DemLink::rank_map() const { return parts_->map; }
const Hello& DemLink::peer() const { return parts_->line.peer(); }

void DemLink::send_particles(std::int64_t step, double time_s, const std::vector<int>& destination,
                             const std::vector<ColumnView>& columns) {
  Line& line = parts_->line;
  line.first_rank([&] { line.say({{state_word, static_cast<int>(DemState::going_on)}}); });
  line.all_ranks([&] { parts_->exchange->send(step, time_s, destination, columns); });
}

SolverWord DemLink::receive_values(const std::vector<MutableColumnView>& columns) {
  Line& line = parts_->line;
  SolverWord word;
  line.first_rank([&] {
    const FrameView& frame = line.session()->receive_frame();
    const auto command = word_of<std::int32_t>(frame, command_word);
    word.command = command == static_cast<int>(Command::stop) ? Command::stop : Command::go_on;
    word.checkpoint = word_of<std::int32_t>(frame, checkpoint_word) == 1;
    word.checkpoint_next = word_of<std::int32_t>(frame, next_word) == 1;
  });
  line.share(word);
  if (word.command == Command::stop) {
    line.say_goodbye();
  } else {
    line.all_ranks([&] { parts_->exchange->receive(columns); });
  }
  return word;
}

void DemLink::finish() {
  Line& line = parts_->line;
  if (!line.open_still()) return;
  line.first_rank([&] { line.say({{state_word, static_cast<int>(DemState::finished)}}); });
  line.say_goodbye();
}

void DemLink::fail(const std::string& why) noexcept { parts_->line.cry(why); }

struct SolverLink::Parts {
  Parts(MPI_Comm local, const LinkOptions& options, Hello hello)
      : line(local, options, std::move(hello)), none(std::vector<FieldSpec>()) {}

  Line line;
  ExchangePlan plan;
  std::unique_ptr<SolverExchange> exchange;
  ParticleTable none;
  const ParticleTable* particles = nullptr;
  bool owes_values = false;
};

SolverLink::SolverLink(MPI_Comm local, const LinkOptions& options, Hello hello, const RankMap& map)
    : parts_(std::make_unique<Parts>(local, options, std::move(hello))) {
  Line& line = parts_->line;
  send_map(line, map);
  parts_->plan = {line.mine().needs, line.mine().offers, options.timeout_s};
  parts_->none = ParticleTable(parts_->plan.to_solver);
  parts_->particles = &parts_->none;
  parts_->exchange = line.over_mpi()
                         ? solver_exchange_over_mpi(line.world(), parts_->plan)
                         : solver_exchange_over_session(local, line.session(), parts_->plan);
}

SolverLink::~SolverLink() = default;

const ExchangePlan& SolverLink::plan() const { return parts_->plan; }
const Hello& SolverLink::peer() const { return parts_->line.peer(); }
const ParticleTable& SolverLink::particles() const { return *parts_->particles; }

bool SolverLink::receive_particles() {
  Line& line = parts_->line;
  std::int32_t state = 0;
  line.first_rank(
      [&] { state = word_of<std::int32_t>(line.session()->receive_frame(), state_word); });
  line.share(state);
  if (state != static_cast<int>(DemState::going_on)) {
    parts_->particles = &parts_->none;
    line.say_goodbye();
    return false;
  }
  line.all_ranks([&] { parts_->particles = &parts_->exchange->receive(); });
  parts_->owes_values = true;
  return true;
}

void SolverLink::send_values(const SolverWord& word, const std::vector<ColumnView>& columns) {
  Line& line = parts_->line;
  line.first_rank([&] {
    line.say({{command_word, static_cast<std::int32_t>(word.command)},
              {checkpoint_word, word.checkpoint ? 1 : 0},
              {next_word, word.checkpoint_next ? 1 : 0}});
  });
  if (word.command == Command::stop) {
    line.say_goodbye();
  } else {
    line.all_ranks([&] { parts_->exchange->send(columns); });
  }
  parts_->owes_values = false;
}

void SolverLink::finish() {
  if (!parts_->line.open_still()) return;
  // The command is an answer: without particles to answer, those on their way would never arrive.
  if (parts_->owes_values || receive_particles()) send_values({Command::stop, false}, {});
}

void SolverLink::fail(const std::string& why) noexcept { parts_->line.cry(why); }

}  // namespace powderlink::bridge
