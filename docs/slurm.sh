#!/bin/bash
# A sweep over many degrees, as a job of a cluster with Slurm:
#
#     sbatch docs/slurm.sh --exact -o sweep
#     sbatch --ntasks=64 docs/slurm.sh --classes pl0p -o sweep
#
# The arguments are those of plprove degrees. The folder is one that all nodes share. A job that ends
# before the sweep does, by its limit of time or with a node, is started again by the same command: it
# goes on where it was. Options of sbatch replace those below.
#SBATCH --job-name=degrees
#SBATCH --ntasks=256
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=1G
#SBATCH --time=01:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=degrees-%j.log
set -euo pipefail
exec mpirun "${PLPROVE:-build/bin/plprove}" degrees "$@"
