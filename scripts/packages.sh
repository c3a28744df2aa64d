# shellcheck shell=bash disable=SC2034,SC2154  # variables shared with scripts/setup
# The packages of packages.txt and their installation by apt: functions of scripts/setup, which sources this file.
table=scripts/packages.txt

say() { printf 'setup: %s\n' "$*" >&2; }
have() { command -v "$1" >/dev/null 2>&1; }

package_names() {   # one line, by column of the table
    awk -F'|' -v column="$1" '!/^#/ && NF { gsub(/ /, "", $column); if ($column != "") line = line " " $column } END { print substr(line, 2) }' "$table"
}

# Debian selects BLAS by alternatives named libblas.so.3-<architecture>. Prints the alternatives of a library (blas, lapack) that
# select, or do not select, the reference implementation, with which factorisations take about five times as long.
choices() {   # blas|lapack reference|optimised
    update-alternatives --get-selections 2>/dev/null | awk -v library="lib$1.so.3-" -v want="$2" '
        index($1, library) == 1 && ($3 ~ /\/(blas\/libblas|lapack\/liblapack)\.so\.3$/ ? "reference" : "optimised") == want { print $1 }'
}

missing_packages() {   # build|package|docs|tests|checks
    local wanted=() absent=() package command need installed
    while read -r package command need; do
        if have "$command" || [[ $need == *optimised* && -n $(choices blas optimised) ]]; then continue; fi   # any optimised BLAS is accepted
        wanted+=("$package")
    done < <(awk -F'|' -v purpose="$1" '$1 ~ "^" purpose " *$" { gsub(/ /, "", $4); print $4, $3 ~ /[^ ]/ ? $3 : "-", $2 }' "$table")
    # dpkg-query fails if one package is unknown, but still prints the others.
    installed=$(dpkg-query --show --showformat '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
    for package in "${wanted[@]}"; do
        if [[ $'\n'$installed$'\n' != *$'\n'"$package installed"$'\n'* ]]; then absent+=("$package"); fi
    done
    echo "${absent[*]}"
}

# Runs a command as root; returns 1 if that is not possible (sudo asks for a password only on a terminal).
as_root() {
    if [[ $(id -u) -eq 0 ]]; then "$@"
    elif have sudo && { sudo -n true 2>/dev/null || { [[ -t 0 ]] && sudo -v; }; }; then sudo "$@"
    else return 1
    fi
}

install() {   # install PURPOSE: installs the missing packages; otherwise returns 1 and sets $reason. Sets $missing.
    local log=$build/install.log apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
    missing='' reason='apt-get is not available to install missing packages'
    have apt-get && have dpkg-query || return 1
    missing=$(missing_packages "$1") reason='packages are missing, and installing them needs root or sudo'
    [[ -n $missing ]] || return 0
    as_root true || return 1
    mkdir -p "$build"
    say "installing $missing (a bare system takes about 2 GB, with the tests 4 GB, and a minute or two; log in $log)"
    as_root "${apt[@]}" update >>"$log" 2>&1 || true   # may fail because of a single broken source; the other sources may suffice
    # shellcheck disable=SC2086  # a list of words
    as_root "${apt[@]}" -o Dpkg::Options::=--force-confold install --yes --no-install-recommends $missing >>"$log" 2>&1 </dev/null && return
    tail -n 15 "$log" | sed 's/^/  | /' >&2
    reason="apt-get could not install $missing (the lines above)"
    return 1
}

choose_blas() {
    local link
    have update-alternatives || return 0
    for link in $(choices blas reference) $(choices lapack reference); do
        as_root update-alternatives --auto "$link" >/dev/null 2>&1 || true   # selects the best installed one
    done
    link=$(choices blas reference)
    [[ -z $link ]] || say "warning: this system uses the reference BLAS, about five times slower than OpenBLAS;" \
        "install libopenblas0-serial or run 'update-alternatives --auto $link' as root"
}
