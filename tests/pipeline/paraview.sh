#!/usr/bin/env bash
# Opens the files of --paraview in ParaView and compares their fields with formulas.   paraview.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# The rod is pulled by 1345.5 kPa on its deformed end with free sides: sigma = diag(1345.5 kPa, 0, 0) in equilibrium for every law.
# The stretch is l = 1 + elongation / 100 mm, and P_11 = sigma_11 J / l.
runs 'mesh-gen designs/verification/rod-uniaxial.yaml | solve > rod.h5'
runs 'postprocess rod.h5 -o rod.csv --paraview rod.pvd'
runs 'postprocess rod.h5 --paraview rod.vtu --quiet && postprocess rod.h5 --paraview copy.hdf --quiet'
claim "stdout is empty" [ ! -s "$seen/out" ]
stretch=$(column elongation_mm rod.csv | tail -n 1 | awk '{ print 1 + $1 / 100 }')
steps=$(column step rod.csv | wc -l)
claim "there is one file per step" [ "$(find rod -name 'step-*.vtu' | wc -l)" -eq "$steps" ]
claim "the time values are the loads" [ -z "$(paste <(grep -o 'timestep="[^"]*' rod.pvd | cut -d'"' -f2) <(column pressure_kPa rod.csv) | awk '{ if (($1 + $2) ^ 2 > 1e-18 * $2 ^ 2) print }')" ]
claim "the .pvd lists them" [ "$(grep -c '<DataSet' rod.pvd)" -eq "$steps" ]
runs 'postprocess copy.hdf > again.csv'
touch rod/step-9999.vtu rod/step-99.vtu
runs 'postprocess rod.h5 --paraview rod.pvd'
claim "a stale step is removed" [ ! -e rod/step-9999.vtu ]
claim "the removal is reported" grep -qx "postprocess: rod.pvd: $steps steps; its time is the negative pressure in kPa; 1 step of an earlier result removed" "$seen/err"
claim "other files are kept" rm rod/step-99.vtu
claim "there is one file per step again" [ "$(find rod -type f | wc -l)" -eq "$steps" ]
claim "the copy is a valid result" cmp rod.csv again.csv
runs 'postprocess rod.h5 --paraview early.vtu --at elongation=50mm --quiet'
claim "--at selects another step" not cmp -s early.vtu rod.vtu

refuses 64 'postprocess: --paraview x.vtk: unknown extension; use .pvd, .vtu, .hdf, .vtkhdf or .h5' 'postprocess rod.h5 --paraview x.vtk'
refuses 73 "postprocess: --paraview none/x.pvd: the folder 'none' for 'x' does not exist; create it first*" 'postprocess rod.h5 --paraview none/x.pvd'
refuses 73 "postprocess: --paraview ser.pvd: 'ser' exists and is not a folder; choose another name or move the file" \
    'touch ser; postprocess rod.h5 --paraview ser.pvd'
runs 'solve --fields none < <(mesh-gen designs/verification/rod-uniaxial.yaml) > bare.h5'
refuses 65 'postprocess: /fields: the result contains no displacements; run solve with --fields all' 'postprocess bare.h5 --paraview x.pvd'

needs pvpython paraview

value() { awk -v p="$1" -v n="$2" -v c="$3" '$1 == p && $2 == n && $3 == c { print $4, $5 }' read.txt; }
both_within() {   # both_within point|cell NAME COMPONENT LOW HIGH: minimum and maximum are in the range
    local least largest
    read -r least largest <<<"$(value "$1" "$2" "$3")"
    within "${least:-x}" "$4" "$5" && within "${largest:-x}" "$4" "$5"
}
about() { awk -v x="$1" -v e="$2" 'BEGIN { d = x < 0 ? -x : x; printf "%.10g %.10g", x - e * d, x + e * d }'; }

for file in rod.pvd rod.vtu copy.hdf; do
    runs "pvpython $here/read_in_paraview.py $file > read.txt"
    for place in point cell; do
        claim "$file: the axial stress is 1345.5 kPa" both_within "$place" cauchy_stress_Pa 0 1345490 1345510
        claim "$file: the lateral stress is 0" both_within "$place" cauchy_stress_Pa 4 -10 10
        claim "$file: the von Mises stress is the axial stress" both_within "$place" von_mises_stress_Pa 0 1345490 1345510
        claim "$file: the pressure is minus a third of the axial stress" both_within "$place" pressure_Pa 0 -448510 -448490
        # shellcheck disable=SC2046  # two numbers
        claim "$file: the stretch is that of the curve" both_within "$place" principal_stretches 0 $(about "$stretch" 1e-6)
        claim "$file: its direction is x" both_within "$place" stretch_direction_1 0 0.999999 1.000001
        read -r J _ <<<"$(value "$place" J 0)"
        nominal=$(awk -v J="$J" -v l="$stretch" 'BEGIN { print 1345500 * J / l }')
        # shellcheck disable=SC2046
        claim "$file: P = sigma J / l" both_within "$place" first_piola_stress_Pa 0 $(about "$nominal" 1e-5)
        claim "$file: the energy density is plausible" both_within "$place" energy_density_J_m3 0 1e5 1e6
    done
    read -r least largest <<<"$(value point displacement_m 0)"
    claim "$file: one end is fixed" within "$least" -1e-9 1e-9
    # shellcheck disable=SC2046
    claim "$file: the other moves by the elongation" within "$largest" $(about "$(column elongation_mm rod.csv | tail -n 1 | awk '{ print $1 / 1000 }')" 1e-5)
done
claim "the series contains all steps" grep -qx "count times $steps" <(pvpython "$here/read_in_paraview.py" rod.pvd)

if [ -n "$(type -P Xvfb)" ]; then
    # Xvfb selects a free display and prints its number; without -noreset it restarts when its last client disconnects.
    Xvfb -displayfd 3 -noreset -screen 0 640x480x24 3>display.txt 2>/dev/null &
    server=$!
    for _ in {1..100}; do
        if [ -s display.txt ]; then break; fi
        sleep 0.1
    done
    runs "DISPLAY=:$(cat display.txt) pvpython $here/read_in_paraview.py rod.pvd drawn.png"
    kill "$server"
    claim "ParaView renders it" [ "$(stat -c %s drawn.png)" -gt 1000 ]
fi
