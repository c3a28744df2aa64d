#!/usr/bin/env bash
# Two ranks give the same curve as one.   ranks.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
tolerance=1e-8

# Compares all rows: the closed tube past its limit point, and a quarter model with hexahedra and wedges.
for options in '--set path.until.steps=16' \
    '--set model=quarter --set mesh.size=10mm --set mesh.through_wall=1 --set path.until.steps=3'; do
    runs "mesh-gen -q designs/tube.yaml $options -o case.h5 && solve -q case.h5 | postprocess -q > one.csv"
    runs 'mpirun -n 2 solve -q case.h5 -o two.h5 --json two.json && postprocess -q two.h5 -o two.csv'
    claim "two ranks were used" has 2 two.json ranks
    claim "the curve is the same to $tolerance" agree one.csv two.csv "$tolerance"
done

# Multigrid, whose smoother works per rank, also gives the same curve, equal to that of the factorisation.
multigrid='--set solver.linear=krylov --set solver.preconditioner=multigrid --set solver.linear_tolerance=1e-10 --set solver.linear_limit=300'
runs "solve -q case.h5 $multigrid | postprocess -q > multigrid.csv; mpirun -n 2 solve -q case.h5 $multigrid -o two.h5; postprocess -q two.h5 > two.csv"
claim "multigrid gives the curve of the factorisation to $tolerance" agree one.csv multigrid.csv "$tolerance"
claim "multigrid on two ranks gives the curve of one rank to $tolerance" agree multigrid.csv two.csv "$tolerance"

# Also on the slender bellows, whose steps would differ if step sizes were not rounded to a few digits.
runs "mesh-gen -q designs/bellows.yaml --set mesh.size=3mm --set path.until.elongation=25mm -o case.h5"
runs 'solve -q case.h5 | postprocess -q > one.csv; mpirun -n 2 solve -q case.h5 -o two.h5; postprocess -q two.h5 > two.csv'
claim "the curve of the bellows is the same to $tolerance" agree one.csv two.csv "$tolerance"

# Streams and exit codes of two ranks are those of one.
runs 'mesh-gen -q designs/tube.yaml | mpirun -n 2 solve -q --set path.until.steps=2 | postprocess -q > piped.csv'
claim "a pipe through mpirun transfers the result" table piped.csv
run 'mpirun -n 2 solve -q absent.h5 -o x.h5'
claim "an error keeps its exit code" exits 66
claim "an error is printed once" [ "$(grep -c '^solve: absent.h5: cannot be opened: ' "$seen/err")" -eq 1 ]
run 'mpirun -n 2 solve -q case.h5 -o x.h5 --set solver.step_limit=1'
claim "an early end keeps its exit code" exits 2
