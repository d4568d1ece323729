# Shared by scripts/run, scripts/test and .ci/run, which set `root` to the source tree. Everything here speaks on
# standard error and reads nothing: standard input and output belong to what is run in the end.

say() { echo "lancer: $*" >&2; }

fail() {
  say "$*"
  exit 70
}

# quietly LOG COMMAND...: what the command says goes to the log, and is shown only if it fails.
quietly() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    fail "failed: $* (all of its output is in $log)"
  fi
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

# install_packages KIND...: those of these kinds in scripts/packages that are missing.
install_packages() {
  command -v dpkg-query >/dev/null || return 0 # not a Debian: CMake says what it does not find
  local kinds installed package missing=
  kinds=$(IFS='|'; echo "$*")
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
  for package in $(sed -nE "s/^($kinds) //p" "$root/scripts/packages"); do
    case $'\n'$installed$'\n' in
      *$'\n'$package$'\n'*) ;;
      *) missing+=" $package" ;;
    esac
  done
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail "these packages are missing and there is no sudo to install them with:" $missing
  fi
  say "installing" $missing
  mkdir -p "$root/build"
  quietly "$root/build/packages.log" as_root apt-get -q update
  quietly "$root/build/packages.log" as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -q install -y --no-install-recommends $missing
}

# configure PRESET: makes build/PRESET ready for Ninja, if it is not; from then on Ninja looks after it itself.
configure() {
  local folder=$root/build/$1
  local cache=$folder/CMakeCache.txt
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    say "the tree has moved: building afresh"
    rm -rf "$folder"
  fi
  if [ ! -f "$folder/build.ninja" ] || [ "$root/CMakePresets.json" -nt "$cache" ]; then
    [ -f "$folder/build.ninja" ] || say "building $1, the first time takes some minutes"
    mkdir -p "$folder"
    if command -v ccache >/dev/null; then
      export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
    (cd "$root" && quietly "$folder.log" cmake --preset "$1") || exit
    touch "$cache"
  fi
}

# build PRESET [TARGET...]: configures and builds; two that start at once take turns.
build() {
  local preset=$1
  shift
  mkdir -p "$root/build"
  {
    flock 9
    configure "$preset"
    # What ccache may overlook so that it can serve files with a precompiled header.
    CCACHE_SLOPPINESS=pch_defines,time_macros quietly "$root/build/$preset.log" \
      cmake --build "$root/build/$preset" ${1:+--target "$@"}
  } 9>"$root/build/$preset.lock"
}
