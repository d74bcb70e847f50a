// SPDX-License-Identifier: MIT
// shigusa-mpi PLAN.json FOLDER: makes a data set with the processes started by mpirun. Each idle
// process takes the next shard from a counter held by the first process; otherwise it works as
// `shigusa dataset`, with the same bytes. If a process is killed, all end; the same command then
// continues, as shards are whole or absent.
#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <shigusa/dataset.hpp>
#include <shigusa/dataset_merge.hpp>
#include <shigusa/files.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace {

using shigusa::DatasetPlan;
using shigusa::DatasetRun;
using shigusa::Result;

constexpr int kDone = 0;
constexpr int kFault = 1;
constexpr int kWrongInput = 2;

// Shared counter of the processes; each number is given out once. It is in the memory of process 0.
class Counter {
 public:
  Counter() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const MPI_Aint size = rank == 0 ? sizeof(std::uint64_t) : 0;
    MPI_Win_allocate(size, sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &memory_,
                     &window_);
    if (rank == 0) *memory_ = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;
  ~Counter() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }

  std::uint64_t next() {
    const std::uint64_t one = 1;
    std::uint64_t drawn = 0;
    MPI_Fetch_and_op(&one, &drawn, MPI_UINT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return drawn;
  }

 private:
  MPI_Win window_ = MPI_WIN_NULL;
  std::uint64_t* memory_ = nullptr;
};

// Makes shards until none is left.
Result<DatasetRun> make_shards(const DatasetPlan& plan, const std::string& folder) {
  Counter counter;
  DatasetRun all;
  for (std::uint64_t shard = counter.next(); shard < plan.shards(); shard = counter.next()) {
    // mpirun starts a process for each core
    const Result<DatasetRun> one = shigusa::make_dataset(
        plan, {.folder = folder, .first_shard = shard, .last_shard = shard + 1, .threads = 1});
    if (!one) return one;
    all.made += one->made;
    all.there += one->there;
    all.tasks += one->tasks;
    all.motions += one->motions;
  }
  return all;
}

// Sums the counts of all processes, for the first one.
std::uint64_t sum_of(std::uint64_t own) {
  std::uint64_t all = 0;
  MPI_Reduce(&own, &all, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  return all;
}

void complain(int rank, const shigusa::Error& error) {
  std::fprintf(stderr, "shigusa-mpi: process %d: %s\n", rank, error.to_string().c_str());
}

// Ends all processes, as the others would wait for this one.
void give_up(int rank, const shigusa::Error& error) {
  complain(rank, error);
  MPI_Abort(MPI_COMM_WORLD, kWrongInput);
}

int run(int argc, char** argv) {
  int rank = 0;
  int processes = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &processes);
  if (argc != 3) {
    if (rank == 0)
      std::fputs("shigusa-mpi: call it as mpirun shigusa-mpi PLAN.json FOLDER\n", stderr);
    return kWrongInput;
  }
  const std::string folder = argv[2];
  const auto begin = std::chrono::steady_clock::now();
  const Result<DatasetPlan> plan = DatasetPlan::read(argv[1]);
  if (!plan) {
    // all processes have read the same plan, so one reports the error
    if (rank == 0) complain(rank, plan.error());
    return kWrongInput;
  }
  if (rank == 0) {
    // the others wait for it at the counter
    const Result<void> ready =
        shigusa::prepare_folder(folder)
            .and_then([&] { return shigusa::keep_plan(*plan, folder); })
            .and_then([&] {
              return shigusa::write_first_card(*plan, folder, "shigusa " SHIGUSA_VERSION);
            });
    if (!ready) give_up(rank, ready.error());
  }
  const Result<DatasetRun> made = make_shards(*plan, folder);
  if (!made) give_up(rank, made.error());
  const std::uint64_t shards = sum_of(made->made);
  const std::uint64_t tasks = sum_of(made->tasks);
  const std::uint64_t motions = sum_of(made->motions);
  if (rank == 0) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::printf("%llu shards made by %d processes: %llu tasks, %llu motions in %.1f s\n",
                static_cast<unsigned long long>(shards), processes,
                static_cast<unsigned long long>(tasks), static_cast<unsigned long long>(motions),
                seconds.count());
  }
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = kFault;
  try {
    code = run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shigusa-mpi: internal fault: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, kFault);
  }
  MPI_Finalize();
  return code;
}
