#include "cli/developers/bench/mpi/mpi_ranks.hpp"

#include <mpi.h>

bool wend_mpi_start(int* rank, int* count) {
  return MPI_Init(nullptr, nullptr) == MPI_SUCCESS &&
         MPI_Comm_rank(MPI_COMM_WORLD, rank) == MPI_SUCCESS &&
         MPI_Comm_size(MPI_COMM_WORLD, count) == MPI_SUCCESS;
}

bool wend_mpi_wait_for_all() { return MPI_Barrier(MPI_COMM_WORLD) == MPI_SUCCESS; }

void wend_mpi_finish() { MPI_Finalize(); }

void wend_mpi_abort(int exit_code) { MPI_Abort(MPI_COMM_WORLD, exit_code); }
