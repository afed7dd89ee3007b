// SPDX-License-Identifier: GPL-3.0-or-later
// One mpirun: first every DEM rank tells every solver rank how much will come (24 bytes each), then
// frames go only where there are particles. The way back needs no first phase.
#include <utility>

#include "coupling/bridge/exchange/particle_rows.h"
#include "coupling/bridge/transport/mpi_mailbox.h"

namespace powderlink::bridge {

namespace {

/// Exchanges of one program pair up with those of the other by the order of their making.
int next_tag() {
  static int tag = 200;
  return tag++;
}

/// First phase. O(ranks of the other program).
class Notices {
 public:
  struct Notice {
    std::uint64_t rows = 0;
    std::int64_t step = 0;
    double time_s = 0.0;
  };

  explicit Notices(const MpiWorld& world)
      : inter_(world.inter),
        waited_for_(world.peer_role + " to take part in the exchange"),
        lists_(std::make_unique<Lists>()) {
    lists_->sent.resize(static_cast<std::size_t>(world.peer_ranks));
    lists_->got.resize(static_cast<std::size_t>(world.peer_ranks));
  }
  ~Notices() {
    // After a timeout MPI may still write into them.
    if (request_ != MPI_REQUEST_NULL) static_cast<void>(lists_.release());
  }
  Notices(const Notices&) = delete;
  Notices& operator=(const Notices&) = delete;

  std::vector<Notice>& sent() { return lists_->sent; }
  const std::vector<Notice>& got() const { return lists_->got; }

  void start() {
    constexpr int bytes = static_cast<int>(sizeof(Notice));
    MPI_Ialltoall(lists_->sent.data(), bytes, MPI_BYTE, lists_->got.data(), bytes, MPI_BYTE, inter_,
                  &request_);
  }
  void wait(const Deadline& deadline) { wait_for(request_, deadline, waited_for_); }

 private:
  struct Lists {
    std::vector<Notice> sent, got;
  };
  MPI_Comm inter_;
  std::string waited_for_;
  std::unique_ptr<Lists> lists_;
  MPI_Request request_ = MPI_REQUEST_NULL;
};

class DemExchangeOverMpi : public DemExchange {
 public:
  DemExchangeOverMpi(const MpiWorld& world, ExchangePlan plan)
      : plan_(std::move(plan)),
        peer_(world.peer_role),
        solver_ranks_(world.peer_ranks),
        notices_(world),
        mailbox_(world.inter, next_tag(), world.peer_role) {
    check_plan(plan_);
    routing_.build({}, solver_ranks_);
  }

  void send(std::int64_t step, double time_s, const std::vector<int>& destination,
            const std::vector<ColumnView>& columns) override {
    const Deadline deadline(plan_.timeout_s);
    check_columns(columns, plan_.to_solver, destination.size());
    complete_former(deadline);
    routing_.build(destination, solver_ranks_);
    for (int rank = 0; rank < solver_ranks_; ++rank) {
      notices_.sent()[static_cast<std::size_t>(rank)] = {routing_.rows_for(rank).count, step,
                                                         time_s};
    }
    notices_.start();
    for (int rank = 0; rank < solver_ranks_; ++rank) {
      const RowList rows = routing_.rows_for(rank);
      if (rows.count == 0) continue;
      encode_rows(mailbox_.letter(), step, time_s, plan_.to_solver, columns, rows);
      mailbox_.post(rank);
    }
    step_ = step;
  }

  void receive(const std::vector<MutableColumnView>& columns) override {
    const Deadline deadline(plan_.timeout_s);
    check_columns(columns, plan_.to_dem, routing_.rows());
    for (int rank = 0; rank < solver_ranks_; ++rank) {
      const RowList rows = routing_.rows_for(rank);
      if (rows.count == 0) continue;
      mailbox_.collect(rank, incoming_, deadline);
      decode(incoming_, view_);
      check_fields(view_, plan_.to_dem, rows.count, peer_);
      check_step(view_.step, step_, peer_);
      for (std::size_t i = 0; i < columns.size(); ++i) {
        scatter_rows(columns[i].data(), view_.fields[i].data.data, plan_.to_dem[i].row_bytes(),
                     rows);
      }
    }
    complete_former(deadline);
  }

 private:
  void complete_former(const Deadline& deadline) {
    notices_.wait(deadline);
    mailbox_.flush(deadline);
  }

  ExchangePlan plan_;
  std::string peer_;
  int solver_ranks_;
  Notices notices_;
  MpiMailbox mailbox_;
  Routing routing_;
  std::int64_t step_ = 0;
  Bytes incoming_;
  FrameView view_;
};

class SolverExchangeOverMpi : public SolverExchange {
 public:
  SolverExchangeOverMpi(const MpiWorld& world, ExchangePlan plan)
      : plan_(std::move(plan)),
        peer_(world.peer_role),
        notices_(world),
        mailbox_(world.inter, next_tag(), world.peer_role),
        table_(plan_.to_solver) {
    check_plan(plan_);
  }

  const ParticleTable& receive() override {
    const Deadline deadline(plan_.timeout_s);
    mailbox_.flush(deadline);
    notices_.start();
    notices_.wait(deadline);
    const auto& notices = notices_.got();
    table_.step = notices.front().step;
    table_.time_s = notices.front().time_s;
    std::size_t rows = 0;
    for (const Notices::Notice& notice : notices) {
      check_step(notice.step, table_.step, peer_);
      rows += static_cast<std::size_t>(notice.rows);
    }
    table_.resize(rows);
    std::size_t first = 0;
    for (std::size_t rank = 0; rank < notices.size(); ++rank) {
      const auto count = static_cast<std::size_t>(notices[rank].rows);
      if (count == 0) continue;
      mailbox_.collect(static_cast<int>(rank), incoming_, deadline);
      decode(incoming_, view_);
      check_fields(view_, plan_.to_solver, count, peer_);
      check_step(view_.step, table_.step, peer_);
      store_rows(view_, table_, first);
      first += count;
    }
    return table_;
  }

  void send(const std::vector<ColumnView>& columns) override {
    check_columns(columns, plan_.to_dem, table_.particles);
    std::size_t first = 0;
    const auto& notices = notices_.got();
    for (std::size_t rank = 0; rank < notices.size(); ++rank) {
      const auto count = static_cast<std::size_t>(notices[rank].rows);
      if (count == 0) continue;
      FrameWriter writer(mailbox_.letter());
      writer.begin(MessageKind::fields, table_.step, table_.time_s);
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::size_t row_bytes = plan_.to_dem[i].row_bytes();
        std::memcpy(writer.add(plan_.to_dem[i], count),
                    static_cast<const std::byte*>(columns[i].data()) + first * row_bytes,
                    count * row_bytes);
      }
      writer.finish();
      mailbox_.post(static_cast<int>(rank));
      first += count;
    }
    // Taken by the DEM side while this one goes on; flushed at the next receive().
  }

 private:
  ExchangePlan plan_;
  std::string peer_;
  Notices notices_;
  MpiMailbox mailbox_;
  ParticleTable table_;
  Bytes incoming_;
  FrameView view_;
};

}  // namespace

std::unique_ptr<DemExchange> dem_exchange_over_mpi(const MpiWorld& world, ExchangePlan plan) {
  return std::make_unique<DemExchangeOverMpi>(world, std::move(plan));
}

std::unique_ptr<SolverExchange> solver_exchange_over_mpi(const MpiWorld& world, ExchangePlan plan) {
  return std::make_unique<SolverExchangeOverMpi>(world, std::move(plan));
}

}  // namespace powderlink::bridge
