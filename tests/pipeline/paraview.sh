#!/usr/bin/env bash
# What --paraview writes, opened in ParaView itself and compared with formulas.   paraview.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# The rod is pulled by 1345.5 kPa on its deformed end and free at its sides: sigma = diag(1345.5 kPa, 0, 0) in equilibrium,
# whatever the law; the stretch is 1 + elongation / 100 mm, and P_11 = sigma_11 J / l.
runs 'mesh-gen designs/verification/rod-uniaxial.yaml | solve > rod.h5'
runs 'postprocess rod.h5 -o rod.csv --paraview rod.pvd'
runs 'postprocess rod.h5 --paraview rod.vtu --quiet && postprocess rod.h5 --paraview copy.hdf --quiet'
claim "nothing else is printed" [ ! -s "$seen/out" ]
stretch=$(column elongation_mm rod.csv | tail -n 1 | awk '{ print 1 + $1 / 100 }')
steps=$(column step rod.csv | wc -l)
claim "a file a step" [ "$(find rod -name 'step-*.vtu' | wc -l)" -eq "$steps" ]
claim "at the times of the load" [ -z "$(paste <(grep -o 'timestep="[^"]*' rod.pvd | cut -d'"' -f2) <(column pressure_kPa rod.csv) | awk '{ if (($1 + $2) ^ 2 > 1e-18 * $2 ^ 2) print }')" ]
claim "the .pvd lists them" [ "$(grep -c '<DataSet' rod.pvd)" -eq "$steps" ]
runs 'postprocess copy.hdf > again.csv'
touch rod/step-9999.vtu rod/step-99.vtu
runs 'postprocess rod.h5 --paraview rod.pvd'
claim "a step of a longer path is gone" [ ! -e rod/step-9999.vtu ]
claim "which is told" grep -qx "postprocess: rod.pvd: $steps steps; its time is the negative pressure in kPa; 1 step of an earlier result removed" "$seen/err"
claim "what is not ours stays" rm rod/step-99.vtu
claim "a file a step as before" [ "$(find rod -type f | wc -l)" -eq "$steps" ]
claim "the copy is still the result" cmp rod.csv again.csv
runs 'postprocess rod.h5 --paraview early.vtu --at elongation=50mm --quiet'
claim "--at picks another step" not cmp -s early.vtu rod.vtu

refuses 64 'postprocess: --paraview x.vtk: unknown extension; use .pvd, .vtu, .hdf, .vtkhdf or .h5' 'postprocess rod.h5 --paraview x.vtk'
refuses 73 "postprocess: --paraview none/x.pvd: there is no folder 'none' to make 'x' in; make it first*" 'postprocess rod.h5 --paraview none/x.pvd'
refuses 73 "postprocess: --paraview ser.pvd: 'ser' exists and is no folder; choose another name, or move it away" \
    'touch ser; postprocess rod.h5 --paraview ser.pvd'
runs 'solve --fields none < <(mesh-gen designs/verification/rod-uniaxial.yaml) > bare.h5'
refuses 65 'postprocess: /fields: the result contains no displacements; run solve with --fields all' 'postprocess bare.h5 --paraview x.pvd'

if [ -z "$(type -P pvpython)" ]; then
    echo 'skipped: pvpython (package paraview) is not installed'
    exit 0
fi

value() { awk -v p="$1" -v n="$2" -v c="$3" '$1 == p && $2 == n && $3 == c { print $4, $5 }' read.txt; }
both_within() {   # both_within PLACE NAME COMPONENT LOW HIGH: least and largest
    local least largest
    read -r least largest <<<"$(value "$1" "$2" "$3")"
    within "${least:-x}" "$4" "$5" && within "${largest:-x}" "$4" "$5"
}
about() { awk -v x="$1" -v e="$2" 'BEGIN { d = x < 0 ? -x : x; printf "%.10g %.10g", x - e * d, x + e * d }'; }

for file in rod.pvd rod.vtu copy.hdf; do
    runs "pvpython $here/read_in_paraview.py $file > read.txt"
    for place in point cell; do
        claim "$file: the pull is 1345.5 kPa" both_within "$place" cauchy_stress_Pa 0 1345490 1345510
        claim "$file: nothing pulls across" both_within "$place" cauchy_stress_Pa 4 -10 10
        claim "$file: von Mises is the pull" both_within "$place" von_mises_stress_Pa 0 1345490 1345510
        claim "$file: the pressure is minus a third of it" both_within "$place" pressure_Pa 0 -448510 -448490
        # shellcheck disable=SC2046  # two numbers
        claim "$file: the stretch is that of the curve" both_within "$place" principal_stretches 0 $(about "$stretch" 1e-6)
        claim "$file: it is along x" both_within "$place" stretch_direction_1 0 0.999999 1.000001
        read -r J _ <<<"$(value "$place" J 0)"
        nominal=$(awk -v J="$J" -v l="$stretch" 'BEGIN { print 1345500 * J / l }')
        # shellcheck disable=SC2046
        claim "$file: P = sigma J / l" both_within "$place" first_piola_stress_Pa 0 $(about "$nominal" 1e-5)
        claim "$file: an energy" both_within "$place" energy_density_J_m3 0 1e5 1e6
    done
    read -r least largest <<<"$(value point displacement_m 0)"
    claim "$file: one end is held" within "$least" -1e-9 1e-9
    # shellcheck disable=SC2046
    claim "$file: the other moves by the elongation" within "$largest" $(about "$(column elongation_mm rod.csv | tail -n 1 | awk '{ print $1 / 1000 }')" 1e-5)
done
claim "the series has all steps" grep -qx "count times $steps" <(pvpython "$here/read_in_paraview.py" rod.pvd)

if [ -n "$(type -P Xvfb)" ]; then
    # It chooses a free display and tells which; without -noreset it is away for a moment whenever its last client leaves.
    Xvfb -displayfd 3 -noreset -screen 0 640x480x24 3>display.txt 2>/dev/null &
    server=$!
    for _ in {1..100}; do
        if [ -s display.txt ]; then break; fi
        sleep 0.1
    done
    runs "DISPLAY=:$(cat display.txt) pvpython $here/read_in_paraview.py rod.pvd drawn.png"
    kill "$server"
    claim "ParaView draws it" [ "$(stat -c %s drawn.png)" -gt 1000 ]
fi
