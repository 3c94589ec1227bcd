#pragma once

// What the program calls in the module wend_mpi, by name.

extern "C" {

/// First; sets this process's rank and how many there are. False if MPI does not start.
bool wend_mpi_start(int* rank, int* count);

/// Returns when all ranks have called it. False if some cannot.
bool wend_mpi_wait_for_all();

/// Last.
void wend_mpi_finish();

/// Ends all ranks at once.
void wend_mpi_abort(int exit_code);
}
