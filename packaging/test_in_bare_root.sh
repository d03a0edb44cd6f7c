#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs packages in a Debian that has nothing else, and uses them; as root:
#   packaging/test_in_bare_root.sh PACKAGES ROOT
# PACKAGES has the .deb files, of this release of Debian. ROOT is made by debootstrap, anew where it exists, and goes
# when all is well. Where no such Debian can be made, that is said, and the exit code is 77.
set -euo pipefail
packages=$(realpath "$1")
root=$(realpath -m "$2")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")

say() { printf '==> %s\n' "$*" >&2; }
skip() {
  say "SKIPPED: the packages were not tried in a bare Debian: $*"
  exit 77
}
die() {
  printf 'test_in_bare_root: %s\n' "$*" >&2
  exit 1
}
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"; }
apt_get() { inside DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" >>"$log" || die "apt-get $*: $log"; }
install() { apt_get install --no-install-recommends "$@"; }
# The root's path of a package's file, for apt-get.
deb() { (cd "$root" && printf './%s' packages/"$1"_*.deb); }
# expect FILE...: these are there below ROOT, and not empty.
expect() {
  local file
  for file in "$@"; do [[ -s $root/$file ]] || die "no $file"; done
}
# expect_pdf FILE, expect_png FILE: by the marks of the formats.
expect_pdf() { [[ $(head -c 5 "$root/$1") == %PDF- ]] || die "$1 is no PDF"; }
expect_png() { [[ $(head -c 8 "$root/$1" | od -An -tx1) == " 89 50 4e 47 0d 0a 1a 0a" ]] || die "$1 is no PNG"; }

make_root() {
  ((EUID == 0)) || skip "debootstrap and chroot need root"
  command -v debootstrap >/dev/null || skip "no debootstrap"
  local codename mirror
  # shellcheck disable=SC1091
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  # From where this machine has its own packages.
  # shellcheck disable=SC2016  # the dollars are apt's
  mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' "Created-By: Packages" |
    awk -v release="$codename" '$2 == release { print $1; exit }')
  say "a bare $codename in $root"
  rm -rf --one-file-system "$root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$codename" "$root" ${mirror:+"$mirror"} >"$log" ||
    skip "debootstrap: $(tail -n 1 "$log") ($log)"
  inside true || skip "chroot is not possible here"
  mkdir "$root/packages" "$root/tmp/test"
  cp "$packages"/*.deb "$root/packages/"
  cp -r "$here/tests/consumer" "$root/tmp/consumer"
  apt_get update
}

test_program() {
  say "the program alone"
  install "$(deb roomatlas)"
  inside roomatlas --version
  local libraries code=0
  libraries=$(inside ldd /usr/bin/roomatlas | wc -l)
  say "it is linked with $libraries shared libraries"
  ((libraries < 40)) || die "40 or more are too many for the base"
  expect usr/share/{bash-completion/completions/roomatlas,zsh/vendor-completions/_roomatlas} \
    usr/share/fish/vendor_completions.d/roomatlas.fish
  [[ $(inside bash -c '. /usr/share/bash-completion/completions/roomatlas && complete -p roomatlas') == *-F* ]] ||
    die "nothing completes roomatlas in bash"
  inside gzip -dc /usr/share/man/man1/roomatlas-build.1.gz | grep -q '^\.SH OPTIONS' || die "no manual page"
  inside roomatlas -q simulate "$world" --odometry typical -o /tmp/test/mission
  inside roomatlas build /tmp/test/mission/mission.clf -o /tmp/test/base 2>"$root.err" || die "$(cat "$root.err")"
  grep -q 'apt-get install roomatlas-pictures' "$root.err" || die "nothing says how to get pictures"
  expect tmp/test/base/{plan.svg,report.html,building.gpkg,map.yaml}
  [[ ! -e $root/tmp/test/base/plan.pdf ]] || die "a PDF without the plug-in"
  inside roomatlas -q build /tmp/test/base/map.yaml -o /tmp/test/map  # a finished map, of its own
  expect tmp/test/map/plan.svg
  inside roomatlas export /tmp/test/base/building.gpkg -f dxf -o /tmp/test/none 2>"$root.err" || code=$?
  [[ $code == 2 ]] || die "exit code $code for a missing plug-in"
  grep -q 'apt-get install roomatlas-gdal' "$root.err" || die "nothing says how to get DXF"
}

test_plugins() {
  say "with the plug-ins"
  install "$(deb roomatlas-pictures)" "$(deb roomatlas-gdal)"
  inside roomatlas -q export /tmp/test/base/building.gpkg -f svg,pdf,png,dxf -o /tmp/test/more
  expect_pdf tmp/test/more/plan.pdf
  expect_png tmp/test/more/plan.png
  grep -q LWPOLYLINE "$root/tmp/test/more/plan.dxf" || die "the DXF has no line"
  cmp "$root"/tmp/test/{base,more}/plan.svg || die "the drawing hangs on the plug-ins"
}

test_python() {
  say "in Python"
  install "$(deb python3-roomatlas)"
  inside python3 -c '
import roomatlas
building = roomatlas.build("/tmp/test/mission/mission.clf")
assert len(building.rooms) == 2 and "<svg" in building.plan.svg()
'
}

test_fleet() {
  say "a fleet of one"
  install "$(deb roomatlas-fleet)"
  inside roomatlas-fleet --version
}

test_library() {
  say "in a program of its own"
  install "$(deb libroomatlas-dev)" cmake g++ make
  inside sh -c 'cmake -S /tmp/consumer -B /tmp/consumer/build && cmake --build /tmp/consumer/build' >>"$log" ||
    die "the consumer is not built: $log"
  [[ $(inside sh -c "cd /tmp/test && ../consumer/build/consumer") == "12 m2, 2 m" ]] || die "the consumer does not answer"
}

test_removal() {
  say "and gone again"
  apt_get purge roomatlas roomatlas-pictures roomatlas-gdal roomatlas-fleet python3-roomatlas libroomatlas-dev
  local left
  left=$(cd "$root" && find usr etc var/lib -path var/lib/apt -prune -o -path var/lib/dpkg -prune -o -name '*roomatlas*' -print)
  [[ -z $left ]] || die "left behind: $left"
}

log=$root.log
world=/usr/share/roomatlas/worlds/two_rooms.geojson
make_root
test_program
test_plugins
test_python
test_fleet
test_library
test_removal
rm -rf --one-file-system "$root"
say "all packages install, work and go in a bare Debian"
