// What plprove does under mpirun where it was built without MPI.
#include "tests/support/program.h"

#include <doctest/doctest.h>

TEST_CASE("a plprove without MPI sweeps by itself, and refuses to be one of several") {
    const TemporaryFolder folder;
    const std::string sweep = std::string(PLPROVE_WITHOUT_MPI) + " degrees --classes 2394,6723 -o ";
    CHECK(run(sweep + (folder / "alone").string()).status == 0);
    CHECK(run("OMPI_COMM_WORLD_SIZE=1 " + sweep + (folder / "one").string()).status == 0);
    for (const char* several :
         {"OMPI_COMM_WORLD_SIZE=4", "PMI_SIZE=4", "PMIX_RANK=0 SLURM_STEP_NUM_TASKS=4"}) {
        CAPTURE(several);
        const Outcome outcome = run(several + (" " + sweep) + (folder / "four").string());
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(outcome.err == "plprove: this plprove was built without MPI, and 4 were started "
                             "together: install Open MPI and build plprove again, or start it "
                             "without mpirun\n");
        CHECK(!std::filesystem::exists(folder / "four"));
    }
}
