# Sourced by tools/vkpt and tools/test: packages, locking, configuring, quiet building.
# Expects: set -euo pipefail, $root (the repository), $tool (name for messages).
# shellcheck disable=SC2154

say() { printf '%s: %s\n' "$tool" "$*" >&2; }
fail() { # fail CODE MESSAGE…
    local code=$1
    shift
    say "$@"
    exit "$code"
}

# Names in package lists, without comments.
packages_in() { sed 's/#.*//' "$@" | tr -s ' \t\n' '\n' | sed '/^$/d'; }

# Those of the given packages that are not installed, a line each. One dpkg-query for all.
missing_packages() {
    local installed
    installed=$(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null | sed -n 's/^.i *//p' | sort -u) || true
    comm -23 <(printf '%s\n' "$@" | sort -u) <(printf '%s\n' "$installed")
}

# Installs what the given lists name and the system lacks; with no_install=1 refuses.
ensure_packages() {
    command -v dpkg-query >/dev/null || {
        say "this is no Debian system; expecting the libraries of tools/packages*.txt to be there"
        return 0
    }
    local -a names missing as
    mapfile -t names < <(packages_in "$@")
    mapfile -t missing < <(missing_packages "${names[@]}")
    [[ ${#missing[@]} -gt 0 ]] || return 0
    if [[ ${no_install:-0} == 1 ]]; then
        fail 4 "these Debian packages are missing (--no-install was given): ${missing[*]}"
    elif [[ $EUID -eq 0 ]]; then
        as=()
        say "installing with apt-get, as root: ${missing[*]}"
    elif command -v sudo >/dev/null; then
        as=(sudo)
        say "installing with apt-get, through sudo: ${missing[*]}"
    else
        fail 4 "neither root nor sudo; run as root: apt-get install ${missing[*]}"
    fi
    local log
    log=$(mktemp)
    apt_get() { "${as[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" </dev/null >>"$log" 2>&1; }
    # Lists may be absent or too old to name files that still exist: then once more after an update.
    local -a install=(install --no-install-recommends "${missing[@]}")
    if ! apt_get "${install[@]}" && ! { apt_get update && apt_get "${install[@]}"; }; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        fail 4 "apt-get failed (above); install by hand: ${missing[*]}"
    fi
    rm -f "$log"
}

# Only one build at a time in this repository. The lock ends with unlock_build or the process.
lock_build() {
    if ! mkdir -p "$root/build" 2>/dev/null || ! touch "$root/build/.lock" 2>/dev/null; then
        fail 4 "$root/build: cannot be written"
    fi
    exec 9>"$root/build/.lock"
    flock -n 9 || {
        say "waiting for another build to finish"
        flock 9
    }
}
unlock_build() { exec 9>&-; }

# As many compilers as there are cores, but not more than memory bears (about 1 GiB each).
build_jobs() {
    local cores memory
    cores=$(nproc)
    memory=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null || echo "$cores")
    echo $((memory < 1 ? 1 : memory < cores ? memory : cores))
}

# Whether build/PRESET was configured from this very folder (a copied or moved tree must start afresh).
is_configured() {
    [[ -f $root/build/$1/build.ninja ]] &&
        grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/$1/CMakeCache.txt"
}

# configure PRESET [-DNAME=VALUE…]: quiet unless it fails. Several sources are compiled as one, in half the time; who
# configures by hand (cmake --preset release) compiles each by itself.
configure() {
    local log fresh=()
    log=$(mktemp)
    is_configured "$1" || fresh=(--fresh)
    if ! (cd "$root" && cmake "${fresh[@]}" --preset "$1" -DCMAKE_UNITY_BUILD=ON "${@:2}") >"$log" 2>&1 9>&-; then
        cat "$log" >&2
        rm -f "$log"
        fail 70 "configuring failed (above)"
    fi
    rm -f "$log"
}

# Shows the progress of a ninja on stdin: on a terminal one line that is rewritten, else a line every 20 %.
show_progress() { # show_progress TITLE LOG
    local line shown=-1 percent
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$2"
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
        percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
        if [[ -t 2 ]]; then
            printf '\r%s: %s, %s of %s ' "$tool" "$1" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
        elif ((BASH_REMATCH[2] > 20 && percent / 20 > shown)); then
            shown=$((percent / 20))
            say "$1, $percent %"
        fi
    done
    [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# build PRESET TARGET…: compiles; shows the compiler's words only where it fails.
build() {
    local preset=$1 log status=0
    shift
    log=$(mktemp)
    NINJA_STATUS='[%f/%t] ' ninja -C "$root/build/$preset" -j "$(build_jobs)" "$@" 2>&1 9>&- |
        show_progress "building $preset" "$log" || status=1
    if [[ $status -ne 0 ]]; then
        grep -vE '^\[[0-9]+/[0-9]+\]|^ninja: Entering' "$log" >&2 || true
        rm -f "$log"
        fail 70 "the build failed (above)"
    fi
    rm -f "$log"
}
