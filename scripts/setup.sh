# What scripts/run and scripts/test share: packages, configure, build. Sourced, not run.
# shellcheck shell=bash
# SPDX-License-Identifier: MIT

facet_say() { printf 'facet: %s\n' "$*" >&2; }

# packages_of SECTION...: the names in those sections of packages.txt.
packages_of() {
    local section='' line
    while IFS= read -r line || [[ -n $line ]]; do
        line=${line%%#*} line=${line//[[:space:]]/}
        [[ -z $line ]] && continue
        if [[ $line == \[*\] ]]; then section=${line:1:-1}; continue; fi
        [[ " $* " == *" $section "* ]] && printf '%s\n' "$line"
    done <"$facet_root/scripts/packages.txt"
}

# Installs what is missing and nothing else; asks dpkg first, so that a second run touches no network.
install_packages() {
    local -a wanted missing=() as_root=()
    local name installed
    mapfile -t wanted < <(packages_of "$@")
    if ! command -v dpkg-query >/dev/null; then
        facet_say "not a Debian system: the packages of scripts/packages.txt are yours to install"
        return 0
    fi
    # Provided names count too (libjpeg-dev is only a name that another package may carry).
    installed=" $(dpkg-query -W -f='${db:Status-Status} ${Package} ${Provides}\n' 2>/dev/null |
        sed -n 's/^installed //p' | tr -s ',\n' '  ') "
    for name in "${wanted[@]}"; do
        [[ $installed == *" $name "* ]] || missing+=("$name")
    done
    [[ ${#missing[@]} -eq 0 ]] && return 0
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null || {
            facet_say "packages are missing (${missing[*]}); install them as root, or install sudo"
            return 2
        }
        as_root=(sudo)
    fi
    facet_say "installing ${#missing[@]} packages: ${missing[*]}"
    local log
    log=$(mktemp)
    local -a apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0
        -o DPkg::Lock::Timeout=300)
    if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
        tail -n 15 "$log" >&2
        facet_say "apt-get could not install the packages (log: $log)"
        return 75
    fi
    rm -f "$log"
}

# configure PRESET FOLDER [cmake arguments]: only where the build tree is not there yet, or was moved here;
# ninja itself configures again when a CMake file changes.
configure() {
    local preset=$1 folder=$2
    shift 2
    if [[ -e $folder/CMakeCache.txt ]] &&
        ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$facet_root" "$folder/CMakeCache.txt"; then
        facet_say "$folder was made for another place; starting it anew"
        rm -rf "$folder"
    fi
    [[ -e $folder/build.ninja ]] && return 0
    local -a launcher=()
    command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    facet_say "configuring $preset"
    (cd "$facet_root" && cmake --preset "$preset" "${launcher[@]}" "$@") >"$facet_root/.configure.log" 2>&1 || {
        cat "$facet_root/.configure.log" >&2
        rm -f "$facet_root/.configure.log"
        return 70
    }
    rm -f "$facet_root/.configure.log"
}

# build FOLDER [targets]: progress on a terminal; elsewhere nothing, but the compiler's words when it fails.
build() {
    local folder=$1 log
    shift
    [[ -e $folder/.ninja_log ]] || facet_say "building $(basename "$folder"); the first time takes some minutes"
    if [[ -t 2 && -z ${CI:-} ]]; then
        (cd "$folder" && ninja "$@" >&2)
        return
    fi
    log=$(mktemp)
    if ! (cd "$folder" && ninja "$@" >"$log" 2>&1); then
        cat "$log" >&2
        rm -f "$log"
        facet_say "the build failed"
        return 70
    fi
    rm -f "$log"
}
