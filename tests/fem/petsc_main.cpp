// gtest's main with MPI and PETSc initialised for the whole run.
#include <gtest/gtest.h>

#include "linalg/session.hpp"

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    const soft::linalg::Session session({});
    return RUN_ALL_TESTS();
}
