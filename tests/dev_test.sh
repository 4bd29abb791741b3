#!/bin/sh
# Tests the setup of ../dev against stand-ins for dpkg-query, apt-get, sudo and id; nothing is installed.
set -eu

source=$(cd -- "$(dirname -- "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
project="$scratch/a project"
bin="$scratch/bin"
mkdir "$project" "$bin"
cp "$source/dev" "$project"
printf '# tools\ncmake\ng++  # compiler\n\nlibfoo-dev\n' >"$project/packages.txt"

# `dev` sees these programs and no others.
for tool in cat dirname env readlink sed sh; do ln -s "$(command -v $tool)" "$bin"; done

stand_in() {
  printf '#!/bin/sh\n%s\n' "$2" >"$bin/$1"
  chmod +x "$bin/$1"
}

# run USER_ID PACKAGE...: `dev setup` as this user on a machine with these packages; sets $status, $calls and $output.
run() {
  stand_in id "echo $1"
  shift
  stand_in dpkg-query "printf 'ii  %s \n' $*; printf 'un  libfoo-dev \n'; exit 1"
  : >"$scratch/calls"
  status=0
  (cd / && PATH="$bin" "$project/dev" setup) </dev/null >"$scratch/output" 2>&1 || status=$?
  calls=$(cat "$scratch/calls")
  output=$(cat "$scratch/output")
}

expect() {
  [ "$2" = "$3" ] && return
  printf '%s\n  expected: %s\n  found:    %s\n' "$1" "$2" "$3" >&2
  exit 1
}

apt='-q -o DPkg::Lock::Timeout=300'
update="noninteractive apt-get $apt update"
install="noninteractive apt-get $apt install --yes --no-install-recommends"
log="\$DEBIAN_FRONTEND apt-get \$*"
stand_in apt-get "echo \"$log\" >>'$scratch/calls'"

run 0 cmake g++ libfoo-dev
expect "all installed: status" 0 $status
expect "all installed: calls" "" "$calls"
expect "all installed: output" "" "$output"

run 0 cmake
expect "root: status" 0 $status
expect "root: calls" "$update
$install g++ libfoo-dev" "$calls"

advice="dev: missing packages, run as root: apt-get install --no-install-recommends libfoo-dev"
run 1000 cmake g++
expect "no sudo: status" 2 $status
expect "no sudo: calls" "" "$calls"
expect "no sudo: output" "$advice" "$output"

stand_in sudo "echo 'a password is required' >&2; exit 1"
run 1000 cmake g++
expect "useless sudo: status" 2 $status
expect "useless sudo: calls" "" "$calls"
expect "useless sudo: output" "$advice" "$output"

# Without a terminal sudo must not ask.
stand_in sudo "[ \"\$1\" = -n ] || exit 1; shift; echo sudo >>'$scratch/calls'; exec \"\$@\""
stand_in true "exit 0"
run 1000 cmake g++
expect "sudo: status" 0 $status
expect "sudo: calls" "sudo
sudo
$update
sudo
$install libfoo-dev" "$calls"

stand_in apt-get "[ \"\$4\" = install ]"
run 0 cmake g++
expect "apt-get update fails: status" 0 $status

stand_in apt-get "exit 100"
run 0 cmake g++
expect "apt-get fails: status" 2 $status
expect "apt-get fails: last line" "dev: apt-get could not install: libfoo-dev" "$(tail -n 1 "$scratch/output")"
