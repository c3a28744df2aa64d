#include "ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <new>
#include <thread>

#include "core/memory.hpp"
#include "core/text.hpp"

namespace soft::cli {

Input read_input_on_first_rank(const std::string& name, int rank) {
    Input input;
    if (rank == 0) input = read_hdf5_input(name);
    auto size = static_cast<std::int64_t>(input.bytes.size());
    MPI_Bcast(&size, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
    input.bytes.resize(static_cast<std::size_t>(size));
    constexpr std::int64_t piece = std::int64_t{1} << 30;  // MPI counts are ints
    for (std::int64_t at = 0; at < size; at += piece)
        MPI_Bcast(input.bytes.data() + at, static_cast<int>(std::min(piece, size - at)), MPI_BYTE, 0, MPI_COMM_WORLD);
    if (rank != 0) input.source = name.empty() || name == "-" ? "<stdin>" : name;
    return input;
}

double broadcast_from_first_rank(double value) {
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    return value;
}

ExitCode run_on_all_ranks(int rank, int size, const std::function<ExitCode()>& body) {
    if (size == 1) return body();
    // The first rank prints an error that occurs on all ranks. The other ranks wait first, so that only an error of one of them alone
    // is printed here.
    const auto fail = [rank](const char* text, ExitCode code) {
        if (rank != 0) std::this_thread::sleep_for(std::chrono::seconds(2));
        std::fprintf(stderr, "solve: %s\n", core::one_line(text, std::string_view::npos).c_str());
        std::fflush(stderr);
        MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
    };
    try {
        return body();
    } catch (const Error& error) {
        fail(error.what(), error.code());
    } catch (const std::bad_alloc&) {
        fail(core::out_of_memory().what(), ExitCode::io_error);
    } catch (const std::exception& error) {
        fail(error.what(), ExitCode::internal);
    }
    return ExitCode::internal;
}

}  // namespace soft::cli
