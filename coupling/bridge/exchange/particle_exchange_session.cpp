// SPDX-License-Identifier: GPL-3.0-or-later
// One connection between rank 0 of both programs: rank 0 gathers and scatters for the others.
// Rows travel ordered by DEM rank, with the solver rank of each in one more field.
#include <limits>
#include <utility>

#include "coupling/bridge/exchange/particle_rows.h"
#include "coupling/bridge/transport/mpi_mailbox.h"

namespace powderlink::bridge {

namespace {

constexpr int local_tag = 300;

const FieldSpec& destination_field() {
  static const FieldSpec spec{"destination_rank", "1", scalar, ElementType::int32};
  return spec;
}

/// What both sides have in common: ranks, letters within the program, and errors of rank 0.
class Group {
 public:
  Group(MPI_Comm local, Session* session, const ExchangePlan& plan)
      : session(session), mailbox(local, local_tag, "this program") {
    check_plan(plan);
    MPI_Comm_rank(local, &rank);
    MPI_Comm_size(local, &ranks);
    parts.resize(static_cast<std::size_t>(ranks));
    views.resize(static_cast<std::size_t>(ranks));
    if (rank == 0 && !session) {
      throw BridgeError(BridgeError::Kind::bad_input, "particle exchange: session of rank 0",
                        "none", "an open session", "open it before the exchange");
    }
  }

  /// Rank 0: does `action`; its error goes to the other ranks and the other program, too.
  template <class Action>
  void as_first_rank(Action&& action) {
    try {
      action();
    } catch (const BridgeError& e) {
      session->fail(e.what());
      for (int other = 1; other < ranks; ++other) {
        encode_text(mailbox.letter(), MessageKind::error, e.what());
        mailbox.post(other);
      }
      throw;
    }
  }

  /// Rank 0: one frame of every other rank into parts and views (from index 1).
  void collect_all(const Deadline& deadline) {
    for (int other = 1; other < ranks; ++other) {
      const auto i = static_cast<std::size_t>(other);
      mailbox.collect(other, parts[i], deadline);
      decode(parts[i], views[i]);
    }
  }

  /// Other ranks: the frame from rank 0, which itself may wait for as long as its timeout.
  const FrameView& from_first_rank(double timeout_s) {
    mailbox.collect(0, parts[0], Deadline(1.1 * timeout_s + 1.0));
    decode(parts[0], views[0]);
    if (views[0].kind == MessageKind::error) {
      throw BridgeError(BridgeError::Kind::peer_failed, std::string(views[0].text));
    }
    return views[0];
  }

  int rank = 0;
  int ranks = 1;
  Session* session;
  MpiMailbox mailbox;
  std::vector<Bytes> parts;
  std::vector<FrameView> views;
  Bytes outgoing;
};

class DemExchangeOverSession : public DemExchange {
 public:
  DemExchangeOverSession(MPI_Comm local, Session* session, ExchangePlan plan)
      : plan_(std::move(plan)), sent_fields_(plan_.to_solver), group_(local, session, plan_) {
    sent_fields_.push_back(destination_field());
    counts_.resize(static_cast<std::size_t>(group_.ranks));
  }

  void send(std::int64_t step, double time_s, const std::vector<int>& destination,
            const std::vector<ColumnView>& columns) override {
    const Deadline deadline(plan_.timeout_s);
    check_columns(columns, plan_.to_solver, destination.size());
    group_.mailbox.flush(deadline);
    routing_.build_kept(destination);
    step_ = step;
    columns_ = columns;
    columns_.emplace_back(destination.data(), destination.size());
    const RowList kept = routing_.rows_for(0);
    if (group_.rank != 0) {
      encode_rows(group_.mailbox.letter(), step, time_s, sent_fields_, columns_, kept);
      group_.mailbox.post(0);
      return;
    }
    group_.as_first_rank([&] {
      encode_rows(group_.parts[0], step, time_s, sent_fields_, columns_, kept);
      decode(group_.parts[0], group_.views[0]);
      group_.collect_all(deadline);
      join_and_send(step, time_s);
    });
  }

  void receive(const std::vector<MutableColumnView>& columns) override {
    check_columns(columns, plan_.to_dem, routing_.rows());
    if (group_.rank != 0) {
      const FrameView& frame = group_.from_first_rank(plan_.timeout_s);
      check_fields(frame, plan_.to_dem, routing_.kept(), "rank 0");
      store(frame, columns);
      return;
    }
    group_.as_first_rank([&] {
      const FrameView& frame = group_.session->receive_frame();
      check_fields(frame, plan_.to_dem, total_, group_.session->peer().role);
      check_step(frame.step, step_, group_.session->peer().role);
      group_.mailbox.flush(Deadline(plan_.timeout_s));
      hand_out(frame);
      store(frame, columns);
    });
  }

 private:
  void join_and_send(std::int64_t step, double time_s) {
    total_ = 0;
    for (std::size_t r = 0; r < counts_.size(); ++r) {
      counts_[r] = rows_of(group_.views[r]);
      check_fields(group_.views[r], sent_fields_, counts_[r], "a rank of this program");
      check_step(group_.views[r].step, step, "a rank of this program");
      total_ += counts_[r];
    }
    FrameWriter writer(group_.outgoing);
    writer.begin(MessageKind::fields, step, time_s);
    for (std::size_t i = 0; i < sent_fields_.size(); ++i) {
      std::byte* room = writer.add(sent_fields_[i], total_);
      for (const FrameView& part : group_.views) {
        const ByteSpan data = part.fields[i].data;
        if (data.size > 0) std::memcpy(room, data.data, data.size);
        room += data.size;
      }
    }
    writer.finish();
    group_.session->send_frame(group_.outgoing);
  }

  /// The rows of the other ranks, which follow those of rank 0.
  void hand_out(const FrameView& frame) {
    std::size_t first = counts_[0];
    for (int other = 1; other < group_.ranks; ++other) {
      const std::size_t count = counts_[static_cast<std::size_t>(other)];
      FrameWriter writer(group_.mailbox.letter());
      writer.begin(MessageKind::fields, frame.step, frame.time_s);
      for (std::size_t i = 0; i < plan_.to_dem.size(); ++i) {
        const std::size_t row_bytes = plan_.to_dem[i].row_bytes();
        std::byte* room = writer.add(plan_.to_dem[i], count);
        if (count > 0) {
          std::memcpy(room, frame.fields[i].data.data + first * row_bytes, count * row_bytes);
        }
      }
      writer.finish();
      group_.mailbox.post(other);
      first += count;
    }
  }

  void store(const FrameView& frame, const std::vector<MutableColumnView>& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      scatter_rows(columns[i].data(), frame.fields[i].data.data, plan_.to_dem[i].row_bytes(),
                   routing_.rows_for(0));
    }
  }

  ExchangePlan plan_;
  std::vector<FieldSpec> sent_fields_;
  Group group_;
  Routing routing_;
  std::int64_t step_ = 0;
  std::size_t total_ = 0;
  std::vector<std::size_t> counts_;
  std::vector<ColumnView> columns_;
};

class SolverExchangeOverSession : public SolverExchange {
 public:
  SolverExchangeOverSession(MPI_Comm local, Session* session, ExchangePlan plan)
      : plan_(std::move(plan)),
        read_fields_(plan_.to_solver),
        group_(local, session, plan_),
        table_(plan_.to_solver) {
    read_fields_.push_back(destination_field());
  }

  const ParticleTable& receive() override {
    if (group_.rank != 0) {
      const FrameView& frame = group_.from_first_rank(plan_.timeout_s);
      check_fields(frame, plan_.to_solver, rows_of(frame), "rank 0");
      start_table(frame, rows_of(frame));
      store_rows(frame, table_, 0);
      group_.mailbox.flush(Deadline(plan_.timeout_s));
      return table_;
    }
    group_.as_first_rank([&] {
      const FrameView& frame = group_.session->receive_frame();
      check_fields(frame, read_fields_, rows_of(frame), group_.session->peer().role);
      group_.mailbox.flush(Deadline(plan_.timeout_s));
      sort(frame);
    });
    return table_;
  }

  void send(const std::vector<ColumnView>& columns) override {
    check_columns(columns, plan_.to_dem, table_.particles);
    if (group_.rank != 0) {
      FrameWriter writer(group_.mailbox.letter());
      writer.begin(MessageKind::fields, table_.step, table_.time_s);
      for (std::size_t i = 0; i < columns.size(); ++i) writer.add(plan_.to_dem[i], columns[i]);
      writer.finish();
      group_.mailbox.post(0);
      return;
    }
    group_.as_first_rank([&] {
      group_.collect_all(Deadline(plan_.timeout_s));
      join_and_send(columns);
    });
  }

 private:
  void start_table(const FrameView& frame, std::size_t rows) {
    table_.step = frame.step;
    table_.time_s = frame.time_s;
    table_.resize(rows);
  }

  void sort(const FrameView& frame) {
    const FieldSlice& destination = frame.fields.back();
    destination_.resize(destination.rows);
    if (destination.rows > 0) {
      std::memcpy(destination_.data(), destination.data.data, destination.data.size);
    }
    routing_.build(destination_, group_.ranks);
    if (routing_.kept() != routing_.rows()) {
      throw BridgeError(BridgeError::Kind::mismatch, "particle exchange: solver rank of a particle",
                        "a negative one", "0 to " + std::to_string(group_.ranks - 1),
                        "use programs of the same release");
    }
    const RowList own = routing_.rows_for(0);
    start_table(frame, own.count);
    for (int other = 1; other < group_.ranks; ++other) {
      const RowList rows = routing_.rows_for(other);
      FrameWriter writer(group_.mailbox.letter());
      writer.begin(MessageKind::fields, frame.step, frame.time_s);
      for (std::size_t i = 0; i < plan_.to_solver.size(); ++i) {
        gather_rows(writer.add(plan_.to_solver[i], rows.count), frame.fields[i].data.data,
                    plan_.to_solver[i].row_bytes(), rows);
      }
      writer.finish();
      group_.mailbox.post(other);
    }
    for (std::size_t i = 0; i < plan_.to_solver.size(); ++i) {
      gather_rows(static_cast<std::byte*>(table_.fields[i].data()), frame.fields[i].data.data,
                  plan_.to_solver[i].row_bytes(), own);
    }
  }

  /// Back into the order in which the rows came.
  void join_and_send(const std::vector<ColumnView>& columns) {
    for (int other = 1; other < group_.ranks; ++other) {
      const FrameView& part = group_.views[static_cast<std::size_t>(other)];
      check_fields(part, plan_.to_dem, routing_.rows_for(other).count, "a rank of this program");
      check_step(part.step, table_.step, "a rank of this program");
    }
    FrameWriter writer(group_.outgoing);
    writer.begin(MessageKind::fields, table_.step, table_.time_s);
    for (std::size_t i = 0; i < plan_.to_dem.size(); ++i) {
      const std::size_t row_bytes = plan_.to_dem[i].row_bytes();
      std::byte* room = writer.add(plan_.to_dem[i], routing_.rows());
      scatter_rows(room, static_cast<const std::byte*>(columns[i].data()), row_bytes,
                   routing_.rows_for(0));
      for (int other = 1; other < group_.ranks; ++other) {
        const FrameView& part = group_.views[static_cast<std::size_t>(other)];
        scatter_rows(room, part.fields[i].data.data, row_bytes, routing_.rows_for(other));
      }
    }
    writer.finish();
    group_.session->send_frame(group_.outgoing);
  }

  ExchangePlan plan_;
  std::vector<FieldSpec> read_fields_;
  Group group_;
  ParticleTable table_;
  Routing routing_;
  std::vector<int> destination_;
};

}  // namespace

std::unique_ptr<DemExchange> dem_exchange_over_session(MPI_Comm local, Session* session,
                                                       ExchangePlan plan) {
  return std::make_unique<DemExchangeOverSession>(local, session, std::move(plan));
}

std::unique_ptr<SolverExchange> solver_exchange_over_session(MPI_Comm local, Session* session,
                                                             ExchangePlan plan) {
  return std::make_unique<SolverExchangeOverSession>(local, session, std::move(plan));
}

}  // namespace powderlink::bridge
